#include "app/anim/clip.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* A channel with width floats a key. */
static struct model_channel make_channel(enum model_path path,
	enum model_interpolation interpolation, int width, int key_count,
	const float *time_s, const float *value)
{
	return (struct model_channel){.path = path,
		.interpolation = interpolation,
		.width = width,
		.key_count = key_count,
		.time_s = time_s,
		.value = value};
}

static float sample_as(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int element)
{
	float out[8] = {0};
	int key = 0;

	clip_sample_channel(channel, time_s, interpolation, &key, out);
	return out[element];
}

static float sample_one(
	const struct model_channel *channel, float time_s, int element)
{
	return sample_as(channel, time_s, CLIP_AUTO, element);
}

static const float TIMES[3] = {0.5f, 1, 3};
static const float POINTS[9] = {1, 2, 3, 11, 12, 13, 11, 22, 33};

static const struct model_channel LINEAR_POINTS = {.path = MODEL_TRANSLATION,
	.interpolation = MODEL_LINEAR,
	.width = 3,
	.key_count = 3,
	.time_s = TIMES,
	.value = POINTS};

static void test_pitfall_3_clamps_before_the_first_key(void **state)
{
	(void)state;
	assert_true(sample_one(&LINEAR_POINTS, 0, 0) == 1);
	assert_true(sample_one(&LINEAR_POINTS, 0.5f, 1) == 2);
	assert_true(sample_one(&LINEAR_POINTS, -100, 2) == 3);
	assert_true(sample_one(&LINEAR_POINTS, NAN, 2) == 3);
}

static void test_pitfall_3_clamps_after_the_last_key(void **state)
{
	(void)state;
	assert_true(sample_one(&LINEAR_POINTS, 3, 0) == 11);
	assert_true(sample_one(&LINEAR_POINTS, 3.0001f, 1) == 22);
	assert_true(sample_one(&LINEAR_POINTS, 1e30f, 2) == 33);
}

static void test_linear_goes_straight_between_keys(void **state)
{
	(void)state;
	assert_near(sample_one(&LINEAR_POINTS, 0.75f, 0), 6, 1e-6);
	assert_true(sample_one(&LINEAR_POINTS, 1, 1) == 12);
	assert_near(sample_one(&LINEAR_POINTS, 1.5f, 1), 14.5, 1e-6);
	assert_near(sample_one(&LINEAR_POINTS, 2.5f, 2), 28, 1e-6);
}

/* Each time between the keys has its own value: there is no sampling rate. */
static void test_pitfall_7_times_between_frames_are_not_rounded(void **state)
{
	(void)state;
	for (int i = 0; i < 1000; i++) {
		float time_s = 1 + (float)i * 0.0017f;

		assert_near(sample_one(&LINEAR_POINTS, time_s, 1),
			12 + 10 * ((double)time_s - 1) / 2, 1e-5);
	}
}

static void test_pitfall_4_one_key_holds_at_all_times(void **state)
{
	static const float time_s[1] = {2};
	static const float cubic[9] = {9, 9, 9, 1, 2, 3, 7, 7, 7};
	struct model_channel channel = {.path = MODEL_SCALE,
		.width = 3,
		.key_count = 1,
		.time_s = time_s};

	(void)state;
	for (int kind = MODEL_STEP; kind <= MODEL_CUBICSPLINE; kind++) {
		channel.interpolation = (enum model_interpolation)kind;
		channel.value = kind == MODEL_CUBICSPLINE ? cubic : cubic + 3;
		assert_true(sample_one(&channel, 0, 0) == 1);
		assert_true(sample_one(&channel, 2, 1) == 2);
		assert_true(sample_one(&channel, 5, 2) == 3);
	}
}

static void test_pitfall_4_step_steps(void **state)
{
	struct model_channel channel = LINEAR_POINTS;

	(void)state;
	channel.interpolation = MODEL_STEP;
	assert_true(sample_one(&channel, 0.999f, 1) == 2);
	assert_true(sample_one(&channel, 1, 1) == 12);
	assert_true(sample_one(&channel, 2.999f, 1) == 12);
	assert_true(sample_one(&channel, 3, 1) == 22);
}

/* Two keys at an interval of 0.5 s, each with tangent, value and tangent. */
static const float CUBIC_TIMES[2] = {1, 1.5f};
static const float CUBIC_POINTS[18] = {
	77, 77, 77, 1, 2, 3, 4, 0, -2,  /* tangents out of key 0 */
	-6, 2, 0, 5, 2, -1, 88, 88, 88, /* tangents into key 1 */
};

static void test_pitfall_1_cubic_tangents_scale_with_the_interval(void **state)
{
	struct model_channel channel = make_channel(MODEL_TRANSLATION,
		MODEL_CUBICSPLINE, 3, 2, CUBIC_TIMES, CUBIC_POINTS);

	(void)state;
	/*
	 * Halfway: (from + to) / 2 + interval * (out - in) / 8, so for x
	 * (1 + 5) / 2 + 0.5 * (4 + 6) / 8 = 3.625.
	 */
	assert_near(sample_one(&channel, 1.25f, 0), 3.625, 1e-6);
	assert_near(sample_one(&channel, 1.25f, 1), 2 - 0.125, 1e-6);
	assert_near(sample_one(&channel, 1.25f, 2), 1 - 0.125, 1e-6);
	assert_true(sample_one(&channel, 1, 0) == 1);
	assert_true(sample_one(&channel, 1.5f, 0) == 5);
	/* The slope at the first key is the tangent. */
	assert_near((sample_one(&channel, 1.001f, 0) - 1) / 0.001, 4, 0.05);
}

static void test_pitfall_1_cubic_rotations_come_out_unit(void **state)
{
	/* Tangent, value, tangent of key 0; the same of key 1. */
	static const float value[24] = {0, 0, 0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0,
		0, -3, 0, 0, 0.6f, 0, 0.8f, 0, 0, 0, 0};
	struct model_channel channel = make_channel(
		MODEL_ROTATION, MODEL_CUBICSPLINE, 4, 2, CUBIC_TIMES, value);
	float out[4];
	int key = 0;
	/* Halfway: mean of the keys + 0.5 / 8 * (out - in). */
	double want[4] = {0.1875, 0.3, 0.1875, 0.9};
	double length = sqrt(2 * 0.1875 * 0.1875 + 0.09 + 0.81);

	(void)state;
	clip_sample_channel(&channel, 1.25f, CLIP_AUTO, &key, out);
	for (int k = 0; k < 4; k++) {
		assert_near(out[k], want[k] / length, 1e-6);
	}
}

static void test_pitfall_2_cubic_weights_are_packed_by_kind(void **state)
{
	/* Three targets: in-tangents, values, out-tangents of each key. */
	static const float value[18] = {
		9, 9, 9, 0, 0.5f, 1, 2, 0, 0, /* of key 0 */
		0, 0, 4, 1, 0.5f, 0, 9, 9, 9  /* of key 1 */
	};
	struct model_channel channel = make_channel(
		MODEL_WEIGHTS, MODEL_CUBICSPLINE, 3, 2, CUBIC_TIMES, value);

	(void)state;
	assert_true(sample_one(&channel, 1, 0) == 0);
	assert_true(sample_one(&channel, 1, 1) == 0.5f);
	assert_true(sample_one(&channel, 1, 2) == 1);
	assert_near(sample_one(&channel, 1.25f, 0), 0.5 + 0.125, 1e-6);
	assert_near(sample_one(&channel, 1.25f, 1), 0.5, 1e-6);
	assert_near(sample_one(&channel, 1.25f, 2), 0.5 - 0.25, 1e-6);
	assert_true(sample_one(&channel, 1.5f, 0) == 1);
}

static void test_linear_rotations_turn_at_constant_speed(void **state)
{
	const double pi = acos(-1);
	static const float time_s[2] = {0, 1};
	const float value[8] = {
		0, 0, 0, 1, 0, (float)sin(pi / 3), 0, (float)cos(pi / 3)};
	struct model_channel channel =
		make_channel(MODEL_ROTATION, MODEL_LINEAR, 4, 2, time_s, value);

	(void)state;
	for (int i = 0; i <= 20; i++) {
		float t = (float)i / 20;

		assert_near(sample_one(&channel, t, 1), sin(t * pi / 3), 3e-6);
		assert_near(sample_one(&channel, t, 3), cos(t * pi / 3), 3e-6);
	}
}

static void test_pitfall_5_rotation_keys_take_the_shorter_arc(void **state)
{
	const double pi = acos(-1);
	static const float time_s[2] = {0, 1};
	/* The negative of 40 degrees about x, which is the same rotation. */
	const float value[8] = {
		0, 0, 0, 1, -(float)sin(pi / 9), 0, 0, -(float)cos(pi / 9)};
	struct model_channel channel =
		make_channel(MODEL_ROTATION, MODEL_LINEAR, 4, 2, time_s, value);

	(void)state;
	assert_near(sample_one(&channel, 0.5f, 0), sin(pi / 18), 3e-6);
	assert_near(sample_one(&channel, 0.5f, 3), cos(pi / 18), 3e-6);
}

/* The loader normalises integer keys, and float keys are the file's. */
static void test_rotation_keys_are_taken_as_they_are(void **state)
{
	static const float time_s[2] = {0, 1};
	static const float value[8] = {0, 0, 0, 1, 0, 0, 0.707f, 0.707f};
	struct model_channel channel =
		make_channel(MODEL_ROTATION, MODEL_LINEAR, 4, 2, time_s, value);
	float out[4];
	int key = 0;

	(void)state;
	clip_sample_channel(&channel, 1, CLIP_AUTO, &key, out);
	assert_memory_equal(out, value + 4, sizeof(out));
}

enum {
	MANY = 200
};

static void make_ramp(struct model_channel *channel, float *time_s, float *value)
{
	for (int i = 0; i < MANY; i++) {
		time_s[i] = (float)i * 0.1f + (i % 3 ? 0.04f : 0);
		value[i] = 10 * time_s[i];
	}
	*channel = (struct model_channel){.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = 1,
		.key_count = MANY,
		.time_s = time_s,
		.value = value};
}

static void assert_ramp(
	const struct model_channel *channel, float time_s, int *key)
{
	float out;
	double want = 10 * (double)time_s;

	clip_sample_channel(channel, time_s, CLIP_AUTO, key, &out);
	want = fmin(fmax(want, channel->value[0]), channel->value[MANY - 1]);
	assert_near(out, want, 1e-4);
	assert_true(*key >= 0 && *key < MANY);
}

static void test_keys_are_found_playing_either_way_and_jumping(void **state)
{
	float time_s[MANY], value[MANY];
	struct model_channel channel;
	int key = 0;

	(void)state;
	make_ramp(&channel, time_s, value);
	for (float t = -1; t < 22; t += 0.013f) {
		assert_ramp(&channel, t, &key);
	}
	for (float t = 22; t > -1; t -= 0.013f) {
		assert_ramp(&channel, t, &key);
	}
	for (int i = 0; i < 2000; i++) {
		assert_ramp(&channel, fmodf((float)i * 7.31f, 20), &key);
	}
}

static void test_any_content_of_the_cache_is_valid(void **state)
{
	static const int odd[] = {-1, -1000, MANY - 2, MANY - 1, MANY, 9999,
		INT32_MAX, INT32_MIN};
	float time_s[MANY], value[MANY];
	struct model_channel channel;

	(void)state;
	make_ramp(&channel, time_s, value);
	for (size_t i = 0; i < sizeof(odd) / sizeof(odd[0]); i++) {
		int key = odd[i];

		assert_ramp(&channel, 12.34f, &key);
		key = odd[i];
		assert_ramp(&channel, 0.01f, &key);
		key = odd[i];
		assert_ramp(&channel, 19.85f, &key);
	}
}

static void test_nearest_takes_the_closer_key(void **state)
{
	(void)state;
	assert_true(sample_as(&LINEAR_POINTS, 0.7f, CLIP_NEAREST, 1) == 2);
	assert_true(sample_as(&LINEAR_POINTS, 0.75f, CLIP_NEAREST, 1) == 12);
	assert_true(sample_as(&LINEAR_POINTS, 1.99f, CLIP_NEAREST, 1) == 12);
	assert_true(sample_as(&LINEAR_POINTS, 2, CLIP_NEAREST, 1) == 22);
	assert_true(sample_as(&LINEAR_POINTS, 9, CLIP_NEAREST, 1) == 22);
}

static void test_an_override_counts_for_any_channel(void **state)
{
	struct model_channel cubic = make_channel(MODEL_TRANSLATION,
		MODEL_CUBICSPLINE, 3, 2, CUBIC_TIMES, CUBIC_POINTS);
	struct model_channel step = LINEAR_POINTS;

	(void)state;
	step.interpolation = MODEL_STEP;
	assert_near(sample_as(&step, 0.75f, CLIP_LINEAR, 0), 6, 1e-6);
	assert_true(sample_as(&step, 0.75f, CLIP_AUTO, 0) == 1);
	assert_true(sample_as(&LINEAR_POINTS, 0.9f, CLIP_STEP, 0) == 1);
	assert_near(sample_as(&cubic, 1.25f, CLIP_LINEAR, 0), 3, 1e-6);
	assert_true(sample_as(&cubic, 1.4f, CLIP_STEP, 0) == 1);
	assert_true(sample_as(&cubic, 1.4f, CLIP_NEAREST, 0) == 5);
	assert_near(sample_as(&cubic, 1.25f, CLIP_CUBIC, 0), 3.625, 1e-6);
}

/*
 * The keys are at 0.5, 1 and 3 s. Between the first two, x goes from 1 to 11.
 * The tangents are (11 - 1) / 0.5 = 20 at the first key and (11 - 1) / 2.5 = 4
 * at the second, so halfway x is (1 + 11) / 2 + 0.5 * (20 - 4) / 8 = 7.
 */
static void test_cubic_makes_catmull_rom_tangents(void **state)
{
	(void)state;
	assert_near(sample_as(&LINEAR_POINTS, 0.75f, CLIP_CUBIC, 0), 7, 1e-5);
	/* x goes from 11 to 11, tangents 4 and 0: 11 + 2 * (4 - 0) / 8. */
	assert_near(sample_as(&LINEAR_POINTS, 2, CLIP_CUBIC, 0), 12, 1e-5);
	assert_true(sample_as(&LINEAR_POINTS, 1, CLIP_CUBIC, 0) == 11);
	assert_true(sample_as(&LINEAR_POINTS, 3, CLIP_CUBIC, 1) == 22);
}

static void test_cubic_follows_a_line_exactly(void **state)
{
	float time_s[MANY], value[MANY];
	struct model_channel channel;

	(void)state;
	make_ramp(&channel, time_s, value);
	for (float t = 0; t < 19; t += 0.017f) {
		assert_near(sample_as(&channel, t, CLIP_CUBIC, 0),
			10 * (double)t, 1e-4);
	}
}

static void test_cubic_has_no_corners(void **state)
{
	const float step_s = 1.0f / 1024;
	float before = sample_as(&LINEAR_POINTS, 1 - step_s, CLIP_CUBIC, 1);
	float at = sample_as(&LINEAR_POINTS, 1, CLIP_CUBIC, 1);
	float after = sample_as(&LINEAR_POINTS, 1 + step_s, CLIP_CUBIC, 1);

	(void)state;
	/* The tangent of the middle key is (22 - 2) / 2.5 a second. */
	assert_near((at - before) / step_s, 8, 0.1);
	assert_near((after - at) / step_s, 8, 0.1);
}

static void test_cubic_rotations_ignore_the_keys_signs(void **state)
{
	static const float time_s[4] = {0, 1, 2, 3};
	float value[16], flipped[16];
	struct model_channel a =
		make_channel(MODEL_ROTATION, MODEL_LINEAR, 4, 4, time_s, value);
	struct model_channel b = a;

	(void)state;
	for (int i = 0; i < 4; i++) {
		double half = 0.3 * i * i + 0.1;
		float sign = i % 2 ? -1 : 1;

		memset(value + 4 * i, 0, 4 * sizeof(*value));
		value[4 * i + 1] = (float)sin(half);
		value[4 * i + 3] = (float)cos(half);
		for (int k = 0; k < 4; k++) {
			flipped[4 * i + k] = sign * value[4 * i + k];
		}
	}
	b.value = flipped;
	for (float t = 0.05f; t < 3; t += 0.1f) {
		float qa[4], qb[4];
		double length = 0;
		double dot = 0;
		int key = 0;

		clip_sample_channel(&a, t, CLIP_CUBIC, &key, qa);
		clip_sample_channel(&b, t, CLIP_CUBIC, &key, qb);
		for (int k = 0; k < 4; k++) {
			length += (double)qa[k] * qa[k];
			dot += (double)qa[k] * qb[k];
		}
		assert_near(length, 1, 1e-6);
		assert_near(fabs(dot), 1, 1e-6);
	}
}

static void test_interpolations_are_found_by_name(void **state)
{
	static const char *const name[] = {
		"auto", "nearest", "step", "linear", "cubic"};

	(void)state;
	for (int i = CLIP_AUTO; i <= CLIP_CUBIC; i++) {
		assert_int_equal(clip_interpolation_find(name[i]), i);
	}
	assert_int_equal(clip_interpolation_find("bezier"), -1);
	assert_int_equal(clip_interpolation_find(""), -1);
}

/* The keys of a spline are normalised as what lies between them is. */
static void test_a_rotation_has_unit_length_at_the_keys_of_a_spline(void **state)
{
	static const float value[24] = {0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0,
		0, /* twice as long as 1 */
		0, 0, 0, 0, 0, 0.3f, 0, 0.4f, 0, 0, 0, 0};
	static const float first[4] = {0, 0, 0, 1}, last[4] = {0, 0.6f, 0, 0.8f};
	const struct model_channel channel = make_channel(
		MODEL_ROTATION, MODEL_CUBICSPLINE, 4, 2, CUBIC_TIMES, value);

	(void)state;
	for (int kind = CLIP_AUTO; kind <= CLIP_CUBIC; kind++) {
		enum clip_interpolation as = (enum clip_interpolation)kind;

		for (int i = 0; i < 4; i++) {
			assert_near(
				sample_as(&channel, 0, as, i), first[i], 1e-6);
			assert_near(
				sample_as(&channel, 1, as, i), first[i], 1e-6);
			assert_near(
				sample_as(&channel, 9, as, i), last[i], 1e-6);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_pitfall_3_clamps_before_the_first_key),
		cmocka_unit_test(test_pitfall_3_clamps_after_the_last_key),
		cmocka_unit_test(test_linear_goes_straight_between_keys),
		cmocka_unit_test(
			test_pitfall_7_times_between_frames_are_not_rounded),
		cmocka_unit_test(test_pitfall_4_one_key_holds_at_all_times),
		cmocka_unit_test(test_pitfall_4_step_steps),
		cmocka_unit_test(
			test_pitfall_1_cubic_tangents_scale_with_the_interval),
		cmocka_unit_test(test_pitfall_1_cubic_rotations_come_out_unit),
		cmocka_unit_test(test_pitfall_2_cubic_weights_are_packed_by_kind),
		cmocka_unit_test(test_linear_rotations_turn_at_constant_speed),
		cmocka_unit_test(
			test_pitfall_5_rotation_keys_take_the_shorter_arc),
		cmocka_unit_test(test_rotation_keys_are_taken_as_they_are),
		cmocka_unit_test(
			test_keys_are_found_playing_either_way_and_jumping),
		cmocka_unit_test(test_any_content_of_the_cache_is_valid),
		cmocka_unit_test(test_nearest_takes_the_closer_key),
		cmocka_unit_test(test_an_override_counts_for_any_channel),
		cmocka_unit_test(test_cubic_makes_catmull_rom_tangents),
		cmocka_unit_test(test_cubic_follows_a_line_exactly),
		cmocka_unit_test(test_cubic_has_no_corners),
		cmocka_unit_test(test_cubic_rotations_ignore_the_keys_signs),
		cmocka_unit_test(test_interpolations_are_found_by_name),
		cmocka_unit_test(
			test_a_rotation_has_unit_length_at_the_keys_of_a_spline),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
