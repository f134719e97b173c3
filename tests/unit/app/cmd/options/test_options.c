#include "app/cmd/options/options.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

struct parse {
	struct options options;
	struct log_capture logged;
	int error;
};

/* Parses words up to NULL. */
static struct parse parse(enum command_bit command, const char *const *words)
{
	struct parse parse = {.options = options_default()};
	struct log log = log_capture_begin(&parse.logged);
	int count = 0;

	while (words[count]) {
		count++;
	}
	parse.error = options_parse(
		&parse.options, command, count, (char **)words, &log);
	parse.logged.count = parse.error ? parse.logged.count : 0;
	return parse;
}

#define PARSE(command, ...) \
	parse((command), (const char *const[]){__VA_ARGS__, NULL})

static void test_reads_values_after_a_space_or_an_equals_sign(void **state)
{
	struct parse p = PARSE(FOR_RENDER, "m.glb", "--size", "320x240",
		"--time=1.5", "-o", "x.png", "--frames", "7");

	(void)state;
	assert_int_equal(p.error, 0);
	assert_string_equal(p.options.model_path, "m.glb");
	assert_string_equal(p.options.screen.output, "x.png");
	assert_int_equal(p.options.screen.size.width, 320);
	assert_int_equal(p.options.screen.size.height, 240);
	assert_int_equal(p.options.show.frames, 7);
	assert_near(p.options.motion.time_s, 1.5, 0.0);
}

static void test_starts_from_the_panels_size(void **state)
{
	struct options options = options_default();

	(void)state;
	assert_int_equal(options.screen.size.width, 480);
	assert_int_equal(options.screen.size.height, 640);
	assert_false(options.show.clock.fixed);
}

static void test_refuses_an_empty_value(void **state)
{
	struct parse demo = PARSE(FOR_RENDER, "--demo", "");
	struct parse output = PARSE(FOR_POSE, "-o", "");

	(void)state;
	assert_int_equal(demo.error, -EINVAL);
	assert_contains(demo.logged.sentence[0], "give the name of a demo");
	assert_int_equal(output.error, -EINVAL);
}

static void test_suggests_the_option_that_was_meant(void **state)
{
	struct parse p = PARSE(FOR_RENDER, "--tmie", "1");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_int_equal(p.logged.count, 1);
	assert_contains(p.logged.sentence[0], "did you mean --time?");
}

static void test_mentions_help_when_no_option_is_similar(void **state)
{
	struct parse p = PARSE(FOR_RENDER, "--frobnicate");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0], "--help lists the options");
}

static void test_suggests_only_options_of_the_command(void **state)
{
	struct parse p = PARSE(FOR_INFO, "--tmie", "1");

	(void)state;
	assert_contains(p.logged.sentence[0], "--help lists the options");
}

static void test_refuses_an_option_of_another_command(void **state)
{
	struct parse p = PARSE(FOR_POSE, "--size", "1x1");

	(void)state;
	struct parse letter = PARSE(FOR_EXPORT, "-o", "a.c");

	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0],
		"--size: this is not an option of this command");
	/* By the name that the user gave it. */
	assert_int_equal(letter.error, -EINVAL);
	assert_contains(letter.logged.sentence[0], "-o: this is not");
	assert_null(strstr(letter.logged.sentence[0], "output"));
}

static void test_refuses_a_model_without_a_name(void **state)
{
	struct parse p = PARSE(FOR_PLAY, "");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0], "MODEL: its name is empty");
}

static void test_describes_a_valid_value(void **state)
{
	static const char *const bad[][2] = {
		{"--size", "480"},
		{"--size", "480x"},
		{"--size", "0x640"},
		{"--size", "480x640x2"},
		{"--size", "-1x5"},
		{"--size", "9000x10"},
		{"--time", "soon"},
		{"--time", "-1"},
		{"--time", "1.5s"},
		{"--time", "nan"},
		{"--frames", "0"},
		{"--frames", "many"},
		{"--frames", "99999999999999999999"},
		{"--clock", "fixed"},
		{"--clock", "fixed:0"},
		{"--math", "double"},
		{"--influences", "9"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		struct parse p = PARSE(FOR_RENDER, bad[i][0], bad[i][1]);

		assert_int_equal(p.error, -EINVAL);
		assert_int_equal(p.logged.count, 1);
		assert_contains(p.logged.sentence[0], ": give ");
		assert_contains(p.logged.sentence[0], bad[i][1]);
	}
}

static void test_reports_a_missing_value(void **state)
{
	struct parse p = PARSE(FOR_RENDER, "-o");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0], "its value is missing");
}

static void test_refuses_a_value_for_a_switch(void **state)
{
	struct parse p = PARSE(FOR_INFO, "--json=yes");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0], "takes no value");
}

static void test_takes_one_model_only(void **state)
{
	struct parse p = PARSE(FOR_INFO, "a.glb", "b.glb");

	(void)state;
	assert_int_equal(p.error, -EINVAL);
	assert_contains(p.logged.sentence[0], "b.glb: limber takes one model");
}

static void test_takes_a_name_with_a_dash_after_two_dashes(void **state)
{
	struct parse p = PARSE(FOR_INFO, "--", "-strange.glb");

	(void)state;
	assert_int_equal(p.error, 0);
	assert_string_equal(p.options.model_path, "-strange.glb");
}

static void test_closest_is_at_most_two_letters_off(void **state)
{
	static const char *const names[] = {"play", "render", "pose", NULL};

	(void)state;
	assert_string_equal(options_closest("rendre", names), "render");
	assert_string_equal(options_closest("plya", names), "play");
	assert_null(options_closest("compare", names));
	assert_null(options_closest("", names));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_reads_values_after_a_space_or_an_equals_sign),
		cmocka_unit_test(test_starts_from_the_panels_size),
		cmocka_unit_test(test_refuses_an_empty_value),
		cmocka_unit_test(test_suggests_the_option_that_was_meant),
		cmocka_unit_test(test_mentions_help_when_no_option_is_similar),
		cmocka_unit_test(test_suggests_only_options_of_the_command),
		cmocka_unit_test(test_refuses_an_option_of_another_command),
		cmocka_unit_test(test_refuses_a_model_without_a_name),
		cmocka_unit_test(test_describes_a_valid_value),
		cmocka_unit_test(test_reports_a_missing_value),
		cmocka_unit_test(test_refuses_a_value_for_a_switch),
		cmocka_unit_test(test_takes_one_model_only),
		cmocka_unit_test(test_takes_a_name_with_a_dash_after_two_dashes),
		cmocka_unit_test(test_closest_is_at_most_two_letters_off),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
