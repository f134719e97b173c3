/* What limber.conf says, what is refused in it, and where it is found. */
#include "tests/unit/app/cmd/options/config_scene.h"

#include <errno.h>
#include <stdio.h>

enum {
	PATH_BYTES = 600 /* for what config_find() finds */
};

/* It was refused with one error, which begins with the file and the line. */
static void expect_refusal(struct scene *scene, int line, const char *why)
{
	char place[600];

	snprintf(place, sizeof(place), "%s:%d: ", scene->path.text, line);
	assert_int_equal(scene->error, -EINVAL);
	assert_int_equal(scene->logged.count, 1);
	assert_int_equal(
		strncmp(scene->logged.sentence[0], place, strlen(place)), 0);
	assert_contains(scene->logged.sentence[0], why);
}

static void test_keys_are_options_by_their_names(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY,
		"; a comment\n"
		"# another\n"
		"[start]\n"
		"demo = face\n"
		"time = 45f@30\n"
		"  speed = 0.5   ; slowly\n"
		"[display]\n"
		"display = null\n"
		"size = 320x240\r\n"
		"gl = soft\n"
		"labels = no\n"
		"[math]\n"
		"influences = 2\n"
		"[watchdog]\n"
		"watchdog = /dev/watchdog\n"
		"[camera]\n"
		"camera = pattern\n"
		"[options]\n"
		"frames = 7\n"
		"verbose = yes\n");
	assert_int_equal(scene->error, 0);
	assert_string_equal(scene->options.show.demo, "face");
	assert_near(scene->options.motion.time_s, 1.5, 1e-9);
	assert_near(scene->options.motion.speed, 0.5, 0.0);
	assert_string_equal(scene->options.screen.display, "null");
	assert_int_equal(scene->options.screen.size.width, 320);
	assert_int_equal(scene->options.screen.size.height, 240);
	assert_string_equal(scene->options.screen.gl, "soft");
	assert_true(scene->options.show.no_labels);
	assert_string_equal(scene->options.show.watchdog, "/dev/watchdog");
	assert_string_equal(scene->options.input.camera, "pattern");
	assert_int_equal(scene->options.show.frames, 7);
	assert_true(scene->options.common.verbose);
	assert_null(scene->options.input.buttons);
}

/* As any other key does, a switch overrides the same key above it. */
static void test_the_last_line_of_a_switch_counts(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY,
		"[options]\nhud = yes\nverbose = no\nhud = no\nverbose = yes\n");
	assert_int_equal(scene->error, 0);
	assert_false(scene->options.show.hud);
	assert_true(scene->options.common.verbose);
}

static void test_buttons_become_the_value_of_an_option(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY,
		"[buttons]\n"
		"UP = gpio 53fd0000.gpio 18 active-low pull-up debounce=20\n"
		"ENTER = gpio KEY_COL4 pull-down , key KEY_KPENTER\n"
		"F9 = key KEY_W\n"
		"keyboard = kpp\n"
		"sources = script:a.txt\n");
	assert_int_equal(scene->error, 0);
	assert_string_equal(scene->options.input.buttons,
		"gpiod:UP=53fd0000.gpio 18 active-low pull-up debounce=20,"
		"ENTER=KEY_COL4 pull-down,evdev:kpp,ENTER=KEY_KPENTER,"
		"F9=KEY_W,script:a.txt");
	load(scene, FOR_PLAY, "[buttons]\nkeyboard = all\n");
	assert_string_equal(scene->options.input.buttons, "evdev");
	load(scene, FOR_PLAY, "[buttons]\nF9 = key KEY_W\n");
	assert_string_equal(scene->options.input.buttons, "evdev:,F9=KEY_W");
	load(scene, FOR_PLAY, "[buttons]\nkeyboard = none\n");
	assert_null(scene->options.input.buttons);
}

static void test_actions_move_to_other_buttons(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY, "[actions]\nF9 = UP\nF10 = none\n");
	assert_int_equal(scene->error, 0);
	assert_int_equal(scene->options.input.action[BUTTON_F9], BUTTON_UP);
	assert_int_equal(scene->options.input.action[BUTTON_F10], BUTTON_COUNT);
	assert_int_equal(scene->options.input.action[BUTTON_UP], BUTTON_UP);
}

static void test_options_of_other_commands_are_checked_and_skipped(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_POSE,
		"[display]\ndisplay = fbdev\nsize = 10x20\n"
		"[buttons]\nkeyboard = all\n[start]\ntime = 2\n");
	assert_int_equal(scene->error, 0);
	assert_null(scene->options.screen.display);
	assert_int_equal(scene->options.screen.size.width, 480);
	assert_null(scene->options.input.buttons);
	assert_near(scene->options.motion.time_s, 2.0, 0.0);
	load(scene, FOR_POSE, "[display]\nsize = big\n");
	expect_refusal(scene, 2, "give a width and a height");
}

static void test_errors_name_their_line(void **state)
{
	static const struct {
		int line;
		const char *text, *why;
	} cases[] = {
		{2, "[start]\ndmeo = arm\n", "did you mean demo?"},
		{3, "\n[dsiplay]\nsize = 1x1\n", "did you mean display?"},
		{1, "demo = arm\n", "before any [section]: write [start] above"},
		{1, "size = 9x9\n", "[section]: write [display] above it"},
		{1, "UP = key A\n", "[section]: write [buttons] above it"},
		{1, "verbose = yes\n", "[section]: write [options] above it"},
		{2, "[display]\nsize = 480\n", "size = 480: give a width"},
		{2, "[display]\nlabels = maybe\n", "give yes or no"},
		{2, "[start]\ndemo arm\n", "KEY = VALUE"},
		{1, "[start\ndemo = arm\n", "a ] is missing"},
		{2, "[buttons]\nUPP = key KEY_W\n", "did you mean UP?"},
		{2, "[buttons]\nUP = gpio 53fd0000.gpio 18 pul-up\n",
			"give CHIP/LINE"},
		{2, "[buttons]\nUP = gpio\n", "the line is missing"},
		{2, "[buttons]\nUP = gpio a 1,\n", "give gpio CHIP LINE"},
		{2, "[buttons]\nUP = keys KEY_W\n", "give gpio CHIP LINE"},
		{2, "[buttons]\nUP = key KEY_NONE\n", "no such key"},
		{2, "[buttons]\nsources = piano\n", "no such source"},
		{2, "[actions]\nF9 = dance\n", "give the button"},
		{2, "[actions]\nF7 = UP\n", "did you mean F6?"},
		{3, "[options]\n; x\nframs = 4\n", "did you mean frames?"},
		{2, "[options]\nframes = none\n", "give a number"},
		{2, "[options]\nconfig = x\n", "does not belong in [options]"},
		{2, "[start]\nmodel =\n", "give the name of a file"},
		{2, "[buttons]\nkeyboard = Keyboard, Pro\n", "leave out"},
		{2, "[buttons]\nkeyboard = a=b\n", "leave out"},
	};
	struct scene *scene = *state;

	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		load(scene, FOR_PLAY, cases[i].text);
		expect_refusal(scene, cases[i].line, cases[i].why);
	}
}

/* A hint must not lead to the next error. */
static void test_no_key_is_suggested_that_is_refused(void **state)
{
	static const char *const refused[] = {
		"help", "version", "config", "output", "demo", "buttons"};
	struct scene *scene = *state;

	load(scene, FOR_PLAY, "[options]\nnothing-like-it = 1\n");
	expect_refusal(scene, 2, "use one such as character, clip,");
	for (size_t i = 0; i < sizeof(refused) / sizeof(refused[0]); i++) {
		char word[32];

		snprintf(word, sizeof(word), " %s,", refused[i]);
		assert_null(strstr(scene->logged.sentence[0], word));
	}
}

static void test_a_line_that_is_too_long_is_refused(void **state)
{
	struct scene *scene = *state;
	char text[3000];

	memset(text, 'x', sizeof(text));
	memcpy(text, "[start]\ndemo = ", 15);
	text[sizeof(text) - 1] = '\0';
	load(scene, FOR_PLAY, text);
	expect_refusal(scene, 2, "this line has more than");
}

/* Some editors begin a file with one. */
static void test_a_byte_order_mark_is_skipped(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY, "\xEF\xBB\xBF[start]\r\ndemo = face\r\n");
	assert_int_equal(scene->error, 0);
	assert_string_equal(scene->options.show.demo, "face");
}

static void test_words_behind_a_section_are_refused(void **state)
{
	struct scene *scene = *state;

	load(scene, FOR_PLAY, "[start] ; these are\n\n[display] gl = soft\n");
	expect_refusal(scene, 3, "a section ends with its ]");
}

static void test_a_missing_file_is_named(void **state)
{
	struct scene *scene = *state;
	struct log log = log_capture_begin(&scene->logged);

	assert_int_equal(config_load(&scene->config, "/nowhere/limber.conf",
				 FOR_PLAY, &scene->options, &log),
		-ENOENT);
	assert_contains(scene->logged.sentence[0], "/nowhere/limber.conf");
	assert_int_equal(config_load(&scene->config, scene->folder.text,
				 FOR_PLAY, &scene->options, &log),
		-EIO);
}

/* What config_find() returns; the path has up to 599 characters. */
static int find(struct scene *scene, const char *given, bool search,
	char found[PATH_BYTES])
{
	struct log log = log_capture_begin(&scene->logged);

	return config_find(given, search, found, PATH_BYTES, &log);
}

static void test_files_are_found_in_order_of_precedence(void **state)
{
	struct scene *scene = *state;
	struct test_path home = path_join(&scene->folder, "none-here");
	char found[PATH_BYTES];

	assert_int_equal(setenv("XDG_CONFIG_HOME", home.text, 1), 0);
	assert_int_equal(setenv("LIMBER_CONFIG", "env.conf", 1), 0);
	assert_int_equal(find(scene, "given.conf", true, found), 1);
	assert_string_equal(found, "given.conf");
	assert_int_equal(find(scene, "none", true, found), 0);
	assert_int_equal(find(scene, NULL, false, found), 1);
	assert_string_equal(found, "env.conf");
	assert_int_equal(setenv("LIMBER_CONFIG", "none", 1), 0);
	assert_int_equal(find(scene, NULL, true, found), 0);
	assert_int_equal(unsetenv("LIMBER_CONFIG"), 0);
	assert_int_equal(find(scene, NULL, false, found), 0);
}

static void test_a_name_that_no_path_may_have_is_refused(void **state)
{
	struct scene *scene = *state;
	char name[PATH_BYTES + 1], found[PATH_BYTES];

	memset(name, 'n', sizeof(name));
	name[PATH_BYTES - 1] = '\0';
	assert_int_equal(find(scene, name, true, found), 1);
	assert_string_equal(found, name);
	assert_int_equal(scene->logged.count, 0);

	name[PATH_BYTES - 1] = 'n';
	name[PATH_BYTES] = '\0';
	assert_int_equal(find(scene, name, true, found), -ENAMETOOLONG);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "more than 599 characters");
	assert_int_equal(setenv("LIMBER_CONFIG", name, 1), 0);
	assert_int_equal(find(scene, NULL, true, found), -ENAMETOOLONG);
	assert_contains(scene->logged.sentence[0], "LIMBER_CONFIG");
	assert_int_equal(unsetenv("LIMBER_CONFIG"), 0);
}

static void test_the_boards_file_is_valid(void **state)
{
	struct scene *scene = *state;
	struct log log = log_capture_begin(&scene->logged);

	scene->options = options_default();
	assert_int_equal(
		config_load(&scene->config, "board/imx31-pdk/limber.conf",
			FOR_PLAY, &scene->options, &log),
		0);
	assert_int_equal(scene->logged.count, 0);
	assert_string_equal(scene->options.show.demo, "walker");
	assert_string_equal(scene->options.screen.display, "fbdev");
	assert_string_equal(scene->options.screen.gl, "soft");
	assert_string_equal(scene->options.input.buttons,
		"gpiod:UP=53fd0000.gpio 18 active-high,"
		"DOWN=53fd0000.gpio 19 active-high,"
		"LEFT=53fd0000.gpio 20 active-high,"
		"RIGHT=53fd0000.gpio 21 active-high,"
		"ENTER=53fd0000.gpio 22 active-high,"
		"F6=53fd0000.gpio 23 active-high,"
		"F8=53fd0000.gpio 24 active-high,"
		"F9=53fd0000.gpio 25 active-high,evdev");
	assert_int_equal(buttons_check(scene->options.input.buttons, &log), 0);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_keys_are_options_by_their_names),
		CASE(test_the_last_line_of_a_switch_counts),
		CASE(test_buttons_become_the_value_of_an_option),
		CASE(test_actions_move_to_other_buttons),
		CASE(test_options_of_other_commands_are_checked_and_skipped),
		CASE(test_errors_name_their_line),
		CASE(test_no_key_is_suggested_that_is_refused),
		CASE(test_a_line_that_is_too_long_is_refused),
		CASE(test_a_byte_order_mark_is_skipped),
		CASE(test_words_behind_a_section_are_refused),
		CASE(test_a_missing_file_is_named),
		CASE(test_files_are_found_in_order_of_precedence),
		CASE(test_a_name_that_no_path_may_have_is_refused),
		CASE(test_the_boards_file_is_valid),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
