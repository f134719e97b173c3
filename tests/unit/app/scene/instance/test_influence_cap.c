#include "app/scene/instance/influence_cap.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

/* Vertices of 3, 1 and 2 influences. */
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
	struct lod lod;

	(void)state;
	assert_true(lod_parse("2", &lod));
	assert_int_equal(lod.kind, LOD_FIXED);
	assert_int_equal(lod.value, 2);
	assert_true(lod_parse("auto", &lod));
	assert_int_equal(lod.kind, LOD_DISTANCE);
	assert_true(lod_parse("budget:5000", &lod));
	assert_int_equal(lod.kind, LOD_BUDGET);
	assert_int_equal(lod.value, 5000);
}

static void test_refuses_other_words(void **state)
{
	static const char *const bad[] = {"", "0", "9", "-1", "two", "2x",
		"budget:", "budget:0", "budget"};
	struct lod lod;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_false(lod_parse(bad[i], &lod));
	}
}

static void test_small_figures_get_fewer_influences(void **state)
{
	(void)state;
	assert_int_equal(lod_for_height(400.0f), 0);
	assert_int_equal(lod_for_height(100.0f), 2);
	assert_int_equal(lod_for_height(30.0f), 1);
}

static void test_counts_what_a_cap_leaves(void **state)
{
	struct instance instance = make_instance();

	(void)state;
	assert_int_equal(lod_cost(&instance, 0), 6);
	assert_int_equal(lod_cost(&instance, 2), 5);
	assert_int_equal(lod_cost(&instance, 1), 3);
}

static void test_a_budget_takes_the_largest_cap_that_fits(void **state)
{
	struct instance instance = make_instance();
	struct camera camera = camera_default();
	struct lod lod = {.kind = LOD_BUDGET};

	(void)state;
	lod.value = 6;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.0f, 640), 0);
	lod.value = 5;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.0f, 640), 2);
	lod.value = 3;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.0f, 640), 1);
	/* One influence a vertex is the least there is. */
	lod.value = 1;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.0f, 640), 1);
}

static void test_distance_makes_the_choice_by_size_on_the_screen(void **state)
{
	struct instance instance = make_instance();
	struct camera camera = camera_default();
	struct lod lod = {.kind = LOD_DISTANCE};

	(void)state;
	camera.distance = 4.0f;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.75f, 640), 0);
	camera.distance = 16.0f;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.75f, 640), 2);
	camera.distance = 80.0f;
	assert_int_equal(lod_choose(&lod, &instance, &camera, 1.75f, 640), 1);
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
