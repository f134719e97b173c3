/* Lines that are driven, and that may be lost. */
#include "platform/buttons/gpio_output.h"
#include "tests/gpiod/bench.h"
#include "tests/gpiod/cases.h"
#include "tests/support/test.h"

#include <errno.h>

static struct gpio_output *open_led(struct gpiod_bench *bench, const char *line)
{
	struct gpio_output *output =
		gpio_output_open("output led", "led", line, &bench->log);

	assert_non_null(output);
	return output;
}

static void test_an_output_is_driven_and_given_back(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 7);
	struct gpio_output *output;

	line->high = true;
	output = open_led(bench, "53fd0000.gpio/7/active-low");
	assert_true(line->requested && !line->input && line->high);
	assert_string_equal(line->consumer, "limber led");
	gpio_output_set(output, true);
	assert_false(line->high);
	gpio_output_set(output, false);
	gpio_output_set(output, true);
	gpio_output_check_all(&output, 1);
	gpio_output_close(output);
	assert_true(line->high);
	assert_int_equal(line->changes, 4);
	assert_int_equal(bench->logged.count, 0);
}

static void test_a_taken_output_is_driven_when_it_is_free(void **state)
{
	struct gpiod_bench *bench = *state;
	struct fake_line *line = gpiod_bench_wire(bench, 7);
	struct gpio_output *output;

	line->holder = "heartbeat";
	output = open_led(bench, "gpiochip2/7");
	gpiod_bench_expect_warning(bench, "output led: line 7 of 53fd0000.gpio",
		"taken by heartbeat");
	gpio_output_set(output, true);
	gpio_output_check_all(&output, 1);
	assert_false(line->requested || line->high);
	line->holder = NULL;
	gpio_output_check_all(&output, 1);
	assert_true(line->requested && line->high);
	gpio_output_close(output);
	assert_false(line->high);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
}

static void test_an_output_that_cannot_be_had_is_a_warning(void **state)
{
	struct gpiod_bench *bench = *state;

	gpio_output_close(open_led(bench, "gpiochip9/7"));
	gpiod_bench_expect_warning(
		bench, "output led", "no chip is labelled gpiochip9");
	gpio_output_close(open_led(bench, "gpiochip2/99"));
	gpiod_bench_expect_warning(bench, "output led", "has no line 99");
	gpiod_bench_wire(bench, 7)->error = EINVAL;
	gpio_output_close(open_led(bench, "gpiochip2/7"));
	gpiod_bench_expect_warning(
		bench, "output led: line 7 of", "cannot be driven");
	for (int i = 0; i < FAKE_CHIPS; i++) {
		bench->gpio.chip[i].name = NULL;
	}
	gpio_output_close(open_led(bench, "gpiochip2/7"));
	gpiod_bench_expect_warning(bench, "output led: no GPIO chip",
		"it works when there is one");
}

static void test_wrong_texts_of_outputs_are_refused(void **state)
{
	struct gpiod_bench *bench = *state;

	assert_int_equal(gpio_output_check("gpiochip0/18", &bench->log), 0);
	assert_int_equal(gpio_output_check("18", &bench->log), -EINVAL);
	assert_contains(
		bench->logged.sentence[0], "18: a number needs its chip");
	assert_null(gpio_output_open("output led", "led", "18", &bench->log));
	gpio_output_set(NULL, true);
	gpio_output_close(NULL);
}

/* Drives an LED through the loss and the return of its chip. */
static void lose_and_find(
	struct gpiod_bench *bench, bool on, bool set_while_gone)
{
	struct fake_chip *chip = &bench->gpio.chip[2];
	struct fake_line *line = gpiod_bench_wire(bench, 7);
	struct gpio_output *outputs[3] = {NULL};

	outputs[0] = open_led(bench, "53fa4000.gpio/3");
	outputs[2] = open_led(bench, "53fd0000.gpio/7");
	gpio_output_set(outputs[2], set_while_gone ? !on : on);
	line->gone = true;
	chip->name = NULL;
	if (set_while_gone) {
		gpio_output_set(outputs[2], on);
	}
	gpio_output_check_all(outputs, 3);
	gpiod_bench_expect_warning(bench, "output led", "lost its GPIO line");
	assert_int_equal(chip->opened, 0);
	gpio_output_check_all(outputs, 3);
	assert_int_equal(bench->logged.count, 0);

	/* A chip that was plugged in again drives nothing. */
	line->gone = line->high = false;
	chip->name = "gpiochip5";
	gpio_output_check_all(outputs, 3);
	assert_true(line->requested);
	assert_int_equal(line->high, on);
	assert_true(log_capture_has(&bench->logged, LOG_NOTE, "is back"));
	gpio_output_set(outputs[2], !on);
	assert_int_equal(line->high, !on);
	gpio_output_set(outputs[2], on);
	gpio_output_close(outputs[0]);
	gpio_output_close(outputs[2]);
	assert_false(line->high);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
	bench->logged.count = 0;
	chip->name = "gpiochip2";
}

static void test_a_lost_output_is_driven_again_when_it_is_back(void **state)
{
	lose_and_find(*state, true, false);
	lose_and_find(*state, false, false);
}

static void test_an_output_that_is_set_while_lost_takes_that_state(void **state)
{
	lose_and_find(*state, true, true);
	lose_and_find(*state, false, true);
}

int gpiod_output_cases_run(void)
{
	const struct CMUnitTest tests[] = {
		GPIOD_CASE(test_an_output_is_driven_and_given_back),
		GPIOD_CASE(test_a_taken_output_is_driven_when_it_is_free),
		GPIOD_CASE(test_an_output_that_cannot_be_had_is_a_warning),
		GPIOD_CASE(test_wrong_texts_of_outputs_are_refused),
		GPIOD_CASE(test_a_lost_output_is_driven_again_when_it_is_back),
		GPIOD_CASE(
			test_an_output_that_is_set_while_lost_takes_that_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
