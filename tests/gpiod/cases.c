#include "tests/gpiod/cases.h"

#include "platform/base/compiler.h"
#include "platform/buttons/gpio_output.h"
#include "platform/buttons/gpiod/gpiod_survey.h"
#include "tests/gpiod/bench.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

static void test_a_line_is_found_by_label_and_offset(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18,F9=53fd0000.gpio/25");
	assert_int_equal(bench->logged.count, 0);
	assert_true(gpiod_bench_wire(bench, 18)->input);
	assert_true(gpiod_bench_wire(bench, 18)->both_edges);
	assert_false(gpiod_bench_wire(bench, 18)->active_low);
	assert_int_equal(gpiod_bench_wire(bench, 18)->bias, FAKE_AS_IS);
	assert_string_equal(gpiod_bench_wire(bench, 18)->consumer, "limber UP");
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 18), BUTTON_UP);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 25), BUTTON_F9);
}

static void test_a_label_finds_its_chip_under_any_number(void **state)
{
	struct gpiod_bench *bench = *state;

	bench->gpio.chip[0].label = "53fd0000.gpio";
	bench->gpio.chip[2].label = "53fa4000.gpio";
	bench->gpio.chip[0].name = "gpiochip7";
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	gpiod_bench_press(bench, &bench->gpio.chip[0].line[18], BUTTON_UP);
	assert_false(gpiod_bench_wire(bench, 18)->requested);
}

static void test_a_line_is_found_by_its_name(void **state)
{
	struct gpiod_bench *bench = *state;

	bench->gpio.chip[1].line[3].name = "KEY_ROW4";
	gpiod_bench_wire(bench, 5)->name = "A/B line";
	gpiod_bench_wire(bench, 6)->name = "KEY_ROW4";
	gpiod_bench_open(bench,
		"gpiod:LEFT=KEY_ROW4,RIGHT=gpiochip2/KEY_ROW4/active-high");
	assert_int_equal(bench->logged.count, 0);
	gpiod_bench_press(bench, &bench->gpio.chip[1].line[3], BUTTON_LEFT);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 6), BUTTON_RIGHT);
}

static void test_with_spaces_a_name_may_contain_slashes(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_wire(bench, 5)->name = "A/B";
	gpiod_bench_open(bench, "gpiod:LEFT=53fd0000.gpio A/B pull-up");
	assert_int_equal(gpiod_bench_wire(bench, 5)->bias, FAKE_PULL_UP);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 5), BUTTON_LEFT);
}

static void test_bias_and_active_level_are_requested(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_wire(bench, 1)->high = true;
	gpiod_bench_open(bench,
		"gpiod:UP=53fd0000.gpio/1/active-low/pull-up,DOWN=53fd0000.gpio/2/pull-down,LEFT=53fd0000.gpio/3/no-pull");
	assert_true(gpiod_bench_wire(bench, 1)->active_low);
	assert_int_equal(gpiod_bench_wire(bench, 1)->bias, FAKE_PULL_UP);
	assert_false(gpiod_bench_wire(bench, 2)->active_low);
	assert_int_equal(gpiod_bench_wire(bench, 2)->bias, FAKE_PULL_DOWN);
	assert_int_equal(gpiod_bench_wire(bench, 3)->bias, FAKE_NO_PULL);
	fake_gpio_set(gpiod_bench_wire(bench, 1), false, 0);
	buttons_poll(&bench->buttons, 100);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	fake_gpio_set(gpiod_bench_wire(bench, 1), true, 0);
	buttons_poll(&bench->buttons, 200);
	gpiod_bench_expect(bench, BUTTON_UP, false);
}

static void test_a_bouncing_contact_counts_once(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	for (int i = 0; i < 7; i++) {
		fake_gpio_set(gpiod_bench_wire(bench, 18), i % 2 == 0,
			30000 - i * 1000);
	}
	buttons_poll(&bench->buttons, 100);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	gpiod_bench_expect_nothing(bench);
	buttons_poll(&bench->buttons, 1000);
	gpiod_bench_expect_nothing(bench);
}

/* Presses UP twice between two frames, 100 ms apart: both must count. */
static void expect_two_presses(struct gpiod_bench *bench,
	void (*set)(struct fake_line *line, bool high, int age_us))
{
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	for (int i = 0; i < 4; i++) {
		set(gpiod_bench_wire(bench, 18), i % 2 == 0,
			400000 - i * 100000);
	}
	buttons_poll(&bench->buttons, 1000);
	for (int i = 0; i < 4; i++) {
		gpiod_bench_expect(bench, BUTTON_UP, i % 2 == 0);
	}
	gpiod_bench_expect_nothing(bench);
}

static void test_two_presses_between_two_frames_count(void **state)
{
	expect_two_presses(*state, fake_gpio_set);
}

static void test_real_time_stamps_are_accepted(void **state)
{
	expect_two_presses(*state, fake_gpio_set_real_time);
}

static void test_a_line_has_a_debounce_time_of_its_own(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench,
		"gpiod:UP=53fd0000.gpio/18/debounce=200,DOWN=53fd0000.gpio/19/debounce=1");
	for (int i = 0; i < 3; i++) {
		fake_gpio_set(gpiod_bench_wire(bench, 18), i % 2 == 0,
			300000 - i * 50000);
		fake_gpio_set(gpiod_bench_wire(bench, 19), i % 2 == 0,
			290000 - i * 2000);
	}
	buttons_poll(&bench->buttons, 1000);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	gpiod_bench_expect(bench, BUTTON_DOWN, true);
	gpiod_bench_expect(bench, BUTTON_DOWN, false);
	gpiod_bench_expect(bench, BUTTON_DOWN, true);
	gpiod_bench_expect_nothing(bench);
}

static void test_edges_of_several_lines_are_sorted_by_time(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench,
		"gpiod:UP=53fd0000.gpio/18,DOWN=53fd0000.gpio/19,LEFT=53fd0000.gpio/20");
	fake_gpio_set(gpiod_bench_wire(bench, 18), true, 100000);
	fake_gpio_set(gpiod_bench_wire(bench, 18), false, 20000);
	fake_gpio_set(gpiod_bench_wire(bench, 19), true, 200000);
	fake_gpio_set(gpiod_bench_wire(bench, 20), true, 50000);
	buttons_poll(&bench->buttons, 1000);
	gpiod_bench_expect(bench, BUTTON_DOWN, true);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	gpiod_bench_expect(bench, BUTTON_LEFT, true);
	gpiod_bench_expect(bench, BUTTON_UP, false);
}

static void test_after_lost_edges_the_level_counts(void **state)
{
	struct gpiod_bench *bench = *state;

	/* One edge more than the kernel buffers: the last one is lost. */
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	for (int i = 0; i < FAKE_EDGES + 1; i++) {
		fake_gpio_set(gpiod_bench_wire(bench, 18), i % 2 == 0,
			900000 - i * 50000);
	}
	assert_int_equal(gpiod_bench_wire(bench, 18)->edges, FAKE_EDGES);
	buttons_poll(&bench->buttons, 999);
	assert_true(bench->buttons.queue.down[BUTTON_UP]);
}

static void test_a_button_held_at_the_start_is_no_press(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_wire(bench, 18)->high = true;
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	buttons_poll(&bench->buttons, 1000);
	gpiod_bench_expect_nothing(bench);
	fake_gpio_set(gpiod_bench_wire(bench, 18), false, 1000);
	buttons_poll(&bench->buttons, 1100);
	gpiod_bench_expect_nothing(bench);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 18), BUTTON_UP);
}

/* One of them is held at the start: its release is not that of the others. */
static void test_a_button_is_up_when_the_last_of_its_lines_is(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_wire(bench, 18)->high = true;
	gpiod_bench_open(bench,
		"gpiod:UP=53fd0000.gpio/18,UP=53fd0000.gpio/19,UP=53fd0000.gpio/20");
	for (int line = 19; line <= 20; line++) {
		fake_gpio_set(gpiod_bench_wire(bench, line), true, 1000);
		buttons_poll(&bench->buttons, line * 100);
	}
	gpiod_bench_expect(bench, BUTTON_UP, true);
	for (int line = 18; line <= 19; line++) {
		fake_gpio_set(gpiod_bench_wire(bench, line), false, 1000);
		buttons_poll(&bench->buttons, 3000 + line * 100);
	}
	gpiod_bench_expect_nothing(bench);
	fake_gpio_set(gpiod_bench_wire(bench, 20), false, 1000);
	buttons_poll(&bench->buttons, 6000);
	gpiod_bench_expect(bench, BUTTON_UP, false);
}

static void test_a_line_that_refuses_is_named_with_the_reason(void **state)
{
	static const int errors[] = {EPERM, EINVAL, ENODEV};
	struct gpiod_bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(errors); i++) {
		gpiod_bench_wire(bench, 18)->error = errors[i];
		gpiod_bench_open(bench,
			"gpiod:UP=53fd0000.gpio/18,DOWN=53fd0000.gpio/19");
		gpiod_bench_expect_warning(bench,
			"gpiod:UP: line 18 of 53fd0000.gpio cannot be read",
			strerror(errors[i]));
		gpiod_bench_press(
			bench, gpiod_bench_wire(bench, 19), BUTTON_DOWN);
		buttons_close(&bench->buttons);
	}
	gpiod_bench_wire(bench, 18)->error = EINVAL;
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18/pull-up");
	gpiod_bench_expect_warning(bench, "line 18", "without pull-up");
}

static void test_a_taken_line_is_named_with_its_holder(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_wire(bench, 18)->holder = "phy-reset";
	gpiod_bench_open(
		bench, "gpiod:UP=53fd0000.gpio/18,DOWN=53fd0000.gpio/19");
	gpiod_bench_expect_warning(bench, "gpiod:UP: line 18 of 53fd0000.gpio",
		"taken by phy-reset");
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 19), BUTTON_DOWN);
}

static void test_a_missing_chip_lists_the_others(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench, "gpiod:UP=pca9555/1,DOWN=53fd0000.gpio/19");
	gpiod_bench_expect_warning(bench, "no chip is labelled pca9555",
		"53fa4000.gpio, 53fcc000.gpio, 53fd0000.gpio");
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 19), BUTTON_DOWN);
}

static void test_a_missing_line_is_named(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/32");
	gpiod_bench_expect_warning(bench, "gpiod:UP", "no line 32");
	buttons_close(&bench->buttons);
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/BELL");
	gpiod_bench_expect_warning(
		bench, "chip 53fd0000.gpio", "no line named BELL");
	buttons_close(&bench->buttons);
	gpiod_bench_open(bench, "gpiod:UP=BELL");
	gpiod_bench_expect_warning(bench, "this machine", "no line named BELL");
}

static void test_no_chips_are_logged_once(void **state)
{
	struct gpiod_bench *bench = *state;

	for (int i = 0; i < FAKE_CHIPS; i++) {
		bench->gpio.chip[i].name = NULL;
	}
	gpiod_bench_open(
		bench, "gpiod:UP=53fd0000.gpio/18,DOWN=53fd0000.gpio/19");
	gpiod_bench_expect_warning(bench, "/dev/gpiochip*", "no GPIO chip");
	buttons_poll(&bench->buttons, 100);
	gpiod_bench_expect_nothing(bench);
}

static void test_no_permission_names_the_device(void **state)
{
	struct gpiod_bench *bench = *state;

	for (int i = 0; i < FAKE_CHIPS; i++) {
		bench->gpio.chip[i].error = EACCES;
	}
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	gpiod_bench_expect_warning(bench, "/dev/gpiochip2", "no permission");
}

static void test_losing_a_line_releases_its_button(void **state)
{
	struct gpiod_bench *bench = *state;

	gpiod_bench_open(
		bench, "gpiod:UP=53fd0000.gpio/18,DOWN=53fd0000.gpio/19");
	fake_gpio_set(gpiod_bench_wire(bench, 18), true, 0);
	buttons_poll(&bench->buttons, 100);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	fake_gpio_lose(gpiod_bench_wire(bench, 18));
	buttons_poll(&bench->buttons, 200);
	gpiod_bench_expect(bench, BUTTON_UP, false);
	gpiod_bench_expect_warning(bench, "gpiod:UP", "lost");
	buttons_poll(&bench->buttons, 300);
	assert_int_equal(bench->logged.count, 0);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 19), BUTTON_DOWN);
}

static void test_wrong_specs_are_refused(void **state)
{
	static const struct {
		const char *spec, *reason;
	} cases[] = {
		{"gpiod", "the lines are missing"},
		{"gpiod:", "the lines are missing"},
		{"gpiod:53fd0000.gpio/18", "give BUTTON="},
		{"gpiod:up=53fd0000.gpio/18", "no such button"},
		{"gpiod:UP=", "the line is missing"},
		{"gpiod:UP=18", "a number needs its chip"},
		{"gpiod:UP=active-low", "the line is missing"},
		{"gpiod:UP=53fd0000.gpio/18/pul-up", "give CHIP/LINE"},
		{"gpiod:UP=53fd0000.gpio/18/debounce=0", "debounce=MS"},
		{"gpiod:UP=53fd0000.gpio/18/debounce=9x", "debounce=MS"},
		{"gpiod:UP=53fd0000.gpio/18/debounce=1001", "debounce=MS"},
		{"gpiod:UP=53fd0000.gpio/18,DOWN=x/y/z/w", "give CHIP/LINE"},
	};
	struct gpiod_bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		bench->logged.count = 0;
		assert_int_equal(buttons_open(&bench->buttons, cases[i].spec,
					 &bench->log),
			-EINVAL);
		assert_int_equal(bench->logged.count, 1);
		assert_contains(bench->logged.sentence[0], cases[i].reason);
		assert_int_equal(
			buttons_check(cases[i].spec, &bench->log), -EINVAL);
	}
	assert_int_equal(buttons_check("gpiod:UP=a/1,DOWN=b/2", &bench->log), 0);
}

static void test_a_survey_reports_chips_lines_and_their_users(void **state)
{
	struct gpiod_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	bench->gpio.chip[1].error = EACCES;
	bench->gpio.chip[2].name = "gpiochip127";
	gpiod_bench_wire(bench, 3)->name = "K";
	gpiod_bench_wire(bench, 18)->holder = "";
	gpiod_bench_wire(bench, 20)->name = "LED";
	gpiod_bench_wire(bench, 20)->holder = "k";
	gpiod_survey(&survey);
	assert_int_equal(capture.count, 6);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/gpiochip0",
		"label 53fa4000.gpio, 32 lines, 0 of them used", NULL);
	survey_capture_expect(&capture, 1, SURVEY_BROKEN, "/dev/gpiochip1",
		"no permission", "root");
	survey_capture_expect(&capture, 2, SURVEY_WORKS, "/dev/gpiochip127",
		"label 53fd0000.gpio, 32 lines, 2 of them used", NULL);
	survey_capture_expect(
		&capture, 3, SURVEY_WORKS, "53fd0000.gpio/3", "K: free", NULL);
	survey_capture_expect(&capture, 4, SURVEY_TAKEN, "53fd0000.gpio/18",
		"line without a name: used by a driver", NULL);
	survey_capture_expect(&capture, 5, SURVEY_TAKEN, "53fd0000.gpio/20",
		"LED: used by k", NULL);
	assert_false(gpiod_bench_wire(bench, 3)->requested);
}

/* Nothing looks for a 129th chip. */
static void test_a_survey_without_chips_is_one_finding(void **state)
{
	struct gpiod_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	for (int i = 0; i < FAKE_CHIPS; i++) {
		bench->gpio.chip[i].name = i == 2 ? "gpiochip128" : NULL;
	}
	gpiod_survey(&survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/gpiochip*",
		"no GPIO chip", "CONFIG_GPIO_CDEV");
}

static void test_128_chips_are_looked_for(void **state)
{
	struct gpiod_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	struct gpio_output *output;

	bench->gpio.chip[2].name = "gpiochip127";
	gpiod_survey(&survey);
	survey_capture_expect(
		&capture, 2, SURVEY_WORKS, "/dev/gpiochip127", "label", NULL);
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 18), BUTTON_UP);
	buttons_close(&bench->buttons);
	output = gpio_output_open(
		"output led", "led", "gpiochip127/7", &bench->log);
	assert_non_null(output);
	gpio_output_close(output);
	bench->gpio.chip[2].name = "gpiochip128";
	output = gpio_output_open(
		"output led", "led", "53fd0000.gpio/7", &bench->log);
	gpiod_bench_expect_warning(
		bench, "output led", "no chip is labelled 53fd0000.gpio");
	gpio_output_close(output);
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	gpiod_bench_expect_warning(bench, "gpiod:UP", "no chip is labelled");
}

int gpiod_cases_run(void)
{
	const struct CMUnitTest tests[] = {
		GPIOD_CASE(test_a_line_is_found_by_label_and_offset),
		GPIOD_CASE(test_128_chips_are_looked_for),
		GPIOD_CASE(test_a_label_finds_its_chip_under_any_number),
		GPIOD_CASE(test_a_line_is_found_by_its_name),
		GPIOD_CASE(test_with_spaces_a_name_may_contain_slashes),
		GPIOD_CASE(test_bias_and_active_level_are_requested),
		GPIOD_CASE(test_a_bouncing_contact_counts_once),
		GPIOD_CASE(test_two_presses_between_two_frames_count),
		GPIOD_CASE(test_real_time_stamps_are_accepted),
		GPIOD_CASE(test_a_line_has_a_debounce_time_of_its_own),
		GPIOD_CASE(test_edges_of_several_lines_are_sorted_by_time),
		GPIOD_CASE(test_after_lost_edges_the_level_counts),
		GPIOD_CASE(test_a_button_held_at_the_start_is_no_press),
		GPIOD_CASE(test_a_button_is_up_when_the_last_of_its_lines_is),
		GPIOD_CASE(test_a_line_that_refuses_is_named_with_the_reason),
		GPIOD_CASE(test_a_taken_line_is_named_with_its_holder),
		GPIOD_CASE(test_a_missing_chip_lists_the_others),
		GPIOD_CASE(test_a_missing_line_is_named),
		GPIOD_CASE(test_no_chips_are_logged_once),
		GPIOD_CASE(test_no_permission_names_the_device),
		GPIOD_CASE(test_losing_a_line_releases_its_button),
		GPIOD_CASE(test_wrong_specs_are_refused),
		GPIOD_CASE(test_a_survey_reports_chips_lines_and_their_users),
		GPIOD_CASE(test_a_survey_without_chips_is_one_finding),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
