/* How many pixels a unit of a model is, and how far two models are apart. */
#include "app/compare/optimize/optimize_measure.h"
#include "app/model/split/split.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <errno.h>

static float px_per_unit(const struct model *model, int width, int height)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_measure_view size = {
		.width = width, .height = height, .share = 1.0};
	struct bounds box;
	float px = -1;

	assert_int_equal(
		optimize_measure_unit(model, &size, &log, &box, &px), 0);
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

/* So that the clip need not be posed for it again. */
static void test_a_unit_comes_with_the_view_of_the_first_clip(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_measure_view view = {
		.width = 48, .height = 64, .share = 1.0};
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct bounds of_unit, of_clip = bounds_empty();
	float px;

	(void)state;
	assert_int_equal(
		optimize_measure_unit(model, &view, &log, &of_unit, &px), 0);
	assert_int_equal(
		optimize_measure(model, model, 0, view, &of_clip, &log, &px), 0);
	assert_memory_equal(&of_unit, &of_clip, sizeof(of_unit));
	model_destroy(model);
}

/* Long clips and many vertices: the search looks at a part of the moments. */
static void test_a_search_measures_a_part_of_long_clips(void **state)
{
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	double share;

	(void)state;
	model->clip_count = 1;
	model->clip[0].duration_s = 30.0f;
	assert_near(optimize_measure_share(model), 1, 0);
	model->clip[0].duration_s = 1e6f;
	share = optimize_measure_share(model);
	assert_true(share > 0 && share < 1);
	model->clip[0].duration_s = 2e6f;
	assert_near(optimize_measure_share(model), 0.5 * share, 1e-6 * share);
	model_destroy(model);
}

/* Of a few seconds, too, if there are very many vertices. */
static void test_a_search_measures_a_part_of_a_huge_model(void **state)
{
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	int count = primitive->vertex_count;

	(void)state;
	model->clip_count = 1;
	model->clip[0].duration_s = 30.0f;
	primitive->vertex_count = 15000;
	assert_near(optimize_measure_share(model), 1, 0);
	primitive->vertex_count = 360000;
	assert_near(optimize_measure_share(model), 3e7 / 360e3 / 1803.0, 1e-4);
	primitive->vertex_count = count;
	model_destroy(model);
}

/* The first model moves, the second one stays where it is at the start. */
static float apart_px(const struct model *model, const struct model *still,
	double share, struct bounds *box)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_measure_view view = {
		.width = 48, .height = 64, .share = share};
	float px;

	assert_int_equal(
		optimize_measure(model, still, 0, view, box, &log, &px), 0);
	return px;
}

static void test_a_part_of_the_moments_shows_about_the_same_error(void **state)
{
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct model_clip rest = {.name = "rest"};
	struct model still = *model;
	struct bounds box = bounds_empty(), empty = bounds_empty();
	float all, part;

	(void)state;
	rest.duration_s = model->clip[0].duration_s;
	still.clip = &rest;
	still.clip_count = 1;
	all = apart_px(model, &still, 1.0, &box);
	assert_false(bounds_is_empty(&box));
	part = apart_px(model, &still, 0.2, &box);
	assert_true(all > 5.0f);
	assert_true(part <= all && part > 0.8f * all);
	/* The view frames the whole clip in any case. */
	assert_near(apart_px(model, &still, 0.2, &empty), part, 0);
	model_destroy(model);
}

/* Each key is away from the others once, for a moment. */
static void test_all_moments_are_measured_unless_a_part_is_asked_for(
	void **state)
{
	enum {
		KEYS = 24
	};
	struct model *model = small_model_grid(1, 1, 1, true), still = *model;
	float time_s[KEYS], value[KEYS][3] = {{0}};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = KEYS,
		.time_s = time_s,
		.value = value[0]};
	struct model_clip clip = {
		.name = "jerk", .channel_count = 1, .channel = &channel};
	struct model_clip rest = {.name = "rest"};

	(void)state;
	for (int k = 0; k < KEYS; k++) {
		time_s[k] = (float)k / 60.0f;
	}
	clip.duration_s = rest.duration_s = time_s[KEYS - 1];
	model->clip = &clip;
	still.clip = &rest;
	model->clip_count = still.clip_count = 1;
	for (int k = 0; k < KEYS; k++) {
		struct bounds box = {{0, 0, 0}, {1, 2, 1}};

		value[k][1] = 1.0f;
		assert_true(apart_px(model, &still, 1.0, &box) > 10.0f);
		value[k][1] = 0.0f;
	}
	model->clip = NULL;
	model->clip_count = 0;
	model_destroy(model);
}

/* A grid that is divided by its places, stretched along +Y. */
static struct model *divided_grid(float height)
{
	struct model *model = small_model_grid(300, 300, 1, true);
	struct model_primitive *primitive = model->mesh[0].primitive;
	struct arena integers = arena_empty();

	for (int v = 0; v < primitive->vertex_count; v++) {
		primitive->position[v][1] *= height;
	}
	assert_int_equal(split_primitives(model, &integers), 0);
	assert_true(model->mesh[0].primitive_count > 1);
	arena_release(&integers);
	return model;
}

static int measure_rest(
	const struct model *wanted, const struct model *found, float *px)
{
	const struct log log = log_to_nowhere();
	const struct optimize_measure_view view = {
		.width = 480, .height = 640, .share = 1.0};
	struct bounds box = bounds_empty();

	return optimize_measure(wanted, found, -1, view, &box, &log, px);
}

/* The longer side is halved first, so that the grids have other parts. */
static void test_vertices_of_other_parts_are_compared(void **state)
{
	struct model *wide = divided_grid(0.9999f);
	struct model *high = divided_grid(1.0001f);
	float px = -1;

	(void)state;
	assert_int_equal(measure_rest(wide, high, &px), 0);
	assert_true(px > 0.02f && px < 0.2f);
	assert_int_equal(measure_rest(high, wide, &px), 0);
	assert_true(px > 0.02f && px < 0.2f);
	model_destroy(wide);
	model_destroy(high);
}

static void test_models_with_other_vertices_are_refused(void **state)
{
	struct model *model = small_model_grid(3, 3, 1, true);
	struct model *other = small_model_grid(3, 4, 1, true);
	float px;

	(void)state;
	assert_int_equal(measure_rest(model, other, &px), -EINVAL);
	assert_int_equal(measure_rest(other, model, &px), -EINVAL);
	other->node[0].mesh = -1;
	assert_int_equal(measure_rest(model, other, &px), -EINVAL);
	assert_int_equal(measure_rest(other, model, &px), -EINVAL);
	model->node[0].mesh = -1;
	assert_int_equal(measure_rest(model, other, &px), 0);
	assert_near(px, 0, 0);
	model_destroy(model);
	model_destroy(other);
}

/*
 * What a step to the picture's right by a short way is in pixels, at the corner
 * of the box where it is most.
 */
static float step_px(const struct screen_view *screen)
{
	float most = 0.0f, unit = 1.0f / 1024.0f;

	for (int i = 0; i < 8; i++) {
		const struct bounds *box = &screen->box;
		float from[3] = {i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2]};
		float to[3], px;

		for (int axis = 0; axis < 3; axis++) {
			to[axis] = from[axis] +
				unit * screen->view[axis][0] / screen->unit;
		}
		px = screen_view_distance_px(screen, from, to) / unit;
		most = px > most ? px : most;
	}
	return most * screen->unit;
}

/* Turned to any side, the grid has corners of its box far from each other. */
static void test_a_unit_is_that_at_the_closest_corner(void **state)
{
	static const float turns[][4] = {{0, 0.6f, 0, 0.8f}, {0, -0.6f, 0, 0.8f},
		{0.6f, 0, 0, 0.8f}, {-0.48f, 0.6f, 0.64f, 0}};
	const struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(turns); i++) {
		struct model *model = small_model_grid(2, 2, 2, true);
		struct model_clip still = {.name = "still", .duration_s = 1};
		struct screen_view screen;
		struct reference *reference;
		struct time_grid grid;

		for (int axis = 0; axis < 4; axis++) {
			model->node[0].rest.rotation[axis] = turns[i][axis];
		}
		model->clip = &still;
		model->clip_count = 1;
		assert_int_equal(
			reference_create(model, 0, &log, &reference), 0);
		assert_int_equal(time_grid_make(&still, &grid), 0);
		screen = screen_view_create(reference, &grid, 300, 200);
		assert_near(px_per_unit(model, 300, 200), step_px(&screen),
			0.01 * (double)step_px(&screen));
		time_grid_release(&grid);
		reference_destroy(reference);
		model->clip = NULL;
		model->clip_count = 0;
		model_destroy(model);
	}
}

static void test_a_view_without_vertices_frames_nothing(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_measure_view view = {48, 64, 1.0, 1.0f};
	struct model *model = small_model_grid(1, 1, 1, true);
	struct bounds box = {{0, 0, 0}, {1, 1, 1}};
	float px;

	(void)state;
	model->node[0].mesh = -1;
	assert_int_equal(
		optimize_measure_unit(model, &view, &log, &box, &px), 0);
	assert_true(bounds_is_empty(&box));
	model_destroy(model);
}

/* Each failure says what to do about it, once. */
static void test_what_cannot_be_measured_is_told(void **state)
{
	struct optimize_measure_view view = {48, 64, 1.0, 1.0f};
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct model *other = small_model_grid(3, 3, 1, true);
	float duration_s = model->clip[0].duration_s, px;
	struct bounds box = bounds_empty();
	struct log_capture said;
	struct log log = log_capture_begin(&said);

	(void)state;
	assert_int_equal(
		optimize_measure(model, other, -1, view, &box, &log, &px),
		-EINVAL);
	assert_int_equal(said.count, 1);
	assert_contains(said.sentence[0], "other vertices");
	model->clip[0].duration_s = 6.0f * 3600.0f;
	log = log_capture_begin(&said);
	assert_int_equal(
		optimize_measure(model, model, 0, view, &box, &log, &px),
		-E2BIG);
	assert_int_equal(said.count, 1);
	assert_contains(said.sentence[0], "longer than five hours");
	log = log_capture_begin(&said);
	assert_int_equal(
		optimize_measure_unit(model, &view, &log, &box, &px), -E2BIG);
	assert_int_equal(said.count, 1);
	assert_contains(said.sentence[0], "longer than five hours");
	model->clip[0].duration_s = duration_s;
	model_destroy(model);
	model_destroy(other);
}

/* A clip of one key has no duration, and yet a pose. */
static void test_a_clip_without_duration_is_measured_in_its_pose(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_measure_view view = {480, 640, 1.0, 1.0f};
	struct model *model = model_fixture("gltf/clip/pose.gltf", NULL);
	struct model rest = *model;
	struct model_clip none = model->clip[0];
	struct bounds box = bounds_empty();
	float px;

	(void)state;
	none.channel_count = 0;
	rest.clip = &none;
	assert_near(model->clip[0].duration_s, 0, 0);
	assert_int_equal(
		optimize_measure(model, model, 0, view, &box, &log, &px), 0);
	assert_near(px, 0, 0);
	assert_int_equal(
		optimize_measure(model, &rest, 0, view, &box, &log, &px), 0);
	assert_true(px > 1.0f);
	model_destroy(model);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_unit_grows_with_the_picture),
		cmocka_unit_test(test_a_search_measures_a_part_of_long_clips),
		cmocka_unit_test(test_a_search_measures_a_part_of_a_huge_model),
		cmocka_unit_test(
			test_a_part_of_the_moments_shows_about_the_same_error),
		cmocka_unit_test(test_a_unit_is_that_of_the_first_clip),
		cmocka_unit_test(test_a_unit_grows_as_the_model_shrinks),
		cmocka_unit_test(
			test_a_unit_of_a_model_without_vertices_is_a_pixel),
		cmocka_unit_test(
			test_a_unit_comes_with_the_view_of_the_first_clip),
		cmocka_unit_test(test_vertices_of_other_parts_are_compared),
		cmocka_unit_test(test_models_with_other_vertices_are_refused),
		cmocka_unit_test(test_a_unit_is_that_at_the_closest_corner),
		cmocka_unit_test(test_a_view_without_vertices_frames_nothing),
		cmocka_unit_test(test_what_cannot_be_measured_is_told),
		cmocka_unit_test(
			test_a_clip_without_duration_is_measured_in_its_pose),
		cmocka_unit_test(
			test_all_moments_are_measured_unless_a_part_is_asked_for),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
