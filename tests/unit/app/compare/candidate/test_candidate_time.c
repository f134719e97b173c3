/* How a candidate is timed, with a clock and a counter that the test moves. */
#include "app/compare/candidate/candidate_time.h"
#include "platform/process/clock.h"
#include "platform/process/instruction_count.h"
#include "tests/support/test.h"

#include <errno.h>

enum {
	FRAMES = 48,
	POSES = 6 /* of a frame: one that is not timed, and five that are */
};

static const float duration_s = 2.0f;

static struct {
	double clock_s;
	int64_t counter, begun;
	int begin_error, end_error;
	int seeks, poses;
	double seek_s;
	/* The cost of the last of a frame's poses; others cost more. */
	double frame_s[FRAMES];
} fake;

double clock_thread_s(void)
{
	return fake.clock_s;
}

int instruction_count_begin(struct instruction_count *count)
{
	count->descriptor = 5;
	fake.begun = fake.counter;
	return fake.begin_error;
}

int64_t instruction_count_end(struct instruction_count *count)
{
	assert_int_equal(count->descriptor, 5);
	return fake.end_error ? fake.end_error : fake.counter - fake.begun;
}

/* The frames' moments are evenly spaced, beside the clip's begin and end. */
static int frame_at(float time_s)
{
	int frame = (int)(time_s * FRAMES / duration_s);

	assert_near(time_s, duration_s * (frame + 0.37) / FRAMES, 1e-5);
	return frame;
}

static void seek(struct candidate *candidate, float time_s)
{
	(void)candidate;
	frame_at(time_s);
	fake.clock_s += 5.0;
	fake.counter += 1000000;
	fake.seek_s = (double)time_s;
	fake.seeks++;
}

/* Counts the frame's number in instructions. */
static void pose(struct candidate *candidate, float time_s)
{
	int frame = frame_at(time_s);

	(void)candidate;
	assert_near(fake.seek_s, (double)time_s, 0);
	fake.clock_s += fake.frame_s[frame] + (POSES - fake.poses % POSES - 1);
	fake.counter += frame;
	fake.poses++;
}

static struct candidate_time measure(void)
{
	static const struct model_clip clip = {.duration_s = duration_s};
	struct reference reference = {.clip = &clip};
	struct candidate candidate = {
		.reference = &reference, .seek = seek, .pose = pose};

	fake.seeks = fake.poses = 0;
	return candidate_time_measure(&candidate, FRAMES);
}

/* Of 48 frames, so many in no order take a second, and the others four. */
static double frame_us_with(int quick)
{
	for (int i = 0; i < FRAMES; i++) {
		fake.frame_s[FRAMES - 1 - i * 7 % FRAMES] =
			i < quick ? 1.0 : 4.0;
	}
	return measure().frame_us;
}

static void test_the_fastest_pose_of_the_median_frame_counts(void **state)
{
	(void)state;
	assert_near(frame_us_with(FRAMES), 1e6, 1e-3);
	assert_near(frame_us_with(25), 1e6, 1e-3);
	assert_near(frame_us_with(24), 4e6, 1e-3);
	assert_near(frame_us_with(0), 4e6, 1e-3);
}

static void test_each_frame_is_sought_and_posed_as_often(void **state)
{
	(void)state;
	(void)measure();
	/* Once more to count instructions. */
	assert_int_equal(fake.seeks, 2 * FRAMES);
	assert_int_equal(fake.poses, POSES * FRAMES + FRAMES);
}

static void test_instructions_are_those_of_an_average_pose(void **state)
{
	(void)state;
	assert_near(measure().instructions, 47 / 2.0, 1e-9);
}

static void test_without_a_counter_instructions_are_negative(void **state)
{
	(void)state;
	fake.begin_error = -ENOENT;
	assert_true(measure().instructions < 0.0);
	fake.begin_error = 0;
	fake.end_error = -EIO;
	assert_true(measure().instructions < 0.0);
	fake.end_error = 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_fastest_pose_of_the_median_frame_counts),
		cmocka_unit_test(test_each_frame_is_sought_and_posed_as_often),
		cmocka_unit_test(test_instructions_are_those_of_an_average_pose),
		cmocka_unit_test(
			test_without_a_counter_instructions_are_negative),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
