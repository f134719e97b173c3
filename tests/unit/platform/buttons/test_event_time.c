/* The program's time of events, and events in its order. */
#include "platform/buttons/button_batch.h"
#include "platform/buttons/event_time.h"
#include "tests/support/test.h"

#include <time.h>

#define MS INT64_C(1000000)
#define S  (1000 * MS)

static const struct event_clocks clocks = {
	.monotonic_ns = 50 * S, .real_ns = 1700000000 * S};

static void test_a_stamp_may_be_ten_seconds_old(void **state)
{
	const int64_t monotonic_ns = clocks.monotonic_ns;
	const int64_t real_ns = clocks.real_ns;

	(void)state;
	assert_int_equal(
		event_time_ms(&clocks, monotonic_ns - 10 * S, -100000, 20000),
		10000);
	assert_int_equal(event_time_ms(&clocks, monotonic_ns - 10 * S - 1,
				 -100000, 20000),
		20000);
	assert_int_equal(
		event_time_ms(&clocks, real_ns - 10 * S, -100000, 20000), 10000);
	assert_int_equal(
		event_time_ms(&clocks, real_ns - 10 * S - 1, -100000, 20000),
		20000);
}

static void test_a_stamp_of_this_moment_is_now(void **state)
{
	const struct event_clocks begun = {.monotonic_ns = 3 * S, .real_ns = 0};

	(void)state;
	assert_int_equal(event_time_ms(&clocks, clocks.monotonic_ns, 0, 70), 70);
	assert_int_equal(event_time_ms(&clocks, clocks.real_ns, 0, 70), 70);
	assert_int_equal(event_time_ms(&clocks, clocks.real_ns + 1, 0, 70), 70);
	/* Right after the machine started, 0 is a time of its own. */
	assert_int_equal(event_time_ms(&begun, 0, -5000, 70), -2930);
}

/* Without a clock of its own a board begins with 1970, as the machine starts. */
static void test_a_stamp_of_both_clocks_is_of_the_monotonic_one(void **state)
{
	const struct event_clocks board = {
		.monotonic_ns = 30 * S, .real_ns = 32 * S};

	(void)state;
	for (int age = 0; age <= 10; age++) {
		assert_int_equal(
			event_time_ms(&board, (30 - age) * S, -100000, 70),
			70 - 1000 * age);
	}
	/* After the one's time it is of the other; too old is of none. */
	assert_int_equal(event_time_ms(&board, 31 * S, -100000, 70), -930);
	assert_int_equal(event_time_ms(&board, 19 * S, -100000, 70), 70);
}

static void test_times_are_rounded_to_the_next_millisecond(void **state)
{
	(void)state;
	assert_int_equal(
		event_time_ms(&clocks, clocks.monotonic_ns - MS + 1, 0, 70), 70);
	assert_int_equal(
		event_time_ms(&clocks, clocks.monotonic_ns - MS, 0, 70), 69);
	assert_int_equal(
		event_time_ms(&clocks, clocks.monotonic_ns - 2 * MS + 1, 0, 70),
		69);
}

static void test_times_stay_between_the_last_poll_and_now(void **state)
{
	const int64_t stamp_ns = clocks.monotonic_ns - 9 * MS;

	(void)state;
	assert_int_equal(event_time_ms(&clocks, stamp_ns, 60, 70), 61);
	assert_int_equal(event_time_ms(&clocks, stamp_ns, 61, 70), 61);
	assert_int_equal(event_time_ms(&clocks, stamp_ns, 62, 70), 62);
	/* Two polls in one millisecond. */
	assert_int_equal(event_time_ms(&clocks, stamp_ns, 71, 70), 70);
}

static int64_t now_ns(clockid_t id)
{
	struct timespec now;

	assert_int_equal(clock_gettime(id, &now), 0);
	return (int64_t)now.tv_sec * S + now.tv_nsec;
}

static void test_the_clocks_are_those_of_the_kernel(void **state)
{
	int64_t monotonic_ns = now_ns(CLOCK_MONOTONIC);
	int64_t real_ns = now_ns(CLOCK_REALTIME);
	struct event_clocks now = event_clocks_now();

	(void)state;
	assert_in_range(now.monotonic_ns - monotonic_ns, 0, 5 * S);
	assert_in_range(now.real_ns - real_ns + S, 0, 6 * S);
	assert_true(now.monotonic_ns <= now_ns(CLOCK_MONOTONIC));
}

static struct button_event event_at(int64_t time_ms, int button, bool down)
{
	return (struct button_event){time_ms, (enum button)button, down, 0};
}

static void expect_next(
	struct button_queue *queue, int64_t time_ms, int button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(queue, &event));
	assert_int_equal(event.time_ms, time_ms);
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
}

static void test_a_batch_is_passed_on_in_the_order_of_time(void **state)
{
	struct button_batch batch = {.count = 0};
	struct button_queue queue;
	struct button_event event;

	(void)state;
	button_queue_init(&queue, 0);
	button_batch_add(&batch, event_at(30, BUTTON_UP, true));
	button_batch_add(&batch, event_at(10, BUTTON_DOWN, true));
	button_batch_add(&batch, event_at(20, BUTTON_LEFT, true));
	button_batch_add(&batch, event_at(10, BUTTON_DOWN, false));
	button_batch_add(&batch, event_at(5, BUTTON_F6, true));
	button_batch_push(&batch, &queue);
	assert_int_equal(batch.count, 0);
	expect_next(&queue, 5, BUTTON_F6, true);
	expect_next(&queue, 10, BUTTON_DOWN, true);
	expect_next(&queue, 10, BUTTON_DOWN, false);
	expect_next(&queue, 20, BUTTON_LEFT, true);
	expect_next(&queue, 30, BUTTON_UP, true);
	assert_false(button_queue_pop(&queue, &event));
	button_batch_push(&batch, &queue);
	assert_false(button_queue_pop(&queue, &event));
}

static void test_a_full_batch_keeps_the_last_state(void **state)
{
	struct button_batch batch = {.count = 0};
	struct button_queue queue;
	struct button_event event;
	int last_ms = -1;

	(void)state;
	button_queue_init(&queue, 0);
	for (int i = 0; i < BUTTON_BATCH_CAPACITY + 1; i++) {
		button_batch_add(&batch, event_at(i, BUTTON_UP, i % 2 == 0));
		assert_int_equal(batch.count,
			i < BUTTON_BATCH_CAPACITY ? i + 1
						  : BUTTON_BATCH_CAPACITY);
	}
	assert_int_equal(batch.event[BUTTON_BATCH_CAPACITY - 1].time_ms,
		BUTTON_BATCH_CAPACITY);
	button_batch_push(&batch, &queue);
	while (button_queue_pop(&queue, &event)) {
		last_ms = (int)event.time_ms;
	}
	assert_int_equal(last_ms, BUTTON_BATCH_CAPACITY - 2);
	assert_true(queue.down[BUTTON_UP]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_stamp_may_be_ten_seconds_old),
		cmocka_unit_test(test_a_stamp_of_this_moment_is_now),
		cmocka_unit_test(
			test_a_stamp_of_both_clocks_is_of_the_monotonic_one),
		cmocka_unit_test(test_times_are_rounded_to_the_next_millisecond),
		cmocka_unit_test(test_times_stay_between_the_last_poll_and_now),
		cmocka_unit_test(test_the_clocks_are_those_of_the_kernel),
		cmocka_unit_test(test_a_batch_is_passed_on_in_the_order_of_time),
		cmocka_unit_test(test_a_full_batch_keeps_the_last_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
