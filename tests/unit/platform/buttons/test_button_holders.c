/* Buttons that several keys, lines or sources hold down. */
#include "platform/buttons/buttons.h"
#include "tests/support/button_events.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* Else the button would seem to be down until it is pressed again. */
static void test_no_last_release_is_lost_when_the_queue_is_full(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	button_push(&queue, 0, BUTTON_LEFT, true);
	button_push(&queue, 1, BUTTON_ENTER, true);
	button_expect(&queue, 0, BUTTON_LEFT, true);
	button_expect(&queue, 1, BUTTON_ENTER, true);
	button_push(&queue, 2, BUTTON_LEFT, false);
	button_push(&queue, 3, BUTTON_ENTER, false);
	for (int i = 4; i < 2 * BUTTON_QUEUE_CAPACITY; i++) {
		button_push(&queue, i, BUTTON_UP, i % 2 == 0);
	}
	button_expect(&queue, 2, BUTTON_LEFT, false);
	button_expect(&queue, 3, BUTTON_ENTER, false);
	for (int i = BUTTON_QUEUE_CAPACITY + 2; i < 2 * BUTTON_QUEUE_CAPACITY;
		i++) {
		button_expect(&queue, i, BUTTON_UP, i % 2 == 0);
	}
	button_expect_nothing(&queue);
}

/* Any holders of any sources press and release one button. */
static void test_a_button_is_down_while_any_holder_holds_it(void **state)
{
	bool held[BUTTON_SOURCES_MAX + 1][BUTTON_HOLDERS_MAX] = {{false}};
	struct button_queue queue;
	uint32_t seed = 3;
	bool shown = false;
	int count = 0;

	(void)state;
	button_queue_init(&queue, 0);
	for (int i = 0; i < 5000; i++) {
		int source = random_between(&seed, 0, BUTTON_SOURCES_MAX);
		int holder = random_between(&seed, 0, BUTTON_HOLDERS_MAX - 1);
		bool down = random_one_in(&seed, 40);

		count += down - held[source][holder];
		held[source][holder] = down;
		queue.source = source;
		button_queue_push(&queue,
			(struct button_event){
				i, BUTTON_F9, down, (uint8_t)holder});
		if (shown != (count > 0)) {
			shown = count > 0;
			button_expect(&queue, i, BUTTON_F9, shown);
		}
		button_expect_nothing(&queue);
	}
}

static void test_each_holder_of_each_source_alone_holds_a_button(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 0);
	for (int i = 0; i < (BUTTON_SOURCES_MAX + 1) * BUTTON_HOLDERS_MAX; i++) {
		uint8_t holder = (uint8_t)(i % BUTTON_HOLDERS_MAX);

		queue.source = i / BUTTON_HOLDERS_MAX;
		for (int up = 0; up < 2; up++) {
			button_queue_push(&queue,
				(struct button_event){i, BUTTON_F9, !up, holder});
			button_expect(&queue, i, BUTTON_F9, !up);
		}
	}
}

/* A contact that bounces while another is held changes nothing. */
static void test_a_bounce_of_a_second_holder_is_dropped(void **state)
{
	struct button_queue queue;

	(void)state;
	button_queue_init(&queue, 10);
	button_push(&queue, 100, BUTTON_UP, true);
	for (int i = 0; i < 6; i++) {
		button_queue_push(&queue,
			(struct button_event){101 + i, BUTTON_UP, i % 2 == 0, 1});
	}
	button_push(&queue, 108, BUTTON_UP, false);
	button_queue_settle(&queue, 500);
	button_expect(&queue, 100, BUTTON_UP, true);
	button_expect(&queue, 110, BUTTON_UP, false);
	button_expect_nothing(&queue);
}

static void test_a_source_does_not_release_what_another_holds(void **state)
{
	static const char *const texts[] = {
		"0 UP down\n500 UP up\n", "100 UP down\n900 UP up\n"};
	struct test_path directory = temp_dir_make();
	struct test_path path[] = {
		path_join(&directory, "a.txt"), path_join(&directory, "b.txt")};
	char spec[2 * sizeof(path[0].text) + 20];
	struct buttons buttons;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	file_write(path[0].text, texts[0], strlen(texts[0]));
	file_write(path[1].text, texts[1], strlen(texts[1]));
	snprintf(spec, sizeof(spec), "script:%s,script:%s", path[0].text,
		path[1].text);
	assert_int_equal(buttons_open(&buttons, spec, &log), 0);
	for (int now_ms = 0; now_ms < 1000; now_ms += 50) {
		buttons_poll(&buttons, now_ms);
		/* Nor does what belongs to no source, such as a window. */
		button_push(&buttons.queue, now_ms, BUTTON_UP, now_ms < 900);
		button_push(&buttons.queue, now_ms, BUTTON_UP, false);
	}
	button_expect(&buttons.queue, 0, BUTTON_UP, true);
	button_expect(&buttons.queue, 900, BUTTON_UP, false);
	button_expect_nothing(&buttons.queue);
	buttons_close(&buttons);
	temp_dir_remove(&directory);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_no_last_release_is_lost_when_the_queue_is_full),
		cmocka_unit_test(test_a_button_is_down_while_any_holder_holds_it),
		cmocka_unit_test(
			test_each_holder_of_each_source_alone_holds_a_button),
		cmocka_unit_test(test_a_bounce_of_a_second_holder_is_dropped),
		cmocka_unit_test(
			test_a_source_does_not_release_what_another_holds),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
