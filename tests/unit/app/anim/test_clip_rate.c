/* The time between a clip's original frames: clip_join_frame_s(). */
#include "app/anim/clip_join.h"
#include "tests/support/test.h"

enum {
	KEYS_MAX = 12
};

/* Of channels, of which the last is not the clip's. */
static float frame_s(const struct model_channel *channel, int count)
{
	const struct model_clip clip = {.duration_s = 1,
		.channel_count = count,
		.channel = (struct model_channel *)channel};

	return clip_join_frame_s(&clip);
}

/* The time after the last key is on no frame and not the channel's. */
static float frame_of_keys_s(const float *time_s, int key_count)
{
	static const float late_s[KEYS_MAX] = {
		0, 0.01f, 0.02f, 0.03f, 0.04f, 0.05f, 0.06f, 0.07f, 0.08f};
	const struct model_channel channel[2] = {
		{.key_count = key_count, .time_s = time_s},
		{.key_count = 9, .time_s = late_s}};

	return frame_s(channel, 1);
}

static void test_few_keys_have_the_first_rate_that_fits_all(void **state)
{
	static const int rates_hz[] = {30, 24, 25, 60, 50, 48, 120, 100, 240};
	static const int frames[] = {0, 1, 12, 13, 29};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rates_hz); i++) {
		float rate_hz = (float)rates_hz[i];
		float time_s[6] = {0};

		for (int k = 0; k < 5; k++) {
			time_s[k] = (float)frames[k] / rate_hz;
		}
		time_s[5] = time_s[4] + 0.0021f;
		assert_near(frame_of_keys_s(time_s, 5), 1 / rate_hz, 1e-6);
		/* One key off the frames is too many, be it the first. */
		time_s[0] = 0.0021f;
		assert_near(frame_of_keys_s(time_s, 5), 1 / 30.0, 1e-6);
	}
}

/* To half a millisecond, and of late keys to a millionth of their time more. */
static void test_keys_may_lie_a_little_beside_frames(void **state)
{
	static const struct {
		float at_s, off_s;
		int rate_hz;
	} cases[] = {{5, 0.0004f, 24}, {5, -0.0004f, 24}, {5, 0.0006f, 30},
		{5, -0.0006f, 30}, {1000, 0.0013f, 24}, {1000, 0.0017f, 30},
		{1000, -0.0013f, 24}, {1000, -0.0017f, 30}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const float time_s[3] = {0, 5 / 24.0f,
			cases[i].at_s + 7 / 24.0f + cases[i].off_s};

		assert_near(frame_of_keys_s(time_s, 3), 1.0 / cases[i].rate_hz,
			1e-6);
	}
}

/* 20 Hz is none of the rates; 60 Hz is the first that has its frames. */
static void test_8_keys_tell_a_rate(void **state)
{
	(void)state;
	for (int count = 2; count < KEYS_MAX; count++) {
		float time_s[KEYS_MAX] = {0};

		for (int k = 0; k < count; k++) {
			time_s[k] = 0.5f + (float)k * 0.05f;
		}
		time_s[count] = time_s[count - 1] + 0.0713f;
		assert_near(frame_of_keys_s(time_s, count),
			count < 8 ? 1 / 60.0 : 0.05, 1e-6);
	}
}

static void test_any_uneven_gap_makes_keys_tell_nothing(void **state)
{
	static const float off_s[] = {
		-0.0006f, -0.0004f, 0, 0.0004f, 0.0006f, 0.1f};

	(void)state;
	for (int at = 2; at < 9; at++) {
		for (size_t i = 0; i < ARRAY_COUNT(off_s); i++) {
			bool even = off_s[i] > -0.0005f && off_s[i] < 0.0005f;
			float time_s[10] = {0};

			for (int k = 1; k < 10; k++) {
				time_s[k] = time_s[k - 1] + 0.043f +
					(k == at ? off_s[i] : 0);
			}
			assert_near(frame_of_keys_s(time_s, 9),
				even ? 0.043 : 1 / 30.0, 1e-6);
		}
	}
}

/* The second gap is off by half a millisecond to the last bit. */
static void test_half_a_millisecond_is_still_even(void **state)
{
	const float off_s = 5e-4f;
	float time_s[10] = {-5e-4f};

	(void)state;
	for (int k = 2; k < 10; k++) {
		time_s[k] = (float)k * off_s;
	}
	assert_near(frame_of_keys_s(time_s, 9), 5e-4, 1e-9);
}

static void test_gaps_above_a_tenth_of_a_second_tell_nothing(void **state)
{
	static const struct {
		float gap_s, want_s;
	} cases[] = {{0.1f, 0.1f}, {0.1009f, 0.1009f}, {0.101f, 0.101f},
		{0.102f, 1 / 30.0f}, {0.25f, 1 / 24.0f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		float time_s[10];

		for (int k = 0; k < 10; k++) {
			time_s[k] = (float)k * cases[i].gap_s;
		}
		assert_near(frame_of_keys_s(time_s, 9), cases[i].want_s, 1e-6);
	}
}

static void test_the_closest_of_all_channels_keys_count(void **state)
{
	static const int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
		{1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	static const float few_s[2] = {0, 0.0021f};
	float wide_s[9], narrow_s[9], beyond_s[9];
	const struct model_channel channel[3] = {
		{.key_count = 2, .time_s = few_s},
		{.key_count = 9, .time_s = wide_s},
		{.key_count = 9, .time_s = narrow_s}};
	struct model_channel ordered[4];

	(void)state;
	for (int k = 0; k < 9; k++) {
		wide_s[k] = (float)k * 0.07f;
		narrow_s[k] = (float)k * 0.03f;
		beyond_s[k] = (float)k * 0.01f;
	}
	ordered[3] = (struct model_channel){.key_count = 9, .time_s = beyond_s};
	for (size_t i = 0; i < ARRAY_COUNT(orders); i++) {
		for (int c = 0; c < 3; c++) {
			ordered[c] = channel[orders[i][c]];
		}
		assert_near(frame_s(ordered, 3), 0.03, 1e-6);
	}
	/* The rates are not asked of channels beyond, either. */
	ordered[0] = (struct model_channel){
		.key_count = 2, .time_s = (const float[2]){0, 7 / 24.0f}};
	ordered[1] = channel[0];
	assert_near(frame_s(ordered, 1), 1 / 24.0, 1e-6);
	assert_near(frame_s(ordered, 2), 1 / 30.0, 1e-6);
	assert_near(frame_s(ordered, 0), 1 / 30.0, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_few_keys_have_the_first_rate_that_fits_all),
		cmocka_unit_test(test_keys_may_lie_a_little_beside_frames),
		cmocka_unit_test(test_8_keys_tell_a_rate),
		cmocka_unit_test(test_any_uneven_gap_makes_keys_tell_nothing),
		cmocka_unit_test(test_half_a_millisecond_is_still_even),
		cmocka_unit_test(
			test_gaps_above_a_tenth_of_a_second_tell_nothing),
		cmocka_unit_test(test_the_closest_of_all_channels_keys_count),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
