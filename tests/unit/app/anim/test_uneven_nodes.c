/*
 * Which nodes, binds and scales need matrices of their own for normals: each at
 * the ends of its array, with an uneven one beyond.
 */
#include "app/anim/math/transform.h"
#include "app/anim/pose_normals.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

enum {
	NODES = 3,
	SKINS = 2
};

/* The last of the nodes, binds and joints is not the model's. */
struct fixture {
	struct model_node node[NODES + 1];
	struct model_skin skin[SKINS];
	int joint[SKINS][NODES + 1];
	mat4 inverse_bind[NODES + 1];
	mat4 shear;
	struct model model;
	struct arena arena;
	struct pose pose;
	struct pose_normals normals;
};

static void set_up(struct fixture *f)
{
	/* Read as a node after the last, these would be uneven. */
	static float weights[10] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
	struct transform wide = transform_identity();

	*f = (struct fixture){.joint = {{0, 1, 2, 0}, {2, 1, 0, 1}}};
	for (int i = 0; i <= NODES; i++) {
		f->node[i] = (struct model_node){
			.parent = -1, .mesh = -1, .rest = transform_identity()};
		wide.scale[0] = i == NODES ? 3 : 1;
		transform_to_matrix(&wide, f->inverse_bind[i]);
	}
	transform_to_matrix(&wide, f->shear);
	f->node[NODES].matrix = &f->shear[0];
	for (int i = 0; i < SKINS; i++) {
		f->skin[i] = (struct model_skin){.joint_count = NODES,
			.joint = f->joint[i],
			.inverse_bind = f->inverse_bind};
	}
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.skin_count = SKINS,
		.skin = f->skin,
		.weight_count = 10,
		.rest_weights = weights};
}

static bool start(struct fixture *f)
{
	assert_int_equal(pose_init(&f->pose, &f->model, &f->arena), 0);
	assert_int_equal(
		pose_normals_init(&f->normals, &f->model, &f->arena), 0);
	return pose_normals_find(&f->normals, &f->pose);
}

static bool scales_are_found(float x, float y, float z)
{
	struct fixture f;
	bool found;

	set_up(&f);
	f.node[1].rest.scale[0] = x;
	f.node[1].rest.scale[1] = y;
	f.node[1].rest.scale[2] = z;
	found = start(&f);
	arena_release(&f.arena);
	return found;
}

/* Half of 2^16 units of the last place may differ, which is 1 + 2^-8 to 1. */
static void test_scales_may_differ_by_a_256th(void **state)
{
	const float last = 1.00390625f, beyond = 1.0039063692f;
	const float least = 1.9921875f / 2, below = least - 1.2e-7f;

	(void)state;
	assert_false(scales_are_found(1, 1, 1));
	assert_false(scales_are_found(1, last, 1));
	assert_false(scales_are_found(1, 1, -last));
	assert_false(scales_are_found(last, 1, 1));
	assert_true(scales_are_found(1, beyond, 1));
	assert_true(scales_are_found(1, 1, beyond));
	assert_true(scales_are_found(beyond, 1, 1));
	assert_true(scales_are_found(1, beyond, beyond));
	assert_false(scales_are_found(1, (1 + least) / 2, 1));
	assert_true(scales_are_found(1, 2 * below - 1, 1));
	assert_true(scales_are_found(1, 1, 2 * below - 1));
	assert_true(scales_are_found(1, 1.0059f, 1));
	assert_true(scales_are_found(-1, -1, 1.0059f));
}

/* The palettes' matrices are turned and wide, so that normals' ones differ. */
static void check_palettes(struct fixture *f, const bool uneven[NODES])
{
	struct transform wide = {{1, 2, 3}, {0, 0, 0.6f, 0.8f}, {1, 2, 3}};
	mat4 palette[NODES];
	const mat4 *made[SKINS];
	bool any = false;

	for (int i = 0; i < NODES; i++) {
		wide.translation[0] = (float)i;
		transform_to_matrix(&wide, palette[i]);
		any = any || uneven[i];
	}
	/* The first skin's matrices are the last to be made. */
	for (int s = SKINS - 1; s >= 0; s--) {
		made[s] = pose_normals_palette(
			&f->normals, &f->model, s, (const mat4 *)palette);
	}
	for (int s = 0; s < SKINS; s++) {
		assert_int_equal(made[s] != (const mat4 *)palette, any);
		for (int j = 0; j < NODES; j++) {
			int joint = f->joint[s][j];
			bool same = memcmp(made[s][j], palette[j],
					    sizeof(mat4)) == 0;

			assert_int_equal(same, !uneven[joint]);
		}
	}
}

/* By its scale, by its matrix, or because its parent is. */
static void test_each_uneven_node_is_found_alone(void **state)
{
	(void)state;
	for (int at = 0; at < NODES; at++) {
		for (int kind = 0; kind < 4; kind++) {
			bool uneven[NODES] = {false};
			struct fixture f;

			set_up(&f);
			uneven[at] = true;
			if (kind == 0) {
				f.node[at].matrix = &f.shear[0];
			} else {
				f.node[at].rest.scale[kind - 1] = 2;
			}
			if (at + 1 < NODES && kind < 2) {
				f.node[at + 1].parent = at;
				uneven[at + 1] = true;
			}
			assert_true(start(&f));
			check_palettes(&f, uneven);
			arena_release(&f.arena);
		}
	}
}

static void test_each_uneven_bind_is_found_alone(void **state)
{
	static const bool all[NODES] = {true, true, true};
	static const bool none[NODES] = {false};

	(void)state;
	for (int at = -1; at < NODES; at++) {
		struct fixture f;

		set_up(&f);
		if (at >= 0) {
			f.inverse_bind[at][1][1] = 2;
		}
		assert_int_equal(start(&f), at >= 0);
		assert_int_equal(f.normals.always, at >= 0);
		check_palettes(&f, at >= 0 ? all : none);
		arena_release(&f.arena);
	}
}

static void test_neither_animated_nodes_nor_others_joints_count(void **state)
{
	mat4 palette[NODES] = {{{1}}};
	struct fixture f;

	(void)state;
	set_up(&f);
	f.node[NODES - 1].matrix = &f.shear[0];
	f.skin[1].joint_count = NODES - 1;
	assert_true(start(&f));
	f.pose.animated[NODES - 1] = true;
	assert_false(pose_normals_find(&f.normals, &f.pose));
	f.pose.local[0].scale[0] = 2;
	assert_true(pose_normals_find(&f.normals, &f.pose));
	assert_true(pose_normals_palette(&f.normals, &f.model, 0,
			    (const mat4 *)palette) != (const mat4 *)palette);
	assert_true(pose_normals_palette(&f.normals, &f.model, 1,
			    (const mat4 *)palette) == (const mat4 *)palette);
	arena_release(&f.arena);
}

static void test_what_memory_does_not_suffice_for_is_refused(void **state)
{
	int refused = 0, made = 0;

	(void)state;
	for (size_t limit = 0; limit < 9000; limit += 32) {
		struct memory_budget budget = {.limit_bytes = limit};
		struct fixture f;
		int error;

		set_up(&f);
		/* So that the first array is larger than all others. */
		f.model.node_count = 4000;
		f.skin[0].joint_count = f.skin[1].joint_count = 1;
		f.arena = arena_within(&budget);
		f.arena.block_bytes = 16;
		error = pose_normals_init(&f.normals, &f.model, &f.arena);
		if (error == 0) {
			assert_non_null(f.normals.uneven);
			assert_non_null(f.normals.uneven_bind);
			assert_non_null(f.normals.palette[0]);
			assert_non_null(f.normals.palette[1]);
			made++;
		} else {
			assert_int_equal(error, -ENOMEM);
			refused++;
		}
		arena_release(&f.arena);
	}
	assert_true(refused > 0 && made > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_scales_may_differ_by_a_256th),
		cmocka_unit_test(test_each_uneven_node_is_found_alone),
		cmocka_unit_test(test_each_uneven_bind_is_found_alone),
		cmocka_unit_test(
			test_neither_animated_nodes_nor_others_joints_count),
		cmocka_unit_test(
			test_what_memory_does_not_suffice_for_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
