/* The box of one drawable is that of its vertices, to the bit. */
#include "app/anim/clip.h"
#include "app/scene/instance/bounds_drawable.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static struct bounds box_of_vertices(
	const struct instance *instance, const struct drawable *drawable)
{
	struct bounds box = bounds_empty();

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float at[3];

		instance_world_vertex(instance, drawable, v, at);
		for (int axis = 0; axis < 3; axis++) {
			at[axis] *= instance->unit_scale;
		}
		bounds_add(&box, at);
	}
	return box;
}

static void expect_boxes(const struct instance *instance)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		struct bounds wanted = box_of_vertices(instance, drawable);
		struct bounds box = bounds_of_drawable(instance, drawable);

		assert_memory_equal(&box, &wanted, sizeof(box));
	}
}

/* Rigid, morphed and skinned vertices, in fixed point and in float. */
static void test_a_box_equals_that_of_single_vertices(void **state)
{
	static const char *const paths[] = {
		"assets/arm.glb", "assets/face.glb", "assets/walker.glb"};

	(void)state;
	for (size_t i = 0; i < 6; i++) {
		struct log log = log_to_stderr(LOG_ERROR);
		const struct kernel *kernel = i % 2 == 0 ? kernel_find("float")
							 : kernel_find("fixed");
		struct clip_cursor none = {0};
		struct instance *instance;
		struct model *model;

		assert_int_equal(model_load(paths[i / 2], &log, &model), 0);
		assert_int_equal(
			instance_create(model, kernel, &log, &instance), 0);
		for (int step = 0; step < 5; step++) {
			pose_rest(&instance->pose, model);
			if (model->clip_count > 0) {
				clip_sample(&model->clip[0], 0.21f * (float)step,
					&none, &instance->pose);
			}
			instance->pose.local[0].translation[1] +=
				0.3f * (float)step;
			instance_update(instance);
			expect_boxes(instance);
		}
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* A place that is none is left out, and all of them leave an empty box. */
static void test_vertices_that_are_no_numbers_are_left_out(void **state)
{
	struct model *model = small_model_grid(2, 2, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct drawable *drawable = &instance->drawable[0];
	struct bounds box;

	(void)state;
	instance_update(instance);
	if (!drawable->fixed) {
		((float(*)[3])(uintptr_t)drawable->position)[0][1] = NAN;
		expect_boxes(instance);
	}
	instance->world[drawable->node][0][0] = NAN;
	box = bounds_of_drawable(instance, drawable);
	assert_true(bounds_is_empty(&box));
	expect_boxes(instance);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_box_equals_that_of_single_vertices),
		cmocka_unit_test(test_vertices_that_are_no_numbers_are_left_out),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
