/* A turned head and a wave, in float and in fixed point. */
#include "app/scene/instance/bend.h"
#include "app/scene/instance/bounds.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct bend_neck neck = {
	.low = 0.098f, .high = 0.15f, .x = 0.01f, .z = -0.02f};
static const struct morph_wave wave = {.direction = {0.0f, 0.0f, 1.0f},
	.axis = {1.0f, 0.0f, 0.0f},
	.amplitude = 0.02f,
	.delay = 1.5f};

static const struct morph_wave oblique = {.direction = {0.48f, 0.6f, 0.64f},
	.axis = {0.8f, 0.36f, -0.48f},
	.amplitude = 0.01f,
	.delay = 1.5f};

struct scene {
	struct model *model;
	struct instance *instance;
	struct bend bend;
	float (*rest)[3];
};

/* A head that stands beside the origin by x and z, or is pressed flat. */
static void begin_as(
	struct scene *scene, const char *kernel, float x, float z, bool flat)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct bend_neck beside = neck;
	const struct drawable *drawable;
	struct model_primitive *head;
	size_t bytes;

	assert_int_equal(model_load("assets/face.glb", &log, &scene->model), 0);
	head = scene->model->mesh[0].primitive;
	for (int v = 0; v < head->vertex_count; v++) {
		head->position[v][0] += x;
		head->position[v][2] += z;
		head->position[v][1] = flat ? 0.05f : head->position[v][1];
	}
	beside.x += x;
	beside.z += z;
	assert_int_equal(instance_create(scene->model, kernel_find(kernel),
				 &log, &scene->instance),
		0);
	drawable = &scene->instance->drawable[0];
	bytes = (size_t)drawable->primitive->vertex_count * sizeof(float[3]);
	scene->rest = malloc(bytes);
	assert_non_null(scene->rest);
	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		drawable_position(drawable, v, scene->rest[v]);
	}
	assert_int_equal(bend_init(&scene->bend, scene->instance,
				 drawable->node, &beside),
		0);
	assert_int_equal(scene->bend.part_count, 1);
	bend_set_wave(&scene->bend, &wave);
}

static void begin_beside(
	struct scene *scene, const char *kernel, float x, float z)
{
	begin_as(scene, kernel, x, z, false);
}

static void begin(struct scene *scene, const char *kernel)
{
	begin_beside(scene, kernel, 0, 0);
}

static void end(struct scene *scene)
{
	free(scene->rest);
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

static int vertex_count(const struct scene *scene)
{
	return scene->instance->drawable[0].primitive->vertex_count;
}

/* The bent position of a vertex, as GL gets it, in metres. */
static void bent(const struct scene *scene, int v, float out[3])
{
	const struct drawable *drawable = &scene->instance->drawable[0];
	const struct batch *batch = drawable->batch;

	if (batch->position) {
		memcpy(out, batch->position[v], sizeof(float[3]));
	} else {
		const struct fixed_vector *at = &batch->fixed_position[v];
		const struct fixed_placement *placement =
			&drawable->fixed->placement;
		const int16_t xyz[3] = {at->x, at->y, at->z};

		for (int i = 0; i < 3; i++) {
			out[i] = (float)xyz[i] * placement->scale +
				placement->offset[i];
		}
	}
	for (int i = 0; i < 3; i++) {
		out[i] /= drawable->vertex_scale;
	}
}

/* The bent normal of a vertex, as GL gets it, in length 1. */
static void bent_normal(const struct scene *scene, int v, float out[3])
{
	const struct batch *batch = scene->instance->drawable[0].batch;
	double length = 0.0;

	if (batch->normal) {
		memcpy(out, batch->normal[v], sizeof(float[3]));
	} else {
		const struct fixed_vector *n = &batch->fixed_normal[v];

		out[0] = n->x;
		out[1] = n->y;
		out[2] = n->z;
	}
	for (int i = 0; i < 3; i++) {
		length += (double)out[i] * (double)out[i];
	}
	for (int i = 0; i < 3; i++) {
		out[i] /= (float)sqrt(length);
	}
}

static double moved(const struct scene *scene, int v)
{
	float unit = scene->instance->drawable[0].vertex_scale;
	double square = 0.0;
	float at[3];

	bent(scene, v, at);
	for (int i = 0; i < 3; i++) {
		double d = (double)at[i] - (double)(scene->rest[v][i] / unit);

		square += d * d;
	}
	return sqrt(square);
}

static void check_rest(const char *kernel)
{
	struct scene scene;

	begin(&scene, kernel);
	for (int i = 0; i < 2; i++) {
		bend_update(&scene.bend, 0.0f, (float)i);
		for (int v = 0; v < vertex_count(&scene); v++) {
			assert_true(moved(&scene, v) < 1e-6);
		}
	}
	end(&scene);
}

/* Such as a flag or a pond; also if the wave's axis is across it. */
static void test_a_flat_shape_has_a_wave_too(void **state)
{
	static const struct morph_wave across = {.direction = {0.0f, 0.0f, 1.0f},
		.axis = {0.0f, 1.0f, 0.0f},
		.amplitude = 0.02f};
	static const char *const kernels[] = {"float", "fixed"};

	(void)state;
	for (int i = 0; i < 4; i++) {
		double most = 0.0;
		struct scene scene;

		begin_as(&scene, kernels[i % 2], 0, 0, true);
		bend_set_wave(&scene.bend, i < 2 ? &wave : &across);
		bend_update(&scene.bend, 0.0f, 0.5f);
		for (int v = 0; v < vertex_count(&scene); v++) {
			float normal[3];

			bent_normal(&scene, v, normal);
			assert_true(isfinite(normal[0]));
			most = fmax(most, moved(&scene, v));
		}
		assert_near(most, 0.02, 1e-3);
		end(&scene);
	}
}

static void test_at_both_ends_of_a_morph_nothing_moves(void **state)
{
	(void)state;
	check_rest("float");
	check_rest("fixed");
}

static void check_turned_normal(const struct scene *scene, int v, double by)
{
	const float *rest = scene->instance->drawable[0].primitive->normal[v];
	const double x = (double)rest[0], z = (double)rest[2];
	float normal[3];

	bent_normal(scene, v, normal);
	assert_near(normal[0], x * cos(by) + z * sin(by), 2e-3);
	assert_near(normal[1], rest[1], 2e-3);
	assert_near(normal[2], z * cos(by) - x * sin(by), 2e-3);
}

static void check_turn(const char *kernel)
{
	struct scene scene;
	double farthest = 0.0;

	begin(&scene, kernel);
	bend_update(&scene.bend, 0.2f, 0.0f);
	for (int v = 0; v < vertex_count(&scene); v++) {
		const float *at =
			scene.instance->drawable[0].primitive->position[v];
		double arm = hypot(
			(double)(at[0] - neck.x), (double)(at[2] - neck.z));

		if (at[1] < neck.low) {
			assert_true(moved(&scene, v) < 1e-6);
		} else if (at[1] > neck.high) {
			assert_near(
				moved(&scene, v), 2.0 * arm * sin(0.1), 1e-4);
			farthest = fmax(farthest, moved(&scene, v));
			check_turned_normal(&scene, v, 0.2);
		}
	}
	assert_true(farthest > 0.02);
	end(&scene);
}

static void test_the_head_turns_and_the_bust_stays(void **state)
{
	(void)state;
	check_turn("float");
	check_turn("fixed");
}

static void check_wave(const char *kernel)
{
	struct scene scene;
	double left = 0.0, right = 0.0;

	begin(&scene, kernel);
	bend_update(&scene.bend, 0.0f, 0.3f);
	for (int v = 0; v < vertex_count(&scene); v++) {
		const float *at =
			scene.instance->drawable[0].primitive->position[v];
		double own = moved(&scene, v);

		assert_true(own < 0.0201);
		if (at[1] < 0.08f || at[1] > 0.38f) {
			assert_true(own < 1e-6); /* bust and crown */
		}
		if (at[0] < -0.02f) {
			left = fmax(left, own);
		}
		if (at[0] > 0.05f) {
			right = fmax(right, own);
		}
	}
	assert_true(left > 0.012);
	assert_true(right < 0.004);
	end(&scene);
}

static void test_the_wave_is_in_the_face_alone_and_has_a_place(void **state)
{
	(void)state;
	check_wave("float");
	check_wave("fixed");
}

static void compare(float x, float z)
{
	struct scene exact, fixed;

	begin_beside(&exact, "float", x, z);
	begin_beside(&fixed, "fixed", x, z);
	bend_set_wave(&exact.bend, &oblique);
	bend_set_wave(&fixed.bend, &oblique);
	for (int i = 0; i < 5; i++) {
		bend_update(
			&exact.bend, 0.08f * (float)(i - 2), 0.2f * (float)i);
		bend_update(
			&fixed.bend, 0.08f * (float)(i - 2), 0.2f * (float)i);
		for (int v = 0; v < vertex_count(&exact); v++) {
			float a[3], b[3];

			bent(&exact, v, a);
			bent(&fixed, v, b);
			for (int k = 0; k < 3; k++) {
				assert_near(a[k], b[k], 1e-4);
			}
			bent_normal(&exact, v, a);
			bent_normal(&fixed, v, b);
			for (int k = 0; k < 3; k++) {
				assert_near(a[k], b[k], 1e-2);
			}
		}
	}
	end(&fixed);
	end(&exact);
}

static void test_fixed_point_agrees_with_float(void **state)
{
	(void)state;
	compare(0, 0);
}

static void test_a_head_beside_the_origin_turns_about_its_own_neck(void **state)
{
	(void)state;
	compare(0.3f, -0.2f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_flat_shape_has_a_wave_too),
		cmocka_unit_test(test_at_both_ends_of_a_morph_nothing_moves),
		cmocka_unit_test(test_the_head_turns_and_the_bust_stays),
		cmocka_unit_test(
			test_the_wave_is_in_the_face_alone_and_has_a_place),
		cmocka_unit_test(test_fixed_point_agrees_with_float),
		cmocka_unit_test(
			test_a_head_beside_the_origin_turns_about_its_own_neck),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
