/* The limits of limber.conf, where it is looked for, and its buttons. */
#include "app/cmd/options/config_buttons.h"
#include "tests/unit/app/cmd/options/config_scene.h"

#include <errno.h>
#include <stdio.h>
#include <sys/stat.h>

static void test_a_file_may_have_a_hundred_thousand_lines(void **state)
{
	enum {
		LINES = 100000
	};
	struct scene *scene = *state;
	char *text = malloc(LINES + 1);

	assert_non_null(text);
	memset(text, '\n', LINES + 1);
	assert_int_equal(load_bytes(scene, FOR_PLAY, text, LINES), 0);
	assert_int_equal(load_bytes(scene, FOR_PLAY, text, LINES + 1), -EINVAL);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "more than 100000 lines");
	free(text);
}

static void test_zero_bytes_are_no_text(void **state)
{
	static const char text[] = "[start]\n\0\0\ndemo = arm\n";
	struct scene *scene = *state;

	assert_int_equal(
		load_bytes(scene, FOR_PLAY, text, sizeof(text) - 1), -EINVAL);
	assert_contains(scene->logged.sentence[0], ":2: ");
	assert_contains(scene->logged.sentence[0], "is no text");
}

static void test_lines_may_be_indented_and_commented(void **state)
{
	struct scene *scene = *state;

	assert_int_equal(load(scene, FOR_PLAY,
				 "; a comment\n"
				 "# another\n"
				 "\t [start]\r\n"
				 "   demo = arm\n"
				 "\tclip: wave ; a remark\n"
				 "\n"
				 " [display]\n"
				 "labels = no"),
		0);
	assert_string_equal(scene->options.show.demo, "arm");
	assert_string_equal(scene->options.motion.clip, "wave");
	assert_true(scene->options.show.no_labels);
}

static void test_labels_are_yes_or_no(void **state)
{
	struct scene *scene = *state;

	assert_int_equal(load(scene, FOR_PLAY, "[display]\nlabels = yes\n"), 0);
	assert_false(scene->options.show.no_labels);
	assert_int_equal(
		load(scene, FOR_PLAY, "[display]\nlabels = no\nlabels = yes\n"),
		0);
	assert_false(scene->options.show.no_labels);
	assert_int_equal(
		load(scene, FOR_PLAY, "[display]\nlabels = maybe\n"), -EINVAL);
	assert_contains(scene->logged.sentence[0], "give yes or no");
}

static void test_an_action_may_be_taken_from_a_button(void **state)
{
	struct scene *scene = *state;

	assert_int_equal(
		load(scene, FOR_PLAY, "[actions]\nF9 = none\nUP = DOWN\n"), 0);
	assert_int_equal(scene->options.input.action[BUTTON_F9], BUTTON_COUNT);
	assert_int_equal(scene->options.input.action[BUTTON_UP], BUTTON_DOWN);
	assert_int_equal(scene->options.input.action[BUTTON_DOWN], BUTTON_DOWN);
	assert_int_equal(load(scene, FOR_PLAY, "[actions]\nF9 = no\n"), -EINVAL);
	assert_int_equal(load(scene, FOR_PLAY, "[actions]\nF7 = UP\n"), -EINVAL);
	assert_contains(scene->logged.sentence[0], "no such button");
}

/* The spec that the lines of [buttons] give, or NULL when they are refused. */
static const char *spec_of(struct scene *scene, const char *lines)
{
	char text[3000];
	int error;

	snprintf(text, sizeof(text), "[buttons]\n%s", lines);
	error = load(scene, FOR_PLAY, text);
	return error ? NULL : scene->options.input.buttons;
}

static void test_buttons_of_each_kind_are_joined(void **state)
{
	static const char *const cases[][2] = {
		{"UP = gpio a 1\n", "gpiod:UP=a 1"},
		{"UP = gpio a 1 , key KEY_W\nDOWN=key KEY_S\n",
			"gpiod:UP=a 1,evdev:,UP=KEY_W,DOWN=KEY_S"},
		{"UP = key KEY_W\n", "evdev:,UP=KEY_W"},
		{"UP = key KEY_W\nkeyboard = kpp\n", "evdev:kpp,UP=KEY_W"},
		{"keyboard = kpp\n", "evdev:kpp"},
		{"keyboard = k\n", "evdev:k"},
		{"keyboard = all\n", "evdev"},
		{"UP = key KEY_W\nkeyboard = none\n", NULL},
		{"sources = script:x\n", "script:x"},
		{"keyboard = all\nsources = script:x\n", "evdev,script:x"},
		{"UP = gpio a 1\nkeyboard = all\n", "gpiod:UP=a 1,evdev"},
		{"UP = gpio a 1\nsources = script:x\n", "gpiod:UP=a 1,script:x"},
		{"UP = key KEY_W\nsources = script:x\n",
			"evdev:,UP=KEY_W,script:x"},
		{"UP = key KEY_W\nkeyboard = none\nsources = script:x\n",
			"script:x"},
		{"UP = gpio a 1\nkeyboard = kpp\nsources = script:x\n",
			"gpiod:UP=a 1,evdev:kpp,script:x"},
	};
	struct scene *scene = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const char *spec = spec_of(scene, cases[i][0]);

		assert_int_equal(scene->logged.count, 0);
		if (cases[i][1]) {
			assert_non_null(spec);
			assert_string_equal(spec, cases[i][1]);
		} else {
			assert_null(spec);
		}
	}
}

static void test_wrong_buttons_are_refused(void **state)
{
	static const char *const cases[][2] = {
		{"UP = gpios a 1\n", "give gpio CHIP LINE or key NAME"},
		{"UP = keys KEY_W\n", "give gpio CHIP LINE or key NAME"},
		{"UP = KEY_W\n", "give gpio CHIP LINE or key NAME"},
		{"UP = key KEY_W,\n", "give gpio CHIP LINE or key NAME"},
		{"UP = key\n", "no such key"},
		{"UP = gpio\n", "line is missing"},
		{"UP = key KEY_NO\n", "no such key"},
		{"sources = piano\n", "no such source"},
	};
	struct scene *scene = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		assert_null(spec_of(scene, cases[i][0]));
		assert_int_equal(scene->logged.count, 1);
		assert_contains(scene->logged.sentence[0], cases[i][1]);
	}
}

/* "gpio c 1" with so many blanks behind the chip, where one is enough. */
static int set_line(
	struct config_buttons *buttons, int blanks, struct log_capture *logged)
{
	struct log log = log_capture_begin(logged);
	char value[700] = "gpio c";

	memset(value + 6, ' ', (size_t)blanks);
	strcpy(value + 6 + blanks, "1");
	return config_buttons_set(buttons, "UP", value, &log);
}

static void test_a_button_that_is_too_long_is_refused(void **state)
{
	const int most = 255 - (int)strlen("UP=c1");
	struct scene *scene = *state;
	struct config_buttons buttons = {0};

	assert_int_equal(set_line(&buttons, most, &scene->logged), 0);
	assert_int_equal(set_line(&buttons, most + 1, &scene->logged), -EINVAL);
	assert_contains(scene->logged.sentence[0], "255 characters");
	assert_int_equal(set_line(&buttons, 690, &scene->logged), -EINVAL);
	assert_contains(scene->logged.sentence[0], "511 characters");
}

/* What does not fit is left out, and the spec of the others is complete. */
static void test_lists_of_buttons_have_a_greatest_length(void **state)
{
	struct scene *scene = *state;
	struct config_buttons buttons = {0};
	struct log log = log_capture_begin(&scene->logged);
	char spec[CONFIG_LIST_BYTES + 64], name[CONFIG_LIST_BYTES];
	int left = CONFIG_LIST_BYTES - 1, part = (int)strlen(",UP=c1");

	for (; left > 2 * part + 200; left -= part + 100) {
		assert_int_equal(set_line(&buttons, 100, &scene->logged), 0);
	}
	assert_int_equal(
		set_line(&buttons, left - part + 1, &scene->logged), -EINVAL);
	assert_contains(scene->logged.sentence[0], "too many buttons");
	assert_int_equal(
		strlen(buttons.lines), (size_t)(CONFIG_LIST_BYTES - 1 - left));
	assert_int_equal(set_line(&buttons, left - part, &scene->logged), 0);
	assert_int_equal(strlen(buttons.lines), CONFIG_LIST_BYTES - 1);
	assert_int_equal(
		config_buttons_spec(&buttons, spec, sizeof(spec), &log), 0);
	assert_int_equal(
		config_buttons_spec(&buttons, spec, strlen(spec) + 1, &log), 0);
	assert_int_equal(config_buttons_spec(&buttons, spec, strlen(spec), &log),
		-EINVAL);

	memset(name, 'k', sizeof(name));
	name[sizeof(buttons.keyboard)] = '\0';
	assert_int_equal(
		config_buttons_set(&buttons, "keyboard", name, &log), -EINVAL);
	name[sizeof(buttons.keyboard) - 1] = '\0';
	assert_int_equal(
		config_buttons_set(&buttons, "keyboard", name, &log), 0);
	assert_string_equal(buttons.keyboard, name);
}

static void test_a_file_is_found_below_the_home_folder(void **state)
{
	struct scene *scene = *state;
	struct test_path dot = path_join(&scene->folder, ".config");
	struct test_path below = path_join(&dot, "limber");
	struct test_path own = path_join(&below, "limber.conf");
	struct test_path cut = path_join(&below, "limber.con");
	struct log log = log_capture_begin(&scene->logged);
	char path[700];

	assert_int_equal(unsetenv("LIMBER_CONFIG"), 0);
	assert_int_equal(mkdir(dot.text, 0700), 0);
	assert_int_equal(mkdir(below.text, 0700), 0);
	file_write(own.text, "", 0);
	assert_int_equal(setenv("HOME", scene->folder.text, 1), 0);
	assert_int_equal(unsetenv("XDG_CONFIG_HOME"), 0);
	assert_int_equal(config_find(NULL, true, path, sizeof(path), &log), 1);
	assert_string_equal(path, own.text);
	assert_int_equal(setenv("XDG_CONFIG_HOME", "", 1), 0);
	assert_int_equal(config_find(NULL, true, path, sizeof(path), &log), 1);
	assert_string_equal(path, own.text);
	assert_int_equal(setenv("HOME", "/nowhere", 1), 0);
	assert_int_equal(setenv("XDG_CONFIG_HOME", dot.text, 1), 0);
	assert_int_equal(config_find(NULL, true, path, sizeof(path), &log), 1);
	assert_string_equal(path, own.text);
	assert_int_equal(
		config_find(NULL, true, path, strlen(own.text) + 1, &log), 1);
	/* A path that does not fit is no file, also where its beginning is one. */
	file_write(cut.text, "", 0);
	if (config_find(NULL, true, path, strlen(own.text), &log)) {
		assert_string_equal(path, "/etc/limber.conf");
	}
	assert_int_equal(config_find("ab", true, path, 3, &log), 1);
	assert_int_equal(scene->logged.count, 0);
	assert_int_equal(config_find("abc", true, path, 3, &log), -ENAMETOOLONG);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_a_file_may_have_a_hundred_thousand_lines),
		CASE(test_zero_bytes_are_no_text),
		CASE(test_lines_may_be_indented_and_commented),
		CASE(test_labels_are_yes_or_no),
		CASE(test_an_action_may_be_taken_from_a_button),
		CASE(test_buttons_of_each_kind_are_joined),
		CASE(test_wrong_buttons_are_refused),
		CASE(test_a_button_that_is_too_long_is_refused),
		CASE(test_lists_of_buttons_have_a_greatest_length),
		CASE(test_a_file_is_found_below_the_home_folder),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
