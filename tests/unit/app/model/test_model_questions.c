/* What is asked of a loaded model: its tree, its clips, levels and materials. */
#include "app/model/color.h"
#include "app/model/model.h"
#include "app/model/model_loader.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	NODES = 8,
	CLIPS = 5
};

/*
 *     0           6
 *    / \          |
 *   1   4         7
 *  / \   \
 * 2   3   5
 */
static const int parents[NODES] = {-1, 0, 1, 1, 0, 4, -1, 6};

static struct model_node nodes[NODES];

static struct model make_tree(void)
{
	static const char *const names[NODES] = {
		"root", "arm", "hand", "arm", "leg", "foot", "other", "last"};

	for (int n = 0; n < NODES; n++) {
		nodes[n] = (struct model_node){.name = names[n],
			.parent = parents[n],
			.in_scene = true,
			.mesh = -1,
			.skin = -1,
			.camera = -1};
	}
	return (struct model){.node_count = NODES, .node = nodes};
}

static void test_the_first_node_of_a_name_is_found(void **state)
{
	struct model model = make_tree();

	(void)state;
	assert_int_equal(model_find_node(&model, "root"), 0);
	assert_int_equal(model_find_node(&model, "arm"), 1);
	assert_int_equal(model_find_node(&model, "last"), 7);
	assert_int_equal(model_find_node(&model, "ar"), -1);
}

static bool is_ancestor(int node, int top)
{
	while (node >= 0 && node != top) {
		node = parents[node];
	}
	return node == top;
}

static void test_nodes_are_below_their_ancestors(void **state)
{
	struct model model = make_tree();

	(void)state;
	for (int node = 0; node < NODES; node++) {
		for (int top = 0; top < NODES; top++) {
			int common = node;

			assert_int_equal(model_is_below(&model, node, top),
				is_ancestor(node, top));
			while (common >= 0 && !is_ancestor(top, common)) {
				common = parents[common];
			}
			assert_int_equal(
				model_find_common(&model, node, top), common);
		}
	}
}

/* Lists the nodes that show a mesh; -1 ends. */
static int carrier_of(const int *shown)
{
	struct model model = make_tree();

	for (; *shown >= 0; shown++) {
		nodes[*shown].mesh = 0;
	}
	return model_find_carrier(&model);
}

static void test_all_that_is_shown_hangs_on_the_carrier(void **state)
{
	(void)state;
	assert_int_equal(carrier_of((const int[]){-1}), -1);
	assert_int_equal(carrier_of((const int[]){0, -1}), 0);
	assert_int_equal(carrier_of((const int[]){3, -1}), 3);
	assert_int_equal(carrier_of((const int[]){2, 3, -1}), 1);
	assert_int_equal(carrier_of((const int[]){2, 1, -1}), 1);
	assert_int_equal(carrier_of((const int[]){2, 5, -1}), 0);
	assert_int_equal(carrier_of((const int[]){4, 5, -1}), 4);
	assert_int_equal(carrier_of((const int[]){6, 7, -1}), 6);
	assert_int_equal(carrier_of((const int[]){5, 7, -1}), -1);
}

/* A skinned mesh hangs on its joints, wherever its node is. */
static void test_joints_carry_a_skin(void **state)
{
	struct model model = make_tree();
	int joints[2] = {2, 3};
	struct model_skin skin = {.joint_count = 2, .joint = joints};

	(void)state;
	model.skin_count = 1;
	model.skin = &skin;
	nodes[7].mesh = 0;
	nodes[7].skin = 0;
	assert_int_equal(model_find_carrier(&model), 1);
	joints[1] = 5;
	assert_int_equal(model_find_carrier(&model), 0);
	skin.joint_count = 1;
	assert_int_equal(model_find_carrier(&model), 2);
	nodes[7].hidden = true;
	assert_int_equal(model_find_carrier(&model), -1);
}

static void test_hidden_nodes_and_those_of_other_scenes_show_nothing(
	void **state)
{
	struct model_primitive primitive = {.vertex_count = 0};
	struct model_mesh mesh[2] = {{.primitive_count = 0},
		{.primitive_count = 1,
			.primitive = &primitive,
			.target_count = 1}};
	struct model model = make_tree();

	(void)state;
	model.mesh_count = 2;
	model.mesh = mesh;
	assert_false(model_has_triangles(&model));
	assert_int_equal(model_find_morphed(&model), -1);
	for (int n = 0; n < NODES; n++) {
		struct model_node *node = &nodes[n];

		node->mesh = 0;
		assert_true(model_node_shows_mesh(node));
		assert_false(model_has_triangles(&model));
		node->mesh = 1;
		assert_true(model_has_triangles(&model));
		assert_int_equal(model_find_morphed(&model), n);
		node->hidden = true;
		assert_false(model_node_shows_mesh(node));
		assert_false(model_has_triangles(&model));
		node->hidden = false;
		node->in_scene = false;
		assert_false(model_has_triangles(&model));
		assert_int_equal(model_find_morphed(&model), -1);
	}
}

static void test_the_coarsest_level_of_a_size_is_found(void **state)
{
	struct model_lod lod[5] = {{.index_count = 300}, {.index_count = 120},
		{.index_count = 60}, {.index_count = 900, .shadow_only = true},
		{.index_count = 90, .shadow_only = true}};
	const struct model_primitive primitive = {.lod_count = 5, .lod = lod};
	static const int rows[][2] = {{301, 0}, {300, 1}, {121, 1}, {120, 2},
		{61, 2}, {60, 3}, {3, 3}, {900, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_int_equal(
			model_lod_of_size(&primitive, rows[i][0]), rows[i][1]);
	}
}

/* Which nodes each clip moves; -1 ends. */
static void make_clips(struct model *model, struct model_clip *clips,
	struct model_channel (*channels)[3])
{
	static const int moved[CLIPS][4] = {
		{1, 2, -1}, {2, 3, -1}, {3, -1}, {-1}, {4, 5, 5, -1}};

	for (int c = 0; c < CLIPS; c++) {
		clips[c] = (struct model_clip){.channel = channels[c]};
		for (int i = 0; moved[c][i] >= 0; i++) {
			channels[c][clips[c].channel_count++] =
				(struct model_channel){.node = moved[c][i],
					.path = i == 2 ? MODEL_WEIGHTS
						       : MODEL_ROTATION};
		}
	}
	model->clip_count = CLIPS;
	model->clip = clips;
}

static void test_clips_tell_what_they_move(void **state)
{
	struct model model = make_tree();
	struct model_clip clips[CLIPS];
	struct model_channel channels[CLIPS][3];
	bool moved[NODES] = {false};

	(void)state;
	make_clips(&model, clips, channels);
	model_clip_mark_moved(&clips[0], moved);
	model_clip_mark_moved(&clips[2], moved);
	for (int n = 0; n < NODES; n++) {
		assert_int_equal(moved[n], n >= 1 && n <= 3);
	}
	for (int n = 0; n < NODES; n++) {
		assert_int_equal(model_clip_moves_weights(&clips[4], n), n == 5);
		assert_false(model_clip_moves_weights(&clips[0], n));
	}
}

static void test_clips_that_share_no_node_are_listed(void **state)
{
	static const int expected[CLIPS][CLIPS] = {
		{0, 2, 4}, {1, 4}, {2, 0, 4}, {3, 0, 2, 4}, {4, 0, 2}};
	static const int counts[CLIPS] = {3, 2, 3, 4, 3};
	struct model model = make_tree();
	struct model_clip clips[CLIPS];
	struct model_channel channels[CLIPS][3];

	(void)state;
	make_clips(&model, clips, channels);
	for (int first = 0; first < CLIPS; first++) {
		bool moved[NODES] = {false};
		int list[CLIPS];

		assert_int_equal(model_clips_apart(&model, first, moved, list),
			counts[first]);
		assert_memory_equal(list, expected[first],
			(size_t)counts[first] * sizeof(list[0]));
	}
}

static void test_weights_are_parts_of_a_whole(void **state)
{
	uint16_t joint[4][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {3, 2, 12}};
	float weight[4][3] = {
		{2, 1, 1}, {-1, 3, 0}, {0, -0.5f, 0}, {0.25f, 0.25f, 0.5f}};
	const float expected[4][3] = {{0.5f, 0.25f, 0.25f}, {0, 1, 0},
		{1, 0, 0}, {0.25f, 0.25f, 0.5f}};
	/* The joint of no weight is the first one. */
	const uint16_t joints[4][3] = {
		{1, 2, 3}, {0, 5, 0}, {7, 0, 0}, {3, 2, 12}};
	struct model_primitive primitive = {.vertex_count = 4,
		.influences = 3,
		.joint = joint[0],
		.weight = weight[0]};

	(void)state;
	assert_int_equal(model_max_joint(&primitive), 12);
	model_normalize_influences(&primitive);
	assert_all_near(weight, expected, 12, 1e-6);
	assert_memory_equal(joint, joints, sizeof(joints));
	primitive.vertex_count = 3;
	assert_int_equal(model_max_joint(&primitive), 7);
	primitive.influences = 0;
	assert_int_equal(model_max_joint(&primitive), -1);
	model_normalize_influences(&primitive);
	assert_all_near(weight, expected, 12, 1e-6);
}

/* Dark materials mirror a little light, unless they shine themselves. */
static void test_a_lit_material_mirrors_light(void **state)
{
	static const float dark[3] = {0.01f, 0.04f, 0.02f};

	(void)state;
	for (int kind = 0; kind < 5; kind++) {
		struct model_material material = model_plain_material;
		float added = color_mirrored(color_encode_srgb(0.04f)), out[3];
		bool emits = kind >= 2;

		assert_true(added > 0.01f);
		memcpy(material.base_color, dark, sizeof(dark));
		material.unlit = kind == 1;
		material.emissive[kind % 3] = emits ? 0.5f : 0;
		material.texture = 4;
		material.emissive_texture = kind == 3 ? 4 : kind == 4 ? 5 : -1;
		assert_int_equal(model_material_emits(&material), emits);
		model_material_shown(&material, out);
		/* A texture of its own shines in other places. */
		added = kind == 0 || kind == 4 ? added : 0;
		for (int i = 0; i < 3; i++) {
			assert_near(out[i], color_encode_srgb(dark[i]) + added,
				1e-5);
		}
	}
}

static void test_a_plain_material_is_white_and_has_no_textures(void **state)
{
	const struct model_material *plain = &model_plain_material;

	(void)state;
	for (int i = 0; i < 4; i++) {
		assert_near(plain->base_color[i], 1, 0);
	}
	assert_int_equal(plain->texture, -1);
	assert_int_equal(plain->normal_texture, -1);
	assert_int_equal(plain->emissive_texture, -1);
	assert_near(plain->roughness, 1, 0);
	assert_near(plain->alpha_cutoff, 0.5, 0);
	assert_false(model_material_emits(plain));
	assert_int_equal(plain->alpha, MODEL_OPAQUE);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_first_node_of_a_name_is_found),
		cmocka_unit_test(test_nodes_are_below_their_ancestors),
		cmocka_unit_test(test_all_that_is_shown_hangs_on_the_carrier),
		cmocka_unit_test(test_joints_carry_a_skin),
		cmocka_unit_test(
			test_hidden_nodes_and_those_of_other_scenes_show_nothing),
		cmocka_unit_test(test_the_coarsest_level_of_a_size_is_found),
		cmocka_unit_test(test_clips_tell_what_they_move),
		cmocka_unit_test(test_clips_that_share_no_node_are_listed),
		cmocka_unit_test(test_weights_are_parts_of_a_whole),
		cmocka_unit_test(test_a_lit_material_mirrors_light),
		cmocka_unit_test(
			test_a_plain_material_is_white_and_has_no_textures),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
