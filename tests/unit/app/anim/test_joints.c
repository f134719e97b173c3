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

/* The portable loops under other names, which the board's must equal. */
#define turns_set        portable_set
#define turns_mix        portable_mix
#define turns_set_packed portable_set_packed
#define turns_mix_packed portable_mix_packed
static void turns_set(struct turn *, int, float, struct transform *);
static void turns_mix(struct turn *, int, float, struct transform *, float);
static void turns_set_packed(struct turn *, int, float, struct transform *);
static void turns_mix_packed(
	struct turn *, int, float, struct transform *, float);
#include "app/anim/portable/turns.c"
#undef turns_set
#undef turns_mix
#undef turns_set_packed
#undef turns_mix_packed

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

/* The same rotations in shorts, of which consecutive ones are on one side. */
struct packed_turning {
	struct turning floats;
	int16_t key[JOINTS][KEYS][4];
	struct turn turn[JOINTS];
};

static void pack_turning(struct packed_turning *all, float angle)
{
	fill_turning(&all->floats, angle);
	for (int j = 0; j < JOINTS; j++) {
		for (int k = 0; k < KEYS; k++) {
			const float *q = all->floats.value[j][k];
			int16_t *key = all->key[j][k];
			int32_t cosine = 0;

			for (int i = 0; i < 4; i++) {
				key[i] = (int16_t)lrintf(
					q[i] * MODEL_PACKED_UNIT);
				cosine += k > 0 ? key[i] * all->key[j][k - 1][i]
						: 0;
			}
			for (int i = 0; cosine < 0 && i < 4; i++) {
				key[i] = (int16_t)-key[i];
			}
		}
		all->turn[j] = all->floats.turn[j];
		all->turn[j].packed = (const int16_t(*)[4])all->key[j];
	}
}

/* How far two rotations are apart, whatever their signs and lengths. */
static float apart(const float a[4], const float b[4])
{
	float unit[2][4], sum = 0, difference = 0;

	memcpy(unit[0], a, sizeof(unit[0]));
	memcpy(unit[1], b, sizeof(unit[1]));
	quat_normalize(unit[0]);
	quat_normalize(unit[1]);
	for (int i = 0; i < 4; i++) {
		sum += fabsf(unit[0][i] + unit[1][i]);
		difference += fabsf(unit[0][i] - unit[1][i]);
	}
	return sum < difference ? sum : difference;
}

static float length_of(const float q[4])
{
	return sqrtf(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

static const float PACKED_ANGLES[] = {0.01f, 0.1f, 0.3f, 0.6f, 1, 4};

/*
 * The unit of a key is 3e-5, so four half units and one of weights are apart
 * from the rotation between the floats.
 */
static void test_packed_turns_are_as_right_as_their_keys(void **state)
{
	static struct packed_turning all;
	struct transform local[JOINTS];

	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(PACKED_ANGLES); a++) {
		pack_turning(&all, PACKED_ANGLES[a]);
		for (int step = 0; step < 200; step++) {
			float time_s = turn_time_s(step);

			fill(local);
			turns_set_packed(all.turn, JOINTS, time_s, local);
			for (int j = 0; j < JOINTS; j++) {
				const float *got = local[j].rotation;
				float want[4];

				want_turn(&all.floats.turn[j], time_s, want);
				assert_true(apart(got, want) < 9e-5f);
				assert_near(length_of(got), 1, 4e-5);
			}
		}
	}
}

/* Between keys that packing does not round, only the weights are rounded. */
static void test_packed_turns_have_exact_weights(void **state)
{
	static const int16_t exact[2][4] = {
		{0, 0, 0, MODEL_PACKED_UNIT}, {0, 0, 19660, 26214}};
	static const float time_s[2] = {0, 1};
	struct transform local = transform_identity();
	struct turn turn = {.time_s = time_s,
		.packed = exact,
		.offset = offsetof(struct transform, rotation),
		.last = 1};

	(void)state;
	for (int i = 0; i <= 64; i++) {
		float u = (float)i / 64;
		double angle = (double)u * atan2(0.6, 0.8);

		turns_set_packed(&turn, 1, u, &local);
		assert_near(local.rotation[2], sin(angle), 2e-5);
		assert_near(local.rotation[3], cos(angle), 2e-5);
		assert_near(local.rotation[0], 0, 0);
	}
}

static void assert_equal_loops(struct packed_turning *all,
	struct packed_turning *other, float time_s, float amount)
{
	struct transform local[JOINTS], want[JOINTS];

	fill(local);
	fill(want);
	turns_set_packed(all->turn, JOINTS, time_s, local);
	portable_set_packed(other->turn, JOINTS, time_s, want);
	assert_memory_equal(local, want, sizeof(local));
	turns_set(all->floats.turn, JOINTS, time_s, local);
	portable_set(other->floats.turn, JOINTS, time_s, want);
	assert_memory_equal(local, want, sizeof(local));
	fill(local);
	fill(want);
	turns_mix_packed(all->turn, JOINTS, time_s, local, amount);
	portable_mix_packed(other->turn, JOINTS, time_s, want, amount);
	assert_memory_equal(local, want, sizeof(local));
	turns_mix(all->floats.turn, JOINTS, time_s, local, amount);
	portable_mix(other->floats.turn, JOINTS, time_s, want, amount);
	assert_memory_equal(local, want, sizeof(local));
	turns_set_packed(all->turn, 0, 0, local);
	assert_memory_equal(local, want, sizeof(local));
}

static void test_turns_equal_the_portable_ones(void **state)
{
	static struct packed_turning all, other;

	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(PACKED_ANGLES); a++) {
		pack_turning(&all, PACKED_ANGLES[a]);
		pack_turning(&other, PACKED_ANGLES[a]);
		for (int step = 0; step < 200; step++) {
			assert_equal_loops(&all, &other, turn_time_s(step),
				(float)(step % 5) * 0.25f);
		}
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
	static struct packed_turning packed;

	(void)state;
	joints_to_matrices(&local, 1, one);
	fill_turning(&all, 4);
	turns_mix(all.turn, 1, 0.15f, &local, 1);
	turns_set(all.turn, 1, 0.25f, &local);
	pack_turning(&packed, 4);
	turns_mix_packed(packed.turn, 1, 0.15f, &local, 1);
	turns_set_packed(packed.turn, 1, 0.25f, &local);
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
		cmocka_unit_test(test_packed_turns_are_as_right_as_their_keys),
		cmocka_unit_test(test_packed_turns_have_exact_weights),
		cmocka_unit_test(test_turns_equal_the_portable_ones),
		cmocka_unit_test(test_leaves_the_processors_mode_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
