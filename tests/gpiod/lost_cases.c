/* Lines whose chips come and go while limber runs. */
#include "tests/gpiod/bench.h"
#include "tests/gpiod/cases.h"
#include "tests/support/test.h"

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

int gpiod_lost_cases_run(void)
{
	const struct CMUnitTest tests[] = {
		GPIOD_CASE(test_a_lost_line_works_again_when_its_chip_is_back),
		GPIOD_CASE(test_a_chip_that_comes_later_is_used),
		GPIOD_CASE(test_a_chip_that_leaves_in_silence_is_noticed),
		GPIOD_CASE(test_a_missed_last_edge_is_made_up_for),
		GPIOD_CASE(test_a_taken_line_is_used_when_it_is_free),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
