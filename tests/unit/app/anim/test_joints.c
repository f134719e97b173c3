/*
 * Compares the loops over joints with the functions for one joint, bit for bit:
 * on the host the portable loops, on ARM the assembly.
 */
#include "app/anim/joints.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/math/transform_inline.h"
#include "app/anim/math/vec.h"
#include "app/anim/turns.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <math.h>
#include <stddef.h>
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

enum {
	KEYS = 9
};

/* Rotations whose keys are up to angle apart, with times of their own. */
struct turning {
	float time_s[JOINTS][KEYS];
	float value[JOINTS][KEYS][4];
	struct turn turn[JOINTS];
};

static void fill_turning(struct turning *all, float angle)
{
	for (int j = 0; j < JOINTS; j++) {
		/* Every third one has the times of the one before. */
		int own = j % 3 == 2 ? j - 1 : j;
		float axis[3] = {1, scattered(j), scattered(j + 50)};

		vec_normalize(axis);
		for (int k = 0; k < KEYS; k++) {
			float *q = all->value[j][k];
			float sign = scattered(7 * j + k) < 0 ? -1 : 1;

			all->time_s[j][k] = 0.1f * (float)(k + own % 4) +
				0.04f * scattered(own * KEYS + k);
			quat_from_axis_angle(
				axis, (float)k * angle * scattered(90 + j), q);
			for (int i = 0; i < 4; i++) {
				q[i] *= sign;
			}
		}
		all->time_s[j][0] = own % 4 ? all->time_s[j][0] : 0;
		all->turn[j] = (struct turn){
			.time_s = all->time_s[own],
			.value = all->value[j][0],
			.offset = (int)(sizeof(struct transform) * (size_t)j +
				offsetof(struct transform, rotation)),
			.weight = (float)(j % 5) * 0.25f,
			.last = own % 5 == 4 ? 1 : KEYS - 1,
		};
	}
}

/* A rotation, found by other means. */
static void want_turn(const struct turn *turn, float time_s, float out[4])
{
	const float *from;
	float u;
	int key = turn->last - 1;

	while (key > 0 && turn->time_s[key] > time_s) {
		key--;
	}
	time_s = scalar_clamp(time_s, turn->time_s[key], turn->time_s[key + 1]);
	u = (time_s - turn->time_s[key]) /
		(turn->time_s[key + 1] - turn->time_s[key]);
	from = turn->value + 4 * key;
	inline_quat_slerp(from, from + 4, u, out);
}

/* Small steps, larger ones than keys, back to the start, both ends. */
static float turn_time_s(int step)
{
	return step % 50 == 17 ? 5
		: step % 2     ? (float)step * 0.0117f
			       : 1 + scattered(step);
}

static void test_turns_as_the_single_function_does(void **state)
{
	static const float angles[] = {0.05f, 0.3f, 1, 4};
	static struct turning all;
	struct transform local[JOINTS], before[JOINTS];

	(void)state;
	for (size_t a = 0; a < sizeof(angles) / sizeof(*angles); a++) {
		fill_turning(&all, angles[a]);
		for (int step = 0; step < 200; step++) {
			float time_s = turn_time_s(step);

			fill(local);
			memcpy(before, local, sizeof(before));
			turns_set(all.turn, JOINTS, time_s, local);
			for (int j = 0; j < JOINTS; j++) {
				want_turn(&all.turn[j], time_s,
					before[j].rotation);
			}
			assert_memory_equal(local, before, sizeof(local));
		}
	}
	turns_set(all.turn, 0, 0, local);
	assert_memory_equal(local, before, sizeof(local));
}

static void test_mixes_turns_as_the_single_function_does(void **state)
{
	static struct turning all;
	struct transform local[JOINTS], want[JOINTS];

	(void)state;
	fill_turning(&all, 0.5f);
	for (int step = 0; step < 200; step++) {
		float time_s = turn_time_s(step);
		float amount = (float)(step % 5) * 0.25f;

		fill(local);
		memcpy(want, local, sizeof(want));
		turns_mix(all.turn, JOINTS, time_s, local, amount);
		for (int j = 0; j < JOINTS; j++) {
			float to[4];

			want_turn(&all.turn[j], time_s, to);
			inline_quat_mix(want[j].rotation, to,
				all.turn[j].weight * amount);
		}
		assert_memory_equal(local, want, sizeof(local));
	}
}

/* The compiler's code needs vector length 1 in FPSCR. */
static void test_leaves_the_processors_mode_alone(void **state)
{
	static const int index[1] = {0};
	mat4 one[1], out[1];
	volatile float a = 2, b = 3;
	struct transform local = transform_identity();
	static struct turning all;

	(void)state;
	joints_to_matrices(&local, 1, one);
	fill_turning(&all, 4);
	turns_mix(all.turn, 1, 0.15f, &local, 1);
	turns_set(all.turn, 1, 0.25f, &local);
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
		cmocka_unit_test(test_turns_as_the_single_function_does),
		cmocka_unit_test(test_mixes_turns_as_the_single_function_does),
		cmocka_unit_test(test_leaves_the_processors_mode_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
