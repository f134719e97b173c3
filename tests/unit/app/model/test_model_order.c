/* model_order.h: parents before children. */
#include "app/model/model_order.h"
#include "tests/support/test.h"

#include <errno.h>

static void test_keeps_an_order_that_is_right(void **state)
{
	const int parent[4] = {-1, 0, 1, -1};
	int order[4], place[4], culprit;
	int i;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 4, order, place, &culprit), 0);
	for (i = 0; i < 4; i++) {
		assert_int_equal(order[i], i);
		assert_int_equal(place[i], i);
	}
}

static void test_puts_parents_before_their_children(void **state)
{
	const int parent[6] = {2, 0, 4, 4, -1, 1};
	int order[6], place[6], culprit;
	int i;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 6, order, place, &culprit), 0);
	for (i = 0; i < 6; i++) {
		assert_int_equal(place[order[i]], i);
		if (parent[i] >= 0) {
			assert_true(place[parent[i]] < place[i]);
		}
	}
}

static void test_keeps_subtrees_in_one_piece(void **state)
{
	const int parent[5] = {-1, -1, 0, 1, 0};
	const int expected[5] = {0, 2, 4, 1, 3};
	int order[5], place[5], culprit;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 5, order, place, &culprit), 0);
	assert_memory_equal(order, expected, sizeof(expected));
}

static void test_names_a_node_on_the_cycle_and_not_below_it(void **state)
{
	const int parent[5] = {2, -1, 3, 4, 3};
	int order[5], place[5], culprit;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 5, order, place, &culprit), -ELOOP);
	assert_true(culprit == 3 || culprit == 4);
}

static void test_refuses_a_node_that_is_its_own_parent(void **state)
{
	const int parent[2] = {-1, 1};
	int order[2], place[2], culprit;

	(void)state;
	assert_int_equal(
		model_order_nodes(parent, 2, order, place, &culprit), -ELOOP);
	assert_int_equal(culprit, 1);
}

static void test_orders_no_nodes_at_all(void **state)
{
	int culprit;

	(void)state;
	assert_int_equal(model_order_nodes(NULL, 0, NULL, NULL, &culprit), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keeps_an_order_that_is_right),
		cmocka_unit_test(test_puts_parents_before_their_children),
		cmocka_unit_test(test_keeps_subtrees_in_one_piece),
		cmocka_unit_test(test_names_a_node_on_the_cycle_and_not_below_it),
		cmocka_unit_test(test_refuses_a_node_that_is_its_own_parent),
		cmocka_unit_test(test_orders_no_nodes_at_all),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
