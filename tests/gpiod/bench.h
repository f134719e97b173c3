/*
 * A machine for the tests of the gpiod driver: simulated chips, the buttons on
 * them, and what was logged.
 */
#ifndef TESTS_GPIOD_BENCH_H
#define TESTS_GPIOD_BENCH_H

#include "platform/buttons/buttons.h"
#include "tests/gpiod/fake.h"
#include "tests/support/log_capture.h"

/* The chips of a machine and the buttons on them. */
struct gpiod_bench {
	struct fake_gpio gpio;
	struct log_capture logged;
	struct log log;
	struct buttons buttons;
	int64_t now_ms;
};

/* For cmocka: the state is a struct gpiod_bench. */
int gpiod_bench_setup(void **state);
int gpiod_bench_teardown(void **state);

/* A member of the list of tests. */
#define GPIOD_CASE(name)                 \
	cmocka_unit_test_setup_teardown( \
		name, gpiod_bench_setup, gpiod_bench_teardown)

/* Opens buttons, which must succeed. */
void gpiod_bench_open(struct gpiod_bench *bench, const char *spec);

/* Opens a button UP on line 18 of gpio2. Returns the line. */
struct fake_line *gpiod_bench_open_up(struct gpiod_bench *bench);

/* A line of gpio2, the third chip. */
struct fake_line *gpiod_bench_wire(struct gpiod_bench *bench, int offset);

/* Polls the buttons at that time. */
void gpiod_bench_poll_at(struct gpiod_bench *bench, int64_t now_ms);

/* Presses UP, 100 ms after the start, and expects that. It stays down. */
void gpiod_bench_hold_up(struct gpiod_bench *bench);

/* Fails the test unless this is the next event, or there is none. */
void gpiod_bench_expect(
	struct gpiod_bench *bench, enum button button, bool down);
void gpiod_bench_expect_nothing(struct gpiod_bench *bench);

/* Fails the test unless one warning with these parts was logged. */
void gpiod_bench_expect_warning(
	struct gpiod_bench *bench, const char *what, const char *why);

/* Fails the test unless pressing and releasing the line is the button's. */
void gpiod_bench_press(
	struct gpiod_bench *bench, struct fake_line *line, enum button button);

#endif
