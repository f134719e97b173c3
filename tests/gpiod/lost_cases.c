/* Lines whose chips come and go while limber runs, and chips with few lines. */
#include "platform/base/compiler.h"
#include "platform/buttons/gpio_output.h"
#include "platform/buttons/gpiod/gpiod_survey.h"
#include "tests/gpiod/bench.h"
#include "tests/gpiod/cases.h"
#include "tests/support/button_events.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>

static void test_a_lost_line_works_again_when_its_chip_is_back(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_chip *chip = &bench->gpio.chip[2];

	gpiod_bench_open(
		bench, "gpiod:UP=53fd0000.gpio/18,DOWN=53fa4000.gpio/19");
	gpiod_bench_hold_up(bench);
	fake_gpio_lose(gpiod_bench_wire(bench, 18));
	chip->name = NULL;
	gpiod_bench_poll_at(bench, 200);
	gpiod_bench_expect(bench, BUTTON_UP, false);
	gpiod_bench_expect_warning(bench, "gpiod:UP", "lost");
	assert_int_equal(chip->opened, 0);
	for (int64_t now_ms = 300; now_ms < 9000; now_ms += 100) {
		gpiod_bench_poll_at(bench, now_ms);
	}
	assert_int_equal(bench->logged.count, 0);
	gpiod_bench_press(bench, &bench->gpio.chip[0].line[19], BUTTON_DOWN);

	gpiod_bench_wire(bench, 18)->gone = false;
	chip->name = "gpiochip5";
	gpiod_bench_poll_at(bench, bench->now_ms + 1000);
	gpiod_bench_expect_nothing(bench);
	assert_int_equal(bench->logged.count, 1);
	assert_string_equal(
		bench->logged.sentence[0], "gpiod:UP: its GPIO line is back");
	/* It is still held, which is no press. */
	fake_gpio_set(gpiod_bench_wire(bench, 18), false, 0);
	gpiod_bench_poll_at(bench, bench->now_ms + 100);
	gpiod_bench_expect_nothing(bench);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 18), BUTTON_UP);
	gpiod_bench_press(bench, &bench->gpio.chip[0].line[19], BUTTON_DOWN);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
}

static void test_a_chip_that_comes_later_is_used(void **state)
{
	struct gpiod_bench *bench = *state;

	for (int i = 0; i < FAKE_CHIPS; i++) {
		bench->gpio.chip[i].name = NULL;
	}
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18/debounce=30");
	gpiod_bench_expect_warning(bench, "/dev/gpiochip*", "yet");
	assert_int_equal(bench->buttons.queue.debounce_ms[BUTTON_UP], 30);
	gpiod_bench_poll_at(bench, 999);
	bench->gpio.chip[2].name = "gpiochip0";
	gpiod_bench_poll_at(bench, 1000);
	gpiod_bench_press(bench, gpiod_bench_wire(bench, 18), BUTTON_UP);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
}

/* As before Linux 6.2: nothing can be read, and poll() does not say why. */
static void test_a_chip_that_leaves_in_silence_is_noticed(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_open_up(bench);

	gpiod_bench_hold_up(bench);
	line->gone = true;
	gpiod_bench_poll_at(bench, 999);
	gpiod_bench_expect_nothing(bench);
	gpiod_bench_poll_at(bench, 1000);
	gpiod_bench_expect(bench, BUTTON_UP, false);
	gpiod_bench_expect_warning(bench, "gpiod:UP", "lost");
	line->gone = line->high = false;
	gpiod_bench_poll_at(bench, 2000);
	gpiod_bench_press(bench, line, BUTTON_UP);
}

/* Nothing may follow that makes the driver look at the line. */
static void test_a_missed_last_edge_is_made_up_for(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_open_up(bench);

	gpiod_bench_hold_up(bench);
	line->high = false;
	gpiod_bench_poll_at(bench, 999);
	gpiod_bench_expect_nothing(bench);
	gpiod_bench_poll_at(bench, 1000);
	gpiod_bench_expect(bench, BUTTON_UP, false);
	line->high = true;
	gpiod_bench_poll_at(bench, 1999);
	gpiod_bench_expect_nothing(bench);
	gpiod_bench_poll_at(bench, 2000);
	gpiod_bench_expect(bench, BUTTON_UP, true);
	line->high = false;
	gpiod_bench_poll_at(bench, 3000);
	gpiod_bench_expect(bench, BUTTON_UP, false);
	gpiod_bench_press(bench, line, BUTTON_UP);
	assert_int_equal(bench->logged.count, 0);
}

/* It is asked for once a second, not in every frame. */
static void test_a_taken_line_is_used_when_it_is_free(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 18);

	line->holder = "phy-reset";
	(void)gpiod_bench_open_up(bench);
	gpiod_bench_expect_warning(bench, "gpiod:UP", "taken by phy-reset");
	gpiod_bench_poll_at(bench, 1000);
	assert_false(line->requested);
	line->holder = NULL;
	gpiod_bench_poll_at(bench, 1999);
	assert_false(line->requested);
	gpiod_bench_poll_at(bench, 2000);
	gpiod_bench_press(bench, line, BUTTON_UP);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
}

/* Counted from the loss, and from the first poll for one that was never there. */
static void test_a_missing_line_is_looked_for_a_second_later(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 18);

	line->holder = "phy-reset";
	assert_int_equal(buttons_open(&bench->buttons,
				 "gpiod:UP=53fd0000.gpio/18", &bench->log),
		0);
	line->holder = NULL;
	gpiod_bench_poll_at(bench, 5000);
	gpiod_bench_poll_at(bench, 5999);
	assert_false(line->requested);
	gpiod_bench_poll_at(bench, 6000);
	assert_true(line->requested);
	gpiod_bench_poll_at(bench, 6900);
	/* Its chip is there again in the same poll. */
	fake_gpio_set(line, true, 0);
	line->read_error = ENODEV;
	gpiod_bench_poll_at(bench, 6950);
	assert_false(line->requested);
	gpiod_bench_poll_at(bench, 7949);
	assert_false(line->requested);
	gpiod_bench_poll_at(bench, 7950);
	assert_true(line->requested);
}

/* Such as by a signal. */
static void test_a_line_stays_when_nothing_can_be_read(void **state)
{
	static const int errors[] = {EAGAIN, EINTR};
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 18);

	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	for (int i = 0; i < 2; i++) {
		fake_gpio_set(line, i == 0, 0);
		line->read_error = errors[i];
		gpiod_bench_poll_at(bench, 100 + i * 200);
		gpiod_bench_expect_nothing(bench);
		gpiod_bench_poll_at(bench, 200 + i * 200);
		gpiod_bench_expect(bench, BUTTON_UP, i == 0);
	}
	assert_int_equal(bench->logged.count, 0);
}

/* Stamps from before then would come before events that are queued. */
static void test_an_edge_is_later_than_the_last_poll(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 18);

	assert_int_equal(buttons_open(&bench->buttons,
				 "gpiod:UP=53fd0000.gpio/18", &bench->log),
		0);
	fake_gpio_set(line, true, 900000);
	gpiod_bench_poll_at(bench, 5000);
	button_expect(&bench->buttons.queue, 5000, BUTTON_UP, true);
	gpiod_bench_poll_at(bench, 5300);
	fake_gpio_set(line, false, 900000);
	gpiod_bench_poll_at(bench, 5600);
	button_expect(&bench->buttons.queue, 5301, BUTTON_UP, false);
}

/* A name has one character at least, and numbers begin with 0. */
static void test_the_first_line_of_the_only_chip_is_found(void **state)
{
	static const char *const specs[] = {
		"gpiod:UP=c/0", "gpiod:UP=K", "gpiod:UP=c/K"};
	struct gpiod_bench *bench = *state;
	struct fake_chip *chip = &bench->gpio.chip[0];

	bench->gpio.chip[1].name = bench->gpio.chip[2].name = NULL;
	chip->label = "c";
	chip->line[0].name = "K";
	for (size_t i = 0; i < ARRAY_COUNT(specs); i++) {
		gpiod_bench_open(bench, specs[i]);
		assert_int_equal(bench->logged.count, 0);
		gpiod_bench_press(bench, &chip->line[0], BUTTON_UP);
		buttons_close(&bench->buttons);
		bench->now_ms = 0;
	}
	gpiod_bench_open(bench, "gpiod:UP=L");
	gpiod_bench_expect_warning(bench, "this machine", "no line named L");
	buttons_close(&bench->buttons);
	gpiod_bench_open(bench, "gpiod:UP=c/L");
	gpiod_bench_expect_warning(bench, "chip c", "no line named L");
	buttons_close(&bench->buttons);
	gpiod_bench_open(bench, "gpiod:UP=d/0");
	gpiod_bench_expect_warning(bench, "no chip is labelled d", "one of c");
	buttons_close(&bench->buttons);
	chip->line[0].holder = "k";
	gpiod_bench_open(bench, "gpiod:UP=c/0");
	gpiod_bench_expect_warning(bench, "line 0 of c", "taken by k");
}

static void test_an_output_may_be_the_first_line_but_none_behind_the_last(
	void **state)
{
	static const char *const lines[] = {"c/0", "K", "c/K"};
	static const struct {
		const char *line, *sentence;
	} missing[] = {{"c/4", "has no line 4"},
		{"d/0", "no chip is labelled d"}, {"L", "no line named L"},
		{"c/L", "no line named L"}, {"d/K", "no chip is labelled d"}};
	struct gpiod_bench *bench = *state;
	struct fake_chip *chip = &bench->gpio.chip[0];

	bench->gpio.chip[1].name = bench->gpio.chip[2].name = NULL;
	chip->label = "c";
	chip->lines = 4;
	chip->line[0].name = "K";
	for (size_t i = 0; i < ARRAY_COUNT(lines); i++) {
		struct gpio_output *output = gpio_output_open(
			"output led", "led", lines[i], &bench->log);

		assert_non_null(output);
		assert_true(chip->line[0].requested);
		gpio_output_close(output);
	}
	assert_int_equal(bench->logged.count, 0);
	for (size_t i = 0; i < ARRAY_COUNT(missing); i++) {
		gpio_output_close(gpio_output_open(
			"output led", "led", missing[i].line, &bench->log));
		gpiod_bench_expect_warning(
			bench, "output led", missing[i].sentence);
	}
}

static void test_a_survey_reports_small_and_broken_chips(void **state)
{
	struct gpiod_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	bench->gpio.chip[0].lines = 1;
	bench->gpio.chip[0].line[0].name = "K";
	bench->gpio.chip[0].line[0].holder = "k";
	bench->gpio.chip[1].error = EIO;
	bench->gpio.chip[2].lines = 2;
	gpiod_survey(&survey);
	assert_int_equal(capture.count, 4);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/gpiochip0",
		"1 line, 1 of them used", NULL);
	survey_capture_expect(&capture, 1, SURVEY_TAKEN, "53fa4000.gpio/0",
		"K: used by k", NULL);
	survey_capture_expect(&capture, 2, SURVEY_BROKEN, "/dev/gpiochip1",
		"does not answer as a GPIO chip", "CONFIG_GPIO_CDEV");
	survey_capture_expect(&capture, 3, SURVEY_WORKS, "/dev/gpiochip2",
		"2 lines, 0 of them used", NULL);
}

int gpiod_lost_cases_run(void)
{
	const struct CMUnitTest tests[] = {
		GPIOD_CASE(test_a_lost_line_works_again_when_its_chip_is_back),
		GPIOD_CASE(test_a_chip_that_comes_later_is_used),
		GPIOD_CASE(test_a_chip_that_leaves_in_silence_is_noticed),
		GPIOD_CASE(test_a_missed_last_edge_is_made_up_for),
		GPIOD_CASE(test_a_taken_line_is_used_when_it_is_free),
		GPIOD_CASE(test_a_missing_line_is_looked_for_a_second_later),
		GPIOD_CASE(test_a_line_stays_when_nothing_can_be_read),
		GPIOD_CASE(test_an_edge_is_later_than_the_last_poll),
		GPIOD_CASE(test_the_first_line_of_the_only_chip_is_found),
		GPIOD_CASE(
			test_an_output_may_be_the_first_line_but_none_behind_the_last),
		GPIOD_CASE(test_a_survey_reports_small_and_broken_chips),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
