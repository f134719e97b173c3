/* The box around a posed instance that is found without its vertices. */
#include "app/anim/clip.h"
#include "app/scene/instance/reach.h"
#include "app/scene/stage/camera.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

/* The box of all vertices along the view's axes. */
static struct bounds find_box(const struct instance *instance, mat4 view)
{
	struct bounds box = bounds_empty();

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float at[3];

			instance_world_vertex(instance, drawable, v, at);
			glm_vec3_scale(at, instance->unit_scale, at);
			glm_mat4_mulv3(view, at, 1.0f, at);
			bounds_add(&box, at);
		}
	}
	return box;
}

/* Returns how many times as long as needed the sides of the box are together. */
static float check_box(const struct instance *instance,
	const struct reach *reach, const struct camera *camera)
{
	float needed = 0.0f, found = 0.0f, rounding;
	struct bounds box, now;
	mat4 view;

	camera_view(camera, view);
	box = find_box(instance, view);
	now = reach_now(reach, instance, (const vec4 *)view);
	rounding = 1e-4f * bounds_extent(&box);
	for (int axis = 0; axis < 3; axis++) {
		assert_true(now.low[axis] <= box.low[axis] + rounding);
		assert_true(now.high[axis] >= box.high[axis] - rounding);
		needed += box.high[axis] - box.low[axis];
		found += now.high[axis] - now.low[axis];
	}
	return found / needed;
}

static void check_model(const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct camera camera = camera_default();
	struct clip_cursor cursor = {0};
	struct instance *instance;
	struct reach reach;
	struct model *model;

	assert_int_equal(model_load(path, &nowhere, &model), 0);
	assert_int_equal(
		instance_create(model, kernel_find(NULL), &nowhere, &instance),
		0);
	assert_int_equal(reach_init(&reach, instance), 0);
	for (int i = 0; i < 8 * model->clip_count; i++) {
		const struct model_clip *clip = &model->clip[i / 8];

		pose_rest(&instance->pose, model);
		clip_sample(clip, (float)(i % 8) / 7.0f * clip->duration_s,
			&cursor, &instance->pose);
		instance_update(instance);
		camera.yaw_rad = 0.7f * (float)i;
		camera.pitch_rad = 0.3f;
		assert_true(check_box(instance, &reach, &camera) < 1.5f);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_all_posed_vertices_are_within_the_box(void **state)
{
	(void)state;
	check_model("assets/walker.glb");
	check_model("assets/arm.glb");
	check_model("assets/face.glb");
}

/* No target, and each alone at weight 1, of a model at rest. */
static void test_the_box_reaches_as_far_as_each_morph_target(void **state)
{
	struct log nowhere = log_to_nowhere();
	mat4 view = GLM_MAT4_IDENTITY_INIT;
	struct bounds wanted = bounds_empty(), found;
	struct test_path path = fixture_path("gltf/skin/and_morph.gltf");
	struct instance *instance;
	struct reach reach;
	struct model *model;

	(void)state;
	assert_int_equal(model_load(path.text, &nowhere, &model), 0);
	assert_int_equal(
		instance_create(model, kernel_find(NULL), &nowhere, &instance),
		0);
	assert_int_equal(reach_init(&reach, instance), 0);
	for (int t = -1; t < model->weight_count; t++) {
		struct bounds box;

		pose_rest(&instance->pose, model);
		for (int w = 0; w < model->weight_count; w++) {
			instance->pose.weight[w] = w == t ? 1.0f : 0.0f;
		}
		instance_update(instance);
		box = find_box(instance, view);
		bounds_join(&wanted, &box);
	}
	found = reach_now(&reach, instance, (const vec4 *)view);
	for (int axis = 0; axis < 3; axis++) {
		assert_near(found.low[axis], wanted.low[axis], 1e-3);
		assert_near(found.high[axis], wanted.high[axis], 1e-3);
	}
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_posed_vertices_are_within_the_box),
		cmocka_unit_test(
			test_the_box_reaches_as_far_as_each_morph_target),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
