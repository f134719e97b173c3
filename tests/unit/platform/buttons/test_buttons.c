#include "platform/buttons/buttons.h"
#include "tests/support/button_events.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void test_a_name_and_its_button_convert_both_ways(void **state)
{
	(void)state;
	for (int i = 0; i < BUTTON_COUNT; i++) {
		const char *name = button_name((enum button)i);

		assert_non_null(name);
		assert_int_equal(button_from_name(name), i);
	}
	assert_string_equal(button_name(BUTTON_F10), "F10");
	assert_null(button_name(BUTTON_COUNT));
	assert_int_equal(button_from_name("up"), BUTTON_COUNT);
	assert_int_equal(button_from_name(""), BUTTON_COUNT);
}

static void test_first_in_is_first_out(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 0, BUTTON_UP, true);
	button_push(&queue, 0, BUTTON_F6, true);
	button_push(&queue, 1, BUTTON_UP, false);
	button_expect(&queue, 0, BUTTON_UP, true);
	button_expect(&queue, 0, BUTTON_F6, true);
	button_expect(&queue, 1, BUTTON_UP, false);
	button_expect_nothing(&queue);
}

static void test_repeats_are_dropped(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 5, BUTTON_UP, false);
	button_push(&queue, 10, BUTTON_UP, true);
	button_push(&queue, 40, BUTTON_UP, true);
	button_push(&queue, 70, BUTTON_UP, true);
	button_expect(&queue, 10, BUTTON_UP, true);
	button_expect_nothing(&queue);
}

static void test_a_press_at_time_zero_is_queued_at_once(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 0, BUTTON_ENTER, true);
	button_expect(&queue, 0, BUTTON_ENTER, true);
}

static void test_a_bouncing_press_is_one_press(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 101, BUTTON_UP, false);
	button_push(&queue, 103, BUTTON_UP, true);
	button_push(&queue, 104, BUTTON_UP, false);
	button_push(&queue, 106, BUTTON_UP, true);
	button_queue_settle(&queue, 1000);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect_nothing(&queue);
}

static void test_the_last_state_of_a_bounce_is_not_lost(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 103, BUTTON_UP, false);
	button_push(&queue, 104, BUTTON_UP, true);
	button_push(&queue, 105, BUTTON_UP, false);
	button_queue_settle(&queue, 109);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect_nothing(&queue);
	button_queue_settle(&queue, 110);
	button_expect(&queue, 110, BUTTON_UP, false);
	button_queue_settle(&queue, 500);
	button_expect_nothing(&queue);
}

static void test_a_later_event_settles_a_held_back_change(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 103, BUTTON_UP, false);
	button_push(&queue, 200, BUTTON_UP, true);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect(&queue, 110, BUTTON_UP, false);
	button_expect(&queue, 200, BUTTON_UP, true);
	button_expect_nothing(&queue);
}

static void test_settled_changes_come_in_the_order_of_their_times(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_DOWN, true);
	button_push(&queue, 102, BUTTON_UP, true);
	button_push(&queue, 104, BUTTON_UP, false);
	button_push(&queue, 105, BUTTON_DOWN, false);
	button_queue_settle(&queue, 300);
	button_expect(&queue, 100, BUTTON_DOWN, true);
	button_expect(&queue, 102, BUTTON_UP, true);
	button_expect(&queue, 110, BUTTON_DOWN, false);
	button_expect(&queue, 112, BUTTON_UP, false);
	button_expect_nothing(&queue);
}

/* Whichever of the two comes first in the list of buttons. */
static void test_the_change_that_is_due_first_comes_first(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 102, BUTTON_DOWN, true);
	button_push(&queue, 104, BUTTON_UP, false);
	button_push(&queue, 105, BUTTON_DOWN, false);
	button_queue_settle(&queue, 300);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect(&queue, 102, BUTTON_DOWN, true);
	button_expect(&queue, 110, BUTTON_UP, false);
	button_expect(&queue, 112, BUTTON_DOWN, false);
	button_expect_nothing(&queue);
}

static void test_a_change_counts_at_once_after_the_debounce_time(void **state)
{
	struct button_queue queue;

	(void)state;
	for (int debounce_ms = 1; debounce_ms < 12; debounce_ms += 10) {
		button_queue_init(&queue, debounce_ms);
		button_push(&queue, 100, BUTTON_UP, true);
		button_push(&queue, 100 + debounce_ms, BUTTON_UP, false);
		button_expect(&queue, 100, BUTTON_UP, true);
		button_expect(&queue, 100 + debounce_ms, BUTTON_UP, false);
		button_push(&queue, 200, BUTTON_UP, true);
		button_push(&queue, 199 + debounce_ms, BUTTON_UP, false);
		button_expect(&queue, 200, BUTTON_UP, true);
		button_expect_nothing(&queue);
	}
}

static void test_buttons_are_debounced_separately(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 101, BUTTON_DOWN, true);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect(&queue, 101, BUTTON_DOWN, true);
}

static void test_the_oldest_is_dropped_when_the_queue_is_full(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	for (int i = 0; i < BUTTON_QUEUE_CAPACITY + 3; i++) {
		button_push(&queue, i, BUTTON_UP, i % 2 == 0);
	}
	for (int i = 3; i < BUTTON_QUEUE_CAPACITY + 3; i++) {
		button_expect(&queue, i, BUTTON_UP, i % 2 == 0);
	}
	button_expect_nothing(&queue);
}

/* Of two buttons, the one that has a later event, which may be the next one. */
static void test_the_dropped_event_is_followed_by_one_of_its_button(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 0, BUTTON_LEFT, true);
	button_push(&queue, 1, BUTTON_LEFT, false);
	for (int i = 2; i <= BUTTON_QUEUE_CAPACITY; i++) {
		button_push(&queue, i, BUTTON_UP, i % 2 == 0);
	}
	button_expect(&queue, 1, BUTTON_LEFT, false);
	button_expect(&queue, 2, BUTTON_UP, true);
}

static void test_without_debouncing_times_do_not_matter(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 100, BUTTON_UP, true);
	button_push(&queue, 90, BUTTON_UP, false);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect(&queue, 90, BUTTON_UP, false);
	button_expect_nothing(&queue);
}

static void test_unknown_buttons_and_holders_are_ignored(void **state)
{
	const struct button_event unknown = {
		0, BUTTON_UP, true, BUTTON_HOLDERS_MAX};
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 0, BUTTON_COUNT, true);
	button_push(&queue, 0, (enum button) - 1, true);
	button_queue_push(&queue, unknown);
	button_expect_nothing(&queue);
}

/* Opens a script of that text. */
static int open_script(
	struct buttons *buttons, const char *text, struct log_capture *capture)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "run.txt");
	struct log log = log_capture_begin(capture);
	char spec[600];
	int error;

	file_write(path.text, text, strlen(text));
	snprintf(spec, sizeof(spec), "script:%s", path.text);
	error = buttons_open(buttons, spec, &log);
	temp_dir_remove(&directory);
	return error;
}

static void test_a_script_pushes_the_events_that_are_due(void **state)
{
	struct buttons buttons;
	struct log_capture capture;

	(void)state;
	assert_int_equal(open_script(&buttons,
				 "# a run\n"
				 "\n"
				 "0 ENTER down\n"
				 "  50\tENTER\tup   # let go\r\n"
				 "500 F10 down\n"
				 "500 F9 down",
				 &capture),
		0);
	buttons_poll(&buttons, 0);
	button_expect(&buttons.queue, 0, BUTTON_ENTER, true);
	button_expect_nothing(&buttons.queue);
	buttons_poll(&buttons, 499);
	button_expect(&buttons.queue, 50, BUTTON_ENTER, false);
	button_expect_nothing(&buttons.queue);
	buttons_poll(&buttons, 500);
	button_expect(&buttons.queue, 500, BUTTON_F10, true);
	button_expect(&buttons.queue, 500, BUTTON_F9, true);
	buttons_poll(&buttons, 100000);
	button_expect_nothing(&buttons.queue);
	buttons_close(&buttons);
}

static void test_polling_settles_the_queue(void **state)
{
	struct buttons buttons;
	struct log log = log_to_nowhere();

	(void)state;
	assert_int_equal(buttons_open(&buttons, NULL, &log), 0);
	button_push(&buttons.queue, 10, BUTTON_UP, true);
	button_push(&buttons.queue, 12, BUTTON_UP, false);
	buttons_poll(&buttons, 12);
	button_expect(&buttons.queue, 10, BUTTON_UP, true);
	button_expect_nothing(&buttons.queue);
	buttons_poll(&buttons, 10 + BUTTON_DEBOUNCE_MS);
	button_expect(&buttons.queue, 10 + BUTTON_DEBOUNCE_MS, BUTTON_UP, false);
	buttons_close(&buttons);
}

/* As --record-buttons writes what was pressed in a window within one frame. */
static void test_all_presses_of_a_script_count(void **state)
{
	struct buttons buttons;
	struct log_capture capture;

	(void)state;
	assert_int_equal(open_script(&buttons,
				 "10 UP down\n10 UP up\n10 UP down\n"
				 "12 UP up\n",
				 &capture),
		0);
	buttons_poll(&buttons, 12);
	button_expect(&buttons.queue, 10, BUTTON_UP, true);
	button_expect(&buttons.queue, 10, BUTTON_UP, false);
	button_expect(&buttons.queue, 10, BUTTON_UP, true);
	button_expect(&buttons.queue, 12, BUTTON_UP, false);
	button_expect_nothing(&buttons.queue);
	/* Contacts that share the queue bounce as before. */
	button_push(&buttons.queue, 30, BUTTON_UP, true);
	button_push(&buttons.queue, 31, BUTTON_UP, false);
	button_expect(&buttons.queue, 30, BUTTON_UP, true);
	button_expect_nothing(&buttons.queue);
	buttons_close(&buttons);
}

static void test_the_message_names_a_wrong_line(void **state)
{
	static const struct {
		const char *text, *place, *reason;
	} cases[] = {
		{"0 UP down\n5 UP\n", ":2: ", "TIME_MS BUTTON down|up"},
		{"\n0\n", ":2: ", "TIME_MS BUTTON down|up"},
		{"0 UP down again\n", ":1: ", "TIME_MS BUTTON down|up"},
		{"\n# x\nsoon UP down\n", ":3: ", "\"soon\""},
		{"1.5 UP down\n", ":1: ", "\"1.5\""},
		{"-1 UP down\n", ":1: ", "\"-1\""},
		{"99999999999999999999 UP down\n", ":1: ", "no time"},
		{"0 LEFT down\n9 up down\n", ":2: ", "\"up\" is no button"},
		{"0 LEFT pressed\n", ":1: ", "\"pressed\""},
		{"10 UP down\n\n9 UP up\n", ":3: ", "before"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct buttons buttons;
		struct log_capture capture;

		assert_int_equal(open_script(&buttons, cases[i].text, &capture),
			-EINVAL);
		assert_int_equal(capture.count, 1);
		assert_contains(capture.sentence[0], cases[i].place);
		assert_contains(capture.sentence[0], cases[i].reason);
		assert_int_equal(buttons.source_count, 0);
	}
}

static void test_the_message_names_a_missing_script(void **state)
{
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_int_equal(buttons_open(&buttons, "script:/nowhere/run.txt", &log),
		-ENOENT);
	assert_contains(capture.sentence[0], "/nowhere/run.txt");
	assert_int_equal(buttons_open(&buttons, "script", &log), -EINVAL);
	assert_contains(capture.sentence[1], "script:FILE");
	assert_int_equal(buttons_open(&buttons, "script:/", &log), -EISDIR);
	assert_contains(capture.sentence[2], "directory");
}

static void test_an_unknown_source_lists_the_known_ones(void **state)
{
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_int_equal(buttons_open(&buttons, "piano:4", &log), -EINVAL);
	assert_contains(capture.sentence[0], "piano");
	assert_contains(capture.sentence[0], "script");
}

static void test_no_spec_opens_nothing(void **state)
{
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_int_equal(buttons_open(&buttons, NULL, &log), 0);
	assert_int_equal(buttons_open(&buttons, "", &log), 0);
	buttons_poll(&buttons, 5);
	button_expect_nothing(&buttons.queue);
	buttons_close(&buttons);
}

static void test_sources_share_one_queue(void **state)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "run.txt");
	char spec[(sizeof(path.text) + 8) * (BUTTON_SOURCES_MAX + 1)] = "";
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	file_write(path.text, "3 UP down\n", 10);
	for (int i = 0; i < BUTTON_SOURCES_MAX + 1; i++) {
		size_t used = strlen(spec);

		snprintf(spec + used, sizeof(spec) - used, "%sscript:%s",
			i ? "," : "", path.text);
	}
	assert_int_equal(buttons_open(&buttons, spec, &log), -E2BIG);
	assert_contains(capture.sentence[0], "at most 8 sources");
	*strrchr(spec, ',') = '\0';
	assert_int_equal(buttons_open(&buttons, spec, &log), 0);
	assert_int_equal(buttons.source_count, BUTTON_SOURCES_MAX);
	buttons_poll(&buttons, 5);
	button_expect(&buttons.queue, 3, BUTTON_UP, true);
	button_expect_nothing(&buttons.queue);
	buttons_close(&buttons);
	temp_dir_remove(&directory);
}

static void test_an_item_with_an_equals_sign_continues_its_source(void **state)
{
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_int_equal(
		buttons_open(&buttons,
			"evdev:no such thing,UP=KEY_W,DOWN=KEY_S,evdev:nor such",
			&log),
		0);
	assert_int_equal(buttons.source_count, 2);
	buttons_close(&buttons);
	assert_int_equal(
		buttons_check("evdev:,UP=KEY_W,DOWN=KEY_NO,evdev", &log),
		-EINVAL);
	assert_contains(capture.sentence[capture.count - 1], "DOWN=KEY_NO");
	assert_int_equal(buttons_check("evdev,piano", &log), -EINVAL);
	assert_contains(capture.sentence[capture.count - 1], "piano");
	assert_int_equal(buttons_check("script:x,evdev:UP=17", &log), 0);
	assert_int_equal(buttons_check(NULL, &log), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_name_and_its_button_convert_both_ways),
		cmocka_unit_test(test_first_in_is_first_out),
		cmocka_unit_test(test_repeats_are_dropped),
		cmocka_unit_test(test_a_press_at_time_zero_is_queued_at_once),
		cmocka_unit_test(test_a_bouncing_press_is_one_press),
		cmocka_unit_test(test_the_last_state_of_a_bounce_is_not_lost),
		cmocka_unit_test(test_a_later_event_settles_a_held_back_change),
		cmocka_unit_test(
			test_settled_changes_come_in_the_order_of_their_times),
		cmocka_unit_test(test_the_change_that_is_due_first_comes_first),
		cmocka_unit_test(
			test_a_change_counts_at_once_after_the_debounce_time),
		cmocka_unit_test(test_buttons_are_debounced_separately),
		cmocka_unit_test(
			test_the_oldest_is_dropped_when_the_queue_is_full),
		cmocka_unit_test(
			test_the_dropped_event_is_followed_by_one_of_its_button),
		cmocka_unit_test(test_without_debouncing_times_do_not_matter),
		cmocka_unit_test(test_unknown_buttons_and_holders_are_ignored),
		cmocka_unit_test(test_a_script_pushes_the_events_that_are_due),
		cmocka_unit_test(test_polling_settles_the_queue),
		cmocka_unit_test(test_all_presses_of_a_script_count),
		cmocka_unit_test(test_the_message_names_a_wrong_line),
		cmocka_unit_test(test_the_message_names_a_missing_script),
		cmocka_unit_test(test_an_unknown_source_lists_the_known_ones),
		cmocka_unit_test(test_no_spec_opens_nothing),
		cmocka_unit_test(test_sources_share_one_queue),
		cmocka_unit_test(
			test_an_item_with_an_equals_sign_continues_its_source),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
