/*
 * Compares the loops over joints with the functions for one joint, bit for bit:
 * on the host the portable loops, on ARM the assembly.
 */
#include "app/anim/joints.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	JOINTS = 40
};

static void fill(struct transform local[JOINTS])
{
	for (int j = 0; j < JOINTS; j++) {
		struct transform *t = &local[j];

		*t = transform_identity();
		for (int k = 0; k < 3; k++) {
			t->translation[k] = scattered(10 * j + k) * 3;
			t->scale[k] = 1 + 0.2f * scattered(10 * j + 3 + k);
		}
		for (int k = 0; k < 4; k++) {
			t->rotation[k] = scattered(10 * j + 6 + k);
		}
		quat_normalize(t->rotation);
	}
	/* Zeros of both signs, and a quaternion that is no rotation. */
	local[1].rotation[0] = -0.0f;
	local[1].scale[1] = -1;
	memset(&local[2], 0, sizeof(local[2]));
	local[3].scale[0] = 1e-30f;
	local[3].translation[2] = 1e30f;
}

static void test_places_as_the_single_function_does(void **state)
{
	struct transform local[JOINTS];
	mat4 want, out[JOINTS + 1];

	(void)state;
	fill(local);
	memset(out, 0x55, sizeof(out));
	joints_to_matrices(local, JOINTS, out);
	for (int j = 0; j < JOINTS; j++) {
		transform_to_matrix(&local[j], want);
		assert_memory_equal(out[j], want, sizeof(want));
	}
	/* It writes nothing behind the last one, and nothing for count 0. */
	memset(want, 0x55, sizeof(want));
	assert_memory_equal(out[JOINTS], want, sizeof(want));
	joints_to_matrices(local, 0, out + JOINTS);
	assert_memory_equal(out[JOINTS], want, sizeof(want));
}

static void test_multiplies_as_the_single_function_does(void **state)
{
	struct transform local[JOINTS];
	int index[JOINTS];
	mat4 a[JOINTS], b[JOINTS], want, out[JOINTS + 1];

	(void)state;
	fill(local);
	joints_to_matrices(local, JOINTS, a);
	for (int j = 0; j < JOINTS; j++) {
		index[j] = (j * 7 + 3) % JOINTS;
		memcpy(b[j], a[(j * 11 + 5) % JOINTS], sizeof(b[j]));
	}
	memset(out, 0x55, sizeof(out));
	joints_multiply((const mat4 *)a, index, sizeof(*index), (const mat4 *)b,
		out, JOINTS);
	for (int j = 0; j < JOINTS; j++) {
		matrix_multiply(a[index[j]], b[j], want);
		assert_memory_equal(out[j], want, sizeof(want));
	}
	memset(want, 0x55, sizeof(want));
	assert_memory_equal(out[JOINTS], want, sizeof(want));
}

/* As in pose_world(): indices in structs, -1 for roots, a is out. */
static void test_walks_down_a_tree_in_place(void **state)
{
	struct node {
		float before;
		int parent;
		double behind;
	} node[JOINTS];
	struct transform local[JOINTS];
	mat4 want[JOINTS], world[JOINTS];

	(void)state;
	fill(local);
	joints_to_matrices(local, JOINTS, world);
	memcpy(want, world, sizeof(want));
	for (int j = 0; j < JOINTS; j++) {
		node[j].parent = j % 13 == 0 ? -1 : j - 1 - j % 3;
		node[j].parent =
			j < 3 && node[j].parent >= j ? 0 : node[j].parent;
		if (node[j].parent >= 0) {
			matrix_multiply(want[node[j].parent], want[j], want[j]);
		}
	}
	joints_multiply((const mat4 *)world, &node[0].parent, sizeof(*node),
		(const mat4 *)world, world, JOINTS);
	assert_memory_equal(world, want, sizeof(want));
}

/* The compiler's code needs vector length 1 in FPSCR. */
static void test_leaves_the_processors_mode_alone(void **state)
{
	static const int index[1] = {0};
	mat4 one[1], out[1];
	volatile float a = 2, b = 3;
	struct transform local = transform_identity();

	(void)state;
	joints_to_matrices(&local, 1, one);
	joints_multiply((const mat4 *)one, index, sizeof(*index),
		(const mat4 *)one, out, 1);
	assert_true(a * b + a == 8);
	assert_memory_equal(out, one, sizeof(one));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_places_as_the_single_function_does),
		cmocka_unit_test(test_multiplies_as_the_single_function_does),
		cmocka_unit_test(test_walks_down_a_tree_in_place),
		cmocka_unit_test(test_leaves_the_processors_mode_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
