/* Any events of three devices that come and go, against a reference. */
#include "platform/base/compiler.h"
#include "platform/buttons/button_batch.h"
#include "platform/buttons/evdev/decode.h"
#include "tests/support/fake/evdev_bench.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/input-event-codes.h>
#include <string.h>

static const struct {
	int code;
	enum button button; /* BUTTON_COUNT: none */
} keys[] = {
	{KEY_UP, BUTTON_UP},
	{KEY_KP8, BUTTON_UP},
	{KEY_LEFT, BUTTON_LEFT},
	{KEY_RIGHT, BUTTON_RIGHT}, /* in the same byte of the keys' bits */
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

/* The queue passes a change on if no other device holds the button. */
static void expect_change(struct evdev_bench *bench,
	struct reference *reference, int number, enum button button, bool down)
{
	if (reference->device[number].down[button] == down) {
		return;
	}
	reference->device[number].down[button] = down;
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		down = down || reference->device[i].down[button];
	}
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

static void test_a_button_is_up_when_the_last_keyboard_releases_it(void **state)
{
	struct evdev_bench *bench = *state;

	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		evdev_bench_plug_in(bench, i, "a keyboard", KEY_UP);
	}
	evdev_bench_open(bench, NULL);
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		evdev_bench_key(bench, i, KEY_UP, 1);
		evdev_bench_poll(bench);
	}
	evdev_bench_expect(bench, BUTTON_UP, true);
	/* The others may get its place in the driver's list. */
	evdev_bench_unplug(bench, 0);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 2, KEY_UP, 0);
	evdev_bench_poll(bench);
	evdev_bench_plug_in(bench, 0, "another keyboard", KEY_UP);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 0, KEY_UP, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
	evdev_bench_key(bench, 1, KEY_UP, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
}

/* The sticks of a gamepad send hundreds of events between two frames. */
static void test_a_press_behind_many_events_is_read_at_once(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 1, "a gamepad", BTN_DPAD_UP);
	evdev_bench_open(bench, NULL);
	for (int i = 0; i < 100; i++) {
		evdev_bench_send(bench, 1, EV_ABS, ABS_X, i);
	}
	evdev_bench_key(bench, 1, BTN_DPAD_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

static ssize_t read_for_ever(int fd, void *bytes, size_t size)
{
	(void)fd;
	memset(bytes, 0, size);
	return (ssize_t)size;
}

static void test_a_device_without_end_does_not_stop_the_frame_loop(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "a gamepad", BTN_DPAD_UP);
	evdev_bench_plug_in(bench, 1, "a keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_send(bench, 0, EV_ABS, ABS_X, 1);
	bench->system.read = read_for_ever;
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
}

/* Of 768 codes, 0 is none, and there may be more in other kernels. */
static void test_the_first_and_the_last_key_are_buttons_and_no_others(
	void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "odd keys", EVDEV_KEYS - 1);
	evdev_bench_open(bench, "UP=1,F9=767");
	evdev_bench_key(bench, 0, EVDEV_KEYS - 1, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_F9, true);
	for (int code = EVDEV_KEYS; code <= 0xffff;
		code += code < EVDEV_KEYS + 200 ? 1 : 1000) {
		evdev_bench_key(bench, 0, code, 1);
		evdev_bench_key(bench, 0, code, 0);
		evdev_bench_poll(bench);
		evdev_bench_expect_nothing(bench);
	}
	evdev_bench_key(bench, 0, 1, 1);
	evdev_bench_key(bench, 0, EVDEV_KEYS - 1, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_expect(bench, BUTTON_F9, false);
	evdev_bench_expect_nothing(bench);
}

/* What each device still has to deliver; one key, alternately up and down. */
static struct {
	const struct evdev_bench *bench;
	int left[EVDEV_BENCH_DEVICES];
	int kept[EVDEV_BENCH_DEVICES]; /* of them, those for later polls */
	int code[EVDEV_BENCH_DEVICES];
} flood;

static ssize_t read_flood(int fd, void *bytes, size_t size)
{
	uint16_t words[2] = {EV_KEY, 0};
	int number = 0;
	size_t at = 0;

	while (flood.bench->device[number].theirs != fd) {
		number++;
	}
	memset(bytes, 0, size);
	words[1] = (uint16_t)flood.code[number];
	for (; at < size && flood.left[number] > flood.kept[number];
		at += EVDEV_SIZE) {
		unsigned char *end = (unsigned char *)bytes + at + EVDEV_SIZE;
		int32_t value = --flood.left[number] % 2;

		memcpy(end - 8, words, sizeof(words));
		memcpy(end - 4, &value, sizeof(value));
	}
	return at > 0 ? (ssize_t)at : -EAGAIN;
}

/*
 * Two devices change more often between two polls than a batch holds. Whichever
 * they are, the third one's release must not be lost.
 */
static void test_no_device_takes_anothers_release(void **state)
{
	struct evdev_bench *bench = *state;

	flood.bench = bench;
	bench->system.read = read_flood;
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		evdev_bench_plug_in(bench, i, "keys", KEY_UP);
	}
	evdev_bench_open(bench, NULL);
	for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
		evdev_bench_key(bench, i, KEY_A, 1); /* poll() finds them all */
		flood.code[i] = KEY_UP;
		flood.left[i] = 0;
	}
	for (int quiet = 0; quiet < EVDEV_BENCH_DEVICES; quiet++) {
		struct button_event event;

		flood.code[quiet] = KEY_UP;
		flood.left[quiet] = 2;
		flood.kept[quiet] = 1;
		evdev_bench_poll(bench);
		assert_true(bench->queue.down[BUTTON_UP]);
		flood.kept[quiet] = 0;
		for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
			if (i != quiet) {
				flood.code[i] = KEY_LEFT;
				flood.left[i] = 3 * BUTTON_BATCH_CAPACITY;
			}
		}
		evdev_bench_poll(bench);
		assert_false(bench->queue.down[BUTTON_UP]);
		/* The rest of the others' events comes later, up to the last. */
		for (int i = 0; i < 12; i++) {
			evdev_bench_poll(bench);
		}
		for (int i = 0; i < EVDEV_BENCH_DEVICES; i++) {
			assert_int_equal(flood.left[i], 0);
		}
		assert_false(bench->queue.down[BUTTON_LEFT]);
		while (button_queue_pop(&bench->queue, &event)) {
		}
	}
}

static void tap_hidden(struct evdev_bench *bench, int number, int code)
{
	evdev_bench_key(bench, number, code, 1);
	evdev_bench_key(bench, number, code, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
}

/* Ctrl-Alt-F8 and Alt-LEFT switch consoles, on another keyboard, too. */
static void test_keys_with_ctrl_or_alt_are_no_buttons(void **state)
{
	static const int modifiers[] = {
		KEY_LEFTCTRL, KEY_RIGHTCTRL, KEY_LEFTALT, KEY_RIGHTALT};
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	evdev_bench_plug_in(bench, 1, "second", KEY_UP);
	evdev_bench_open(bench, NULL);
	for (size_t i = 0; i < ARRAY_COUNT(modifiers); i++) {
		evdev_bench_key(bench, 0, modifiers[i], 1);
		evdev_bench_poll(bench);
		tap_hidden(bench, 0, KEY_F8);
		tap_hidden(bench, 1, KEY_LEFT);
		/* It stays hidden when the modifier is released first. */
		evdev_bench_key(bench, 0, KEY_F8, 1);
		evdev_bench_key(bench, 0, modifiers[i], 0);
		evdev_bench_key(bench, 0, KEY_F8, 2);
		evdev_bench_poll(bench);
		evdev_bench_expect_nothing(bench);
		evdev_bench_key(bench, 0, KEY_F8, 0);
		evdev_bench_key(bench, 0, KEY_F8, 1);
		evdev_bench_poll(bench);
		evdev_bench_expect(bench, BUTTON_F8, true);
		/* A button that was down before stays a button. */
		evdev_bench_key(bench, 0, modifiers[i], 1);
		evdev_bench_poll(bench);
		evdev_bench_expect_nothing(bench);
		evdev_bench_key(bench, 0, KEY_F8, 0);
		evdev_bench_key(bench, 0, modifiers[i], 0);
		evdev_bench_poll(bench);
		evdev_bench_expect(bench, BUTTON_F8, false);
	}
}

static void test_after_lost_events_new_keys_with_alt_are_no_buttons(void **state)
{
	struct evdev_bench *bench = *state;
	uint8_t *down = bench->device[0].down;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_set_key(down, KEY_UP, true);
	evdev_bench_set_key(down, KEY_LEFTALT, true);
	evdev_bench_set_key(down, KEY_F6, true);
	evdev_bench_send(bench, 0, EV_SYN, SYN_DROPPED, 0);
	evdev_bench_send(bench, 0, EV_SYN, SYN_REPORT, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
	evdev_bench_key(bench, 0, KEY_UP, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
}

/* Its keyboard releases nothing more when it is unplugged. */
static void test_an_unplugged_keyboard_holds_no_modifier(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	evdev_bench_plug_in(bench, 1, "second", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_LEFTALT, 1);
	evdev_bench_poll(bench);
	tap_hidden(bench, 1, KEY_UP);
	evdev_bench_unplug(bench, 0);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 1, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

static void test_a_modifier_that_is_a_button_hides_nothing(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, "ENTER=KEY_LEFTCTRL");
	evdev_bench_key(bench, 0, KEY_LEFTCTRL, 1);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_ENTER, true);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(
			test_any_events_do_what_the_reference_does,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_button_is_up_when_the_last_keyboard_releases_it,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_press_behind_many_events_is_read_at_once,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_device_without_end_does_not_stop_the_frame_loop,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_the_first_and_the_last_key_are_buttons_and_no_others,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_no_device_takes_anothers_release,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_keys_with_ctrl_or_alt_are_no_buttons,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_after_lost_events_new_keys_with_alt_are_no_buttons,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_an_unplugged_keyboard_holds_no_modifier,
			evdev_bench_setup, evdev_bench_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_modifier_that_is_a_button_hides_nothing,
			evdev_bench_setup, evdev_bench_teardown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
