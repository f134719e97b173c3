#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

static void assert_matrix_near(
	const struct gl_recorded_draw *draw, mat4 expected)
{
	for (int i = 0; i < 16; i++) {
		assert_near(draw->matrix[i], expected[i / 4][i % 4], 1e-3);
	}
}

/* AN4044's arm: each part has its own order of rotations. */
static void make_arm(struct hierarchy_pivot pivot[4])
{
	static const enum hierarchy_order orders[4] = {
		HIERARCHY_HEADING_PITCH_BANK, HIERARCHY_PITCH_HEADING_BANK,
		HIERARCHY_PITCH_BANK_HEADING, HIERARCHY_HEADING_PITCH_BANK};

	for (int i = 0; i < 4; i++) {
		pivot[i] = hierarchy_pivot_default();
		pivot[i].parent = i - 1;
		pivot[i].part = 0;
		pivot[i].order = orders[i];
		pivot[i].position[0] = 0.25f;
		pivot[i].position[1] = 0.5f;
		pivot[i].heading_rad = 0.3f + 0.1f * (float)i;
		pivot[i].pitch_rad = -0.7f;
		pivot[i].bank_rad = 0.2f * (float)i;
	}
	pivot[3].scale[1] = 2.0f;
}

static void test_matrix_stack_agrees_with_the_pivots_world(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};
	const struct gl_recording *recording = gl_recorder_result();
	struct hierarchy_pivot pivot[4];
	struct hierarchy arm = {4, pivot};
	mat4 world[4];

	(void)state;
	make_arm(pivot);
	hierarchy_world(&arm, world);
	draw_hierarchy(&gl, &arm, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(recording->draw_count, 4);
	for (int i = 0; i < 4; i++) {
		assert_matrix_near(&recording->draw[i], world[i]);
	}
	assert_int_equal(recording->depth, 0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_a_rigid_mesh_is_placed_by_its_node(void **state)
{
	struct model *model = small_model_grid(1, 1, 1000.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};
	const struct gl_recorded_draw *draw = gl_recorder_result()->draw;
	float(*position)[3] = instance->drawable[0].position;

	(void)state;
	instance->pose.local[0].translation[0] = 500.0f;
	instance_update(instance);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 1);
	assert_int_equal(draw->count, 6);
	assert_near(draw->matrix[0] * position[3][0] + draw->matrix[12],
		1500.0 * instance->unit_scale, 1e-3);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_a_mirrored_node_turns_the_front_face(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	(void)state;
	instance->pose.local[0].scale[0] = -1.0f;
	instance_update(instance);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw[0].front_face, GL_CW);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_hidden_drawables_cost_no_call(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	(void)state;
	instance->drawable[0].hidden = true;
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_blended_surfaces_come_after_opaque_ones(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_primitive two[2] = {
		model->mesh[0].primitive[0], model->mesh[0].primitive[0]};
	struct model_material material[2] = {
		model->material[0], model->material[0]};
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};
	struct instance *instance;

	(void)state;
	material[0].alpha = MODEL_BLEND;
	two[1].material = 1;
	two[1].index_count = 3;
	model->mesh[0].primitive = two;
	model->mesh[0].primitive_count = model->material_count = 2;
	model->material = material;
	instance = small_model_instance(model);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 2);
	assert_int_equal(gl_recorder_result()->draw[0].count, 3);
	assert_int_equal(gl_recorder_result()->draw[1].count, 6);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_matrix_stack_agrees_with_the_pivots_world),
		cmocka_unit_test(test_a_rigid_mesh_is_placed_by_its_node),
		cmocka_unit_test(test_a_mirrored_node_turns_the_front_face),
		cmocka_unit_test(test_hidden_drawables_cost_no_call),
		cmocka_unit_test(test_blended_surfaces_come_after_opaque_ones),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
