/* glTF skins: joints in any order, weights in any format. */
#include "app/model/model.h"
#include "app/model/model_loader.h"
#include "tests/support/model/deltas.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <string.h>

static const char *joint_name(
	const struct model *model, const struct model_skin *skin, int joint)
{
	return model->node[skin->joint[joint]].name;
}

static void expect_influences(const struct model_primitive *primitive,
	int vertex, const uint16_t *joint, const float *weight)
{
	size_t first = (size_t)vertex * (size_t)primitive->influences;

	assert_memory_equal(primitive->joint + first, joint,
		(size_t)primitive->influences * sizeof(*joint));
	assert_all_near(primitive->weight + first, weight,
		(size_t)primitive->influences, 1e-7);
}

static void test_uses_identities_without_inverse_bind_matrices(void **state)
{
	struct model *model =
		model_fixture("gltf/skin/no_inverse_bind.gltf", NULL);
	const struct model_skin *skin = &model->skin[0];
	int i, c, r;

	(void)state;
	assert_int_equal(skin->joint_count, 2);
	for (i = 0; i < 2; i++) {
		for (c = 0; c < 4; c++) {
			for (r = 0; r < 4; r++) {
				assert_near(
					skin->inverse_bind[i][c][r], c == r, 0);
			}
		}
	}
	model_destroy(model);
}

static void test_keeps_the_order_of_the_joint_list(void **state)
{
	struct model *model = model_fixture("gltf/skin/unsorted.gltf", NULL);
	const struct model_skin *skin = &model->skin[0];

	(void)state;
	assert_string_equal(joint_name(model, skin, 0), "tip");
	assert_string_equal(joint_name(model, skin, 1), "root");
	assert_string_equal(joint_name(model, skin, 2), "middle");
	assert_near(skin->inverse_bind[0][3][1], -30, 0);
	assert_near(skin->inverse_bind[1][3][1], -1, 0);
	assert_near(skin->inverse_bind[2][3][1], -20, 0);
	model_destroy(model);
}

static void test_sorts_parents_before_their_children(void **state)
{
	struct model *model = model_fixture("gltf/skin/unsorted.gltf", NULL);
	int i;

	(void)state;
	for (i = 0; i < model->node_count; i++) {
		assert_true(model->node[i].parent < i);
	}
	assert_string_equal(fixture_node(model, 0)->name, "tip");
	assert_string_equal(fixture_node(model, 4)->name, "between");
	i = model_find_node(model, "middle");
	assert_string_equal(model->node[model->node[i].parent].name, "between");
	model_destroy(model);
}

static void test_reads_eight_influences_of_bytes_and_shorts(void **state)
{
	static const uint16_t joint[8] = {0, 1, 2, 3, 4, 0, 0, 0};
	static const float weight[8] = {0.2f, 0.2f, 0.2f, 0.2f, 0.2f};
	struct model *model =
		model_fixture("gltf/skin/eight_influences.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];
	int i;

	(void)state;
	assert_int_equal(primitive->influences, 8);
	for (i = 0; i < 3; i++) {
		expect_influences(primitive, i, joint, weight);
	}
	model_destroy(model);
}

static void test_attaches_a_vertex_without_weight_to_its_first_joint(
	void **state)
{
	static const uint16_t joint[4] = {1, 0, 0, 0};
	static const float weight[4] = {1, 0, 0, 0};
	struct model *model = model_fixture("gltf/skin/odd_weights.gltf", NULL);

	(void)state;
	expect_influences(&model->mesh[0].primitive[0], 0, joint, weight);
	model_destroy(model);
}

static void test_scales_weights_to_a_sum_of_1(void **state)
{
	static const uint16_t joint[4] = {0, 1, 0, 0};
	static const float weight[4] = {0.75f, 0.25f, 0, 0};
	struct model *model = model_fixture("gltf/skin/odd_weights.gltf", NULL);

	(void)state;
	expect_influences(&model->mesh[0].primitive[0], 1, joint, weight);
	model_destroy(model);
}

static void test_treats_negative_weights_as_0(void **state)
{
	static const uint16_t joint[4] = {0, 1, 0, 0};
	static const float weight[4] = {0, 1, 0, 0};
	struct model *model = model_fixture("gltf/skin/odd_weights.gltf", NULL);

	(void)state;
	expect_influences(&model->mesh[0].primitive[0], 2, joint, weight);
	model_destroy(model);
}

static void test_accepts_a_joint_out_of_range_without_weight(void **state)
{
	static const uint16_t joint[4] = {1, 0, 0, 0};
	static const float weight[4] = {1, 0, 0, 0};
	struct model *model = model_fixture("gltf/skin/odd_weights.gltf", NULL);

	(void)state;
	expect_influences(&model->mesh[0].primitive[0], 3, joint, weight);
	model_destroy(model);
}

static void test_draws_one_mesh_with_several_skins(void **state)
{
	struct model *model = model_fixture("gltf/skin/shared_mesh.gltf", NULL);

	(void)state;
	assert_int_equal(model->mesh_count, 1);
	assert_int_equal(model->skin_count, 2);
	assert_int_equal(fixture_node(model, 0)->skin, 0);
	assert_int_equal(fixture_node(model, 1)->skin, 1);
	assert_int_equal(fixture_node(model, 2)->skin, -1);
	assert_int_equal(fixture_node(model, 2)->mesh, 0);
	assert_int_equal(model->skin[0].joint_count, 2);
	assert_int_equal(model->skin[1].joint_count, 3);
	assert_int_equal(model->mesh[0].primitive[0].influences, 4);
	model_destroy(model);
}

static void test_reads_morph_and_skin_together(void **state)
{
	float moved[3], turned[3];
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	const struct model_mesh *mesh = &model->mesh[0];
	const struct model_primitive *primitive = &mesh->primitive[0];

	(void)state;
	assert_int_equal(mesh->target_count, 2);
	assert_string_equal(mesh->target_name[0], "out");
	assert_string_equal(mesh->target_name[1], "up");
	assert_int_equal(primitive->influences, 4);
	model_deltas_get(&primitive->target[0].position, 2, moved);
	model_deltas_get(&primitive->target[0].normal, 1, turned);
	assert_all_near(moved, ((const float[3]){0, 0, 1}), 3, 0);
	assert_near(turned[0], 1, 0);
	assert_int_equal(primitive->target[1].normal.vertex_count, 0);
	assert_near(model->rest_weights[0], 0.5, 0);
	assert_int_equal(model->clip[0].channel_count, 2);
	model_destroy(model);
}

static void test_keeps_a_rigid_mesh_below_a_scaled_bone(void **state)
{
	struct model *model =
		model_fixture("gltf/skin/rigid_on_bone.gltf", NULL);
	const struct model_node *hat = fixture_node(model, 2);

	(void)state;
	assert_int_equal(hat->skin, -1);
	assert_int_equal(model->mesh[hat->mesh].primitive[0].influences, 0);
	assert_int_equal(hat->parent, model->skin[0].joint[0]);
	assert_near(model->node[hat->parent].rest.scale[1], 3, 0);
	model_destroy(model);
}

#define ZEROS(type) "{'componentType':5126,'count':3,'type':'" type "'}"
#define BYTES(type) "{'componentType':5121,'count':3,'type':'" type "'}"
#define SKINNED     "{'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':2}}"

/* Without a skin, no joint count limits the joint numbers. */
static void test_drops_influences_that_no_skin_uses(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text("{'asset':{'version':'2.0'},'accessors':"
				"[" ZEROS("VEC3") "," BYTES("VEC4") "," ZEROS(
					"VEC4") "],'nodes':[{'mesh':0}],"
						"'meshes':[{'primitives':"
						"[" SKINNED "]}]}",
			&logged, &model),
		0);
	assert_int_equal(model->mesh[0].primitive[0].influences, 0);
	assert_null(model->mesh[0].primitive[0].joint);
	assert_null(model->mesh[0].primitive[0].weight);
	model_destroy(model);
}

static void test_warns_of_a_skinned_primitive_without_joints(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'accessors':[" ZEROS(
				"VEC3") "],'skins':[{'joints':[0]}],"
					"'nodes':[{'mesh':0,'skin':0}],'meshes'"
					":["
					"{'primitives':[{'attributes':{'"
					"POSITION':0}"
					"}]}]}",
			&logged, &model),
		0);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/meshes/0/primitives/0: has no JOINTS_0"));
	model_destroy(model);
}

static void test_normalises_large_and_small_weights(void **state)
{
	uint16_t joint[8] = {3, 2, 1, 0, 3, 2, 1, 0};
	float weight[8] = {3e38f, 3e38f, 0, 0, 1e-45f, 0, 0, 1e-45f};
	static const float expected[8] = {0.5f, 0.5f, 0, 0, 0.5f, 0, 0, 0.5f};
	struct model_primitive primitive = {
		.vertex_count = 2,
		.influences = 4,
		.joint = joint,
		.weight = weight,
	};

	(void)state;
	model_normalize_influences(&primitive);
	assert_all_near(weight, expected, 8, 1e-7);
	assert_int_equal(joint[0], 3);
	assert_int_equal(joint[2], 0);
	assert_int_equal(model_max_joint(&primitive), 3);
}

static void test_warns_of_a_skin_without_a_mesh(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text("{'asset':{'version':'2.0'},"
					 "'nodes':[{'skin':0}],"
					 "'skins':[{'joints':[0]}]}",
				 &logged, &model),
		0);
	assert_int_equal(model->node[0].skin, -1);
	assert_true(log_capture_has(
		&logged, LOG_WARNING, "/nodes/0: has a skin but no mesh"));
	model_destroy(model);
}

static void test_takes_the_first_eight_influences(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'accessors':[" ZEROS("VEC3") "," BYTES(
				"VEC4") "," ZEROS("VEC4") "],'nodes':[{'mesh':0,'skin':0}],"
							  "'skins':[{'joints':[0]}],'meshes':[{"
							  "'primitives':[{'attributes':{'"
							  "POSITION':0,"
							  "'JOINTS_0':1,'WEIGHTS_0':2,'JOINTS_1':"
							  "1,"
							  "'WEIGHTS_1':2,'JOINTS_2':1,'WEIGHTS_2'"
							  ":2"
							  "}}]}]}",
			&logged, &model),
		0);
	assert_int_equal(model->mesh[0].primitive[0].influences, 8);
	assert_near(model->mesh[0].primitive[0].weight[0], 1, 0);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/attributes: limber uses only the first 8 influences"));
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_uses_identities_without_inverse_bind_matrices),
		cmocka_unit_test(test_keeps_the_order_of_the_joint_list),
		cmocka_unit_test(test_sorts_parents_before_their_children),
		cmocka_unit_test(test_reads_eight_influences_of_bytes_and_shorts),
		cmocka_unit_test(
			test_attaches_a_vertex_without_weight_to_its_first_joint),
		cmocka_unit_test(test_scales_weights_to_a_sum_of_1),
		cmocka_unit_test(test_treats_negative_weights_as_0),
		cmocka_unit_test(
			test_accepts_a_joint_out_of_range_without_weight),
		cmocka_unit_test(test_draws_one_mesh_with_several_skins),
		cmocka_unit_test(test_reads_morph_and_skin_together),
		cmocka_unit_test(test_keeps_a_rigid_mesh_below_a_scaled_bone),
		cmocka_unit_test(test_drops_influences_that_no_skin_uses),
		cmocka_unit_test(
			test_warns_of_a_skinned_primitive_without_joints),
		cmocka_unit_test(test_normalises_large_and_small_weights),
		cmocka_unit_test(test_warns_of_a_skin_without_a_mesh),
		cmocka_unit_test(test_takes_the_first_eight_influences),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
