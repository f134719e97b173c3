/* What F9 is to the demo, and what to the program. */
#include "app/cmd/show/program_keys.h"
#include "tests/support/test.h"

struct bench {
	struct program_keys keys;
	struct button_event passed[PROGRAM_KEYS_PASSED];
	int count;
};

static enum program_wish take(
	struct bench *bench, int64_t at_ms, enum button button, bool down)
{
	const struct button_event event = {at_ms, button, down};

	return program_keys_take(
		&bench->keys, &event, bench->passed, &bench->count);
}

static void test_other_buttons_pass_as_they_come(void **state)
{
	struct bench bench = {.count = 0};

	(void)state;
	assert_int_equal(take(&bench, 5, BUTTON_F8, true), WISH_NOTHING);
	assert_int_equal(bench.count, 1);
	assert_int_equal(bench.passed[0].button, BUTTON_F8);
	assert_true(bench.passed[0].down);
	take(&bench, 9, BUTTON_F8, false);
	assert_int_equal(bench.count, 1);
	assert_false(bench.passed[0].down);
}

static void test_a_short_f9_is_the_demos_when_it_is_let_go(void **state)
{
	struct bench bench = {.count = 0};

	(void)state;
	take(&bench, 100, BUTTON_F9, true);
	assert_int_equal(bench.count, 0);
	assert_int_equal(program_keys_wait(&bench.keys, 799), WISH_NOTHING);
	take(&bench, 799, BUTTON_F9, false);
	assert_int_equal(bench.count, 2);
	assert_true(bench.passed[0].down);
	assert_false(bench.passed[1].down);
	assert_int_equal(bench.passed[0].time_ms, 799);
}

static void test_a_held_f9_asks_for_the_graph_once(void **state)
{
	struct bench bench = {.count = 0};

	(void)state;
	take(&bench, 100, BUTTON_F9, true);
	assert_int_equal(program_keys_wait(&bench.keys, 800), WISH_GRAPH);
	assert_int_equal(program_keys_wait(&bench.keys, 900), WISH_NOTHING);
	take(&bench, 2000, BUTTON_F9, false);
	assert_int_equal(bench.count, 0);
	assert_int_equal(program_keys_wait(&bench.keys, 9000), WISH_NOTHING);
}

static void test_f8_under_f9_keeps_the_picture_and_is_not_passed(void **state)
{
	struct bench bench = {.count = 0};

	(void)state;
	take(&bench, 0, BUTTON_F9, true);
	assert_int_equal(take(&bench, 100, BUTTON_F8, true), WISH_PICTURE);
	assert_int_equal(bench.count, 0);
	take(&bench, 200, BUTTON_F9, false);
	assert_int_equal(bench.count, 0);
	take(&bench, 300, BUTTON_F8, false);
	assert_int_equal(bench.count, 0);
	take(&bench, 400, BUTTON_F8, true);
	assert_int_equal(bench.count, 1);
}

static void test_a_press_let_go_twice_is_heard_once(void **state)
{
	struct bench bench = {.count = 0};

	(void)state;
	take(&bench, 0, BUTTON_F9, false);
	assert_int_equal(bench.count, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_other_buttons_pass_as_they_come),
		cmocka_unit_test(test_a_short_f9_is_the_demos_when_it_is_let_go),
		cmocka_unit_test(test_a_held_f9_asks_for_the_graph_once),
		cmocka_unit_test(
			test_f8_under_f9_keeps_the_picture_and_is_not_passed),
		cmocka_unit_test(test_a_press_let_go_twice_is_heard_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
