#include "platform/base/json_memory.h"

#include "tests/support/test.h"

#include <jansson.h>

static void test_a_failed_allocation_is_noticed(void **state)
{
	json_t *value;

	(void)state;
	json_memory_begin();
	value = json_string("small");
	assert_true(json_memory_ok());
	json_decref(value);
	assert_null(json_stringn_nocheck("large", SIZE_MAX / 4));
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
