/* Devices that fail or are not what their files look like, and odd arguments. */
#include "platform/base/compiler.h"
#include "platform/buttons/evdev/decode.h"
#include "tests/support/button_events.h"
#include "tests/support/fake/evdev_bench.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <grp.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int fail_to_describe(int fd, struct evdev_description *out)
{
	(void)fd;
	memset(out, 0xff, sizeof(*out));
	return -EIO;
}

static int fail_to_tell_keys(int fd, uint8_t bits[EVDEV_KEY_BYTES])
{
	(void)fd;
	memset(bits, 0xff, EVDEV_KEY_BYTES);
	return -EIO;
}

static ssize_t find_the_end(int fd, void *bytes, size_t size)
{
	(void)fd;
	(void)bytes;
	(void)size;
	return 0;
}

static void test_a_device_that_does_not_tell_its_keys_is_not_used(void **state)
{
	struct evdev_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	evdev_bench_plug_in(bench, 0, "dumb", KEY_UP);
	bench->system.describe = fail_to_describe;
	evdev_bench_open(bench, NULL);
	assert_int_equal(bench->logged.count, 1);
	assert_contains(bench->logged.sentence[0], "no keyboard or keypad");
	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/event0",
		"does not answer as a keyboard", "unplug it");
}

static void test_a_device_whose_events_end_is_unplugged(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "ending", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	evdev_bench_key(bench, 0, KEY_F6, 1);
	bench->system.read = find_the_end;
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
	evdev_bench_expect_nothing(bench);
	assert_true(log_capture_has(
		&bench->logged, LOG_WARNING, "ending was unplugged"));
}

/* Until a report ends, what follows may belong to what was lost. */
static void test_only_a_report_ends_the_loss_of_events(void **state)
{
	static const struct {
		int type, code;
	} others[] = {{EV_ABS, ABS_X}, {EV_MSC, SYN_REPORT},
		{EV_SYN, SYN_MT_REPORT}, {EV_SYN, SYN_CONFIG}};
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_set_key(bench->device[0].down, KEY_F6, true);
	evdev_bench_send(bench, 0, EV_SYN, SYN_DROPPED, 0);
	for (size_t i = 0; i < ARRAY_COUNT(others); i++) {
		evdev_bench_send(bench, 0, others[i].type, others[i].code, 0);
		evdev_bench_poll(bench);
		evdev_bench_expect_nothing(bench);
	}
	evdev_bench_send(bench, 0, EV_SYN, SYN_REPORT, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_F6, true);
}

static void test_a_device_that_does_not_tell_what_is_down_changes_nothing(
	void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, NULL);
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, true);
	bench->system.keys_down = fail_to_tell_keys;
	evdev_bench_send(bench, 0, EV_SYN, SYN_DROPPED, 0);
	evdev_bench_send(bench, 0, EV_SYN, SYN_REPORT, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect_nothing(bench);
	evdev_bench_key(bench, 0, KEY_UP, 0);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_UP, false);
}

/* How often a device was opened; fails for a file of another name. */
static int opened;

static int open_an_event(const char *path)
{
	assert_int_equal(strncmp(strrchr(path, '/'), "/event", 6), 0);
	opened++;
	return -ENOENT;
}

static void test_files_of_other_names_are_not_opened(void **state)
{
	static const char *const names[] = {
		"mice", "js0", "even0", "evens", "by-id"};
	struct evdev_bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		file_write(path_join(&bench->folder, names[i]).text, "", 0);
	}
	file_write(path_join(&bench->folder, "event7").text, "", 0);
	bench->system.open = open_an_event;
	opened = 0;
	evdev_bench_open(bench, NULL);
	assert_int_equal(opened, 1);
}

/* The kernel tells of new devices: none is looked for in vain. */
static void test_a_watched_folder_is_not_scanned_again(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	bench->system.open = open_an_event;
	opened = 0;
	evdev_bench_open(bench, NULL);
	for (int i = 0; i < 50; i++) {
		evdev_bench_poll(bench);
	}
	assert_int_equal(opened, 1);
}

/* Counted from the first poll. */
static void test_a_device_by_its_path_is_looked_for_once_a_second(void **state)
{
	struct evdev_bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "event7");

	bench->system.open = open_an_event;
	opened = 0;
	assert_int_equal(evdev_create_on(&bench->system, path.text, &bench->log,
				 &bench->source),
		0);
	bench->now_ms = 4900;
	for (int i = 0; i < 31; i++) {
		evdev_bench_poll(bench);
		assert_int_equal(opened, 1 + i / 10);
	}
}

/* Of the folder's events, the one that says so may come behind others. */
static void test_a_folder_that_vanishes_after_changes_is_watched_again(
	void **state)
{
	struct evdev_bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "a file");

	evdev_bench_open(bench, NULL);
	file_write(path.text, "", 0);
	assert_int_equal(unlink(path.text), 0);
	assert_int_equal(rmdir(bench->folder.text), 0);
	evdev_bench_poll(bench);
	assert_int_equal(mkdir(bench->folder.text, 0700), 0);
	for (int i = 0; i < 10; i++) {
		evdev_bench_poll(bench);
	}
	evdev_bench_plug_in(bench, 0, "first", KEY_UP);
	evdev_bench_poll(bench);
	assert_true(bench->device[0].ours >= 0);
}

/* Stamps from before then would come before events that are queued. */
static void test_a_press_is_later_than_the_last_poll(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	assert_int_equal(evdev_create_on(&bench->system, NULL, &bench->log,
				 &bench->source),
		0);
	bench->now_ms = 4900;
	bench->age_ms = 900;
	evdev_bench_key(bench, 0, KEY_UP, 1);
	evdev_bench_poll(bench);
	button_expect(&bench->queue, 5000, BUTTON_UP, true);
	evdev_bench_poll(bench);
	evdev_bench_key(bench, 0, KEY_UP, 0);
	evdev_bench_poll(bench);
	button_expect(&bench->queue, 5101, BUTTON_UP, false);
}

static void test_a_name_has_one_to_255_characters(void **state)
{
	struct evdev_bench *bench = *state;
	char text[300];

	evdev_bench_plug_in(bench, 0, "USB", KEY_UP);
	evdev_bench_plug_in(bench, 1, "kpp", KEY_UP);
	evdev_bench_open(bench, "k");
	assert_int_equal(bench->logged.count, 1);
	assert_contains(bench->logged.sentence[0], "/event1: buttons of kpp");
	button_driver_evdev.destroy(bench->source);
	bench->source = NULL;
	bench->logged.count = 0;
	evdev_bench_open(bench, "z");
	assert_contains(bench->logged.sentence[0], "evdev:z: ");
	memset(text, 'n', sizeof(text));
	text[255] = '\0';
	assert_int_equal(button_driver_evdev.check(text, &bench->log), 0);
	text[255] = 'n';
	text[256] = '\0';
	bench->logged.count = 0;
	assert_int_equal(button_driver_evdev.check(text, &bench->log), -EINVAL);
	assert_contains(bench->logged.sentence[0], "at most 255 characters");
}

static void test_a_wrong_argument_creates_nothing(void **state)
{
	struct evdev_bench *bench = *state;
	struct button_source *source = NULL;

	assert_int_equal(evdev_create_on(&bench->system, "UP=KEY_NO",
				 &bench->log, &source),
		-EINVAL);
	assert_null(source);
}

static void test_every_number_of_a_key_is_accepted(void **state)
{
	struct evdev_bench *bench = *state;

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	evdev_bench_open(bench, "F6=9,F8=KEY_ESC,F9=0x0a");
	evdev_bench_key(bench, 0, KEY_8, 1);
	evdev_bench_key(bench, 0, KEY_ESC, 1);
	evdev_bench_key(bench, 0, KEY_9, 1);
	evdev_bench_poll(bench);
	evdev_bench_expect(bench, BUTTON_F6, true);
	evdev_bench_expect(bench, BUTTON_F8, true);
	evdev_bench_expect(bench, BUTTON_F9, true);
}

/* Only of one with keys, limber can say how to use them. */
static void test_a_survey_knows_devices_without_any_key(void **state)
{
	struct evdev_bench *bench = *state;
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	evdev_bench_plug_in(bench, 0, "Jack", KEY_ESC);
	evdev_bench_set_key(bench->device[0].description.keys, KEY_ESC, false);
	evdev_bench_plug_in(bench, 1, "Escape", KEY_ESC);
	evdev_survey_on(&bench->system, &survey);
	assert_int_equal(capture.count, 2);
	survey_capture_expect(&capture, 0, SURVEY_UNUSED, "/event0",
		"Jack: no key is mapped to a button", NULL);
	survey_capture_expect(&capture, 1, SURVEY_UNUSED, "/event1",
		"Escape: no key is mapped to a button", ",UP=KEY");
}

static void test_the_first_and_the_last_time_are_decoded(void **state)
{
	static const struct {
		int64_t time[2], stamp_ns;
	} cases[] = {{{0, 0}, 0}, {{0, 999999}, 999999000},
		{{INT64_C(9000000000), 0}, INT64_C(9000000000000000000)}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		unsigned char bytes[EVDEV_SIZE_64] = {0};

		memcpy(bytes, cases[i].time, sizeof(cases[i].time));
		assert_true(evdev_decode(bytes, sizeof(bytes)).stamp_ns ==
			cases[i].stamp_ns);
	}
}

/* Only root can give a file to a group of others; it needs a name. */
static void test_a_missing_permission_names_the_group_that_has_it(void **state)
{
	struct evdev_bench *bench = *state;
	struct test_path path = path_join(&bench->folder, "event0");
	gid_t gid = getgid() ? getgid() : 1;
	const struct group *group = getgrgid(gid);
	char sentence[200];

	evdev_bench_plug_in(bench, 0, "keyboard", KEY_UP);
	bench->device[0].error = EACCES;
	if (!group || chown(path.text, getuid(), gid) != 0) {
		skip();
	}
	assert_int_equal(chmod(path.text, 0640), 0);
	evdev_bench_open(bench, NULL);
	snprintf(sentence, sizeof(sentence), "join the group %s (as root",
		group->gr_name);
	assert_int_equal(bench->logged.count, 1);
	assert_contains(bench->logged.sentence[0], sentence);
}

int main(void)
{
#define CASE(name)                       \
	cmocka_unit_test_setup_teardown( \
		name, evdev_bench_setup, evdev_bench_teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_a_device_that_does_not_tell_its_keys_is_not_used),
		CASE(test_a_device_whose_events_end_is_unplugged),
		CASE(test_only_a_report_ends_the_loss_of_events),
		CASE(test_a_device_that_does_not_tell_what_is_down_changes_nothing),
		CASE(test_files_of_other_names_are_not_opened),
		CASE(test_a_watched_folder_is_not_scanned_again),
		CASE(test_a_device_by_its_path_is_looked_for_once_a_second),
		CASE(test_a_folder_that_vanishes_after_changes_is_watched_again),
		CASE(test_a_press_is_later_than_the_last_poll),
		CASE(test_a_name_has_one_to_255_characters),
		CASE(test_a_wrong_argument_creates_nothing),
		CASE(test_every_number_of_a_key_is_accepted),
		CASE(test_a_survey_knows_devices_without_any_key),
		CASE(test_the_first_and_the_last_time_are_decoded),
		CASE(test_a_missing_permission_names_the_group_that_has_it),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
