/* How far vertices move when a node moves, in models made by hand. */
#include "app/compare/optimize/optimize_reach.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <string.h>

#include <cglm/cglm.h>

enum {
	NODES = 3
};

static const float px_per_unit = 10.0f;

/* A root of scale (1, 2, 0.5), a node with a mesh at (1, 0, 0), a helper. */
struct fixture {
	struct bones bones;
	float position[2][3], moved[3][2][3];
	struct model_primitive primitive[2];
	struct model_target target[2][2];
	bool needed[NODES + 2]; /* by the index in the file */
	struct optimize_reach reach;
};

static void begin(struct fixture *f)
{
	struct bones *bones = &f->bones;

	memset(f, 0, sizeof(*f));
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones->node[0].rest.scale[1] = 2.0f;
	bones->node[0].rest.scale[2] = 0.5f;
	bones_add(bones, 0, 1, 0, 0);
	bones->node[1].mesh = 0;
	bones_add(bones, 0, 0, 1, 0);
	/* (1, 0, 0) and (1, 6, 0) in the world */
	f->position[1][1] = 3.0f;
	f->primitive[0] = (struct model_primitive){
		.vertex_count = 2, .position = f->position};
	bones->mesh[0] = (struct model_mesh){
		.primitive_count = 1, .primitive = f->primitive};
}

static void find(struct fixture *f)
{
	assert_int_equal(optimize_reach_find(&f->reach, &f->bones.model,
				 px_per_unit, f->needed),
		0);
}

static void end(struct fixture *f)
{
	optimize_reach_release(&f->reach);
	bones_end(&f->bones);
}

static void expect_node(
	const struct fixture *f, int number, float move_px, float turn_px)
{
	const struct optimize_reach_node *node = &f->reach.node[number];

	assert_near(node->move_px, move_px, 1e-4);
	assert_near(node->turn_px, turn_px, 1e-4);
	assert_near(node->scale_px, turn_px, 1e-4);
}

/* A translation moves as far as the parent's largest scale makes it. */
static void test_the_farthest_vertex_counts(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	find(&f);
	assert_int_equal(f.reach.node_count, NODES);
	expect_node(&f, 0, px_per_unit, px_per_unit * 6.0827625f);
	expect_node(&f, 1, 2 * px_per_unit, px_per_unit * 6);
	for (int i = 0; i < NODES; i++) {
		assert_false(f.reach.node[i].exact);
		assert_int_equal(f.reach.node[i].target_count, 0);
	}
	end(&f);
}

static void test_a_helper_reaches_a_tenth_of_the_model(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	find(&f);
	expect_node(&f, 2, 2 * px_per_unit, px_per_unit * 0.6f);
	end(&f);
}

/* Not that of a node beside, whichever comes first. */
static void test_only_the_parents_scale_counts(void **state)
{
	(void)state;
	for (int beside = 1; beside <= 2; beside++) {
		struct fixture f;

		begin(&f);
		for (int axis = 0; axis < 3; axis++) {
			f.bones.node[beside].rest.scale[axis] = 7.0f;
		}
		find(&f);
		assert_near(f.reach.node[0].move_px, px_per_unit, 1e-4);
		assert_near(f.reach.node[1].move_px, 2 * px_per_unit, 1e-4);
		assert_near(f.reach.node[2].move_px, 2 * px_per_unit, 1e-4);
		end(&f);
	}
}

/* Nobody sees the helper move, unless the file says that it is needed. */
static void test_a_node_that_moves_nothing_is_idle(void **state)
{
	(void)state;
	for (int needed = 0; needed < 3; needed++) {
		struct fixture f;

		begin(&f);
		f.needed[2] = needed == 1;
		f.bones.node[2].camera = needed == 2 ? 0 : -1;
		find(&f);
		assert_false(f.reach.node[0].idle);
		assert_false(f.reach.node[1].idle);
		assert_int_equal(f.reach.node[2].idle, needed == 0);
		end(&f);
	}
}

static void test_idle_nodes_that_clips_move_are_counted(void **state)
{
	struct model_channel channel[] = {
		{.node = 1}, {.node = 2, .constant = true}, {.node = 2}};
	struct model_clip clip = {.channel = channel};
	struct optimize_idle idle;
	struct fixture f;

	(void)state;
	begin(&f);
	find(&f);
	f.bones.node[2].name = "socket";
	f.bones.model.clip = &clip;
	f.bones.model.clip_count = 1;
	for (clip.channel_count = 0; clip.channel_count <= 3;
		clip.channel_count++) {
		idle = optimize_reach_idle(&f.reach, &f.bones.model);
		assert_int_equal(idle.count, clip.channel_count == 3);
		assert_string_equal(
			idle.name, clip.channel_count == 3 ? "socket" : "");
	}
	end(&f);
}

/* A node without a mesh is idle, but not what is above one that is needed. */
static void test_nodes_above_what_is_seen_are_not_idle(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[1].mesh = -1;
	f.needed[2] = true;
	find(&f);
	assert_false(f.reach.node[0].idle);
	assert_true(f.reach.node[1].idle);
	assert_false(f.reach.node[2].idle);
	end(&f);
}

/* Nodes of the file that the model does not have keep their keys. */
static void test_nodes_have_the_numbers_of_the_file(void **state)
{
	static const int number[NODES] = {4, 0, 2};
	struct fixture f;

	(void)state;
	begin(&f);
	for (int i = 0; i < NODES; i++) {
		f.bones.node[i].file_index = number[i];
	}
	find(&f);
	assert_int_equal(f.reach.node_count, 5);
	expect_node(&f, 0, 2 * px_per_unit, px_per_unit * 6);
	expect_node(&f, 2, 2 * px_per_unit, px_per_unit * 0.6f);
	for (int i = 0; i < 5; i++) {
		assert_int_equal(f.reach.node[i].exact, i == 1 || i == 3);
	}
	end(&f);
}

/* A camera's path is exact, and that of all nodes above it. */
static void test_nodes_that_carry_a_camera_are_exact(void **state)
{
	(void)state;
	for (int camera = 0; camera < NODES; camera++) {
		struct fixture f;

		begin(&f);
		f.bones.node[camera].camera = 0;
		find(&f);
		for (int i = 0; i < NODES; i++) {
			assert_int_equal(
				f.reach.node[i].exact, i == camera || i == 0);
		}
		end(&f);
	}
}

static void add_target(
	struct fixture *f, int primitive, int target, float (*moved)[3])
{
	f->target[primitive][target].position = (struct model_deltas){
		.vertex_count = 2, .unit = 1.0f, .value = moved};
}

/* The vertices of target 0 move by 0.5 and 2, those of target 1 by 0.25. */
static void add_targets(struct fixture *f)
{
	f->moved[0][0][0] = 0.5f;
	f->moved[0][1][2] = -2.0f;
	f->moved[1][0][1] = 0.25f;
	f->primitive[1] = f->primitive[0];
	add_target(f, 0, 0, f->moved[2]);
	add_target(f, 0, 1, f->moved[1]);
	add_target(f, 1, 0, f->moved[0]);
	add_target(f, 1, 1, f->moved[2]);
	f->primitive[0].target = f->target[0];
	f->primitive[1].target = f->target[1];
	f->bones.mesh[0].primitive_count = 2;
	f->bones.mesh[0].target_count = 2;
}

static void test_targets_count_by_their_farthest_vertex(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	add_targets(&f);
	find(&f);
	assert_int_equal(f.reach.node[0].target_count, 0);
	assert_int_equal(f.reach.node[1].target_count, 2);
	/* The node's largest scale is 2. */
	assert_near(f.reach.node[1].target_px[0], 4 * px_per_unit, 1e-4);
	assert_near(f.reach.node[1].target_px[1], 0.5 * px_per_unit, 1e-4);
	end(&f);
}

/*
 * The skin's joints are the nodes 2 and 0, and its matrices make the mesh three
 * times as large. Vertex 0 is fixed to the first; of vertex 1, which the second
 * moves, the first has a share of a hundredth or less.
 */
static void add_skin(struct fixture *f, float share)
{
	static int joints[2] = {2, 0};
	static mat4 bind[2];
	static uint16_t joint[8] = {0, 0, 0, 0, 1, 0, 0, 0};
	static float weight[8];
	static struct model_skin skin = {
		.joint_count = 2, .joint = joints, .inverse_bind = bind};

	glm_mat4_identity(bind[0]);
	glm_mat4_identity(bind[1]);
	glm_scale_uni(bind[0], 3.0f);
	glm_scale_uni(bind[1], 3.0f);
	memset(weight, 0, sizeof(weight));
	weight[0] = 1.0f;
	weight[4] = 1.0f - share;
	weight[5] = share;
	f->primitive[0].influences = 4;
	f->primitive[0].joint = joint;
	f->primitive[0].weight = weight;
	f->bones.node[1].skin = 0;
	f->bones.model.skin = &skin;
	f->bones.model.skin_count = 1;
}

/*
 * Vertex 0 is at (0, 2, 0), where the node 2 is; vertex 1 is at (0, 18, 0), or
 * where the node 2 would bring it, at (0, 20, 0).
 */
static void test_vertices_of_a_skin_follow_their_joints(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	add_skin(&f, 0.009f);
	find(&f);
	expect_node(&f, 0, px_per_unit, px_per_unit * 18);
	expect_node(&f, 2, 2 * px_per_unit, px_per_unit * 1.6f);
	/* No vertex follows the node of the mesh. */
	expect_node(&f, 1, 2 * px_per_unit, px_per_unit * 1.6f);
	end(&f);
	begin(&f);
	add_skin(&f, 0.01f);
	find(&f);
	expect_node(&f, 0, px_per_unit, px_per_unit * 20);
	expect_node(&f, 2, 2 * px_per_unit, px_per_unit * 18);
	end(&f);
}

/*
 * The joints' matrices enlarge by 3, and their nodes' world by 2. One of the
 * two may hide what it moves by a scale of 0.
 */
static void test_targets_of_a_skin_are_as_large_as_its_largest_joint(
	void **state)
{
	struct fixture f;

	(void)state;
	for (int hidden = -1; hidden < 2; hidden++) {
		begin(&f);
		add_skin(&f, 0.0f);
		add_targets(&f);
		if (hidden >= 0) {
			glm_mat4_zero(
				f.bones.model.skin[0].inverse_bind[hidden]);
		}
		find(&f);
		assert_near(
			f.reach.node[1].target_px[0], 12 * px_per_unit, 1e-3);
		assert_near(
			f.reach.node[1].target_px[1], 1.5 * px_per_unit, 1e-3);
		end(&f);
	}
}

/* Another node shows the mesh by a skin that makes it five times as large. */
static void test_targets_of_each_node_are_as_large_as_its_skin(void **state)
{
	mat4 bind[2] = {GLM_MAT4_IDENTITY_INIT, GLM_MAT4_IDENTITY_INIT};
	struct model_skin skins[2];
	struct fixture f;

	(void)state;
	for (int first = 0; first <= 1; first++) {
		begin(&f);
		add_skin(&f, 0.0f);
		add_targets(&f);
		glm_scale_uni(bind[0], first ? 1.0f : 5.0f);
		skins[first] = skins[!first] = *f.bones.model.skin;
		skins[!first].inverse_bind = bind;
		f.bones.model.skin = skins;
		f.bones.model.skin_count = 2;
		f.bones.node[1].skin = first;
		f.bones.node[2].mesh = 0;
		f.bones.node[2].skin = !first;
		find(&f);
		assert_near(
			f.reach.node[1].target_px[0], 12 * px_per_unit, 1e-3);
		assert_near(
			f.reach.node[2].target_px[0], 20 * px_per_unit, 1e-3);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_farthest_vertex_counts),
		cmocka_unit_test(test_a_helper_reaches_a_tenth_of_the_model),
		cmocka_unit_test(test_only_the_parents_scale_counts),
		cmocka_unit_test(test_a_node_that_moves_nothing_is_idle),
		cmocka_unit_test(test_idle_nodes_that_clips_move_are_counted),
		cmocka_unit_test(test_nodes_above_what_is_seen_are_not_idle),
		cmocka_unit_test(test_nodes_have_the_numbers_of_the_file),
		cmocka_unit_test(test_nodes_that_carry_a_camera_are_exact),
		cmocka_unit_test(test_targets_count_by_their_farthest_vertex),
		cmocka_unit_test(test_vertices_of_a_skin_follow_their_joints),
		cmocka_unit_test(
			test_targets_of_a_skin_are_as_large_as_its_largest_joint),
		cmocka_unit_test(
			test_targets_of_each_node_are_as_large_as_its_skin),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
