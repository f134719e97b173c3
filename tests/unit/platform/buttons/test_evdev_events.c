/* Any events of three devices that come and go, against a reference. */
#include "platform/base/compiler.h"
#include "tests/support/fake/evdev_bench.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <linux/input-event-codes.h>
#include <string.h>

static const struct {
	int code;
	enum button button; /* BUTTON_COUNT: none */
} keys[] = {
	{KEY_UP, BUTTON_UP},
	{KEY_KP8, BUTTON_UP},
	{KEY_LEFT, BUTTON_LEFT},
	{KEY_F10, BUTTON_F10},
	{KEY_A, BUTTON_COUNT},
};

struct reference {
	struct {
		bool plugged, dropped;
		bool held[ARRAY_COUNT(keys)];
		bool down[BUTTON_COUNT];
	} device[EVDEV_BENCH_DEVICES];
	bool shown[BUTTON_COUNT]; /* by the queue */
};

/* The queue passes a change on unless the button already is as it says. */
static void expect_change(struct evdev_bench *bench,
	struct reference *reference, int number, enum button button, bool down)
{
	if (reference->device[number].down[button] == down) {
		return;
	}
	reference->device[number].down[button] = down;
	if (reference->shown[button] != down) {
		reference->shown[button] = down;
		evdev_bench_expect(bench, button, down);
	}
}

static void press_any(struct evdev_bench *bench, struct reference *reference,
	int number, uint32_t *seed)
{
	int key = random_between(seed, 0, (int)ARRAY_COUNT(keys) - 1);
	int value = random_between(seed, 0, 2); /* 2 repeats */

	evdev_bench_send(bench, number, EV_KEY, keys[key].code, value);
	evdev_bench_poll(bench);
	if (!reference->device[number].dropped && value < 2 &&
		keys[key].button != BUTTON_COUNT) {
		bool *held = reference->device[number].held;

		held[key] = value;
		/* The first two keys are one button. */
		expect_change(bench, reference, number, keys[key].button,
			key < 2 ? held[0] || held[1] : value);
	}
}

/* Events were lost: the next report tells to ask which keys are down. */
static void drop(
	struct evdev_bench *bench, struct reference *reference, int number)
{
	evdev_bench_send(bench, number, EV_SYN, SYN_DROPPED, 0);
	evdev_bench_poll(bench);
	reference->device[number].dropped = true;
}

static void report(struct evdev_bench *bench, struct reference *reference,
	int number, uint32_t *seed)
{
	bool down[BUTTON_COUNT + 1] = {false};
	bool all[ARRAY_COUNT(keys)];

	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		bool held = random_one_in(seed, 2);

		all[i] = held;
		evdev_bench_set_key(
			bench->device[number].down, keys[i].code, held);
		down[keys[i].button] = down[keys[i].button] || held;
	}
	evdev_bench_send(bench, number, EV_SYN, SYN_REPORT, 0);
	evdev_bench_poll(bench);
	if (!reference->device[number].dropped) {
		return;
	}
	reference->device[number].dropped = false;
	memcpy(reference->device[number].held, all, sizeof(all));
	for (int i = 0; i < BUTTON_COUNT; i++) {
		expect_change(bench, reference, number, (enum button)i, down[i]);
	}
}

static void unplug(
	struct evdev_bench *bench, struct reference *reference, int number)
{
	bench->logged.count = 0;
	evdev_bench_unplug(bench, number);
	evdev_bench_poll(bench);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 1);
	for (int i = 0; i < BUTTON_COUNT; i++) {
		expect_change(bench, reference, number, (enum button)i, false);
	}
	reference->device[number].plugged = false;
}

static void plug_in(
	struct evdev_bench *bench, struct reference *reference, int number)
{
	evdev_bench_plug_in(bench, number, "any keys", KEY_UP);
	evdev_bench_poll(bench);
	assert_true(bench->device[number].ours >= 0);
	memset(&reference->device[number], 0, sizeof(reference->device[number]));
	reference->device[number].plugged = true;
}

static void test_any_events_do_what_the_reference_does(void **state)
{
	struct evdev_bench *bench = *state;
	struct reference reference = {0};
	uint32_t seed = 1;

	evdev_bench_open(bench, NULL);
	for (int step = 0; step < 3000; step++) {
		int number = random_between(&seed, 0, EVDEV_BENCH_DEVICES - 1);
		int choice = random_between(&seed, 0, 19);

		if (!reference.device[number].plugged) {
			plug_in(bench, &reference, number);
		} else if (choice == 0) {
			unplug(bench, &reference, number);
		} else if (choice < 3) {
			drop(bench, &reference, number);
		} else if (choice < 6) {
			report(bench, &reference, number, &seed);
		} else {
			press_any(bench, &reference, number, &seed);
		}
		evdev_bench_expect_nothing(bench);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(
			test_any_events_do_what_the_reference_does,
			evdev_bench_setup, evdev_bench_teardown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
