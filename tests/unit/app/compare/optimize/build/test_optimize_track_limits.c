/* The limits within which values and keys of a channel may be left out. */
#include "app/compare/optimize/build/optimize_track.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	KEYS_MAX = 20
};

/* The last target belongs to another mesh. */
static const float target_px[3] = {3.0f, 5.0f, 1000.0f};

static struct optimize_reach_node reach_of(float move_px, bool exact)
{
	return (struct optimize_reach_node){.move_px = move_px,
		.turn_px = 64.0f,
		.scale_px = 16.0f,
		.exact = exact,
		.target_count = 2,
		.target_px = target_px};
}

static struct optimize_track track_of(enum model_path path, int width,
	const struct optimize_reach_node *reach, float bound_px)
{
	return (struct optimize_track){.path = path,
		.interpolation = MODEL_LINEAR,
		.width = width,
		.reach = reach,
		.bound_px = bound_px};
}

/* Whether a value may be replaced by one that is so many steps of floats on. */
static bool is_near(const struct optimize_track *track, float value, int steps)
{
	float a[4] = {value}, b[4] = {value};

	for (int i = 0; i < steps; i++) {
		b[0] = nextafterf(b[0], 1e9f);
	}
	return optimize_track_is_near(track, a, b);
}

/*
 * Floats of 400 are 2^-15 apart, which are 0.031 pixels here: a millionth of 400
 * is more than a tenth of a pixel, and rounding may not move anything by more.
 */
static void test_rounding_moves_nothing_by_a_tenth_of_a_pixel(void **state)
{
	static const struct {
		float bound_px;
		int most; /* steps */
	} cases[] = {{0.0f, 3}, {0.02f, 0}, {0.05f, 1}, {0.07f, 2}, {0.5f, 3},
		{2.0f, 3}};
	const struct optimize_reach_node reach = reach_of(1000.0f, true);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct optimize_track track = track_of(
			MODEL_TRANSLATION, 3, &reach, cases[i].bound_px);

		for (int steps = 0; steps < 5; steps++) {
			assert_int_equal(is_near(&track, 400.0f, steps),
				steps <= cases[i].most);
		}
	}
}

/* A screen's height is 1000 pixels, of which a millionth is rounding. */
static void test_rounding_of_a_small_model_is_that_of_a_screen(void **state)
{
	static const float sizes_px[] = {1e4f, 1e6f, 1e8f};
	const float rest[4] = {0.0f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		const struct optimize_reach_node reach =
			reach_of(sizes_px[i], true);
		struct optimize_track track =
			track_of(MODEL_TRANSLATION, 3, &reach, 0.0f);
		float most = 1e-6f * 1000.0f / sizes_px[i];
		const float within[4] = {0.0f, 0.9995f * most};
		const float beyond[4] = {0.0f, 1.0005f * most};

		assert_true(optimize_track_is_near(&track, rest, within));
		assert_false(optimize_track_is_near(&track, rest, beyond));
		/* Turns and scales do not depend on the size. */
		track.path = MODEL_SCALE;
		assert_true(optimize_track_is_near(
			&track, rest, (const float[4]){0, 0.9995e-6f}));
		assert_false(optimize_track_is_near(
			&track, rest, (const float[4]){0, 1.0005e-6f}));
		track.path = MODEL_ROTATION;
		track.width = 4;
		assert_true(optimize_track_is_near(
			&track, rest, (const float[4]){0, 0, 0, 0.9995e-6f}));
		assert_false(optimize_track_is_near(
			&track, rest, (const float[4]){0, 0, 0, 1.0005e-6f}));
	}
}

/* 1 / 128 units are half a pixel, and so is a quaternion that is off by 1/256. */
static void test_an_error_of_exactly_the_bound_is_kept(void **state)
{
	static const struct {
		enum model_path path;
		int width;
		float apart;
	} cases[] = {{MODEL_TRANSLATION, 3, 1.0f / 128.0f},
		{MODEL_ROTATION, 4, 1.0f / 256.0f},
		{MODEL_SCALE, 3, 1.0f / 32.0f}};
	const struct optimize_reach_node reach = reach_of(64.0f, false);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct optimize_track track =
			track_of(cases[i].path, cases[i].width, &reach, 0.5f);
		const float a[4] = {0.5f, 0.5f, 0.5f, 0.5f};
		const float b[4] = {0.5f, 0.5f + cases[i].apart, 0.5f, 0.5f};

		assert_true(optimize_track_is_near(&track, a, b));
		track.bound_px = nextafterf(0.5f, 0.0f);
		assert_false(optimize_track_is_near(&track, a, b));
	}
}

/* Behind three numbers of a value is the next value. */
static void test_numbers_beyond_a_value_do_not_count(void **state)
{
	static const enum model_path paths[] = {
		MODEL_TRANSLATION, MODEL_SCALE, MODEL_WEIGHTS};
	const struct optimize_reach_node reach = reach_of(64.0f, false);
	const float a[5] = {0.5f, 0.25f, 1.0f, 0.0f, 0.0f};
	const float b[5] = {0.5f, 0.2501f, 1.0f, 9.0f, 9.0f};
	const float other[5] = {0.5f, 0.25f, 7.0f, 0.0f, 0.0f};
	const float next[5] = {0.5001f, 9.0f, 9.0f, 9.0f, 9.0f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct optimize_track track =
			track_of(paths[i], 3, &reach, 0.1f);

		assert_true(optimize_track_is_near(&track, a, b));
		/* Nothing shows a weight without a target. */
		assert_int_equal(optimize_track_is_near(&track, a, other),
			paths[i] == MODEL_WEIGHTS);
		track.width = 1;
		assert_int_equal(optimize_track_is_near(&track, a, next),
			paths[i] == MODEL_WEIGHTS);
	}
}

/* The way to -q is as far as that to q. */
static void test_opposite_quaternions_differ_in_any_component(void **state)
{
	const struct optimize_reach_node reach = reach_of(64.0f, false);
	struct optimize_track track = track_of(MODEL_ROTATION, 4, &reach, 0.5f);
	const float a[4] = {0.5f, -0.5f, 0.5f, 0.5f};

	(void)state;
	for (int i = 0; i < 4; i++) {
		for (int sign = -1; sign <= 1; sign += 2) {
			float b[4] = {-0.5f, 0.5f, -0.5f, -0.5f};

			/* 2 * 64 pixels for each 1 */
			b[i] += 0.99f * (float)sign * 0.5f / 128.0f;
			assert_true(optimize_track_is_near(&track, a, b));
			b[i] += 0.02f * (float)sign * 0.5f / 128.0f;
			assert_false(optimize_track_is_near(&track, a, b));
		}
	}
}

/* Quaternions that are perpendicular: each product cancels another one. */
static void test_half_turns_are_found_whatever_their_axes(void **state)
{
	static const float signs[][4] = {
		{1, 1, -1, -1}, {1, -1, 1, -1}, {1, -1, -1, 1}};
	const float a[4] = {0.5f, 0.5f, 0.5f, 0.5f};

	(void)state;
	assert_false(optimize_track_is_half_turn(a, a));
	for (int i = 0; i < 3; i++) {
		float b[4], c[4], d[4];

		for (int k = 0; k < 4; k++) {
			b[k] = 0.5f * signs[i][k];
			/* their product with a is 0.0009, and 0.0011 */
			c[k] = b[k] + (k == 0 ? 0.0018f : 0.0f);
			d[k] = b[k] + (k == 0 ? 0.0022f : 0.0f);
		}
		assert_true(optimize_track_is_half_turn(a, b));
		assert_true(optimize_track_is_half_turn(b, a));
		assert_true(optimize_track_is_half_turn(a, c));
		assert_false(optimize_track_is_half_turn(a, d));
	}
}

/* What a search may do without, in another arithmetic. */
static bool may_leave_out(const float *value, int from, int to)
{
	for (int key = from + 1; key < to; key++) {
		double u = (double)(key - from) / (double)(to - from);
		double line = (double)value[from] +
			u * (double)(value[to] - value[from]);

		if (fabs(line - (double)value[key]) * 3.0 > 3.1) {
			return false;
		}
	}
	return true;
}

/*
 * The next key is 2, 4, 8... further on while that fits. Then it is sought by
 * halves between the last that fitted and the first that did not, or the end,
 * which is tried first.
 */
static int next_key(const float *value, int from, int last)
{
	int fits = from + 1, step = 2, fails;

	for (; from + step <= last && may_leave_out(value, from, from + step);
		step *= 2) {
		fits = from + step;
	}
	fails = from + step <= last ? from + step : last;
	if (may_leave_out(value, from, fails)) {
		return fails;
	}
	while (fails > fits + 1) {
		int middle = (fits + fails) / 2;

		if (may_leave_out(value, from, middle)) {
			fits = middle;
		} else {
			fails = middle;
		}
	}
	return fits;
}

/* Of any values, also where a longer way fits and a shorter one does not. */
static void test_a_search_for_keys_doubles_its_steps_and_halves_them(
	void **state)
{
	const struct optimize_reach_node reach = reach_of(64.0f, false);
	uint32_t random = 1;
	float time_s[KEYS_MAX];

	(void)state;
	for (int i = 0; i < 400; i++) {
		struct optimize_track track =
			track_of(MODEL_WEIGHTS, 1, &reach, 3.1f);
		const struct optimize_track *const tracks[] = {&track};
		float value[KEYS_MAX];
		int kept[KEYS_MAX], count, at = 0;

		track.key_count = 2 + i % (KEYS_MAX - 1);
		track.time_s = time_s;
		track.value = value;
		for (int k = 0; k < KEYS_MAX; k++) {
			random = random * 1664525u + 1013904223u;
			time_s[k] = (float)k;
			value[k] = (float)(random >> 30);
		}
		count = optimize_track_reduce(tracks, 1, kept);
		assert_int_equal(kept[0], 0);
		for (int k = 1; k < count; k++) {
			at = next_key(value, at, track.key_count - 1);
			assert_int_equal(kept[k], at);
		}
		assert_int_equal(at, track.key_count - 1);
	}
}

/* All targets together may move a vertex by the bound, and no more. */
static void test_a_key_of_weights_is_left_out_by_the_sum_of_its_targets(
	void **state)
{
	static const struct {
		float apart[3];
		float bound_px;
		bool kept;
	} cases[] = {
		{{1.0f, 0, 0}, 3.0f, false},
		{{1.0f, 0, 0}, 2.999f, true},
		{{0, 1.0f, 0}, 5.0f, false},
		{{0, 1.0f, 0}, 4.999f, true},
		{{1.0f, -1.0f, 0}, 8.0f, false},
		{{1.0f, -1.0f, 0}, 7.999f, true},
		{{0, 0, 4.0f}, 0.5f, false}, /* a weight without a target */
		{{0.125f, 0, 4.0f}, 0.375f, false},
	};
	const struct optimize_reach_node reach = reach_of(64.0f, false);
	const float time_s[3] = {0, 1, 2};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct optimize_track track =
			track_of(MODEL_WEIGHTS, 3, &reach, cases[i].bound_px);
		const struct optimize_track *const tracks[] = {&track};
		float value[3][3] = {{0}};
		int kept[3];

		for (int k = 0; k < 3; k++) {
			value[1][k] = cases[i].apart[k];
		}
		track.key_count = 3;
		track.time_s = time_s;
		track.value = value[0];
		assert_int_equal(optimize_track_reduce(tracks, 1, kept),
			cases[i].kept ? 3 : 2);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_rounding_moves_nothing_by_a_tenth_of_a_pixel),
		cmocka_unit_test(
			test_rounding_of_a_small_model_is_that_of_a_screen),
		cmocka_unit_test(test_an_error_of_exactly_the_bound_is_kept),
		cmocka_unit_test(test_numbers_beyond_a_value_do_not_count),
		cmocka_unit_test(
			test_opposite_quaternions_differ_in_any_component),
		cmocka_unit_test(test_half_turns_are_found_whatever_their_axes),
		cmocka_unit_test(
			test_a_search_for_keys_doubles_its_steps_and_halves_them),
		cmocka_unit_test(
			test_a_key_of_weights_is_left_out_by_the_sum_of_its_targets),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
