#include "platform/base/json_memory.h"

#include "tests/support/test.h"

#include <jansson.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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
	/* So many that a table without places for them would take minutes. */
	enum {
		COUNT = 200000
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
		json_string_value(json_array_get(value, COUNT - 1)), "s199999");
	json_decref(value);
	text[size - 1] = '"';
	assert_null(json_memory_load(text, size, 0, &error));
	assert_true(json_memory_ok());
	free(text);
}

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
enum {
	HEAP_BYTES = 1 << 20,
	KEPT_BYTES = 64 << 10 /* by malloc() for allocations of the same size */
};

/* Leaves free memory in the heap, which malloc() would give back or map. */
static bool prepare_heap(void)
{
	void *memory;

	if (!mallopt(M_MMAP_THRESHOLD, 2 * HEAP_BYTES) ||
		!mallopt(M_TRIM_THRESHOLD, 2 * HEAP_BYTES)) {
		return false;
	}
	memory = malloc(HEAP_BYTES);
	free(memory);
	return memory != NULL;
}

/* Loads the text without memory; returns what is wrong then, or 0. */
static int load_without_memory(const char *text, size_t size)
{
	struct rlimit limit = {0};
	json_error_t error;
	struct mallinfo2 before, after;
	json_t *value;

	if (!prepare_heap() || getrlimit(RLIMIT_AS, &limit) != 0) {
		return 1;
	}
	limit.rlim_cur = 1 << 20;
	/* From now on the heap cannot grow. */
	if (setrlimit(RLIMIT_AS, &limit) != 0) {
		return 2;
	}
	before = mallinfo2();
	value = json_memory_load(text, size, 0, &error);
	after = mallinfo2();
	if (value || json_memory_ok()) {
		return 3;
	}
	limit.rlim_cur = limit.rlim_max;
	if (setrlimit(RLIMIT_AS, &limit) != 0) {
		return 4;
	}
	value = json_memory_load("[1]", 3, 0, &error);
	if (json_array_size(value) != 1 || !json_memory_ok()) {
		return 5;
	}
	json_decref(value);
	return after.uordblks > before.uordblks + KEPT_BYTES ? 6 : 0;
}
#endif

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
/* Lets the text, an array of the same element, end the memory of a child. */
static void expect_no_memory_kept(const char *element)
{
	enum {
		SIZE = 4 << 20
	};
	size_t length = strlen(element), size = 1;
	char *text = malloc(SIZE);
	pid_t child;
	int status = -1;

	assert_non_null(text);
	text[0] = '[';
	while (size + length + 1 <= SIZE) {
		memcpy(text + size, element, length);
		size += length;
		text[size++] = ',';
	}
	child = fork();
	if (child == 0) {
		_exit(load_without_memory(text, size));
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_int_equal(status, 0);
	free(text);
}
#endif

static void test_a_load_without_memory_keeps_none(void **state)
{
	(void)state;
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
	expect_no_memory_kept("1");
	/* Of these jansson frees some while it reads: repeated keys, tables. */
	expect_no_memory_kept("{\"a\":[1,[],\"s\"],\"b\":{\"a\":2},\"a\":3}");
	expect_no_memory_kept(
		"{\"0\":0,\"1\":1,\"2\":2,\"3\":3,\"4\":4,\"5\":5,\"6\":6,"
		"\"7\":7,\"8\":8,\"9\":9,\"0\":[],\"1\":\"a longer string\"}");
#else
	skip_because("memory cannot be limited here");
#endif
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_failed_allocation_is_noticed),
		cmocka_unit_test(test_a_load_gives_the_value_or_null),
		cmocka_unit_test(test_a_large_load_forgets_what_jansson_freed),
		cmocka_unit_test(test_a_load_without_memory_keeps_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
