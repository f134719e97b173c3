#include "platform/base/json_memory.h"

#include "tests/support/test.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static void test_a_load_gives_the_value_or_null(void **state)
{
	static const char text[] =
		"{\"a\": [1, 2.5, \"a long \\u0041 string of many bytes\", "
		"{\"b\": null, \"c\": true}], \"name\": \"x\"}";
	json_error_t error;
	json_t *value;

	(void)state;
	value = json_memory_load(text, strlen(text), 0, &error);
	assert_true(json_memory_ok());
	assert_int_equal(json_array_size(json_object_get(value, "a")), 4);
	json_decref(value);
	assert_null(json_memory_load("[1,", 3, 0, &error));
	assert_true(json_memory_ok());
}

static void test_a_large_load_forgets_what_jansson_freed(void **state)
{
	enum {
		COUNT = 20000
	};
	char *text = malloc(COUNT * 16 + 3);
	size_t size = 0;
	json_error_t error;
	json_t *value;

	(void)state;
	assert_non_null(text);
	text[size++] = '[';
	for (int i = 0; i < COUNT; i++) {
		size += (size_t)sprintf(text + size, "\"s%d\",", i);
	}
	text[size - 1] = ']';
	value = json_memory_load(text, size, 0, &error);
	assert_non_null(value);
	assert_int_equal(json_array_size(value), COUNT);
	assert_string_equal(
		json_string_value(json_array_get(value, COUNT - 1)), "s19999");
	json_decref(value);
	text[size - 1] = '"';
	assert_null(json_memory_load(text, size, 0, &error));
	assert_true(json_memory_ok());
	free(text);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_failed_allocation_is_noticed),
		cmocka_unit_test(test_a_load_gives_the_value_or_null),
		cmocka_unit_test(test_a_large_load_forgets_what_jansson_freed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
