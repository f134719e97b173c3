#include "app/anim/kernel/kernel.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static void test_bitangents_take_their_sign_from_the_attribute(void **state)
{
	static const float normal[2][3] = {{0, 0, 1}, {0, 1, 0}};
	static const float tangent[2][3] = {{1, 0, 0}, {1, 0, 0}};
	static const float attribute[2][4] = {{9, 9, 9, 1}, {9, 9, 9, -1}};
	/* z x x = y; -(y x x) = z. */
	static const float want[2][3] = {{0, 1, 0}, {0, 0, 1}};
	float out[2][3];

	(void)state;
	kernel_float.bitangents(2, normal, tangent, attribute, out);
	assert_all_near(out, want, 6, 0);
}

static void test_lerp_ends_at_its_inputs(void **state)
{
	static const float source[2][3] = {{0.1f, -7, 1e5f}, {3, 2, 0.7f}};
	static const float destiny[2][3] = {{9.3f, 1e-3f, 2}, {0.3f, 4, 5}};
	static const float none[3] = {0, 0, 0};
	float out[2][3];

	(void)state;
	kernel_float.morph_lerp(2, source, destiny, 0, none, out);
	assert_memory_equal(out, source, sizeof(out));
	kernel_float.morph_lerp(2, source, destiny, 1, none, out);
	assert_memory_equal(out, destiny, sizeof(out));
}

static void test_lerp_adds_the_offset_and_may_overwrite(void **state)
{
	float source[2][3] = {{0, 4, 8}, {1, 1, 1}};
	static const float destiny[2][3] = {{4, 0, 8}, {3, 3, 3}};
	static const float offset[3] = {0, 10, -10};
	static const float want[2][3] = {{1, 13, -2}, {1.5f, 11.5f, -8.5f}};

	(void)state;
	kernel_float.morph_lerp(
		2, (const float(*)[3])source, destiny, 0.25f, offset, source);
	assert_all_near(source, want, 6, 1e-6);
}

static void test_targets_add_up_by_weight(void **state)
{
	static const float base[2][3] = {{1, 2, 3}, {4, 5, 6}};
	static const float a[2][3] = {{1, 0, 0}, {0, 1, 0}};
	static const float b[2][3] = {{0, 0, 8}, {8, 0, 0}};
	static const float poison[2][3] = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
	const struct morph_term term[4] = {{2, a, NULL, NULL},
		{0.5f, b, a, NULL}, {0, poison, poison, NULL},
		{7, NULL, NULL, NULL}};
	static const float want[2][3] = {{3, 2, 7}, {8, 7, 6}};
	static const float want_normal[2][3] = {{1.5f, 2, 3}, {4, 5.5f, 6}};
	float out[2][3];

	(void)state;
	kernel_float.morph_targets(2, base, term, 4, false, out);
	assert_all_near(out, want, 6, 1e-6);
	kernel_float.morph_targets(2, base, term, 4, true, out);
	assert_all_near(out, want_normal, 6, 1e-6);
	kernel_float.morph_targets(2, base, term, 0, false, out);
	assert_memory_equal(out, base, sizeof(out));
}

static void test_normalize_leaves_zero_vectors(void **state)
{
	float v[4][3] = {{3, 4, 0}, {0, 0, 0}, {0, 0, -1e-9f}, {1e9f, 0, 0}};
	static const float want[4][3] = {
		{0.6f, 0.8f, 0}, {0, 0, 0}, {0, 0, -1}, {1, 0, 0}};

	(void)state;
	kernel_float.normalize(4, v);
	assert_all_near(v, want, 12, 1e-6);
}

static void test_kernels_are_found_by_name(void **state)
{
	(void)state;
	assert_ptr_equal(kernel_find(NULL), kernel_registry[0]);
	assert_ptr_equal(kernel_find("float"), &kernel_float);
	assert_null(kernel_find("Float"));
	assert_null(kernel_find(""));
	for (int i = 0; kernel_registry[i]; i++) {
		const struct kernel *kernel = kernel_registry[i];

		assert_ptr_equal(kernel_find(kernel->name), kernel);
		assert_true(strlen(kernel->summary) > 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_bitangents_take_their_sign_from_the_attribute),
		cmocka_unit_test(test_lerp_ends_at_its_inputs),
		cmocka_unit_test(test_lerp_adds_the_offset_and_may_overwrite),
		cmocka_unit_test(test_targets_add_up_by_weight),
		cmocka_unit_test(test_normalize_leaves_zero_vectors),
		cmocka_unit_test(test_kernels_are_found_by_name),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
