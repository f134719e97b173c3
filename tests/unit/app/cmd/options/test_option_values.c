/* Which values each option takes, and what they become. */
#include "app/cmd/options/options.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

/* Gives one option; returns whether its value is valid. */
static bool give(struct options *options, enum command_bit command,
	const char *option, const char *value)
{
	const char *const words[] = {option, value};
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	int error;

	*options = options_default();
	error = options_parse(options, command, 2, (char **)words, &log);
	assert_int_equal(logged.count, error ? 1 : 0);
	if (error) {
		assert_int_equal(error, -EINVAL);
		assert_contains(logged.sentence[0], option);
	}
	return error == 0;
}

static void test_numbers_are_taken_within_their_limits(void **state)
{
	static const struct {
		enum command_bit command;
		const char *option;
		const char *below, *least, *most, *above;
	} cases[] = {
		{FOR_PLAY, "--frames", "0", "1", "1000000", "1000001"},
		{FOR_PLAY, "--speed", "-100.1", "-100", "100", "100.1"},
		{FOR_PLAY, "--fps", "0.9", "1", "1000", "1001"},
		{FOR_PLAY, "--budget-ms", "0.9", "1", "1000", "1001"},
		{FOR_PLAY, "--walkers", "0", "1", "50", "51"},
		{FOR_PLAY, "--size", "0x1", "1x1", "8192x8192", "1x8193"},
		{FOR_PLAY, "--size", "1x0", "1x8192", "8192x1", "8193x1"},
		{FOR_PLAY, "--clock", "fixed:0", "fixed:0.1", "fixed:1000",
			"fixed:1001"},
		{FOR_PLAY, "--time", "-0.1", "0", "86400", "86400.1"},
		{FOR_PLAY, "--influences", "0", "1", "8", "9"},
		{FOR_PLAY, "--memory", "0.9", "1", "4000000000", "4000000001"},
		{FOR_PLAY, "--memory", "0k", "1k", "3g", "4g"},
		{FOR_BENCH, "--runs", "0", "1", "1001", "1002"},
		{FOR_COMPARE, "--fps", "0.9", "1", "240", "241"},
		{FOR_COMPARE, "--error", "0.0009", "0.001", "1000", "1000.1"},
		{FOR_COMPARE, "--ms", "0.0009", "0.001", "1000", "1000.1"},
		{FOR_COMPARE, "--ram", "0", "1", "4e9", "4.1e9"},
		{FOR_COMPARE, "--jobs", "0", "1", "64", "65"},
	};
	struct options o;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		enum command_bit command = cases[i].command;
		const char *option = cases[i].option;

		assert_false(give(&o, command, option, cases[i].below));
		assert_true(give(&o, command, option, cases[i].least));
		assert_true(give(&o, command, option, cases[i].most));
		assert_false(give(&o, command, option, cases[i].above));
		assert_false(give(&o, command, option, ""));
		assert_false(give(&o, command, option, "x"));
		assert_false(give(&o, command, option, "nan"));
		assert_false(give(&o, command, option, "1 "));
		assert_false(give(&o, command, option, "1,5"));
	}
}

static void test_numbers_become_what_was_written(void **state)
{
	struct options o;

	(void)state;
	assert_true(give(&o, FOR_PLAY, "--frames", "250"));
	assert_int_equal(o.show.frames, 250);
	assert_true(give(&o, FOR_PLAY, "--speed", "-1.5"));
	assert_near(o.motion.speed, -1.5, 0.0);
	assert_true(give(&o, FOR_PLAY, "--fps", "29.97"));
	assert_near(o.show.fps, 29.97, 0.0);
	assert_near(o.compare.fps, 60.0, 0.0);
	assert_true(give(&o, FOR_COMPARE, "--fps", "24"));
	assert_near(o.compare.fps, 24.0, 0.0);
	assert_near(o.show.fps, 0.0, 0.0);
	assert_true(give(&o, FOR_PLAY, "--budget-ms", "12.5"));
	assert_near(o.show.budget_ms, 12.5, 0.0);
	assert_true(give(&o, FOR_PLAY, "--walkers", "3"));
	assert_int_equal(o.show.walkers, 3);
	assert_true(give(&o, FOR_PLAY, "--size", "7x5"));
	assert_int_equal(o.screen.size.width, 7);
	assert_int_equal(o.screen.size.height, 5);
	assert_true(o.screen.size.given);
	assert_true(give(&o, FOR_BENCH, "--runs", "9"));
	assert_int_equal(o.bench.runs, 9);
	assert_true(give(&o, FOR_COMPARE, "--error", "0.25"));
	assert_near(o.compare.error_px, 0.25, 0.0);
	assert_true(give(&o, FOR_COMPARE, "--ms", "16.5"));
	assert_near(o.compare.ms, 16.5, 0.0);
	assert_true(give(&o, FOR_COMPARE, "--jobs", "2"));
	assert_int_equal(o.compare.jobs, 2);
	assert_true(give(&o, FOR_PLAY, "--time", "45f@30"));
	assert_near(o.motion.time_s, 1.5, 0.0);
}

static void test_bytes_may_have_a_suffix(void **state)
{
	static const struct {
		const char *value;
		size_t bytes;
	} cases[] = {
		{"200000", 200000},
		{"512k", 512 << 10},
		{"512K", 512 << 10},
		{"1.5k", 1536},
		{"64m", 64 << 20},
		{"64M", 64 << 20},
		{"2g", (size_t)2 << 30},
		{"1G", (size_t)1 << 30},
		{"1e6", 1000000},
	};
	static const char *const wrong[] = {
		"k", "-1", "1kb", "1 k", "1t", "5000m", "4000001k", "inf"};
	struct options o;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		assert_true(give(&o, FOR_INFO, "--memory", cases[i].value));
		assert_int_equal(o.common.memory_bytes, cases[i].bytes);
		assert_true(give(&o, FOR_COMPARE, "--ram", cases[i].value));
		assert_int_equal(o.compare.ram_bytes, cases[i].bytes);
	}
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		assert_false(give(&o, FOR_INFO, "--memory", wrong[i]));
	}
}

static void test_kinds_are_chosen_by_their_names(void **state)
{
	static const char *const modes[] = {
		"auto", "nearest", "step", "linear", "cubic"};
	static const enum clip_interpolation interpolations[] = {
		CLIP_AUTO, CLIP_NEAREST, CLIP_STEP, CLIP_LINEAR, CLIP_CUBIC};
	static const char *const kinds[] = {"loop", "ping-pong", "once"};
	static const enum clip_repeat repeats[] = {
		CLIP_LOOP, CLIP_PING_PONG, CLIP_ONCE};
	struct options o;

	(void)state;
	for (int i = 0; i < 5; i++) {
		assert_true(give(&o, FOR_POSE, "--interpolation", modes[i]));
		assert_int_equal(o.motion.interpolation, interpolations[i]);
	}
	assert_false(give(&o, FOR_POSE, "--interpolation", "Linear"));
	for (int i = 0; i < 3; i++) {
		assert_true(give(&o, FOR_PLAY, "--repeat", kinds[i]));
		assert_int_equal(o.motion.repeat, repeats[i]);
	}
	assert_false(give(&o, FOR_PLAY, "--repeat", "twice"));
	assert_true(give(&o, FOR_POSE, "--math", "fixed"));
	assert_int_equal(o.vertices.math, MATH_FIXED);
	assert_true(give(&o, FOR_POSE, "--math", "float"));
	assert_int_equal(o.vertices.math, MATH_FLOAT);
	assert_true(give(&o, FOR_PLAY, "--format", "rgb565"));
	assert_true(o.screen.format_given);
	assert_int_equal(o.screen.format, PIXELS_RGB565);
	assert_true(give(&o, FOR_PLAY, "--format", "rgba8888"));
	assert_int_equal(o.screen.format, PIXELS_RGBA8888);
	assert_true(give(&o, FOR_PLAY, "--clock", "real"));
	assert_false(o.show.clock.fixed);
	assert_true(give(&o, FOR_PLAY, "--clock", "fixed:25"));
	assert_true(o.show.clock.fixed);
}

static void test_reports_and_files_are_known_by_their_names(void **state)
{
	static const struct {
		enum command_bit command;
		const char *option, *value;
		bool valid;
	} cases[] = {
		{FOR_COMPARE, "--format", "text", true},
		{FOR_COMPARE, "--format", "json", true},
		{FOR_COMPARE, "--format", "csv", true},
		{FOR_COMPARE, "--format", "md", true},
		{FOR_COMPARE, "--format", "rgb565", false},
		{FOR_COMPARE, "--board", "imx31-pdk", true},
		{FOR_COMPARE, "--board", "imx31", false},
		{FOR_COMPARE, "--plot", "a.b.svg", true},
		{FOR_COMPARE, "--plot", "/dev/stdout", true},
		{FOR_COMPARE, "--plot", "a.svg.png", false},
		{FOR_COMPARE, "--plot", "svg", false},
		{FOR_COMPARE, "--plot", "/device/x", false},
		{FOR_PLAY, "--record", "a.gif", true},
		{FOR_PLAY, "--record", "a.y4m", true},
		{FOR_PLAY, "--record", "a.png", false},
		{FOR_PLAY, "--record", "gif", false},
		{FOR_PLAY, "--camera-use", "background", true},
		{FOR_PLAY, "--camera-use", "screen", true},
		{FOR_PLAY, "--camera-use", "motion", true},
		{FOR_PLAY, "--camera-use", "off", true},
		{FOR_PLAY, "--camera-use", "on", false},
		{FOR_PLAY, "--show", "all", true},
		{FOR_PLAY, "--show", "skeleton,keys", true},
		{FOR_PLAY, "--show", "skeletons", false},
		{FOR_PLAY, "--influences", "auto", true},
		{FOR_PLAY, "--influences", "budget:100", true},
		{FOR_PLAY, "--influences", "budget", false},
		{FOR_PLAY, "--lod", "auto", true},
		{FOR_PLAY, "--lod", "off", true},
		{FOR_PLAY, "--lod", "level:2", true},
		{FOR_PLAY, "--lod", "100", true},
		{FOR_PLAY, "--lod", "101", false},
	};
	struct options o;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		assert_int_equal(give(&o, cases[i].command, cases[i].option,
					 cases[i].value),
			cases[i].valid);
	}
}

static void test_nothing_given_leaves_the_defaults(void **state)
{
	const struct options o = options_default();

	(void)state;
	assert_int_equal(o.common.memory_bytes, 256 << 20);
	assert_near(o.motion.speed, 1.0, 0.0);
	assert_int_equal(o.motion.repeat, CLIP_LOOP);
	assert_int_equal(o.motion.interpolation, CLIP_AUTO);
	assert_int_equal(o.bench.runs, 15);
	assert_near(o.compare.fps, 60.0, 0.0);
	assert_near(o.compare.error_px, 0.5, 0.0);
	assert_string_equal(o.compare.format, "text");
	assert_non_null(o.compare.board);
	assert_int_equal(o.compare.jobs, 0);
	for (int i = 0; i < BUTTON_COUNT; i++) {
		assert_int_equal(o.input.action[i], i);
	}
}

static void test_the_closest_name_is_the_one_with_fewest_changes(void **state)
{
	static const char *const names[] = {"size", "sizes", "time",
		"a-name-of-thirty-one-characters", NULL};

	(void)state;
	assert_string_equal(options_closest("size", names), "size");
	assert_string_equal(options_closest("sizess", names), "sizes");
	assert_string_equal(options_closest("SIZE", names), "size");
	assert_string_equal(options_closest("tme", names), "time");
	/* A word of three letters may differ in one. */
	assert_null(options_closest("tmx", names));
	assert_string_equal(options_closest("timexx", names), "time");
	assert_null(options_closest("timexxx", names));
	assert_string_equal(
		options_closest("a-name-of-thirty-one-character", names),
		names[3]);
	assert_null(options_closest("a-name-of-thirty-one-charactersx", names));
}

/* No option is that long, so that such words are not compared. */
static void test_words_of_more_than_31_letters_are_close_to_none(void **state)
{
	(void)state;
	for (int letters = 30; letters <= 33; letters++) {
		for (int more = -1; more <= 1; more++) {
			char word[40] = "", name[40] = "";
			const char *const names[] = {name, NULL};
			bool compared = letters <= 31 && letters + more <= 31;

			memset(word, 'a', (size_t)letters);
			memset(name, 'a', (size_t)(letters + more));
			name[5] = 'b';
			assert_ptr_equal(options_closest(word, names),
				compared ? name : NULL);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_numbers_are_taken_within_their_limits),
		cmocka_unit_test(test_numbers_become_what_was_written),
		cmocka_unit_test(test_bytes_may_have_a_suffix),
		cmocka_unit_test(test_kinds_are_chosen_by_their_names),
		cmocka_unit_test(test_reports_and_files_are_known_by_their_names),
		cmocka_unit_test(test_nothing_given_leaves_the_defaults),
		cmocka_unit_test(
			test_the_closest_name_is_the_one_with_fewest_changes),
		cmocka_unit_test(
			test_words_of_more_than_31_letters_are_close_to_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
