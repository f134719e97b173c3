#include "platform/base/scalar.h"
#include "tests/support/test.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

static const double TOLERANCE = 2e-6;

static void test_sine_and_cosine_keep_their_tolerance(void **state)
{
	double worst = 0;

	(void)state;
	for (int i = -40000; i <= 40000; i++) {
		float angle = (float)i * (8192.0f / 40000.0f);

		worst = fmax(worst, fabs(scalar_sin(angle) - sin(angle)));
		worst = fmax(worst, fabs(scalar_cos(angle) - cos(angle)));
		angle = (float)i * (7.0f / 40000.0f);
		worst = fmax(worst, fabs(scalar_sin(angle) - sin(angle)));
		worst = fmax(worst, fabs(scalar_cos(angle) - cos(angle)));
	}
	assert_near(worst, 0, TOLERANCE);
}

static void test_sine_is_exact_where_it_matters(void **state)
{
	(void)state;
	assert_true(scalar_sin(0) == 0);
	assert_true(scalar_cos(0) == 1);
	assert_true(scalar_sin(-0.25f) == -scalar_sin(0.25f));
	assert_true(scalar_cos(-0.25f) == scalar_cos(0.25f));
}

static void test_absurd_angles_count_as_zero(void **state)
{
	const float absurd[] = {NAN, INFINITY, -INFINITY, FLT_MAX, 2e9f};

	(void)state;
	for (size_t i = 0; i < sizeof(absurd) / sizeof(absurd[0]); i++) {
		assert_true(scalar_sin(absurd[i]) == 0);
		assert_true(scalar_cos(absurd[i]) == 1);
	}
}

static void test_arc_cosine_keeps_its_tolerance(void **state)
{
	double worst = 0;

	(void)state;
	for (int i = -20000; i <= 20000; i++) {
		float x = (float)i / 20000.0f;

		worst = fmax(worst, fabs(scalar_acos(x) - acos(x)));
	}
	/* Close to the ends, where the curve is steepest. */
	for (float x = 1; x > 0.99f; x -= 0x1p-22f) {
		worst = fmax(worst, fabs(scalar_acos(x) - acos(x)));
		worst = fmax(worst, fabs(scalar_acos(-x) - acos(-x)));
	}
	assert_near(worst, 0, TOLERANCE);
}

static void test_arc_cosine_clamps_its_argument(void **state)
{
	(void)state;
	assert_true(scalar_acos(1.0001f) == 0);
	assert_true(scalar_acos(NAN) == 0);
	assert_near(scalar_acos(-1.0001f), acos(-1), TOLERANCE);
	assert_near(scalar_acos(-INFINITY), acos(-1), TOLERANCE);
}

static void test_arc_tangent_keeps_its_tolerance_all_round(void **state)
{
	double worst = 0;

	(void)state;
	for (int i = 0; i < 30000; i++) {
		double angle = i * (2 * acos(-1) / 30000);
		float x = (float)(cos(angle) * (0.001 + i));
		float y = (float)(sin(angle) * (0.001 + i));

		worst = fmax(worst, fabs(scalar_atan2(y, x) - atan2(y, x)));
	}
	assert_near(worst, 0, TOLERANCE);
	assert_near(scalar_atan2(0, -1), acos(-1), TOLERANCE);
	assert_near(scalar_atan2(1, 0), acos(-1) / 2, TOLERANCE);
	assert_near(scalar_atan2(-1, 0), -acos(-1) / 2, TOLERANCE);
}

static void test_arc_tangent_of_no_direction_is_zero(void **state)
{
	(void)state;
	assert_true(scalar_atan2(0, 0) == 0);
	assert_true(scalar_atan2(NAN, 1) == 0);
	assert_true(scalar_atan2(1, INFINITY) == 0);
}

static void test_square_root_never_gives_a_nan(void **state)
{
	(void)state;
	assert_true(scalar_sqrt(9) == 3);
	assert_true(scalar_sqrt(0) == 0);
	assert_true(scalar_sqrt(-4) == 0);
	assert_true(scalar_sqrt(NAN) == 0);
}

static void test_floor_rounds_down_at_both_signs(void **state)
{
	const float value[] = {
		0, 0.5f, 1, -0.5f, -1, -1.5f, 7.999f, -8388607.5f, 3e9f, -3e9f};

	(void)state;
	for (size_t i = 0; i < sizeof(value) / sizeof(value[0]); i++) {
		assert_true(scalar_floor(value[i]) == (float)floor(value[i]));
	}
}

static void test_exponential_is_close_in_proportion(void **state)
{
	double worst = 0;

	(void)state;
	for (float x = -86; x < 88; x += 0.0137f) {
		double want = exp(x);

		worst = fmax(worst, fabs(scalar_exp(x) - want) / want);
	}
	assert_near(worst, 0, 1e-6);
	assert_true(scalar_exp(0) == 1);
	assert_true(scalar_exp(-200) == 0);
	assert_true(scalar_exp(NAN) == 0);
	assert_true(scalar_exp(1000) == FLT_MAX);
}

/* FNV-1a of a float's bits. */
static uint32_t add_bits(uint32_t hash, float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	for (int i = 0; i < 4; i++) {
		hash = (hash ^ (bits >> 8 * i & 0xFF)) * 16777619u;
	}
	return hash;
}

/* Poses and pictures are the same everywhere only if each bit of these is. */
static void test_every_machine_gives_the_same_bits(void **state)
{
	uint32_t sine, cosine, arc_cosine, arc_tangent, exponential;

	(void)state;
	sine = cosine = arc_cosine = arc_tangent = exponential = 2166136261u;
	for (int i = -2000; i <= 2000; i++) {
		float x = (float)i / 2000.0f;

		sine = add_bits(sine, scalar_sin(x * 50));
		cosine = add_bits(cosine, scalar_cos(x * 50));
		arc_cosine = add_bits(arc_cosine, scalar_acos(x));
		arc_tangent = add_bits(arc_tangent, scalar_atan2(x, 0.5f));
		arc_tangent = add_bits(arc_tangent, scalar_atan2(x, -0.5f));
		exponential = add_bits(exponential, scalar_exp(x * 87));
	}
	assert_int_equal(sine, 0xC1CF41B9);
	assert_int_equal(cosine, 0xCDB5224);
	assert_int_equal(arc_cosine, 0xC71DDAC5);
	assert_int_equal(arc_tangent, 0x5992EA6E);
	assert_int_equal(exponential, 0x54253C4D);
}

static void test_clamp_keeps_to_its_limits(void **state)
{
	(void)state;
	assert_true(scalar_clamp(3, 0, 2) == 2);
	assert_true(scalar_clamp(-3, 0, 2) == 0);
	assert_true(scalar_clamp(1.5f, 0, 2) == 1.5f);
	assert_true(scalar_clamp(NAN, 0, 2) == 0);
}

static void test_the_smaller_and_the_larger_number_are_chosen(void **state)
{
	(void)state;
	assert_true(scalar_min(1, 2) == 1);
	assert_true(scalar_min(2, 1) == 1);
	assert_true(scalar_max(1, 2) == 2);
	assert_true(scalar_max(2, 1) == 2);
	assert_true(scalar_min(NAN, 2) == 2);
	assert_true(scalar_max(NAN, 2) == 2);
}

static void test_integers_are_clamped(void **state)
{
	(void)state;
	assert_int_equal(scalar_to_int(2.9, 0, 10), 2);
	assert_int_equal(scalar_to_int(-2.9, -10, 10), -2);
	assert_int_equal(scalar_to_int(1e300, 0, 10), 10);
	assert_int_equal(scalar_to_int(-1e300, 3, 10), 3);
	assert_int_equal(
		scalar_to_int((double)INFINITY, 0, INT32_MAX), INT32_MAX);
	assert_int_equal(scalar_to_int((double)NAN, -7, 7), -7);
	assert_int_equal(
		scalar_to_int(-2147483648.0, INT32_MIN, INT32_MAX), INT32_MIN);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_integers_are_clamped),
		cmocka_unit_test(test_sine_and_cosine_keep_their_tolerance),
		cmocka_unit_test(test_sine_is_exact_where_it_matters),
		cmocka_unit_test(test_absurd_angles_count_as_zero),
		cmocka_unit_test(test_arc_cosine_keeps_its_tolerance),
		cmocka_unit_test(test_arc_cosine_clamps_its_argument),
		cmocka_unit_test(test_arc_tangent_keeps_its_tolerance_all_round),
		cmocka_unit_test(test_arc_tangent_of_no_direction_is_zero),
		cmocka_unit_test(test_square_root_never_gives_a_nan),
		cmocka_unit_test(test_floor_rounds_down_at_both_signs),
		cmocka_unit_test(test_exponential_is_close_in_proportion),
		cmocka_unit_test(test_every_machine_gives_the_same_bits),
		cmocka_unit_test(test_clamp_keeps_to_its_limits),
		cmocka_unit_test(
			test_the_smaller_and_the_larger_number_are_chosen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
