/* The vertices of shadows before they are laid: where the figure is posed. */
#include "app/anim/math/vec.h"
#include "app/scene/shadow/shadow_drape.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>

/* The distance of a point from the drawable's nearest vertex. */
static float distance_to(const struct instance *instance,
	const struct drawable *drawable, const float point[3])
{
	float nearest = 1e9f;

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float at[3], way[3];

		instance_world_vertex(instance, drawable, v, at);
		for (int axis = 0; axis < 3; axis++) {
			at[axis] *= instance->unit_scale;
		}
		vec_subtract(at, point, way);
		nearest = fminf(nearest, vec_length(way));
	}
	return nearest;
}

/* Every corner of every sheet is a vertex in its place. */
static void check_posed(struct instance *instance, float tolerance)
{
	static struct floor floor = {.y = -3, .tile = 1, .radius = 9};
	const struct shadow_light light = {.towards = {0.36f, 0.8f, 0.48f},
		.eye = {0, 50, 0},
		.ground = &floor};
	struct log nowhere = log_to_nowhere();
	struct shadow_drape drape;

	assert_int_equal(
		shadow_drape_init(&drape, instance, NULL, 0, &nowhere), 0);
	drape.longest = 1e6f; /* divides no triangle */
	shadow_drape_update(&drape, instance, &light);
	assert_true(drape.sheet_count > 0);
	for (int i = 0; i < drape.sheet_count; i++) {
		const struct shadow_sheet *sheet = &drape.sheet[i];

		assert_true(sheet->index_count >= 3);
		for (int v = 0; v < sheet->vertex_count; v++) {
			assert_near(distance_to(instance, sheet->drawable,
					    sheet->posed[v]),
				0, tolerance);
		}
	}
}

static void test_a_turned_and_moved_part_is_posed(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		struct model *model = small_model_grid(2, 2, 200.0f, true);
		struct instance *instance;
		struct transform *local;

		for (int v = 0; v < 9; v++) {
			model->mesh[0].primitive->position[v][2] =
				(float)(v * v);
		}
		instance = small_model_instance(model);
		local = &instance->pose.local[0];
		local->rotation[axis] = 0.6f;
		local->rotation[3] = 0.8f;
		local->translation[0] = 30;
		local->translation[1] = 50;
		local->translation[2] = -70;
		local->scale[axis] = 1.5f;
		instance_update(instance);
		check_posed(instance, 1e-4f);
		instance_destroy(instance);
		model_destroy(model);
	}
}

static void test_skins_are_posed_in_float_and_in_fixed_point(void **state)
{
	static const char *const kernels[] = {"float", "fixed"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct model *model =
			model_fixture("gltf/skin/and_morph.gltf", NULL);
		struct log nowhere = log_to_nowhere();
		struct instance *instance;

		assert_int_equal(instance_create(model, kernel_find(kernels[i]),
					 &nowhere, &instance),
			0);
		for (int n = 0; n < model->node_count; n++) {
			instance->pose.local[n].translation[2] += 0.25f;
		}
		instance_update(instance);
		check_posed(instance, 1e-3f);
		instance_destroy(instance);
		model_destroy(model);
	}
}

static struct {
	GLenum function, passed, other[2];
	GLint mark;
	GLuint mask;
} stencil;

static void keep_function(GLenum function, GLint reference, GLuint mask)
{
	stencil.function = function;
	stencil.mark = reference;
	stencil.mask = mask;
}

static void keep_operation(GLenum fail, GLenum deep, GLenum passed)
{
	stencil.other[0] = fail;
	stencil.other[1] = deep;
	stencil.passed = passed;
}

/* Of all bits: a pixel that was darkened counts one more than the mark. */
static void test_only_pixels_of_the_mark_are_darkened(void **state)
{
	struct shadow_drape drape = {.sheet_count = 0};
	struct gl gl = gl_recorder_begin();

	(void)state;
	gl.StencilFunc = keep_function;
	gl.StencilOp = keep_operation;
	for (int mark = 0; mark < 200; mark += 99) {
		shadow_drape_draw(&drape, &gl, 0.5f, mark, true);
		assert_int_equal(stencil.function, GL_EQUAL);
		assert_int_equal(stencil.mark, mark);
		assert_int_equal(stencil.mask & 255, 255);
		assert_int_equal(stencil.passed, GL_INCR);
		assert_int_equal(stencil.other[0], GL_KEEP);
		assert_int_equal(stencil.other[1], GL_KEEP);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_turned_and_moved_part_is_posed),
		cmocka_unit_test(
			test_skins_are_posed_in_float_and_in_fixed_point),
		cmocka_unit_test(test_only_pixels_of_the_mark_are_darkened),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
