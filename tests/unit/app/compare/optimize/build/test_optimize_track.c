/* Which values may stand for others, and which keys of a channel suffice. */
#include "app/compare/optimize/build/optimize_track.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>

enum {
	KEYS_MAX = 20
};

static const float target_px[2] = {3.0f, 5.0f};
static const struct optimize_reach_node reach = {.move_px = 100.0f,
	.turn_px = 50.0f,
	.scale_px = 20.0f,
	.target_count = 2,
	.target_px = target_px};

/* The times of keys at even distances: 0, 0.5, 1... */
static const float *even_times(void)
{
	static float time_s[KEYS_MAX];

	for (int i = 0; i < KEYS_MAX; i++) {
		time_s[i] = 0.5f * (float)i;
	}
	return time_s;
}

static struct optimize_track track_of(enum model_path path, int width,
	const float *value, int keys, float bound_px)
{
	return (struct optimize_track){.path = path,
		.interpolation = MODEL_LINEAR,
		.width = width,
		.key_count = keys,
		.time_s = even_times(),
		.value = value,
		.reach = &reach,
		.bound_px = bound_px};
}

/* Whether values apart by so much, in one component, may replace each other. */
static bool near(struct optimize_track *track, int component, float apart)
{
	float a[4] = {0.25f, -0.5f, 0.125f, 0.75f}, b[4];

	for (int i = 0; i < 4; i++) {
		b[i] = a[i] + (i == component ? apart : 0.0f);
	}
	return optimize_track_is_near(track, a, b) &&
		optimize_track_is_near(track, b, a);
}

static void test_values_are_near_within_the_bound_of_pixels(void **state)
{
	static const struct {
		enum model_path path;
		int width;
		float px[4]; /* of 1, by component */
	} paths[] = {
		{MODEL_TRANSLATION, 3, {100, 100, 100}},
		{MODEL_ROTATION, 4, {2 * 50, 2 * 50, 2 * 50, 2 * 50}},
		{MODEL_SCALE, 3, {20, 20, 20}},
		{MODEL_WEIGHTS, 2, {3, 5}},
	};

	(void)state;
	for (size_t p = 0; p < ARRAY_COUNT(paths); p++) {
		struct optimize_track track =
			track_of(paths[p].path, paths[p].width, NULL, 0, 0.5f);

		for (int i = 0; i < paths[p].width; i++) {
			float most = 0.5f / paths[p].px[i];

			assert_true(near(&track, i, 0.99f * most));
			assert_true(near(&track, i, -0.99f * most));
			assert_false(near(&track, i, 1.01f * most));
			assert_false(near(&track, i, -1.01f * most));
		}
		assert_true(near(&track, -1, 0.0f));
	}
}

/* A turn by q is one by -q, too. */
static void test_opposite_quaternions_are_near(void **state)
{
	const float a[4] = {0.5f, -0.5f, 0.5f, 0.5f};
	const float b[4] = {-0.5f, 0.5f, -0.5f, -0.5f};
	struct optimize_track track =
		track_of(MODEL_ROTATION, 4, NULL, 0, 0.01f);

	(void)state;
	assert_true(optimize_track_is_near(&track, a, b));
	track.bound_px = 0.0f;
	assert_false(optimize_track_is_near(&track, a, b));
}

/* Without a bound, and where a camera follows, only rounding may differ. */
static void test_exact_values_may_differ_by_rounding(void **state)
{
	static const float sizes[] = {0.01f, 1.0f, 1000.0f};
	struct optimize_reach_node followed = reach;
	struct optimize_track track[2] = {
		track_of(MODEL_TRANSLATION, 3, NULL, 0, 0.0f),
		track_of(MODEL_TRANSLATION, 3, NULL, 0, 1e6f)};

	(void)state;
	followed.exact = true;
	track[1].reach = &followed;
	for (int i = 0; i < 6; i++) {
		float size = sizes[i / 2], limit = size > 1.0f ? size : 1.0f;
		float a[3] = {-size, size, size};
		float b[3] = {-size, size + 0.5e-6f * limit, size};

		assert_true(optimize_track_is_near(&track[i % 2], a, b));
		b[1] = size + 2e-6f * limit;
		assert_false(optimize_track_is_near(&track[i % 2], a, b));
		b[1] = size - 2e-6f * limit;
		assert_false(optimize_track_is_near(&track[i % 2], a, b));
	}
}

/* A model of a micrometre moves by less than the rounding of 1. */
static void test_rounding_is_small_beside_a_small_model(void **state)
{
	struct optimize_reach_node small = reach;
	struct optimize_track track =
		track_of(MODEL_TRANSLATION, 3, NULL, 0, 0.0f);
	const float rest[3] = {0.0f};
	float moved[3] = {0.0f, 1e-7f, 0.0f};

	(void)state;
	small.move_px = 1e8f;
	track.reach = &small;
	assert_false(optimize_track_is_near(&track, rest, moved));
	assert_false(optimize_track_is_near(&track, moved, rest));
	moved[1] = 5e-12f;
	assert_true(optimize_track_is_near(&track, rest, moved));
}

/* As in models with coordinates of a country's grid. */
static void test_places_far_away_stay_apart_by_what_is_seen(void **state)
{
	const float a[3] = {5e6f, 0.0f, 0.0f}, b[3] = {5e6f + 1.0f, 0.0f, 0.0f};
	const float large[3] = {50.0f, 0.0f, 0.0f};
	const float nearly[3] = {50.00004f, 0.0f, 0.0f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		static const float bound_px[] = {0.0f, 0.05f, 0.5f};
		const struct optimize_track track =
			track_of(MODEL_TRANSLATION, 3, NULL, 0, bound_px[i]);

		assert_false(optimize_track_is_near(&track, a, b));
		assert_true(optimize_track_is_near(&track, a, a));
		assert_true(optimize_track_is_near(&track, large, nearly));
	}
}

static void test_a_track_is_constant_if_all_keys_are_near_the_first(void **state)
{
	float value[4] = {1.0f, 1.0f, 1.0f, 1.0f};
	struct optimize_track track = track_of(MODEL_WEIGHTS, 1, value, 4, 0.0f);

	(void)state;
	assert_true(optimize_track_is_constant(&track));
	for (int key = 0; key < 4; key++) {
		value[key] = 2.0f;
		assert_false(optimize_track_is_constant(&track));
		value[key] = 1.0f;
	}
	track.key_count = 1;
	value[1] = 2.0f;
	assert_true(optimize_track_is_constant(&track));
}

/* Before each value of a spline is a tangent, and behind it. */
static void test_a_spline_is_constant_without_tangents(void **state)
{
	float value[3 * 3 * 2];
	struct optimize_track track = track_of(MODEL_WEIGHTS, 2, value, 3, 0.0f);

	(void)state;
	track.interpolation = MODEL_CUBICSPLINE;
	for (int i = 0; i < 18; i++) {
		value[i] = i / 2 % 3 == 1 ? 0.5f + (float)(i % 2) : 0.0f;
	}
	assert_near(optimize_track_value(&track, 2)[1], 1.5, 0.0);
	assert_true(optimize_track_is_constant(&track));
	for (int i = 0; i < 18; i++) {
		value[i] += 0.25f;
		assert_false(optimize_track_is_constant(&track));
		value[i] -= 0.25f;
	}
}

static void expect_kept(const struct optimize_track *first,
	const struct optimize_track *second, const int *wanted, int count)
{
	const struct optimize_track *const tracks[] = {first, second};
	int kept[KEYS_MAX];

	assert_int_equal(
		optimize_track_reduce(tracks, second ? 2 : 1, kept), count);
	for (int i = 0; i < count; i++) {
		assert_int_equal(kept[i], wanted[i]);
	}
}

/* A line with a bend at each key in turn. */
static void test_a_line_keeps_its_bends(void **state)
{
	(void)state;
	for (int keys = 2; keys <= KEYS_MAX; keys++) {
		for (int bend = 0; bend < keys; bend++) {
			float value[KEYS_MAX];
			struct optimize_track track =
				track_of(MODEL_WEIGHTS, 1, value, keys, 0.0f);
			bool inner = bend > 0 && bend < keys - 1;
			const int wanted[] = {
				0, inner ? bend : keys - 1, keys - 1};

			for (int i = 0; i < keys; i++) {
				value[i] = (float)(i < bend ? i : 2 * bend - i);
			}
			expect_kept(&track, NULL, wanted, inner ? 3 : 2);
		}
	}
}

static void test_tracks_with_common_times_keep_all_their_bends(void **state)
{
	enum {
		KEYS = 12
	};
	float a[KEYS], b[KEYS];
	struct optimize_track first = track_of(MODEL_WEIGHTS, 1, a, KEYS, 0.0f);
	struct optimize_track second = track_of(MODEL_WEIGHTS, 1, b, KEYS, 0.0f);

	(void)state;
	for (int i = 0; i < KEYS; i++) {
		a[i] = (float)abs(i - 3);
		b[i] = (float)abs(i - 8);
	}
	expect_kept(&first, &second, (const int[]){0, 3, 8, KEYS - 1}, 4);
	expect_kept(&first, NULL, (const int[]){0, 3, KEYS - 1}, 3);
}

/* A step's last key is where its value ends. */
static void test_a_stair_keeps_the_key_of_each_step(void **state)
{
	enum {
		KEYS = 9
	};
	float value[KEYS] = {1, 1, 1, 4, 4, 2, 2, 2, 2};
	struct optimize_track track =
		track_of(MODEL_WEIGHTS, 1, value, KEYS, 0.0f);

	(void)state;
	track.interpolation = MODEL_STEP;
	expect_kept(&track, NULL, (const int[]){0, 3, 5, KEYS - 1}, 4);
}

/* Between the keys that stay, others may be away by the bound. */
static void test_a_path_keeps_within_the_bound(void **state)
{
	float value[3][3] = {{0, 0, 0}, {0, 0, 0}, {2, 4, 6}};

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (int far = 0; far < 2; far++) {
			struct optimize_track track = track_of(
				MODEL_TRANSLATION, 3, value[0], 3, 0.5f);

			for (int i = 0; i < 3; i++) {
				value[1][i] = 0.5f * value[2][i];
			}
			value[1][axis] += far ? 0.00505f : 0.00495f;
			expect_kept(&track, NULL,
				far ? (const int[]){0, 1, 2}
				    : (const int[]){0, 2, 2},
				far ? 3 : 2);
		}
	}
}

/* A turn about an axis at a constant speed needs its ends alone. */
static void test_a_turn_is_interpolated_on_the_sphere(void **state)
{
	float value[9][4];
	struct optimize_track track =
		track_of(MODEL_ROTATION, 4, value[0], 9, 0.0f);

	(void)state;
	for (int i = 0; i < 9; i++) {
		float half = 0.15f * (float)i;

		value[i][0] = value[i][1] = 0.0f;
		value[i][2] = sinf(half);
		value[i][3] = cosf(half);
	}
	expect_kept(&track, NULL, (const int[]){0, 8}, 2);
	value[5][2] = sinf(0.15f * 5.1f);
	value[5][3] = cosf(0.15f * 5.1f);
	track.bound_px = 0.1f;
	expect_kept(&track, NULL, (const int[]){0, 4, 5, 6, 8}, 5);
	/* 0.03 radian are 1.5 px. */
	track.bound_px = 1.6f;
	expect_kept(&track, NULL, (const int[]){0, 8}, 2);
}

/* Keys of a turn about Y, so many degrees apart. */
static int kept_of_turn(int degrees, int keys, int *kept)
{
	static float value[KEYS_MAX][4];
	const struct optimize_track track =
		track_of(MODEL_ROTATION, 4, value[0], keys, 0.5f);
	const struct optimize_track *const tracks[] = {&track};

	for (int k = 0; k < keys; k++) {
		float half = (float)(degrees * k) * 3.14159265f / 360.0f;

		value[k][0] = value[k][2] = 0.0f;
		value[k][1] = sinf(half);
		value[k][3] = cosf(half);
	}
	return optimize_track_reduce(tracks, 1, kept);
}

static void test_keys_left_out_make_no_half_turns(void **state)
{
	int kept[KEYS_MAX];

	(void)state;
	assert_int_equal(kept_of_turn(90, 9, kept), 9);
	/* 135 degrees are a shorter way than 225. */
	assert_int_equal(kept_of_turn(45, 13, kept), 5);
	for (int i = 0; i < 5; i++) {
		assert_int_equal(kept[i], 3 * i);
	}
	/* A still node may keep its ends alone, and so may a turn of 170. */
	assert_int_equal(kept_of_turn(0, 9, kept), 2);
	assert_int_equal(kept_of_turn(17, 11, kept), 2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_values_are_near_within_the_bound_of_pixels),
		cmocka_unit_test(test_opposite_quaternions_are_near),
		cmocka_unit_test(test_exact_values_may_differ_by_rounding),
		cmocka_unit_test(test_rounding_is_small_beside_a_small_model),
		cmocka_unit_test(test_places_far_away_stay_apart_by_what_is_seen),
		cmocka_unit_test(
			test_a_track_is_constant_if_all_keys_are_near_the_first),
		cmocka_unit_test(test_a_spline_is_constant_without_tangents),
		cmocka_unit_test(test_a_line_keeps_its_bends),
		cmocka_unit_test(
			test_tracks_with_common_times_keep_all_their_bends),
		cmocka_unit_test(test_a_stair_keeps_the_key_of_each_step),
		cmocka_unit_test(test_a_path_keeps_within_the_bound),
		cmocka_unit_test(test_a_turn_is_interpolated_on_the_sphere),
		cmocka_unit_test(test_keys_left_out_make_no_half_turns),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
