/* Which models are known to pose their vertices in the same way. */
#include "app/compare/optimize/optimize_known.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

static void test_equal_models_have_the_same_stamp(void **state)
{
	struct model *a = model_fixture("gltf/clip/cubic.gltf", NULL);
	struct model *b = model_fixture("gltf/clip/cubic.gltf", NULL);

	(void)state;
	for (int clip = -1; clip < a->clip_count; clip++) {
		assert_true(optimize_known_stamp(a, clip) ==
			optimize_known_stamp(b, clip));
	}
	assert_true(optimize_known_stamp(a, -1) != optimize_known_stamp(a, 0));
	model_destroy(a);
	model_destroy(b);
}

/* Each change is undone before the next one. */
static void test_whatever_poses_vertices_changes_the_stamp(void **state)
{
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	struct model_channel *channel = &model->clip[0].channel[0];
	float *last_time = (float *)channel->time_s + channel->key_count - 1;
	float *last_value = (float *)channel->value +
		3 * channel->width * channel->key_count - 1;
	float *const number[] = {&model->node[0].rest.translation[0],
		&model->clip[0].duration_s, last_time, last_value};
	uint64_t stamp = optimize_known_stamp(model, 0);

	(void)state;
	assert_int_equal(channel->interpolation, MODEL_CUBICSPLINE);
	for (size_t i = 0; i < ARRAY_COUNT(number); i++) {
		float kept = *number[i];

		*number[i] += 1.0f;
		assert_true(optimize_known_stamp(model, 0) != stamp);
		*number[i] = kept;
	}
	channel->constant = !channel->constant;
	assert_true(optimize_known_stamp(model, 0) != stamp);
	channel->constant = !channel->constant;
	channel->node++;
	assert_true(optimize_known_stamp(model, 0) != stamp);
	channel->node--;
	assert_true(optimize_known_stamp(model, 0) == stamp);
	model_destroy(model);
}

static void test_errors_are_found_by_their_stamp(void **state)
{
	struct optimize_known known = {.count = 0};
	float px = -1.0f;

	(void)state;
	assert_false(optimize_known_find(&known, 5, &px));
	for (int i = 0; i < OPTIMIZE_KNOWN_MAX + 3; i++) {
		optimize_known_add(&known, (uint64_t)i, (float)i);
	}
	assert_true(optimize_known_find(&known, 5, &px));
	assert_near(px, 5, 0);
	/* The last one is replaced when the list is full. */
	assert_true(optimize_known_find(&known, OPTIMIZE_KNOWN_MAX + 2, &px));
	assert_near(px, OPTIMIZE_KNOWN_MAX + 2, 0);
	assert_false(optimize_known_find(&known, OPTIMIZE_KNOWN_MAX + 1, &px));
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_equal_models_have_the_same_stamp),
		cmocka_unit_test(test_whatever_poses_vertices_changes_the_stamp),
		cmocka_unit_test(test_errors_are_found_by_their_stamp),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
