/*
 * Vertices of instances in fixed point, compared with the same in float, and
 * what does not fit 16 bits.
 */
#include "app/scene/instance/bounds.h"
#include "app/scene/shadow/shadow_drape.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/instance_pair.h"
#include "tests/support/model/samples.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	TIMES = 5
};

static const double DEGREE = 0.017453292519943295;

static double distance(const float a[3], const float b[3])
{
	return hypot(hypot((double)a[0] - b[0], (double)a[1] - b[1]),
		(double)a[2] - b[2]);
}

/* Returns the vertex in scene units. */
static void scaled_vertex(const struct instance *instance,
	const struct drawable *drawable, int v, float out[3])
{
	instance_world_vertex(instance, drawable, v, out);
	for (int i = 0; i < 3; i++) {
		out[i] *= instance->unit_scale;
	}
}

/* The radius of the sphere around the middle of the model's box. */
static double radius_of(const struct instance *instance)
{
	struct bounds box = bounds_of_instance(instance);
	float middle[3];
	double most = 0;

	bounds_center(&box, middle);
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float at[3];

			scaled_vertex(instance, drawable, v, at);
			most = fmax(most, distance(at, middle));
		}
	}
	return most / (double)instance->unit_scale;
}

static struct bounds bounds_of_each_vertex(const struct instance *instance)
{
	struct bounds box = bounds_empty();

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float at[3];

			scaled_vertex(instance, drawable, v, at);
			bounds_add(&box, at);
		}
	}
	return box;
}

static double worst_position(const struct instance_pair *pair, int d)
{
	const struct drawable *drawable = &pair->exact->drawable[d];
	double worst = 0;

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float want[3], got[3];

		instance_world_vertex(pair->exact, drawable, v, want);
		instance_world_vertex(
			pair->fixed, &pair->fixed->drawable[d], v, got);
		worst = fmax(worst, distance(want, got));
	}
	return worst;
}

static void unit_of(const struct fixed_vector *v, float out[3])
{
	double length = sqrt((double)v->x * v->x + (double)v->y * v->y +
		(double)v->z * v->z);

	out[0] = (float)(v->x / length);
	out[1] = (float)(v->y / length);
	out[2] = (float)(v->z / length);
}

static double worst_normal(const struct instance_pair *pair, int d)
{
	const struct drawable *exact = &pair->exact->drawable[d];
	const struct drawable_fixed *fixed = pair->fixed->drawable[d].fixed;
	double worst = 0;

	for (int v = 0;
		exact->normal && fixed && v < exact->primitive->vertex_count;
		v++) {
		const float *want = exact->normal[v];
		const float none[3] = {0, 0, 0};
		float got[3];

		if (distance(want, none) < 0.5) {
			continue;
		}
		unit_of(&fixed->normal[fixed->inverse_order
					? fixed->inverse_order[v]
					: (uint32_t)v],
			got);
		worst = fmax(worst, 2 * asin(0.5 * distance(want, got)));
	}
	return worst;
}

static void compare_posed(
	struct instance_pair *pair, double *position, double *normal_rad)
{
	double radius = radius_of(pair->exact);
	struct bounds box = bounds_of_instance(pair->fixed);
	struct bounds same = bounds_of_each_vertex(pair->fixed);

	assert_memory_equal(&box, &same, sizeof(box));
	for (int d = 0; d < pair->exact->drawable_count; d++) {
		*position = fmax(*position,
			worst_position(pair, d) / (radius > 0 ? radius : 1));
		*normal_rad = fmax(*normal_rad, worst_normal(pair, d));
	}
}

static int count_fixed(const struct instance *instance)
{
	int count = 0;

	for (int d = 0; d < instance->drawable_count; d++) {
		count += instance->drawable[d].fixed != NULL;
	}
	return count;
}

static void compare_model(const char *path)
{
	struct log nowhere = log_to_nowhere();
	double position = 0, normal_rad = 0;
	struct model *model;
	struct instance_pair pair;

	if (model_load(path, &nowhere, &model) != 0) {
		return;
	}
	instance_pair_begin(&pair, model);
	for (int i = 0; i < model->clip_count * TIMES; i++) {
		float part = (float)(i % TIMES) / (TIMES - 1);

		pair.exact->max_influences = i % 3 == 2 ? 2 : 0;
		pair.fixed->max_influences = pair.exact->max_influences;
		instance_pair_pose(&pair, i / TIMES,
			part * model->clip[i / TIMES].duration_s);
		compare_posed(&pair, &position, &normal_rad);
	}
	instance_pair_pose(&pair, -1, 0);
	compare_posed(&pair, &position, &normal_rad);
	print_message("# %s: %d of %d parts fixed, %.2g of the radius, %.2g "
		      "degrees\n",
		path, count_fixed(pair.fixed), pair.fixed->drawable_count,
		position, normal_rad / DEGREE);
	assert_int_equal(count_fixed(pair.fixed), pair.fixed->drawable_count);
	assert_near(position, 0, 2e-4);
	assert_near(normal_rad / DEGREE, 0, 1);
	instance_pair_end(&pair);
}

static void test_every_model_is_where_it_is_in_float(void **state)
{
	(void)state;
	assert_true(samples_each_model("assets", compare_model) >= 3);
	samples_each_model(samples_path("").text, compare_model);
	samples_each_model(samples_path("x").text, compare_model);
}

static void test_positions_beyond_16_bits_stay_in_float_with_a_warning(
	void **state)
{
	struct model *model = small_model_grid(1, 1, 1e20f, true);
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);
	struct instance *instance;

	(void)state;
	assert_int_equal(
		instance_create(model, kernel_find("fixed"), &log, &instance),
		0);
	assert_null(instance->drawable[0].fixed);
	assert_non_null(instance->drawable[0].position);
	assert_int_equal(heard.count, 1);
	assert_contains(heard.sentence[0], "float");
	instance_destroy(instance);
	model_destroy(model);
}

static void test_a_pose_that_does_not_fit_keeps_the_last_one(void **state)
{
	struct instance_pair pair;
	struct drawable *skinned;
	float before[3], after[3];

	(void)state;
	instance_pair_load(&pair, "assets/walker.glb");
	skinned = pair.fixed->drawable;
	while (skinned->skin < 0 || !skinned->fixed) {
		skinned++;
	}
	drawable_position(skinned, 0, before);
	for (int i = 0; i < pair.model->node_count; i++) {
		pair.fixed->pose.local[i].translation[0] = INFINITY;
	}
	instance_update(pair.fixed);
	assert_true(instance_overflowed(pair.fixed));
	drawable_position(skinned, 0, after);
	assert_memory_equal(before, after, sizeof(before));
	instance_pair_pose(&pair, 0, 0.1f);
	instance_pair_end(&pair);
}

static void test_normal_maps_are_lit_as_in_float(void **state)
{
	static const uint8_t map[1][4] = {{128, 128, 255, 255}};
	struct model *model = small_model_grid(4, 4, 1.0f, true);
	struct instance_pair pair;

	(void)state;
	small_model_add_normal_map(model, 1, map);
	for (int v = 0; v < 25; v++) {
		float *normal = model->mesh[0].primitive[0].normal[v];

		normal[0] = 0.6f * (float)(v % 3 - 1);
		normal[2] = normal[0] == 0 ? 1 : 0.8f;
	}
	instance_pair_begin(&pair, model);
	instance_pair_pose(&pair, -1, 0);
	for (int v = 0; v < 25; v++) {
		for (int i = 0; i < 4; i++) {
			assert_near(pair.fixed->drawable[0].light[v][i],
				pair.exact->drawable[0].light[v][i], 1);
		}
	}
	instance_pair_end(&pair);
}

static void test_shadows_fall_as_in_float(void **state)
{
	static struct floor floor = {
		.tile = 1.0f, .radius = 9.0f, .wave_height = 0.2f};
	static const struct shadow_light light = {.towards = {0.3f, 0.9f, 0.3f},
		.eye = {0.0f, 1.5f, 4.0f},
		.ground = &floor};
	struct log nowhere = log_to_nowhere();
	struct shadow_drape exact, fixed;
	struct instance_pair pair;

	(void)state;
	instance_pair_load(&pair, "assets/walker.glb");
	instance_pair_pose(&pair, 0, 0.3f);
	assert_int_equal(
		shadow_drape_init(&exact, pair.exact, NULL, 0, &nowhere), 0);
	assert_int_equal(
		shadow_drape_init(&fixed, pair.fixed, NULL, 0, &nowhere), 0);
	fixed.longest = exact.longest = 9.0f;
	shadow_drape_update(&exact, pair.exact, &light);
	shadow_drape_update(&fixed, pair.fixed, &light);
	for (int h = 0; h < exact.sheet_count; h++) {
		const struct shadow_sheet *a = &exact.sheet[h];
		const struct shadow_sheet *b = &fixed.sheet[h];

		/* Both cast the shadow of the same vertices. */
		assert_true(a->vertex_count > 0);
		assert_int_equal(a->vertex_count, b->vertex_count);
		assert_int_equal(a->index_count, b->index_count);
		assert_memory_equal(a->index, b->index,
			(size_t)a->index_count * sizeof(*a->index));
		for (int v = 0; v < a->vertex_count; v++) {
			assert_true(distance(a->position[v], b->position[v]) <
				4e-4);
		}
	}
	instance_pair_end(&pair);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_model_is_where_it_is_in_float),
		cmocka_unit_test(
			test_positions_beyond_16_bits_stay_in_float_with_a_warning),
		cmocka_unit_test(
			test_a_pose_that_does_not_fit_keeps_the_last_one),
		cmocka_unit_test(test_normal_maps_are_lit_as_in_float),
		cmocka_unit_test(test_shadows_fall_as_in_float),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
