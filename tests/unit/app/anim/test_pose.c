#include "app/anim/math/matrix.h"
#include "app/anim/math/transform.h"
#include "app/anim/pose.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static const float ROOT_HALF = 0.70710678f;

/*
 * Four nodes: a root at (1, 0, 0), rotated by 90 degrees about z; its child at
 * (0, 2, 0), which is no joint; below that a joint at (3, 0, 0) with scale 2;
 * and a skinned node that is not among their parents.
 */
struct fixture {
	struct model model;
	struct model_node node[4];
	float weights[3];
	struct arena arena;
	struct pose pose;
	mat4 world[4];
};

static struct model_node make_node(int parent, float x, float y, float z)
{
	struct model_node node = {.name = "",
		.parent = parent,
		.mesh = -1,
		.skin = -1,
		.camera = -1,
		.rest = transform_identity()};

	node.rest.translation[0] = x;
	node.rest.translation[1] = y;
	node.rest.translation[2] = z;
	return node;
}

static void set_up(struct fixture *f)
{
	*f = (struct fixture){.weights = {0.25f, 0.5f, 1}};
	f->node[0] = make_node(-1, 1, 0, 0);
	f->node[0].rest.rotation[2] = ROOT_HALF;
	f->node[0].rest.rotation[3] = ROOT_HALF;
	f->node[1] = make_node(0, 0, 2, 0);
	f->node[2] = make_node(1, 3, 0, 0);
	for (int i = 0; i < 3; i++) {
		f->node[2].rest.scale[i] = 2;
	}
	f->node[3] = make_node(-1, 100, 100, 100);
	f->model = (struct model){.node_count = 4,
		.node = f->node,
		.weight_count = 3,
		.rest_weights = f->weights};
	assert_int_equal(pose_init(&f->pose, &f->model, &f->arena), 0);
}

static void tear_down(struct fixture *f)
{
	arena_release(&f->arena);
}

static void test_pitfall_15_a_new_pose_is_at_rest_weights_too(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = 0; i < 4; i++) {
		assert_memory_equal(&f.pose.local[i], &f.node[i].rest,
			sizeof(struct transform));
		assert_false(f.pose.animated[i]);
	}
	assert_memory_equal(f.pose.weight, f.weights, sizeof(f.weights));
	f.pose.weight[1] = 9;
	f.pose.local[2].scale[0] = 9;
	f.pose.animated[2] = true;
	pose_rest(&f.pose, &f.model);
	assert_memory_equal(f.pose.weight, f.weights, sizeof(f.weights));
	assert_true(f.pose.local[2].scale[0] == 2);
	assert_false(f.pose.animated[2]);
	tear_down(&f);
}

static void test_a_model_without_nodes_has_a_pose(void **state)
{
	struct model model = {0};
	struct arena arena = arena_empty();
	struct pose pose;

	(void)state;
	assert_int_equal(pose_init(&pose, &model, &arena), 0);
	pose_world(&pose, &model, NULL, NULL);
	arena_release(&arena);
}

static void test_copies_keep_their_own_room(void **state)
{
	struct fixture f;
	struct pose copy;

	(void)state;
	set_up(&f);
	assert_int_equal(pose_init(&copy, &f.model, &f.arena), 0);
	f.pose.local[1].translation[2] = 7;
	f.pose.animated[1] = true;
	f.pose.weight[0] = 0.75f;
	pose_copy(&copy, &f.pose);
	f.pose.local[1].translation[2] = 8;
	assert_true(copy.local[1].translation[2] == 7);
	assert_true(copy.animated[1]);
	assert_true(copy.weight[0] == 0.75f);
	tear_down(&f);
}

static void test_children_move_with_their_parents(void **state)
{
	struct fixture f;
	const float origin[3] = {0, 0, 0};
	const float unit_x[3] = {1, 0, 0};
	/* root (1,0,0) + rotated (0,2,0) = (-2,0,0) + rotated (3,0,0) */
	const float want[3][3] = {{1, 0, 0}, {-1, 0, 0}, {-1, 3, 0}};
	/* x is rotated to y and scaled by 2 */
	const float tip[3] = {-1, 5, 0};
	float out[3];

	(void)state;
	set_up(&f);
	pose_world(&f.pose, &f.model, NULL, f.world);
	for (int i = 0; i < 3; i++) {
		matrix_apply(f.world[i], origin, out);
		assert_all_near(out, want[i], 3, 1e-5);
	}
	matrix_apply(f.world[2], unit_x, out);
	assert_all_near(out, tip, 3, 1e-5);
	tear_down(&f);
}

static void test_the_root_matrix_goes_before_everything(void **state)
{
	struct fixture f;
	mat4 root = {{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 5, 1}};
	const float origin[3] = {0, 0, 0};
	const float want[3] = {-2, 6, 5};
	const float aside[3] = {200, 200, 205};
	float out[3];

	(void)state;
	set_up(&f);
	pose_world(&f.pose, &f.model, root, f.world);
	matrix_apply(f.world[2], origin, out);
	assert_all_near(out, want, 3, 1e-5);
	matrix_apply(f.world[3], origin, out);
	assert_all_near(out, aside, 3, 1e-4);
	tear_down(&f);
}

static void test_a_late_change_reaches_its_descendants(void **state)
{
	struct fixture f;
	mat4 root = {{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 5, 1}};
	mat4 whole[4];

	(void)state;
	set_up(&f);
	pose_world(&f.pose, &f.model, root, f.world);
	f.pose.local[1].translation[2] = 4;
	f.pose.local[3].translation[2] = 5;
	pose_world_from(&f.pose, &f.model, root, 1, f.world);
	pose_world(&f.pose, &f.model, root, whole);
	assert_memory_equal(f.world, whole, sizeof(whole));
	tear_down(&f);
}

static void test_a_sheared_matrix_counts_until_a_clip_moves_it(void **state)
{
	struct fixture f;
	static const float shear[4][4] = {
		{1, 0, 0, 0}, {0.5f, 1, 0, 0}, {0, 0, 1, 0}, {4, 0, 0, 1}};
	const float up[3] = {0, 1, 0};
	const float sheared[3] = {4.5f, 1, 0};
	const float animated[3] = {100, 101, 100};
	float out[3];

	(void)state;
	set_up(&f);
	f.node[3].matrix = shear;
	assert_int_equal(pose_init(&f.pose, &f.model, &f.arena), 0);
	pose_world(&f.pose, &f.model, NULL, f.world);
	matrix_apply(f.world[3], up, out);
	assert_all_near(out, sheared, 3, 1e-6);
	f.pose.animated[3] = true;
	pose_world(&f.pose, &f.model, NULL, f.world);
	matrix_apply(f.world[3], up, out);
	assert_all_near(out, animated, 3, 1e-5);
	tear_down(&f);
}

static void test_pitfall_9_plain_ancestors_count_in_a_palette(void **state)
{
	struct fixture f;
	int joint[1] = {2};
	mat4 inverse_bind[1];
	struct model_skin skin = {.name = "",
		.joint_count = 1,
		.joint = joint,
		.inverse_bind = inverse_bind};
	mat4 palette[1], moved[1];
	const float vertex[3] = {5, 5, 5};
	float before[3], after[3];

	(void)state;
	set_up(&f);
	memset(inverse_bind, 0, sizeof(inverse_bind));
	for (int i = 0; i < 4; i++) {
		inverse_bind[0][i][i] = 1;
	}
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&skin, (const mat4 *)f.world, palette);
	/* Node 1 is no joint; its x axis is the world's y axis. */
	f.pose.local[1].translation[0] += 1;
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&skin, (const mat4 *)f.world, moved);
	matrix_apply(palette[0], vertex, before);
	matrix_apply(moved[0], vertex, after);
	assert_near(after[0] - before[0], 0, 1e-4);
	assert_near(after[1] - before[1], 1, 1e-4);
	tear_down(&f);
}

static void test_pitfall_9_the_skinned_nodes_place_is_ignored(void **state)
{
	struct fixture f;
	int joint[1] = {2};
	mat4 inverse_bind[1] = {
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
	struct model_skin skin = {.name = "",
		.joint_count = 1,
		.joint = joint,
		.inverse_bind = inverse_bind};
	mat4 before[1], after[1];

	(void)state;
	set_up(&f);
	f.node[3].skin = 0;
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&skin, (const mat4 *)f.world, before);
	f.pose.local[3].translation[0] = -55;
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&skin, (const mat4 *)f.world, after);
	assert_memory_equal(before, after, sizeof(before));
	tear_down(&f);
}

static void test_the_bind_pose_leaves_vertices_in_place(void **state)
{
	struct fixture f;
	int joint[2] = {2, 0}; /* in no order of the tree */
	/* By hand: the inverse of (-1,3,0), 90 degrees and scale 2. */
	mat4 inverse_bind[2] = {
		{{0, -0.5f, 0, 0}, {0.5f, 0, 0, 0}, {0, 0, 0.5f, 0},
			{-1.5f, -0.5f, 0, 1}},
		{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 1}},
	};
	struct model_skin skin = {.name = "",
		.joint_count = 2,
		.joint = joint,
		.inverse_bind = inverse_bind};
	mat4 palette[2];
	const float vertex[3] = {5, 6, 7};
	float out[3];

	(void)state;
	set_up(&f);
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&skin, (const mat4 *)f.world, palette);
	for (int j = 0; j < 2; j++) {
		matrix_apply(palette[j], vertex, out);
		assert_all_near(out, vertex, 3, 1e-5);
	}
	tear_down(&f);
}

static void test_pitfall_11_skins_of_one_mesh_have_own_palettes(void **state)
{
	struct fixture f;
	int joint_a[1] = {0};
	int joint_b[1] = {2};
	mat4 inverse_bind[1] = {
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
	struct model_skin a = {.name = "",
		.joint_count = 1,
		.joint = joint_a,
		.inverse_bind = inverse_bind};
	struct model_skin b = {.name = "",
		.joint_count = 1,
		.joint = joint_b,
		.inverse_bind = inverse_bind};
	mat4 palette_a[1], palette_b[1];
	float out[3];
	const float origin[3] = {0, 0, 0};
	const float want_a[3] = {1, 0, 0};
	const float want_b[3] = {-1, 3, 0};

	(void)state;
	set_up(&f);
	pose_world(&f.pose, &f.model, NULL, f.world);
	pose_palette(&a, (const mat4 *)f.world, palette_a);
	pose_palette(&b, (const mat4 *)f.world, palette_b);
	matrix_apply(palette_a[0], origin, out);
	assert_all_near(out, want_a, 3, 1e-5);
	matrix_apply(palette_b[0], origin, out);
	assert_all_near(out, want_b, 3, 1e-5);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_pitfall_15_a_new_pose_is_at_rest_weights_too),
		cmocka_unit_test(test_a_model_without_nodes_has_a_pose),
		cmocka_unit_test(test_copies_keep_their_own_room),
		cmocka_unit_test(test_children_move_with_their_parents),
		cmocka_unit_test(test_a_late_change_reaches_its_descendants),
		cmocka_unit_test(test_the_root_matrix_goes_before_everything),
		cmocka_unit_test(
			test_a_sheared_matrix_counts_until_a_clip_moves_it),
		cmocka_unit_test(
			test_pitfall_9_plain_ancestors_count_in_a_palette),
		cmocka_unit_test(
			test_pitfall_9_the_skinned_nodes_place_is_ignored),
		cmocka_unit_test(test_the_bind_pose_leaves_vertices_in_place),
		cmocka_unit_test(
			test_pitfall_11_skins_of_one_mesh_have_own_palettes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
