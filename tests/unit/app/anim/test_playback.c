#include "app/anim/playback.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	CAPACITY = 16
};

/* Events of a two-second clip: at both ends and twice in between. */
static const struct playback_event EVENTS[4] = {
	{0, 'a'}, {0.5f, 'b'}, {1.25f, 'c'}, {2, 'd'}};

/* Advances and returns the passed ids as a string. */
static const char *go(struct playback *playback, double step_s)
{
	static char text[CAPACITY + 1];
	int passed[CAPACITY];
	int count =
		playback_advance(playback, step_s, EVENTS, 4, passed, CAPACITY);

	assert_true(count <= CAPACITY);
	for (int i = 0; i < count; i++) {
		text[i] = (char)passed[i];
	}
	text[count] = '\0';
	return text;
}

static void test_once_passes_each_mark_and_stops(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, 1);

	(void)state;
	assert_string_equal(go(&playback, 0), "a");
	assert_string_equal(go(&playback, 0.25), "");
	assert_string_equal(go(&playback, 0.25), "b");
	assert_string_equal(go(&playback, 1), "c");
	assert_false(playback.finished);
	assert_string_equal(go(&playback, 5), "d");
	assert_true(playback.finished);
	assert_true(playback.time_s == 2);
	assert_string_equal(go(&playback, 5), "");
	assert_true(playback.finished);
	assert_string_equal(go(&playback, 0), "");
	assert_true(playback.finished);
}

static void test_a_long_first_step_passes_all(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, 1);

	(void)state;
	assert_string_equal(go(&playback, 2), "abcd");
	assert_true(playback.finished);
}

static void test_speed_scales_time(void **state)
{
	struct playback playback = playback_begin(2, CLIP_LOOP, 0.5f);

	(void)state;
	assert_string_equal(go(&playback, 1), "ab");
	assert_near(playback.time_s, 0.5, 1e-6);
	playback.speed = 3;
	assert_string_equal(go(&playback, 0.25), "c");
	assert_near(playback.time_s, 1.25, 1e-6);
	playback.speed = 0;
	assert_string_equal(go(&playback, 10), "");
	assert_near(playback.time_s, 1.25, 1e-6);
}

static void test_negative_speed_begins_at_the_end(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, -1);

	(void)state;
	assert_true(playback.time_s == 2);
	assert_string_equal(go(&playback, 1), "dc");
	assert_string_equal(go(&playback, 3), "ba");
	assert_true(playback.finished);
	assert_true(playback.time_s == 0);
}

static void test_a_mark_where_a_step_ends_counts_once(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, 1);

	(void)state;
	assert_string_equal(go(&playback, 0.5), "ab");
	playback.speed = -1;
	assert_string_equal(go(&playback, 0.25), "");
	playback.speed = 1;
	assert_string_equal(go(&playback, 0.25), "b");
}

static void test_a_loop_passes_its_end_and_its_start(void **state)
{
	struct playback playback = playback_begin(2, CLIP_LOOP, 1);

	(void)state;
	assert_string_equal(go(&playback, 1.5), "abc");
	assert_string_equal(go(&playback, 1), "dab");
	assert_near(playback.time_s, 0.5, 1e-6);
	assert_string_equal(go(&playback, 1.5), "cda");
	assert_true(playback.time_s == 0);
	assert_string_equal(go(&playback, 0.1), "");
	assert_false(playback.finished);
}

static void test_a_loop_runs_backwards_over_its_start(void **state)
{
	struct playback playback = playback_begin(2, CLIP_LOOP, -1);

	(void)state;
	assert_string_equal(go(&playback, 0.25), "ad");
	assert_near(playback.time_s, 1.75, 1e-6);
	assert_string_equal(go(&playback, 1.5), "cb");
	assert_string_equal(go(&playback, 1), "adc");
}

static void test_to_and_fro_passes_its_turning_points_once(void **state)
{
	struct playback playback = playback_begin(2, CLIP_PING_PONG, 1);

	(void)state;
	assert_string_equal(go(&playback, 1.5), "abc");
	assert_string_equal(go(&playback, 1), "d");
	assert_near(playback.time_s, 1.5, 1e-6);
	assert_true(playback.returning);
	assert_string_equal(go(&playback, 2), "cbab");
}

static void test_to_and_fro_turns_with_the_speed(void **state)
{
	struct playback playback = playback_begin(2, CLIP_PING_PONG, 1);

	(void)state;
	go(&playback, 3); /* on the way back, at 1 */
	assert_near(playback.time_s, 1, 1e-6);
	playback.speed = -1;
	assert_string_equal(go(&playback, 0.5), "c");
	assert_near(playback.time_s, 1.5, 1e-6);
	assert_string_equal(go(&playback, 1), "d");
	assert_near(playback.time_s, 1.5, 1e-6);
}

/* Small steps and large ones pass the same events. */
static void test_steps_of_any_size_pass_the_same_marks(void **state)
{
	static const enum clip_repeat repeats[] = {CLIP_LOOP, CLIP_PING_PONG};

	(void)state;
	for (int r = 0; r < 2; r++) {
		for (int sign = -1; sign <= 1; sign += 2) {
			struct playback fine =
				playback_begin(2, repeats[r], (float)sign);
			struct playback coarse = fine;
			int fine_count = 0;
			int coarse_count = 0;

			for (int i = 0; i < 512; i++) {
				fine_count += playback_advance(
					&fine, 1 / 64.0, EVENTS, 4, NULL, 0);
			}
			for (int i = 0; i < 4; i++) {
				coarse_count += playback_advance(
					&coarse, 2, EVENTS, 4, NULL, 0);
			}
			assert_int_equal(fine_count, coarse_count);
			assert_near(fine.time_s, coarse.time_s, 1e-5);
		}
	}
}

static void test_a_step_over_many_loops_ends_at_the_right_place(void **state)
{
	struct playback loop = playback_begin(2, CLIP_LOOP, 1);
	struct playback fro = playback_begin(2, CLIP_PING_PONG, -1);

	(void)state;
	playback_advance(&loop, 1e6 + 0.75, EVENTS, 4, NULL, 0);
	assert_near(loop.time_s, 0.75, 1e-4);
	playback_advance(&fro, 1e6 + 0.75, EVENTS, 4, NULL, 0);
	assert_near(fro.time_s, 0.75, 1e-4);
	playback_advance(&loop, 1e300, EVENTS, 4, NULL, 0);
	playback_advance(&loop, (double)NAN, EVENTS, 4, NULL, 0);
	playback_advance(&loop, (double)INFINITY, EVENTS, 4, NULL, 0);
	assert_true(loop.time_s >= 0 && loop.time_s <= 2);
}

static void test_the_ids_that_do_not_fit_are_counted(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, 1);
	int passed[3] = {0, 0, -1};

	(void)state;
	assert_int_equal(
		playback_advance(&playback, 9, EVENTS, 4, passed, 2), 4);
	assert_int_equal(passed[0], 'a');
	assert_int_equal(passed[1], 'b');
	assert_int_equal(passed[2], -1);
}

static void test_a_seek_begins_anew(void **state)
{
	struct playback playback = playback_begin(2, CLIP_ONCE, 1);

	(void)state;
	go(&playback, 9);
	playback_seek(&playback, 1.25f);
	assert_false(playback.finished);
	assert_string_equal(go(&playback, 0.25), "c");
	playback_seek(&playback, 99);
	assert_true(playback.time_s == 2);
	playback_seek(&playback, -1);
	assert_true(playback.time_s == 0);
}

static void test_a_clip_without_length_is_finished_at_once(void **state)
{
	struct playback playback = playback_begin(0, CLIP_ONCE, 1);
	struct playback loop = playback_begin(0, CLIP_LOOP, 1);

	(void)state;
	assert_string_equal(go(&playback, 0.1), "a");
	assert_true(playback.finished);
	assert_string_equal(go(&loop, 0.1), "a");
	assert_string_equal(go(&loop, 0.1), "");
	assert_true(loop.time_s == 0);
}

/*
 * The times of frames at 60 a second, as the clock gives them, in the first 20
 * seconds of each hour; a position in float ends up anywhere in the clip.
 */
static void test_a_month_of_frames_keeps_the_time(void **state)
{
	const double month_s = 30 * 86400.0, burst_s = 20;
	struct playback playback = playback_begin(0.7f, CLIP_LOOP, 1);
	double now_s = 0, far_s = 0, off_s;

	(void)state;
	for (double begin_s = 0; begin_s < month_s; begin_s += 3600) {
		for (double at_s = 0; at_s < burst_s; at_s += 1 / 60.0) {
			playback_advance(&playback, begin_s + at_s - now_s,
				NULL, 0, NULL, 0);
			now_s = begin_s + at_s;
			off_s = fabs(playback.time_s -
				fmod(now_s, (double)0.7f));
			/* Either side of the end is the same place. */
			off_s = fmin(off_s, (double)0.7f - off_s);
			far_s = fmax(far_s, off_s);
		}
	}
	assert_near(far_s, 0, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_once_passes_each_mark_and_stops),
		cmocka_unit_test(test_a_long_first_step_passes_all),
		cmocka_unit_test(test_speed_scales_time),
		cmocka_unit_test(test_negative_speed_begins_at_the_end),
		cmocka_unit_test(test_a_mark_where_a_step_ends_counts_once),
		cmocka_unit_test(test_a_loop_passes_its_end_and_its_start),
		cmocka_unit_test(test_a_loop_runs_backwards_over_its_start),
		cmocka_unit_test(test_to_and_fro_passes_its_turning_points_once),
		cmocka_unit_test(test_to_and_fro_turns_with_the_speed),
		cmocka_unit_test(test_steps_of_any_size_pass_the_same_marks),
		cmocka_unit_test(
			test_a_step_over_many_loops_ends_at_the_right_place),
		cmocka_unit_test(test_the_ids_that_do_not_fit_are_counted),
		cmocka_unit_test(test_a_seek_begins_anew),
		cmocka_unit_test(test_a_clip_without_length_is_finished_at_once),
		cmocka_unit_test(test_a_month_of_frames_keeps_the_time),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
