#include "app/scene/instance/influence_cap.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

/* A stream of three vertices with 3, 1 and 2 influences. */
static struct drawable drawable = {
	.stream = {.vertex_count = 3,
		.influence_count = 6,
		.capped = {0, 3, 5, 6, 6, 6, 6, 6, 6}},
};

static struct instance make_instance(void)
{
	return (struct instance){.drawable_count = 1, .drawable = &drawable};
}

static void test_reads_numbers_auto_and_budgets(void **state)
{
	struct influence_cap cap;

	(void)state;
	assert_true(influence_cap_parse("2", &cap));
	assert_int_equal(cap.kind, INFLUENCE_CAP_FIXED);
	assert_int_equal(cap.value, 2);
	assert_true(influence_cap_parse("auto", &cap));
	assert_int_equal(cap.kind, INFLUENCE_CAP_DISTANCE);
	assert_true(influence_cap_parse("budget:5000", &cap));
	assert_int_equal(cap.kind, INFLUENCE_CAP_BUDGET);
	assert_int_equal(cap.value, 5000);
	assert_true(influence_cap_parse("1", &cap) && cap.value == 1);
	assert_true(influence_cap_parse("8", &cap) && cap.value == 8);
	assert_true(influence_cap_parse("budget:1", &cap) && cap.value == 1);
	assert_true(influence_cap_parse("budget:100000000", &cap));
	assert_int_equal(cap.value, 100000000);
}

static void test_refuses_other_words(void **state)
{
	static const char *const bad[] = {"", "0", "9", "-1", "two", "2x",
		"budget:", "budget:0", "budget", "budget:100000001", "budgets9"};
	struct influence_cap cap;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_false(influence_cap_parse(bad[i], &cap));
	}
}

static void test_small_figures_get_fewer_influences(void **state)
{
	(void)state;
	assert_int_equal(influence_cap_for_height(400.0f), 0);
	assert_int_equal(influence_cap_for_height(100.0f), 2);
	assert_int_equal(influence_cap_for_height(30.0f), 1);
	assert_int_equal(influence_cap_for_height(160.0f), 0);
	assert_int_equal(influence_cap_for_height(159.9f), 2);
	assert_int_equal(influence_cap_for_height(64.0f), 2);
	assert_int_equal(influence_cap_for_height(63.9f), 1);
}

static void test_counts_what_a_cap_leaves(void **state)
{
	struct instance instance = make_instance();

	(void)state;
	assert_int_equal(influence_cap_cost(&instance, 0), 6);
	assert_int_equal(influence_cap_cost(&instance, 2), 5);
	assert_int_equal(influence_cap_cost(&instance, 1), 3);
}

static void test_a_budget_takes_the_largest_cap_that_fits(void **state)
{
	struct instance instance = make_instance();
	struct camera camera = camera_default();
	struct influence_cap cap = {.kind = INFLUENCE_CAP_BUDGET};

	(void)state;
	cap.value = 6;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.0f, 640), 0);
	cap.value = 5;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.0f, 640), 2);
	cap.value = 3;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.0f, 640), 1);
	/* A vertex has at least one influence. */
	cap.value = 1;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.0f, 640), 1);
}

static void test_distance_makes_the_choice_by_size_on_the_screen(void **state)
{
	struct instance instance = make_instance();
	struct camera camera = camera_default();
	struct influence_cap cap = {.kind = INFLUENCE_CAP_DISTANCE};

	(void)state;
	camera.distance = 4.0f;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.75f, 640), 0);
	camera.distance = 16.0f;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.75f, 640), 2);
	camera.distance = 80.0f;
	assert_int_equal(
		influence_cap_choose(&cap, &instance, &camera, 1.75f, 640), 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_numbers_auto_and_budgets),
		cmocka_unit_test(test_refuses_other_words),
		cmocka_unit_test(test_small_figures_get_fewer_influences),
		cmocka_unit_test(test_counts_what_a_cap_leaves),
		cmocka_unit_test(test_a_budget_takes_the_largest_cap_that_fits),
		cmocka_unit_test(
			test_distance_makes_the_choice_by_size_on_the_screen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
