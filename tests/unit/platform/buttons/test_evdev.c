/* The evdev driver on devices that are sockets in a folder of their own. */
#include "platform/base/compiler.h"
#include "platform/buttons/buttons.h"
#include "platform/buttons/evdev/decode.h"
#include "platform/buttons/evdev/system.h"
#include "platform/buttons/event_time.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

extern const struct button_driver button_driver_evdev;

enum {
	PLUGS = 3
};

/* event0 to event2 of the folder, where they are plugged in. */
struct plug {
	int ours, theirs; /* -1: not open */
	int error;        /* of opening it, or of reading when it is gone */
	bool gone;
	struct evdev_description description;
	uint8_t down[EVDEV_KEY_BYTES];
};

struct bench {
	struct test_path folder;
	struct evdev_system system;
	struct plug plug[PLUGS];
	struct log_capture said;
	struct log log;
	struct button_source *source;
	struct button_queue queue;
	int64_t now_ms;
};

/* The system's functions are given no context. */
static struct bench *bench_now;

static struct plug *plug_of(int fd)
{
	for (int i = 0; i < PLUGS; i++) {
		if (bench_now->plug[i].theirs == fd) {
			return &bench_now->plug[i];
		}
	}
	return NULL;
}

static int open_plug(const char *path)
{
	const char *number = strrchr(path, '/') + 6;
	int pair[2];
	struct plug *plug;

	if (access(path, F_OK) < 0) {
		return -errno;
	}
	plug = &bench_now->plug[atoi(number)];
	if (plug->error) {
		return -plug->error;
	}
	assert_int_equal(socketpair(AF_UNIX, SOCK_STREAM, 0, pair), 0);
	assert_int_equal(fcntl(pair[1], F_SETFL, O_NONBLOCK), 0);
	plug->ours = pair[0];
	plug->theirs = pair[1];
	return pair[1];
}

static int describe_plug(int fd, struct evdev_description *out)
{
	*out = plug_of(fd)->description;
	return 0;
}

static int keys_down_plug(int fd, uint8_t bits[EVDEV_KEY_BYTES])
{
	memcpy(bits, plug_of(fd)->down, EVDEV_KEY_BYTES);
	return 0;
}

static ssize_t read_plug(int fd, void *bytes, size_t size)
{
	ssize_t count;

	if (plug_of(fd)->gone) {
		return -ENODEV;
	}
	count = read(fd, bytes, size);
	return count < 0 ? -errno : count;
}

static void set_bit(uint8_t *bits, int code, bool on)
{
	bits[code / 8] =
		(uint8_t)((bits[code / 8] & ~(1 << code % 8)) | on << code % 8);
}

static void plug_in(struct bench *bench, int number, const char *name, int key)
{
	char file[16];
	struct test_path path;
	struct plug *plug = &bench->plug[number];

	*plug = (struct plug){.ours = -1, .theirs = -1, .error = plug->error};
	snprintf(plug->description.name, sizeof(plug->description.name), "%s",
		name);
	set_bit(plug->description.keys, key, true);
	snprintf(file, sizeof(file), "event%d", number);
	path = path_join(&bench->folder, file);
	file_write(path.text, "", 0);
}

static void pull_out(struct bench *bench, int number)
{
	char file[16];
	struct test_path path;

	snprintf(file, sizeof(file), "event%d", number);
	path = path_join(&bench->folder, file);
	assert_int_equal(unlink(path.text), 0);
	bench->plug[number].gone = true;
	close(bench->plug[number].ours);
	bench->plug[number].ours = -1;
}

static int setup(void **state)
{
	struct bench *bench = calloc(1, sizeof(*bench));

	assert_non_null(bench);
	bench->folder = temp_dir_make();
	bench->system = (struct evdev_system){
		.directory = bench->folder.text,
		.open = open_plug,
		.describe = describe_plug,
		.keys_down = keys_down_plug,
		.read = read_plug,
	};
	for (int i = 0; i < PLUGS; i++) {
		bench->plug[i].ours = bench->plug[i].theirs = -1;
	}
	bench->log = log_capture_begin(&bench->said);
	button_queue_init(&bench->queue, 8);
	bench_now = bench;
	*state = bench;
	return 0;
}

static int teardown(void **state)
{
	struct bench *bench = *state;

	button_driver_evdev.destroy(bench->source);
	for (int i = 0; i < PLUGS; i++) {
		if (bench->plug[i].ours >= 0) {
			close(bench->plug[i].ours);
		}
	}
	temp_dir_remove(&bench->folder);
	free(bench);
	return 0;
}

static void begin(struct bench *bench, const char *argument)
{
	assert_int_equal(evdev_create_on(&bench->system, argument, &bench->log,
				 &bench->source),
		0);
	button_driver_evdev.poll(bench->source, 0, &bench->queue);
}

static void look(struct bench *bench)
{
	bench->now_ms += 100;
	button_driver_evdev.poll(bench->source, bench->now_ms, &bench->queue);
	button_queue_settle(&bench->queue, bench->now_ms);
}

static void send_event(
	struct bench *bench, int number, int type, int code, int value)
{
	unsigned char bytes[EVDEV_SIZE];
	struct event_clocks clocks = event_clocks_now();
	long time[2] = {(long)(clocks.monotonic_ns / 1000000000),
		(long)(clocks.monotonic_ns % 1000000000 / 1000)};
	uint16_t words[2] = {(uint16_t)type, (uint16_t)code};
	int32_t number_value = value;

	memcpy(bytes, time, sizeof(time));
	memcpy(bytes + sizeof(time), words, sizeof(words));
	memcpy(bytes + sizeof(time) + 4, &number_value, 4);
	assert_int_equal(write(bench->plug[number].ours, bytes, sizeof(bytes)),
		sizeof(bytes));
}

static void key(struct bench *bench, int number, int code, int value)
{
	send_event(bench, number, EV_KEY, code, value);
	send_event(bench, number, EV_SYN, SYN_REPORT, 0);
}

static void expect(struct bench *bench, enum button button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(&bench->queue, &event));
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
}

static void expect_nothing(struct bench *bench)
{
	struct button_event event;

	assert_false(button_queue_pop(&bench->queue, &event));
}

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
	struct bench *bench = *state;

	plug_in(bench, 0, "43fa8000.kpp", KEY_UP);
	begin(bench, NULL);
	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		key(bench, 0, keys[i].code, 1);
		look(bench);
		expect(bench, keys[i].button, true);
		key(bench, 0, keys[i].code, 0);
		look(bench);
		expect(bench, keys[i].button, false);
	}
	key(bench, 0, KEY_A, 1);
	send_event(bench, 0, EV_KEY, 0xffff, 1);
	look(bench);
	expect_nothing(bench);
}

static void test_a_key_that_repeats_is_one_press(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "keyboard", KEY_UP);
	begin(bench, "");
	key(bench, 0, KEY_UP, 1);
	key(bench, 0, KEY_UP, 2);
	key(bench, 0, KEY_UP, 2);
	look(bench);
	expect(bench, BUTTON_UP, true);
	expect_nothing(bench);
}

static void test_a_device_that_comes_later_works(void **state)
{
	struct bench *bench = *state;

	begin(bench, NULL);
	assert_int_equal(bench->said.count, 1);
	assert_contains(bench->said.sentence[0], "no keyboard or keypad");
	plug_in(bench, 1, "keyboard", KEY_UP);
	look(bench);
	assert_true(bench->plug[1].ours >= 0);
	key(bench, 1, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
}

static void test_a_device_that_goes_lets_its_buttons_go(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "first", KEY_UP);
	plug_in(bench, 1, "second", KEY_UP);
	begin(bench, NULL);
	key(bench, 0, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
	bench->said.count = 0;
	pull_out(bench, 0);
	look(bench);
	expect(bench, BUTTON_UP, false);
	assert_int_equal(log_capture_count(&bench->said, LOG_WARNING), 1);
	assert_contains(bench->said.sentence[0], "first is gone");
	key(bench, 1, KEY_DOWN, 1);
	look(bench);
	expect(bench, BUTTON_DOWN, true);
	plug_in(bench, 0, "first", KEY_UP);
	look(bench);
	key(bench, 0, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
}

static void test_lost_events_are_asked_for(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "keyboard", KEY_UP);
	begin(bench, NULL);
	key(bench, 0, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
	set_bit(bench->plug[0].down, KEY_F6, true);
	send_event(bench, 0, EV_SYN, SYN_DROPPED, 0);
	send_event(bench, 0, EV_KEY, KEY_LEFT, 1);
	look(bench);
	expect_nothing(bench);
	send_event(bench, 0, EV_SYN, SYN_REPORT, 0);
	look(bench);
	expect(bench, BUTTON_UP, false);
	expect(bench, BUTTON_F6, true);
	expect_nothing(bench);
	key(bench, 0, KEY_F6, 0);
	look(bench);
	expect(bench, BUTTON_F6, false);
}

static void test_any_key_can_be_any_button(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "keyboard", KEY_W);
	begin(bench, "UP=KEY_W,F9=0x1e,F6=KEY_F8");
	key(bench, 0, KEY_W, 1);
	key(bench, 0, KEY_A, 1);
	key(bench, 0, KEY_F8, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
	expect(bench, BUTTON_F9, true);
	expect(bench, BUTTON_F6, true);
}

static void test_a_device_is_chosen_by_part_of_its_name(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "USB keyboard", KEY_UP);
	plug_in(bench, 1, "43fa8000.kpp", KEY_UP);
	begin(bench, "kpp");
	assert_int_equal(log_capture_count(&bench->said, LOG_WARNING), 0);
	key(bench, 1, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
	button_driver_evdev.destroy(bench->source);
	bench->said.count = 0;
	begin(bench, "piano");
	assert_contains(bench->said.sentence[0], "evdev:piano");
}

static void test_a_device_is_chosen_by_its_path_and_waited_for(void **state)
{
	struct bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "event2");

	plug_in(bench, 0, "other", KEY_UP);
	begin(bench, path.text);
	assert_contains(bench->said.sentence[0], "no such device yet");
	plug_in(bench, 2, "wanted", KEY_UP);
	bench->now_ms += 1000;
	look(bench);
	assert_true(bench->plug[2].ours >= 0);
	assert_true(bench->plug[0].ours < 0);
	key(bench, 2, KEY_UP, 1);
	look(bench);
	expect(bench, BUTTON_UP, true);
}

static void test_devices_without_a_mapped_key_are_left_alone(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "power button", KEY_POWER);
	begin(bench, NULL);
	assert_contains(bench->said.sentence[0], "no keyboard or keypad");
}

static void test_a_missing_permission_is_one_sentence(void **state)
{
	struct bench *bench = *state;

	plug_in(bench, 0, "keyboard", KEY_UP);
	bench->plug[0].error = EACCES;
	plug_in(bench, 1, "keyboard", KEY_UP);
	bench->plug[1].error = EACCES;
	begin(bench, NULL);
	look(bench);
	assert_int_equal(bench->said.count, 1);
	assert_contains(bench->said.sentence[0], "no permission");
}

static void test_wrong_words_are_named(void **state)
{
	static const char *const cases[][2] = {
		{"up=KEY_W", "no such button"},
		{"UP=KEY_NOWHERE", "no such key"},
		{"UP=", "no such key"},
		{"UP=768", "no such key"},
		{"UP=0", "no such key"},
	};
	struct bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		bench->said.count = 0;
		assert_int_equal(
			button_driver_evdev.check(cases[i][0], &bench->log),
			-EINVAL);
		assert_contains(bench->said.sentence[0], cases[i][1]);
	}
}

static void test_both_layouts_are_read(void **state)
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

static void test_stamps_become_the_programs_time(void **state)
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

static void test_a_survey_tells_whose_keys_are_buttons(void **state)
{
	struct bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);
	struct test_path locked;

	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "evdev",
		bench->folder.text, "modprobe evdev");
	plug_in(bench, 0, "Keypad", KEY_F6);
	set_bit(bench->plug[0].description.keys, KEY_KP8, true);
	plug_in(bench, 1, "Mouse", BTN_LEFT);
	plug_in(bench, 2, "Locked", KEY_UP);
	locked = path_join(&bench->folder, "event2");
	assert_int_equal(chmod(locked.text, 0600), 0);
	bench->plug[2].error = EACCES;
	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 4);
	survey_capture_expect(
		&capture, 1, SURVEY_WORKS, "/event0", "Keypad: UP, F6", NULL);
	survey_capture_expect(&capture, 2, SURVEY_UNUSED, "/event1",
		"Mouse: no key that is a button", ",UP=KEY");
	survey_capture_expect(
		&capture, 3, SURVEY_BROKEN, "/event2", "no permission", "root");
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_the_keypads_keys_are_the_buttons_of_their_names),
		CASE(test_a_key_that_repeats_is_one_press),
		CASE(test_a_device_that_comes_later_works),
		CASE(test_a_device_that_goes_lets_its_buttons_go),
		CASE(test_lost_events_are_asked_for),
		CASE(test_any_key_can_be_any_button),
		CASE(test_a_device_is_chosen_by_part_of_its_name),
		CASE(test_a_device_is_chosen_by_its_path_and_waited_for),
		CASE(test_devices_without_a_mapped_key_are_left_alone),
		CASE(test_a_missing_permission_is_one_sentence),
		CASE(test_wrong_words_are_named),
		cmocka_unit_test(test_both_layouts_are_read),
		cmocka_unit_test(test_stamps_become_the_programs_time),
		CASE(test_a_survey_tells_whose_keys_are_buttons),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
