#include "app/anim/math/matrix.h"
#include "app/anim/math/transform.h"
#include "app/anim/pose_normals.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	NODES = 4
};

/* A chain of four joints, and a fifth node that is no joint. */
struct fixture {
	struct model model;
	struct model_node node[NODES + 1];
	struct model_skin skin;
	int joint[NODES];
	mat4 inverse_bind[NODES], palette[NODES];
	struct arena arena;
	struct pose pose;
	struct pose_normals normals;
};

static void set_up(struct fixture *f)
{
	*f = (struct fixture){.skin = {.joint_count = NODES}};
	f->skin.joint = f->joint;
	f->skin.inverse_bind = f->inverse_bind;
	f->model = (struct model){.node_count = NODES + 1,
		.node = f->node,
		.skin_count = 1,
		.skin = &f->skin};
	for (int i = 0; i <= NODES; i++) {
		f->node[i] =
			(struct model_node){.parent = i == NODES ? -1 : i - 1,
				.mesh = -1,
				.skin = -1,
				.rest = transform_identity()};
	}
	for (int i = 0; i < NODES; i++) {
		struct transform t = transform_identity();

		t.scale[0] = (float)(i + 1);
		f->joint[i] = i;
		transform_to_matrix(&t, f->palette[i]);
		t.scale[0] = 1;
		transform_to_matrix(&t, f->inverse_bind[i]);
	}
}

static void start(struct fixture *f)
{
	assert_int_equal(pose_init(&f->pose, &f->model, &f->arena), 0);
	assert_int_equal(
		pose_normals_init(&f->normals, &f->model, &f->arena), 0);
}

/* Whether a joint's matrix is made for normals. */
static bool is_made(struct fixture *f, const mat4 *made, int joint)
{
	mat4 want;

	matrix_normals((const mat4 *)&f->palette[joint], (mat4 *)want);
	if (memcmp(want, made[joint], sizeof(want)) == 0) {
		return true;
	}
	assert_memory_equal(made[joint], f->palette[joint], sizeof(mat4));
	return false;
}

/* Asserts that joints from the first on have matrices of their own. */
static void assert_uneven_from(struct fixture *f, int first)
{
	const mat4 *made;

	assert_true(pose_normals_find(&f->normals, &f->pose));
	made = pose_normals_palette(
		&f->normals, &f->model, 0, (const mat4 *)f->palette);
	for (int j = 1; j < NODES; j++) {
		assert_int_equal(is_made(f, made, j), j >= first);
	}
}

static void test_even_poses_need_no_other_palette(void **state)
{
	static const float scale[][3] = {{1, 1, 1}, {3, 3, 3}, {-2, 2, 2},
		{1, 1.0005f, 0.9995f}, {0, 0, 0}};
	struct fixture f;

	(void)state;
	set_up(&f);
	start(&f);
	for (int i = 0; i < 5; i++) {
		memcpy(f.pose.local[i % NODES].scale, scale[i],
			sizeof(scale[i]));
		assert_false(pose_normals_find(&f.normals, &f.pose));
	}
	arena_release(&f.arena);
}

static void test_uneven_joints_affect_those_below(void **state)
{
	static const float scale[][3] = {
		{1, 1, 1.01f}, {1, 0.99f, 1}, {-2, 2, 1}, {1, 0, 1}, {0, 1, 0}};
	struct fixture f;

	(void)state;
	set_up(&f);
	start(&f);
	for (int i = 0; i < 5; i++) {
		memcpy(f.pose.local[2].scale, scale[i], sizeof(scale[i]));
		assert_uneven_from(&f, 2);
	}
	arena_release(&f.arena);
}

static void test_other_nodes_may_be_uneven(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	start(&f);
	f.pose.local[NODES].scale[1] = 2;
	assert_true(pose_normals_find(&f.normals, &f.pose));
	assert_ptr_equal(pose_normals_palette(&f.normals, &f.model, 0,
				 (const mat4 *)f.palette),
		f.palette);
	arena_release(&f.arena);
}

static void test_a_matrix_with_shear_is_uneven_unless_it_is_replaced(
	void **state)
{
	struct fixture f;
	mat4 sheared;

	(void)state;
	set_up(&f);
	memcpy(sheared, f.palette[0], sizeof(sheared));
	sheared[1][0] = 0.5f;
	f.node[1].matrix = (const float(*)[4])sheared;
	start(&f);
	assert_uneven_from(&f, 1);
	f.pose.animated[1] = true;
	assert_false(pose_normals_find(&f.normals, &f.pose));
	arena_release(&f.arena);
}

static void test_uneven_bind_poses_make_all_joints_uneven(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.inverse_bind[3][1][1] = 2;
	start(&f);
	assert_uneven_from(&f, 0);
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_even_poses_need_no_other_palette),
		cmocka_unit_test(test_uneven_joints_affect_those_below),
		cmocka_unit_test(test_other_nodes_may_be_uneven),
		cmocka_unit_test(
			test_a_matrix_with_shear_is_uneven_unless_it_is_replaced),
		cmocka_unit_test(test_uneven_bind_poses_make_all_joints_uneven),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
