/* Heights of uneven ground of a model's own, and shadows laid upon it. */
#include "app/scene/shadow/shadow_drape.h"
#include "app/scene/shadow/shadow_lay.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	SIDE = 8 /* quads on a side of the ground */
};

/* Ground of 4 x 4 units, from the origin to +x and +z, of these heights. */
static struct model *make_ground(float (*height)(float x, float z))
{
	struct model *model = small_model_grid(SIDE, SIDE, 4.0f, true);
	struct model_primitive *primitive = model->mesh[0].primitive;

	for (int v = 0; v < primitive->vertex_count; v++) {
		float *at = primitive->position[v];

		at[2] = at[1];
		at[1] = height(at[0], at[2]);
	}
	return model;
}

static float slope(float x, float z)
{
	return 0.25f * x - 0.125f * z;
}

static float hill(float x, float z)
{
	return 0.3f * sinf(x) * sinf(z);
}

static struct instance *make_relief(
	struct model *model, struct shadow_relief *relief)
{
	static const int drawable[1] = {0};
	struct instance *instance = small_model_instance(model);

	assert_near(instance->unit_scale, 1, 0);
	assert_int_equal(shadow_relief_make(relief, instance, drawable, 1), 0);
	assert_non_null(relief->height);
	return instance;
}

static void release(struct model *model, struct instance *instance)
{
	instance_destroy(instance);
	model_destroy(model);
}

static void test_heights_are_those_of_the_ground(void **state)
{
	struct model *model = make_ground(slope);
	struct shadow_relief relief;
	struct instance *instance = make_relief(model, &relief);

	(void)state;
	for (float x = 0; x <= 4; x += 0.37f) {
		for (float z = 0; z <= 4; z += 0.41f) {
			assert_near(shadow_relief_height(&relief, x, z),
				slope(x, z), 1e-3);
		}
	}
	assert_near(relief.error, 0, 1e-3);
	assert_near(relief.y, slope(2, 2), 1e-3);
	/* Outside, the nearest edge counts. */
	assert_near(shadow_relief_height(&relief, -9, 2), slope(0, 2), 1e-3);
	assert_near(shadow_relief_height(&relief, 9, 9), slope(4, 4), 2e-3);
	release(model, instance);
}

static float peak(float x, float z)
{
	return x > 1.9f && x < 2.1f && z > 1.9f && z < 2.1f ? 4.0f : 0.0f;
}

/* A vertex between the nodes of the grid. */
static void test_the_error_is_how_far_vertices_are_off(void **state)
{
	struct model *model = make_ground(peak);
	struct shadow_relief relief;
	struct instance *instance = make_relief(model, &relief);

	(void)state;
	assert_true(relief.error > 0.1f);
	assert_near(relief.error, 4 - shadow_relief_height(&relief, 2, 2), 1e-3);
	release(model, instance);
}

/* Triangles cover half of the box; the other half has the nearest heights. */
static void test_a_hole_has_the_height_beside_it(void **state)
{
	struct model *model = make_ground(slope);
	struct shadow_relief relief;
	struct instance *instance;

	(void)state;
	model->mesh[0].primitive->index_count /= 2;
	instance = make_relief(model, &relief);
	for (float z = 0; z <= 4; z += 0.4f) {
		assert_in_range(
			(long)(1000 + 1000 * shadow_relief_height(&relief, 1, z)),
			700, 2000);
	}
	release(model, instance);
}

/* The light falls at an angle; the ground meets it before level ground would. */
static void test_a_shadow_lies_on_the_ground_along_the_light(void **state)
{
	float (*const kinds[2])(float, float) = {slope, hill};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct model *model = make_ground(kinds[i]);
		struct shadow_relief relief;
		struct instance *instance = make_relief(model, &relief);
		const struct shadow_light light = {
			.towards = {0.48f, 0.8f, 0.36f},
			.eye = {2, 1e6f, 2},
			.relief = &relief};
		const float from[3] = {2.6f, 1.2f, 2.4f};
		float node[SHADOW_NODES_MAX][3], to[1][3], along;
		struct shadow_grid grid = {.node = node};
		struct bounds box = bounds_empty();

		relief.error = 0;
		shadow_lay(&grid, &light, &from, 1, to, &box);
		/* The eye is above, so that lifting changes x and z little. */
		along = (from[0] - to[0][0]) / light.towards[0];
		assert_near(from[2] - to[0][2], along * 0.36f, 0.01);
		assert_near(from[1] - along * 0.8f,
			kinds[i](to[0][0], to[0][2]), 0.02);
		release(model, instance);
	}
}

static void test_lifting_keeps_a_points_place_in_the_picture(void **state)
{
	const struct shadow_relief relief = {.error = 0.1f};
	const float eye[3] = {3, 4, 5};
	float point[3] = {1, 0, 2};

	(void)state;
	shadow_relief_lift(&relief, eye, point);
	assert_true(point[1] >= 0.1f && point[1] < 0.15f);
	assert_near((point[0] - 1) / 2, point[1] / 4, 1e-6);
	assert_near((point[2] - 2) / 3, point[1] / 4, 1e-6);
}

/* Each level of a file may have more corners than the finest list. */
static void test_any_level_may_have_the_most_corners(void **state)
{
	enum {
		MOST = 3 * 1000
	};
	static uint32_t corner[MOST];

	(void)state;
	for (int kind = 0; kind < 4; kind++) {
		struct model_lod lod[2] = {
			{.error_m = 0.01f, .index_count = 3, .index = corner},
			{.error_m = 0.02f, .index_count = 3, .index = corner}};
		struct model *model = make_ground(hill);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct log nowhere = log_to_nowhere();
		struct instance *instance;
		struct shadow_drape few, many;

		primitive->lod = lod;
		primitive->lod_count = 2;
		lod[0].shadow_only = kind / 2;
		lod[1].shadow_only = kind / 2;
		instance = small_model_instance(model);
		assert_int_equal(
			shadow_drape_init(&few, instance, NULL, 0, &nowhere), 0);
		instance_destroy(instance);
		lod[kind % 2].index_count = MOST;
		instance = small_model_instance(model);
		assert_int_equal(
			shadow_drape_init(&many, instance, NULL, 0, &nowhere),
			0);
		assert_int_equal(many.index_max - few.index_max,
			MOST - primitive->index_count);
		release(model, instance);
	}
}

static void test_too_small_a_limit_of_memory_is_named(void **state)
{
	struct model *model = make_ground(hill);
	struct memory_budget nothing = {.limit_bytes = 0};
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct shadow_relief relief;
	struct instance *instance = make_relief(model, &relief);
	struct shadow_drape drape;

	(void)state;
	instance->arena.budget = &nothing;
	assert_int_equal(
		shadow_drape_init_on(&drape, instance, NULL, 0, &relief, &log),
		-ENOMEM);
	assert_int_equal(capture.count, 1);
	assert_true(log_capture_has(&capture, LOG_ERROR, "--memory"));
	instance->arena.budget = NULL;
	release(model, instance);
}

/* A ramp along x or z of which only a part is covered by triangles. */
static void test_a_hole_has_the_height_of_its_edge(void **state)
{
	(void)state;
	for (int kind = 0; kind < 4; kind++) {
		int axis = kind / 2, upper = kind % 2;
		struct model *model = make_ground(slope);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct shadow_relief relief;
		struct instance *instance;
		uint32_t *to = primitive->index;

		for (int v = 0; v < primitive->vertex_count; v++) {
			float *at = primitive->position[v];

			at[1] = at[2 * axis];
		}
		/* Triangles of the lower or the upper half. */
		for (int k = 0; k < primitive->index_count; k += 3) {
			const uint32_t *corner = primitive->index + k;
			float sum = 0;

			for (int i = 0; i < 3; i++) {
				sum += primitive->position[corner[i]][2 * axis];
			}
			if ((sum > 6) == upper) {
				memmove(to, corner, 3 * sizeof(*to));
				to += 3;
			}
		}
		primitive->index_count = (int)(to - primitive->index);
		instance = make_relief(model, &relief);
		for (int i = 0; i <= 16; i++) {
			float at = 0.25f * (float)i, expected = at;

			if (upper ? at < 2 : at > 2) {
				expected = 2;
			}
			/* Half a cell beside the edge is interpolated. */
			assert_near(shadow_relief_height(&relief,
					    axis ? 1.7f : at, axis ? at : 1.7f),
				expected, 0.04);
		}
		assert_near(relief.error, 2, 0.04);
		release(model, instance);
	}
}

/* A table above a floor, whichever comes first in the file. */
static void test_the_higher_surface_counts(void **state)
{
	(void)state;
	for (int order = 0; order < 2; order++) {
		struct model *model = small_model_grid(1, 2, 4.0f, true);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct shadow_relief relief;
		struct instance *instance;

		/* Each square for itself, at the same place. */
		assert_int_equal(primitive->vertex_count, 6);
		assert_int_equal(primitive->index_count, 12);
		for (int v = 0; v < 6; v++) {
			float *at = primitive->position[v];

			at[0] = v % 2 ? 4.0f : 0.0f;
			at[1] = v / 2 == 1 ? 3.0f : 1.0f;
			at[2] = v / 2 == 1 ? 4.0f : 0.0f;
		}
		primitive->position[order ? 4 : 0][1] = 2;
		primitive->position[order ? 5 : 1][1] = 2;
		instance = make_relief(model, &relief);
		assert_near(shadow_relief_height(&relief, 2, 1), 2.25, 1e-3);
		assert_near(shadow_relief_height(&relief, 2, 3), 2.75, 1e-3);
		release(model, instance);
	}
}

static void test_a_model_of_another_size_is_measured_in_scene_units(void **state)
{
	struct model *model = make_ground(slope);
	struct model_primitive *primitive = model->mesh[0].primitive;
	struct shadow_relief relief;
	struct instance *instance;
	static const int drawable[1] = {0};
	float scale;

	(void)state;
	for (int v = 0; v < primitive->vertex_count; v++) {
		primitive->position[v][0] += 1;
		primitive->position[v][2] -= 2;
		for (int axis = 0; axis < 3; axis++) {
			primitive->position[v][axis] *= 1000;
		}
	}
	instance = small_model_instance(model);
	scale = 1000 * instance->unit_scale;
	assert_true(scale < 100);
	assert_int_equal(shadow_relief_make(&relief, instance, drawable, 1), 0);
	assert_near(relief.cell[0], 4 * scale / 63, 1e-4);
	assert_near(shadow_relief_height(&relief, 2 * scale, scale),
		slope(1, 3) * scale, 1e-3);
	release(model, instance);
}

/* Seen from above, a wall is a line. */
static void test_a_wall_is_no_uneven_ground(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis += 2) {
		static const int drawable[1] = {0};
		struct model *model = make_ground(slope);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct shadow_relief relief;
		struct instance *instance;

		for (int v = 0; v < primitive->vertex_count; v++) {
			primitive->position[v][axis] = 1;
		}
		instance = small_model_instance(model);
		assert_int_equal(
			shadow_relief_make(&relief, instance, drawable, 1), 0);
		assert_null(relief.height);
		release(model, instance);
	}
}

/* By 0.4% of the way and the error, and by a quarter of the way at most. */
static void test_a_point_is_lifted_by_a_part_of_the_way_to_the_eye(void **state)
{
	static const struct {
		float error, eye_y, expected;
	} cases[] = {
		{0, 4, 0.016f},
		{0.1f, 4, 0.116f},
		{0.9f, 4, 0.916f},
		{2, 4, 1},
		{0.1f, 0, 0},
		{0.1f, -2, -0.5f},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct shadow_relief relief = {.error = cases[i].error};
		const float eye[3] = {8, cases[i].eye_y, 2};
		float point[3] = {0, 0, 2};

		shadow_relief_lift(&relief, eye, point);
		assert_near(point[1], cases[i].expected, 1e-5);
		assert_near(point[2], 2, 1e-6);
		if (cases[i].eye_y <= 0) {
			assert_near(point[0], 2, 1e-5);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_heights_are_those_of_the_ground),
		cmocka_unit_test(test_a_hole_has_the_height_beside_it),
		cmocka_unit_test(
			test_a_shadow_lies_on_the_ground_along_the_light),
		cmocka_unit_test(
			test_lifting_keeps_a_points_place_in_the_picture),
		cmocka_unit_test(test_the_error_is_how_far_vertices_are_off),
		cmocka_unit_test(test_any_level_may_have_the_most_corners),
		cmocka_unit_test(test_too_small_a_limit_of_memory_is_named),
		cmocka_unit_test(test_a_hole_has_the_height_of_its_edge),
		cmocka_unit_test(test_the_higher_surface_counts),
		cmocka_unit_test(
			test_a_model_of_another_size_is_measured_in_scene_units),
		cmocka_unit_test(test_a_wall_is_no_uneven_ground),
		cmocka_unit_test(
			test_a_point_is_lifted_by_a_part_of_the_way_to_the_eye),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
