/* How many pixels a unit of a model is. */
#include "app/compare/optimize/optimize_measure.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

static float px_per_unit(const struct model *model, int width, int height)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_view_size size = {width, height};
	float px = -1;

	assert_int_equal(optimize_measure_unit(model, size, &log, &px), 0);
	return px;
}

static void test_a_unit_grows_with_the_picture(void **state)
{
	struct model *model = small_model_grid(2, 2, 1, true);
	float small = px_per_unit(model, 100, 100);

	(void)state;
	/* The grid of one unit fills most of the picture. */
	assert_true(small > 50 && small < 200);
	assert_near(px_per_unit(model, 300, 300), 3 * small, 1e-3);
	model_destroy(model);
}

/* limber frames a model of any size in the same way. */
static void test_a_unit_grows_as_the_model_shrinks(void **state)
{
	static const float sides[] = {1e-6f, 1e-3f, 0.1f, 100.0f, 1e5f};
	struct model *model = small_model_grid(2, 2, 1, true);
	float one = px_per_unit(model, 100, 100);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		for (int axis = 0; axis < 3; axis++) {
			model->node[0].rest.scale[axis] = sides[i];
		}
		assert_near(px_per_unit(model, 100, 100) * sides[i], one,
			0.1 * (double)one);
	}
	model_destroy(model);
}

static void test_a_unit_of_a_model_without_vertices_is_a_pixel(void **state)
{
	struct model *model = small_model_grid(1, 1, 1, true);

	(void)state;
	model->node[0].mesh = -1;
	assert_near(px_per_unit(model, 300, 300), 1, 0);
	model_destroy(model);
}

/* Its first clip moves far, so that the whole way fits the picture. */
static void test_a_unit_is_that_of_the_first_clip(void **state)
{
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct model_clip *clips = model->clip;
	struct model_clip still = {.name = "still", .duration_s = 1};
	struct model_clip still_first[2] = {still, clips[0]};
	struct model_clip still_last[2] = {clips[0], still};
	int count = model->clip_count;
	float moving_px, resting_px;

	(void)state;
	model->clip_count = 1;
	moving_px = px_per_unit(model, 300, 300);
	model->clip_count = 0;
	resting_px = px_per_unit(model, 300, 300);
	assert_true(moving_px < 0.5f * resting_px);
	model->clip_count = 2;
	model->clip = still_last;
	assert_near(px_per_unit(model, 300, 300), moving_px, 0);
	model->clip = still_first;
	assert_near(px_per_unit(model, 300, 300), resting_px, 0);
	model->clip = clips;
	model->clip_count = count;
	model_destroy(model);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_unit_grows_with_the_picture),
		cmocka_unit_test(test_a_unit_is_that_of_the_first_clip),
		cmocka_unit_test(test_a_unit_grows_as_the_model_shrinks),
		cmocka_unit_test(
			test_a_unit_of_a_model_without_vertices_is_a_pixel),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
