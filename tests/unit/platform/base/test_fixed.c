#include "platform/base/fixed.h"
#include "tests/support/test.h"

#include <math.h>

static void test_values_round_to_the_nearest(void **state)
{
	(void)state;
	assert_int_equal(fx16_from_float(1), 65536);
	assert_int_equal(fx16_from_float(-1), -65536);
	assert_int_equal(fx16_from_float(0.5f), 32768);
	assert_int_equal(fx16_from_float(0), 0);
	assert_int_equal(fx16_from_float(0.6f / 65536), 1);
	assert_int_equal(fx16_from_float(0.4f / 65536), 0);
	assert_int_equal(fx16_from_float(-0.6f / 65536), -1);
	assert_int_equal(fx16_from_float(-0.4f / 65536), 0);
}

static void test_values_beyond_the_range_saturate(void **state)
{
	(void)state;
	assert_int_equal(fx16_from_float(32768), INT32_MAX);
	assert_int_equal(fx16_from_float(1e20f), INT32_MAX);
	assert_int_equal(fx16_from_float(INFINITY), INT32_MAX);
	assert_int_equal(fx16_from_float(-32768), INT32_MIN);
	assert_int_equal(fx16_from_float(-1e20f), INT32_MIN);
	assert_int_equal(fx16_from_float(-INFINITY), INT32_MIN);
}

static void test_nan_gives_zero(void **state)
{
	(void)state;
	assert_int_equal(fx16_from_float(NAN), 0);
}

static void test_values_convert_back(void **state)
{
	(void)state;
	for (int i = -200; i <= 200; i++) {
		float value = (float)i * 0.03125f;

		assert_true(fx16_to_float(fx16_from_float(value)) == value);
	}
	assert_near(fx16_to_float(fx16_from_float(3.14159f)), 3.14159,
		0.5 / 65536 + 1e-7);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_values_round_to_the_nearest),
		cmocka_unit_test(test_values_beyond_the_range_saturate),
		cmocka_unit_test(test_nan_gives_zero),
		cmocka_unit_test(test_values_convert_back),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
