#include "platform/base/compiler.h"
#include "platform/buttons/evdev/decode.h"
#include "platform/buttons/event_time.h"
#include "tests/support/fake/evdev_bench.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void test_the_keypads_keys_are_the_buttons_of_their_names(void **state)
{
	static const struct {
		int code;
		enum button button;
	} keys[] = {
		{KEY_UP, BUTTON_UP},
		{KEY_DOWN, BUTTON_DOWN},
		{KEY_RIGHT, BUTTON_RIGHT},
		{KEY_LEFT, BUTTON_LEFT},
		{KEY_ENTER, BUTTON_ENTER},
		{KEY_F6, BUTTON_F6},
		{KEY_F8, BUTTON_F8},
		{KEY_F9, BUTTON_F9},
		{KEY_F10, BUTTON_F10},
		{KEY_KP8, BUTTON_UP},
		{KEY_KPENTER, BUTTON_ENTER},
	};
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "43fa8000.kpp", KEY_UP);
	evdev_bench_open(bench, NULL);
	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		evdev_bench_key(bench, 0, keys[i].code, 1);
		evdev_bench_poll(bench);
		evdev_bench_expect(bench, keys[i].button, true);
		evdev_bench_key(bench, 0, keys[i].code, 0);
		evdev_bench_poll(bench);
		evdev_bench_expect(bench, keys[i].button, false);
	}
	evdev_bench_key(bench, 0, KEY_A, 1);
	evdev_bench_send(bench, 0, EV_KEY, 0xffff, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
}

static void test_a_key_that_repeats_is_one_press(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, "");
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_key(bench, 0, KEY_UP, 2);
	evdev_bench_key(bench, 0, KEY_UP, 2);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_expect_nothing(bench);
}

static void test_a_device_that_is_plugged_in_later_works(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_open(bench, NULL);
	assert_int_equal(bench->logged.count, 1);
	assert_contains(bench->logged.sentence[0], "no keyboard or keypad");
	evdev_bench_plug_in(bench, 1, "keyboard", KEY_UP);
	evdev_bench_poll(bench);
	assert_true(bench->device[1].ours >= 0);
	evdev_bench_key(bench, 1, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

static ssize_t find_nothing(int fd, void *bytes, size_t size)
{
	(void)fd;
	(void)bytes;
	(void)size;
	return -EAGAIN;
}

static ssize_t be_interrupted(int fd, void *bytes, size_t size)
{
	(void)fd;
	(void)bytes;
	(void)size;
	return -EINTR;
}

static void test_a_device_stays_when_nothing_can_be_read(void **state)
{
	struct evdev_bench *bench = *state;
	ssize_t (*const reads[])(int, void *, size_t) = {
		find_nothing, be_interrupted};

	evdev_bench_plug_in(bench, 0, "keypad", KEY_UP);
	evdev_bench_open(bench, NULL);
	for (int i = 0; i < 2; i++) {
		ssize_t (*const usual)(int, void *, size_t) = bench->system.read;

		evdev_bench_key(bench, 0, KEY_UP, 1 - i);
		bench->system.read = reads[i];
		evdev_bench_poll(bench);
		evdev_bench_expect_nothing(bench);
		bench->system.read = usual;
		evdev_bench_poll(bench);
		evdev_bench_expect(bench, BUTTON_UP, i == 0);
	}
}

static void test_unplugging_a_device_releases_its_buttons(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	evdev_bench_plug_in(bench, 1, "second", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	bench->logged.count = 0;
	evdev_bench_unplug(bench, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 1);
	assert_contains(bench->logged.sentence[0], "first was unplugged");
	evdev_bench_key(bench, 1, KEY_DOWN, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_DOWN, true);
	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

static void test_a_folder_that_vanishes_is_watched_when_it_returns(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_open(bench, NULL);
	assert_int_equal(rmdir(bench->folder.text), 0);
	evdev_bench_poll(bench);
	assert_int_equal(mkdir(bench->folder.text, 0700), 0);
	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	/* It is looked for once a second. */
	for (int i = 0; i < 8; i++) {
		evdev_bench_poll(bench);
		assert_int_equal(bench->device[0].ours, -1);
	}
	evdev_bench_poll(bench);
	evdev_bench_poll(bench);
	assert_true(bench->device[0].ours >= 0);
	/* From then on a new device works at once. */
	evdev_bench_plug_in(bench, 1, "second", KEY_UP);
	evdev_bench_poll(bench);
	assert_true(bench->device[1].ours >= 0);
}

static void test_after_lost_events_the_keys_are_read_again(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_set_key(bench->device[0].down, KEY_F6, true);
	evdev_bench_send(bench, 0, EV_SYN, SYN_DROPPED, 0);
	evdev_bench_send(bench, 0, EV_KEY, KEY_LEFT, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
	evdev_bench_send(bench, 0, EV_SYN, SYN_REPORT, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
	evdev_bench_expect(bench, BUTTON_F6, true);
	evdev_bench_expect_nothing(bench);
	evdev_bench_key(bench, 0, KEY_F6, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_F6, false);
}

static void test_any_key_can_be_any_button(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_W);
	evdev_bench_open(bench, "UP=KEY_W,F9=0x1e,F6=KEY_F8");
	evdev_bench_key(bench, 0, KEY_W, 1);
	evdev_bench_key(bench, 0, KEY_A, 1);
	evdev_bench_key(bench, 0, KEY_F8, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_expect(bench, BUTTON_F9, true);
	evdev_bench_expect(bench, BUTTON_F6, true);
}

static void test_a_device_is_chosen_by_part_of_its_name(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "USB keyboard", KEY_UP);
	evdev_bench_plug_in(bench, 1, "43fa8000.kpp", KEY_UP);
	evdev_bench_open(bench, "kpp");
	assert_int_equal(log_capture_count(&bench->logged, LOG_WARNING), 0);
	evdev_bench_key(bench, 1, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	button_driver_evdev.destroy(bench->source);
	bench->logged.count = 0;
	evdev_bench_open(bench, "piano");
	assert_contains(bench->logged.sentence[0], "evdev:piano");
}

static void test_a_device_is_chosen_by_its_path_and_waited_for(void **state)
{
	struct evdev_bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "event2");

	evdev_bench_plug_in(bench, 0, "other", KEY_UP);
	evdev_bench_open(bench, path.text);
	assert_contains(bench->logged.sentence[0], "no such device yet");
	evdev_bench_plug_in(bench, 2, "wanted", KEY_UP);
	bench->now_ms += 1000;
	evdev_bench_poll(bench);
	assert_true(bench->device[2].ours >= 0);
	assert_true(bench->device[0].ours < 0);
	evdev_bench_key(bench, 2, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
}

static void test_a_device_that_fails_is_tried_once_a_second(void **state)
{
	struct evdev_bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "event0");

	evdev_bench_plug_in(bench, 0, "loose contact", KEY_UP);
	evdev_bench_open(bench, path.text);
	bench->now_ms += 5000;
	evdev_bench_poll(bench);
	bench->device[0].gone = true;
	close(bench->device[0].ours);
	bench->device[0].ours = -1;
	bench->logged.count = 0;
	evdev_bench_poll(bench);
	assert_contains(bench->logged.sentence[0], "was unplugged");
	for (int i = 0; i < 9; i++) {
		evdev_bench_poll(bench);
		assert_int_equal(bench->device[0].ours, -1);
	}
	evdev_bench_poll(bench);
	assert_true(bench->device[0].ours >= 0);
}

static void test_devices_without_a_mapped_key_are_not_opened(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "power button", KEY_POWER);
	evdev_bench_open(bench, NULL);
	assert_contains(bench->logged.sentence[0], "no keyboard or keypad");
}

static void test_a_missing_permission_is_logged_once(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	bench->device[0].error = EACCES;
	evdev_bench_plug_in(bench, 1, "keyboard", KEY_UP);
	bench->device[1].error = EACCES;
	evdev_bench_open(bench, NULL);
	evdev_bench_poll(bench);
	assert_int_equal(bench->logged.count, 1);
	assert_contains(bench->logged.sentence[0], "no permission");
}

static void test_wrong_arguments_are_refused(void **state)
{
	static const char *const cases[][2] = {
		{"up=KEY_W", "no such button"},
		{"UP=KEY_NOWHERE", "no such key"},
		{"UP=", "no such key"},
		{"UP=768", "no such key"},
		{"UP=0", "no such key"},
		{"UP=:", "no such key"},
		{"UP= 5", "no such key"},
	};
	struct evdev_bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		bench->logged.count = 0;
		assert_int_equal(
			button_driver_evdev.check(cases[i][0], &bench->log),
			-EINVAL);
		assert_contains(bench->logged.sentence[0], cases[i][1]);
	}
}

static void test_events_of_both_sizes_are_decoded(void **state)
{
	static const unsigned char narrow[EVDEV_SIZE_32] = {
		2, 0, 0, 0, 3, 0, 0, 0, 1, 0, 103, 0, 1, 0, 0, 0};
	static const unsigned char wide[EVDEV_SIZE_64] = {2, 0, 0, 0, 1, 0, 0, 0,
		3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0x60, 1, 0xff, 0xff, 0xff, 0xff};
	struct evdev_event event = evdev_decode(narrow, sizeof(narrow));

	(void)state;
	assert_int_equal(event.stamp_ns, 2000003000);
	assert_int_equal(event.type, EV_KEY);
	assert_int_equal(event.code, KEY_UP);
	assert_int_equal(event.value, 1);
	event = evdev_decode(wide, sizeof(wide));
	assert_true(event.stamp_ns == INT64_C(4294967298) * 1000000000 + 3000);
	assert_int_equal(event.code, KEY_OK);
	assert_int_equal(event.value, -1);
}

static void test_absurd_time_stamps_are_no_time(void **state)
{
	static const int64_t times[][2] = {{INT64_MAX, 0}, {INT64_MIN, 0},
		{INT64_C(9000000001), 0}, {-1, 999999}, {1, -1}, {1, 1000000},
		{0, INT64_MAX}};
	const struct event_clocks clocks = {INT64_C(5000000000), INT64_MAX};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(times); i++) {
		unsigned char bytes[EVDEV_SIZE_64] = {0};

		memcpy(bytes, times[i], sizeof(times[i]));
		assert_true(evdev_decode(bytes, sizeof(bytes)).stamp_ns < 0);
	}
	assert_int_equal(event_time_ms(&clocks, INT64_MIN, 1, 70), 70);
	assert_int_equal(event_time_ms(&clocks, -1, 1, 70), 70);
	assert_int_equal(event_time_ms(&clocks, INT64_C(4990000000), 1, 70), 60);
}

static void test_time_stamps_become_the_programs_time(void **state)
{
	const struct event_clocks clocks = {
		.monotonic_ns = INT64_C(50000000000),
		.real_ns = INT64_C(1700000000000000000),
	};
	const int64_t ms = 1000000;

	(void)state;
	assert_int_equal(
		event_time_ms(&clocks, clocks.monotonic_ns - 7 * ms, 900, 1000),
		993);
	assert_int_equal(
		event_time_ms(&clocks, clocks.real_ns - 7 * ms, 900, 1000), 993);
	assert_int_equal(event_time_ms(&clocks, clocks.monotonic_ns - 700 * ms,
				 900, 1000),
		900);
	assert_int_equal(
		event_time_ms(&clocks, clocks.monotonic_ns + 7 * ms, 900, 1000),
		1000);
	assert_int_equal(event_time_ms(&clocks, 0, 900, 1000), 1000);
}

/* Polls are far apart, so presses get the times of their stamps. */
static void test_a_press_has_the_time_of_its_stamp(void **state)
{
	struct evdev_bench *bench = *state;
	struct button_event down, up;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	bench->now_ms = 4900;
	bench->age_ms = 600;
	evdev_bench_key(bench, 0, KEY_UP, 1);
	bench->age_ms = 300;
	evdev_bench_key(bench, 0, KEY_UP, 0);
	evdev_bench_poll(bench);
	assert_true(button_queue_pop(&bench->queue, &down));
	assert_true(button_queue_pop(&bench->queue, &up));
	assert_true(down.down && !up.down);
	/* The test itself takes time, but no seconds. */
	assert_in_range(down.time_ms, 5000 - 600 - 3000, 5000 - 600);
	assert_in_range(up.time_ms, down.time_ms + 299, 5000 - 300);
}

static void test_a_survey_reports_which_keys_are_buttons(void **state)
{
	struct evdev_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	struct test_path locked;

	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "evdev",
		bench->folder.text, "modprobe evdev");
	evdev_bench_plug_in(bench, 0, "Keypad", KEY_F6);
	evdev_bench_set_key(bench->device[0].description.keys, KEY_KP8, true);
	evdev_bench_plug_in(bench, 1, "Mouse", BTN_LEFT);
	evdev_bench_plug_in(bench, 2, "Locked", KEY_UP);
	locked = path_join(&bench->folder, "event2");
	assert_int_equal(chmod(locked.text, 0600), 0);
	bench->device[2].error = EACCES;
	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 4);
	survey_capture_expect(
		&capture, 1, SURVEY_WORKS, "/event0", "Keypad: UP, F6", NULL);
	survey_capture_expect(&capture, 2, SURVEY_UNUSED, "/event1",
		"Mouse: no key is mapped to a button", ",UP=KEY");
	survey_capture_expect(
		&capture, 3, SURVEY_BROKEN, "/event2", "no permission", "root");
}

static int devices_denied;

static int deny(const char *path)
{
	char name[32];

	snprintf(name, sizeof(name), "/event%d", devices_denied++);
	assert_contains(path, name);
	return -EPERM;
}

static void ignore_finding(void *user, const struct survey_finding *finding)
{
	(void)user;
	assert_contains(finding->text, "no permission");
}

static void test_a_survey_tries_256_devices(void **state)
{
	struct evdev_bench *bench = *state;
	struct evdev_system system = bench->system;
	const struct survey survey = {.take = ignore_finding};

	system.open = deny;
	devices_denied = 0;
	evdev_survey_on(&system, &survey);
	assert_int_equal(devices_denied, 256);
}

int main(void)
{
#define CASE(name)                       \
	cmocka_unit_test_setup_teardown( \
		name, evdev_bench_setup, evdev_bench_teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_the_keypads_keys_are_the_buttons_of_their_names),
		CASE(test_a_key_that_repeats_is_one_press),
		CASE(test_a_device_that_is_plugged_in_later_works),
		CASE(test_a_device_stays_when_nothing_can_be_read),
		CASE(test_unplugging_a_device_releases_its_buttons),
		CASE(test_a_folder_that_vanishes_is_watched_when_it_returns),
		CASE(test_after_lost_events_the_keys_are_read_again),
		CASE(test_any_key_can_be_any_button),
		CASE(test_a_device_is_chosen_by_part_of_its_name),
		CASE(test_a_device_is_chosen_by_its_path_and_waited_for),
		CASE(test_a_device_that_fails_is_tried_once_a_second),
		CASE(test_devices_without_a_mapped_key_are_not_opened),
		CASE(test_a_missing_permission_is_logged_once),
		CASE(test_wrong_arguments_are_refused),
		cmocka_unit_test(test_events_of_both_sizes_are_decoded),
		cmocka_unit_test(test_absurd_time_stamps_are_no_time),
		cmocka_unit_test(test_time_stamps_become_the_programs_time),
		CASE(test_a_press_has_the_time_of_its_stamp),
		CASE(test_a_survey_reports_which_keys_are_buttons),
		CASE(test_a_survey_tries_256_devices),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
