/* model_order.h: parents before children. */
#include "app/model/model_order.h"
#include "tests/support/test.h"

#include <errno.h>

static void test_keeps_a_sorted_order(void **state)
{
	const int parent[4] = {-1, 0, 1, -1};
	int order[4], new_index[4], node_on_cycle;
	int i;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 4, order, new_index, &node_on_cycle),
		0);
	for (i = 0; i < 4; i++) {
		assert_int_equal(order[i], i);
		assert_int_equal(new_index[i], i);
	}
}

static void test_puts_parents_before_their_children(void **state)
{
	const int parent[6] = {2, 0, 4, 4, -1, 1};
	int order[6], new_index[6], node_on_cycle;
	int i;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 6, order, new_index, &node_on_cycle),
		0);
	for (i = 0; i < 6; i++) {
		assert_int_equal(new_index[order[i]], i);
		if (parent[i] >= 0) {
			assert_true(new_index[parent[i]] < new_index[i]);
		}
	}
}

static void test_keeps_subtrees_contiguous(void **state)
{
	const int parent[5] = {-1, -1, 0, 1, 0};
	const int expected[5] = {0, 2, 4, 1, 3};
	int order[5], new_index[5], node_on_cycle;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 5, order, new_index, &node_on_cycle),
		0);
	assert_memory_equal(order, expected, sizeof(expected));
}

static void test_reports_a_node_on_the_cycle(void **state)
{
	const int parent[5] = {2, -1, 3, 4, 3};
	int order[5], new_index[5], node_on_cycle;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 5, order, new_index, &node_on_cycle),
		-ELOOP);
	assert_true(node_on_cycle == 3 || node_on_cycle == 4);
}

static void test_refuses_a_node_that_is_its_own_parent(void **state)
{
	const int parent[2] = {-1, 1};
	int order[2], new_index[2], node_on_cycle;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 2, order, new_index, &node_on_cycle),
		-ELOOP);
	assert_int_equal(node_on_cycle, 1);
}

static void test_accepts_zero_nodes(void **state)
{
	int node_on_cycle;

	(void)state;
	assert_int_equal(
		model_order_nodes(NULL, 0, NULL, NULL, &node_on_cycle), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keeps_a_sorted_order),
		cmocka_unit_test(test_puts_parents_before_their_children),
		cmocka_unit_test(test_keeps_subtrees_contiguous),
		cmocka_unit_test(test_reports_a_node_on_the_cycle),
		cmocka_unit_test(test_refuses_a_node_that_is_its_own_parent),
		cmocka_unit_test(test_accepts_zero_nodes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
