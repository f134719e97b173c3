/* The soft driver's arithmetic, against double. */
#include "platform/gl/soft/vertex/number.h"
#include "tests/support/test.h"

#include <math.h>

static void test_a_reciprocal_is_exact_to_2_to_the_minus_25(void **state)
{
	(void)state;
	for (uint64_t v = 1u << 31; v <= UINT32_MAX; v += 4099) {
		double exact = ldexp(1.0, 62) / (double)v;
		double got = reciprocal((uint32_t)v);

		assert_true(fabs(got - exact) < 32.0);
	}
	assert_true(reciprocal(1u << 31) > 0);
	assert_true(reciprocal(UINT32_MAX) >= 1 << 29);
}

static void test_a_root_is_exact_to_2_to_the_minus_20(void **state)
{
	uint64_t value = 1;

	(void)state;
	for (int i = 0; i < 10000; i++) {
		struct root root = soft_reciprocal_root(value);
		double got = ldexp(root.mantissa_q30, -30 - root.shift);
		double exact = 1.0 / sqrt((double)value);

		assert_true(fabs(got / exact - 1.0) < ldexp(1.0, -20));
		value = value * 6364136223846793005u + 1442695040888963407u;
		value >>= i % 63;
		value += value == 0;
	}
}

static void test_powers_are_within_a_thousandth(void **state)
{
	static const double exponents[] = {0.5, 1.0, 4.0, 17.3, 64.0, 128.0};

	(void)state;
	for (size_t e = 0; e < sizeof(exponents) / sizeof(exponents[0]); e++) {
		for (int i = 0; i <= 1000; i++) {
			int32_t base = (int32_t)(ldexp(1.0, 28) * i / 1000.0);
			double exact = pow(ldexp(base, -28), exponents[e]);
			double got =
				ldexp(soft_power_q28(base,
					      (int32_t)(exponents[e] * 65536)),
					-28);

			assert_true(fabs(got - exact) < 0.001);
		}
	}
	assert_int_equal(soft_power_q28(0, 65536), 0);
	assert_int_equal(soft_power_q28(1 << 27, 0), 1 << 28);
}

static void test_first_guesses_are_those_of_the_middles(void **state)
{
	(void)state;
	for (int i = 0; i < 256; i++) {
		assert_int_equal(
			soft_reciprocal_table[i], (1 << 25) / (513 + 2 * i));
	}
	for (int i = 0; i < 192; i++) {
		assert_int_equal(soft_root_table[i],
			lrint(32768.0 / sqrt((64.5 + i) / 256.0)));
	}
}

/* 2 to the power of a number of 65536ths, on a line between 64ths. */
static int32_t power_between_steps(long exponent)
{
	long step = exponent >> 10, part = exponent & 1023;
	long low = lrint(32768 * exp2((double)step / 64));
	long high = lrint(32768 * exp2((double)(step + 1) / 64));

	return (int32_t)((low * 1024 + (high - low) * part) << 2);
}

static void test_powers_are_exact_at_their_steps(void **state)
{
	(void)state;
	for (int i = 0; i < 64; i++) {
		assert_int_equal(soft_power_q28(1 << 27, 65536 - 1024 * i),
			power_between_steps(1024 * i));
		assert_int_equal(soft_power_q28((64 + i) << 21, 65536),
			power_between_steps(lrint(65536 * log2(1 + i / 64.0))));
	}
	assert_int_equal(soft_power_q28(1 << 27, 1), power_between_steps(65535));
	assert_int_equal(soft_power_q28((1 << 28) - 1, 65536),
		power_between_steps(65535));
}

static void test_shifts_may_be_of_any_size(void **state)
{
	(void)state;
	assert_int_equal(shift_by(3, 4), 48);
	assert_int_equal(shift_by(-48, -4), -3);
	assert_int_equal(shift_by(1, 32), 0);
	assert_int_equal(shift_by(-5, -1000), -1);
	assert_int_equal(shift_by(5, 1000), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_reciprocal_is_exact_to_2_to_the_minus_25),
		cmocka_unit_test(test_a_root_is_exact_to_2_to_the_minus_20),
		cmocka_unit_test(test_powers_are_within_a_thousandth),
		cmocka_unit_test(test_first_guesses_are_those_of_the_middles),
		cmocka_unit_test(test_powers_are_exact_at_their_steps),
		cmocka_unit_test(test_shifts_may_be_of_any_size),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
