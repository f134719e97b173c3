#include "platform/base/json_memory.h"

#include "tests/support/test.h"

#include <jansson.h>

/* Lets malloc() fail under AddressSanitizer, which would end the test. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
	return "allocator_may_return_null=1";
}

static void test_a_failed_allocation_is_noticed(void **state)
{
	json_malloc_t allocate;
	json_free_t release;
	json_t *value;

	(void)state;
	json_memory_begin();
	value = json_string("small");
	assert_true(json_memory_ok());
	json_decref(value);
	json_get_alloc_funcs(&allocate, &release);
	assert_null(allocate(SIZE_MAX - 4096));
	assert_false(json_memory_ok());
	json_memory_begin();
	assert_true(json_memory_ok());
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_failed_allocation_is_noticed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
