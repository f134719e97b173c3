/* Which kernel --kernel and --math choose. */
#include "app/cmd/options/options_kernel.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

static const struct kernel *choose(
	const char *name, enum options_math math, struct log_capture *said)
{
	const struct options_vertices options = {.kernel = name, .math = math};
	const struct log log = log_capture_begin(said);

	return options_kernel(&options, &log);
}

static void test_the_first_kernel_that_computes_so_is_taken(void **state)
{
	struct log_capture said;

	(void)state;
	assert_ptr_equal(choose(NULL, MATH_ANY, &said), kernel_registry[0]);
	assert_ptr_equal(choose(NULL, MATH_FLOAT, &said), kernel_find("float"));
	assert_non_null(choose(NULL, MATH_FIXED, &said)->fixed);
	assert_int_equal(said.count, 0);
}

static void test_a_named_kernel_may_be_given_with_its_math(void **state)
{
	struct log_capture said;

	(void)state;
	for (int i = 0; kernel_registry[i]; i++) {
		const struct kernel *kernel = kernel_registry[i];
		enum options_math own = kernel->fixed ? MATH_FIXED : MATH_FLOAT;
		enum options_math other =
			kernel->fixed ? MATH_FLOAT : MATH_FIXED;

		assert_ptr_equal(choose(kernel->name, MATH_ANY, &said), kernel);
		assert_ptr_equal(choose(kernel->name, own, &said), kernel);
		assert_int_equal(said.count, 0);
		assert_null(choose(kernel->name, other, &said));
		assert_int_equal(said.count, 1);
		assert_contains(said.sentence[0],
			kernel->fixed ? "computes in fixed point: leave out "
					"--math float"
				      : "computes in float: leave out --math "
					"fixed");
	}
}

static void test_an_unknown_kernel_is_refused_with_the_names(void **state)
{
	struct log_capture said;

	(void)state;
	assert_null(choose("mmx", MATH_ANY, &said));
	assert_int_equal(said.count, 1);
	assert_contains(said.sentence[0],
		"--kernel mmx: there is no such kernel: choose one of");
	for (int i = 0; kernel_registry[i]; i++) {
		assert_contains(said.sentence[0], kernel_registry[i]->name);
	}
	if (!kernel_find("armv6")) {
		assert_null(choose("armv6", MATH_ANY, &said));
		assert_contains(said.sentence[0],
			"is ARMv6 assembly, which only the build for ARM has");
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_first_kernel_that_computes_so_is_taken),
		cmocka_unit_test(test_a_named_kernel_may_be_given_with_its_math),
		cmocka_unit_test(
			test_an_unknown_kernel_is_refused_with_the_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
