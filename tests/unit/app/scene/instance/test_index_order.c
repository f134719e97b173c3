/* The order of triangles in lists. */
#include "app/scene/instance/batch/index_order.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	TRIANGLES = 3000,
	COUNT = 3 * TRIANGLES
};

/* A strip of triangles, shuffled by a step that visits all of them. */
static void list_strip(uint16_t *index, int step)
{
	for (int i = 0; i < TRIANGLES; i++) {
		int at = i * step % TRIANGLES;

		index[3 * i] = (uint16_t)at;
		index[3 * i + 1] = (uint16_t)(at + 1 + at % 2);
		index[3 * i + 2] = (uint16_t)(at + 2 - at % 2);
	}
}

static int compare(const void *left, const void *right)
{
	return memcmp(left, right, 3 * sizeof(uint16_t));
}

static void test_a_shuffled_strip_is_transformed_once_again(void **state)
{
	static uint16_t index[COUNT], before[COUNT];

	(void)state;
	list_strip(index, 1499);
	memcpy(before, index, sizeof(before));
	assert_true(index_order_misses(index, COUNT) > 2 * TRIANGLES);
	index_order_improve(index, COUNT);
	assert_int_equal(index_order_misses(index, COUNT), TRIANGLES + 2);
	/* The triangles are the same ones, with the same corners. */
	qsort(index, TRIANGLES, 3 * sizeof(*index), compare);
	qsort(before, TRIANGLES, 3 * sizeof(*before), compare);
	assert_memory_equal(index, before, sizeof(before));
}

static void test_a_good_order_stays(void **state)
{
	/* Sorting would put the second triangle first. */
	static const uint16_t good[] = {4, 5, 6, 0, 5, 4, 1, 2, 3};
	uint16_t index[9];

	(void)state;
	memcpy(index, good, sizeof(index));
	index_order_improve(index, 9);
	assert_memory_equal(index, good, sizeof(good));
	index_order_improve(index, 0);
}

static void test_vertices_that_share_a_place_miss(void **state)
{
	static const uint16_t index[] = {
		0, 1, 2, INDEX_ORDER_CACHE, 1, 2, 0, 1, 65535};

	(void)state;
	assert_int_equal(index_order_misses(index, 9), 6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_shuffled_strip_is_transformed_once_again),
		cmocka_unit_test(test_a_good_order_stays),
		cmocka_unit_test(test_vertices_that_share_a_place_miss),
	};

	return cmocka_run_group_tests_name("index_order", tests, NULL, NULL);
}
