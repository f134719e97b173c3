/* The limits of button scripts and of lists of sources. */
#include "platform/buttons/buttons.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Opens a script of these bytes; what was logged is in the capture. */
static int open_bytes(struct buttons *buttons, const char *bytes, size_t size,
	struct log_capture *capture)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "run.txt");
	struct log log = log_capture_begin(capture);
	int error = buttons_open(buttons, NULL, &log);

	file_write(path.text, bytes, size);
	error = error ? error : buttons_add(buttons, "script", path.text, &log);
	temp_dir_remove(&directory);
	return error;
}

static void test_a_script_may_have_a_thousand_events(void **state)
{
	enum {
		EVENTS = 1000
	};
	char *text = calloc(EVENTS, 32);
	size_t size = 0;
	struct buttons buttons;
	struct log_capture capture;

	(void)state;
	assert_non_null(text);
	for (int i = 0; i < EVENTS; i++) {
		size += (size_t)sprintf(text + size, "%d F%d %s\n", 10 * i,
			i % 4 < 2 ? 9 : 10, i % 2 ? "up" : "down");
	}
	assert_int_equal(open_bytes(&buttons, text, size, &capture), 0);
	for (int i = 0; i < EVENTS; i++) {
		struct button_event event;

		buttons_poll(&buttons, 10 * i);
		assert_true(button_queue_pop(&buttons.queue, &event));
		assert_int_equal(event.time_ms, 10 * i);
		assert_int_equal(
			event.button, i % 4 < 2 ? BUTTON_F9 : BUTTON_F10);
		assert_int_equal(event.down, i % 2 == 0);
		assert_false(button_queue_pop(&buttons.queue, &event));
	}
	buttons_close(&buttons);
	free(text);
}

static void test_times_end_after_a_hundred_days(void **state)
{
	static const char last[] = "8640000000 UP down\n";
	static const char later[] = "8640000001 UP down\n";
	struct buttons buttons;
	struct log_capture capture;
	struct button_event event;

	(void)state;
	assert_int_equal(open_bytes(&buttons, last, strlen(last), &capture), 0);
	buttons_poll(&buttons, INT64_C(8639999999));
	assert_false(button_queue_pop(&buttons.queue, &event));
	buttons_poll(&buttons, INT64_C(8640000000));
	assert_true(button_queue_pop(&buttons.queue, &event));
	buttons_close(&buttons);
	assert_int_equal(
		open_bytes(&buttons, later, strlen(later), &capture), -EINVAL);
	assert_contains(capture.sentence[0], "is no time");
}

/* A comment of that many characters, between two events. */
static int open_long_line(int length, struct log_capture *capture)
{
	struct buttons buttons;
	char text[1200];
	int error;

	snprintf(text, sizeof(text), "0 UP down\n#%0*d\n5 UP up\n", length - 1,
		0);
	error = open_bytes(&buttons, text, strlen(text), capture);
	if (!error) {
		struct button_event event;

		buttons_poll(&buttons, 5 + BUTTON_DEBOUNCE_MS);
		assert_true(button_queue_pop(&buttons.queue, &event));
		assert_true(button_queue_pop(&buttons.queue, &event));
		buttons_close(&buttons);
	}
	return error;
}

static void test_a_line_may_have_510_characters(void **state)
{
	struct log_capture capture;

	(void)state;
	assert_int_equal(open_long_line(509, &capture), 0);
	assert_int_equal(open_long_line(510, &capture), 0);
	assert_int_equal(open_long_line(511, &capture), -EINVAL);
	assert_contains(capture.sentence[0], ":2: this line has more than 510");
	assert_int_equal(open_long_line(512, &capture), -EINVAL);
}

static void test_a_script_of_zero_bytes_is_no_text(void **state)
{
	static const char bytes[] = "0 UP down\n\0\0\0\n5 UP up\n";
	struct buttons buttons;
	struct log_capture capture;

	(void)state;
	assert_int_equal(
		open_bytes(&buttons, bytes, sizeof(bytes) - 1, &capture),
		-EINVAL);
	assert_contains(capture.sentence[0], ":2: ");
	assert_contains(capture.sentence[0], "is no text");
}

static void test_a_script_may_have_a_million_lines(void **state)
{
	enum {
		LINES = 1000000
	};
	char *text = malloc(LINES + 1);
	struct buttons buttons;
	struct log_capture capture;

	(void)state;
	assert_non_null(text);
	memset(text, '\n', LINES + 1);
	assert_int_equal(open_bytes(&buttons, text, LINES, &capture), 0);
	buttons_close(&buttons);
	assert_int_equal(
		open_bytes(&buttons, text, LINES + 1, &capture), -EFBIG);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "more than 1000000 lines");
	free(text);
}

static void test_an_empty_script_presses_nothing(void **state)
{
	struct buttons buttons;
	struct log_capture capture;
	struct button_event event;

	(void)state;
	assert_int_equal(open_bytes(&buttons, "", 0, &capture), 0);
	buttons_poll(&buttons, 1000);
	assert_false(button_queue_pop(&buttons.queue, &event));
	buttons_close(&buttons);
}

static void test_a_source_may_have_4095_characters(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	char spec[4200] = "script:";

	(void)state;
	memset(spec + 7, 'x', 4095 - 7);
	assert_int_equal(buttons_check(spec, &log), 0);
	strcat(spec, ",evdev");
	assert_int_equal(buttons_check(spec, &log), 0);
	memset(spec + 7, 'x', 4096 - 7);
	strcpy(spec + 4096, ",evdev");
	assert_int_equal(capture.count, 0);
	assert_int_equal(buttons_check(spec, &log), -EINVAL);
	assert_contains(capture.sentence[0], "at most 4095 characters");
}

static void test_empty_sources_are_refused(void **state)
{
	static const char *const specs[] = {",", ",evdev", "evdev,,evdev", ":x"};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		struct buttons buttons;

		assert_int_equal(buttons_check(specs[i], &log), -EINVAL);
		assert_int_equal(capture.count, 1);
		assert_contains(capture.sentence[0], "no such source");
		assert_int_equal(
			buttons_open(&buttons, specs[i], &log), -EINVAL);
		assert_int_equal(buttons.source_count, 0);
	}
}

static void test_an_error_closes_the_sources_before_it(void **state)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "run.txt");
	struct log log = log_to_nowhere();
	struct buttons buttons;
	char spec[700];

	(void)state;
	file_write(path.text, "0 UP down\n", 10);
	snprintf(spec, sizeof(spec), "script:%s,script:/nowhere", path.text);
	assert_int_equal(buttons_open(&buttons, spec, &log), -ENOENT);
	assert_int_equal(buttons.source_count, 0);
	temp_dir_remove(&directory);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_script_may_have_a_thousand_events),
		cmocka_unit_test(test_times_end_after_a_hundred_days),
		cmocka_unit_test(test_a_line_may_have_510_characters),
		cmocka_unit_test(test_a_script_of_zero_bytes_is_no_text),
		cmocka_unit_test(test_a_script_may_have_a_million_lines),
		cmocka_unit_test(test_an_empty_script_presses_nothing),
		cmocka_unit_test(test_a_source_may_have_4095_characters),
		cmocka_unit_test(test_empty_sources_are_refused),
		cmocka_unit_test(test_an_error_closes_the_sources_before_it),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
