#include "tests/gpiod/bench.h"

#include "tests/support/test.h"

#include <stdlib.h>

int gpiod_bench_setup(void **state)
{
	struct gpiod_bench *bench = calloc(1, sizeof(*bench));

	assert_non_null(bench);
	fake_gpio_begin(&bench->gpio);
	bench->log = log_capture_begin(&bench->logged);
	*state = bench;
	return 0;
}

int gpiod_bench_teardown(void **state)
{
	struct gpiod_bench *bench = *state;

	buttons_close(&bench->buttons);
	fake_gpio_end(&bench->gpio);
	free(bench);
	return 0;
}

void gpiod_bench_open(struct gpiod_bench *bench, const char *spec)
{
	assert_int_equal(buttons_open(&bench->buttons, spec, &bench->log), 0);
	buttons_poll(&bench->buttons, 0);
}

struct fake_line *gpiod_bench_open_up(struct gpiod_bench *bench)
{
	gpiod_bench_open(bench, "gpiod:UP=53fd0000.gpio/18");
	return gpiod_bench_wire(bench, 18);
}

void gpiod_bench_poll_at(struct gpiod_bench *bench, int64_t now_ms)
{
	bench->now_ms = now_ms;
	buttons_poll(&bench->buttons, now_ms);
}

void gpiod_bench_hold_up(struct gpiod_bench *bench)
{
	fake_gpio_set(gpiod_bench_wire(bench, 18), true, 0);
	gpiod_bench_poll_at(bench, 100);
	gpiod_bench_expect(bench, BUTTON_UP, true);
}

struct fake_line *gpiod_bench_wire(struct gpiod_bench *bench, int offset)
{
	return &bench->gpio.chip[2].line[offset];
}

void gpiod_bench_expect(struct gpiod_bench *bench, enum button button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(&bench->buttons.queue, &event));
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
	assert_int_equal(event.holder, 0);
}

void gpiod_bench_expect_nothing(struct gpiod_bench *bench)
{
	struct button_event event;

	assert_false(button_queue_pop(&bench->buttons.queue, &event));
}

void gpiod_bench_expect_warning(
	struct gpiod_bench *bench, const char *what, const char *why)
{
	assert_int_equal(bench->logged.count, 1);
	assert_int_equal(bench->logged.level[0], LOG_WARNING);
	assert_contains(bench->logged.sentence[0], what);
	assert_contains(bench->logged.sentence[0], why);
	bench->logged.count = 0;
}

void gpiod_bench_press(
	struct gpiod_bench *bench, struct fake_line *line, enum button button)
{
	fake_gpio_set(line, true, 2000);
	bench->now_ms += 1000;
	buttons_poll(&bench->buttons, bench->now_ms);
	gpiod_bench_expect(bench, button, true);
	fake_gpio_set(line, false, 2000);
	bench->now_ms += 1000;
	buttons_poll(&bench->buttons, bench->now_ms);
	gpiod_bench_expect(bench, button, false);
	gpiod_bench_expect_nothing(bench);
}
