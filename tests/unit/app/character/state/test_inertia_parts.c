/* The differences that a transition keeps of each node, and their polynomials. */
#include "app/anim/math/quat.h"
#include "app/character/state/inertia.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	TURNED,
	SHIFTED,
	SCALED,
	SAME,
	NODES
};

static const float step_s = 0.125f;

struct fixture {
	struct bones bones;
	struct inertia inertia;
};

static void begin(struct fixture *f)
{
	memset(f, 0xff, sizeof(*f));
	bones_begin(&f->bones);
	for (int i = 0; i < NODES; i++) {
		bones_add(&f->bones, -1, 0, 0, 0);
	}
	f->bones.node[0].mesh = 0;
	f->bones.mesh[0].target_count = 2;
	f->bones.model.weight_count = 2;
	f->bones.rest_weights[0] = 8;
	f->bones.rest_weights[1] = 16;
	bones_pose(&f->bones);
	assert_int_equal(inertia_init(&f->inertia, &f->bones.model,
				 &f->bones.model.arena),
		0);
	assert_int_equal(f->inertia.shown, 0);
	assert_false(f->inertia.running);
}

static void end(struct fixture *f)
{
	bones_end(&f->bones);
}

static struct transform *local(struct fixture *f, int node)
{
	return &f->bones.pose.local[node];
}

static void turn(struct fixture *f, const float axis[3], float angle_rad)
{
	quat_from_axis_angle(axis, angle_rad, local(f, TURNED)->rotation);
}

static void keep(struct fixture *f)
{
	inertia_keep(&f->inertia, &f->bones.pose, step_s);
}

/* Begins a transition from the poses kept to the rest pose. */
static void change(struct fixture *f, float duration_s, enum inertia_curve curve)
{
	pose_rest(&f->bones.pose, &f->bones.model);
	inertia_begin(&f->inertia, &f->bones.pose, duration_s, curve);
}

/* The two last poses are known, if frames take time. */
static void test_it_counts_the_poses_that_give_a_velocity(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	for (int i = 1; i < 5; i++) {
		keep(&f);
		assert_int_equal(f.inertia.shown, i < 2 ? i : 2);
	}
	inertia_keep(&f.inertia, &f.bones.pose, 0);
	assert_int_equal(f.inertia.shown, 1);
	inertia_reset(&f.inertia);
	assert_int_equal(f.inertia.shown, 0);
	end(&f);
}

/* From a size, with a velocity to 0 in so much time or earlier. */
static void test_a_difference_follows_a_polynomial_of_the_fifth_degree(
	void **state)
{
	static const struct {
		float older, last, duration_s, end_s, coefficient[6];
	} rows[] = {
		/* At rest, and moving away, which counts as the same. */
		{1, 1, 0.5f, 0.5f, {1, 0, 0, -80, 240, -192}},
		{0.5f, 1, 0.5f, 0.5f, {1, 0, 0, -80, 240, -192}},
		{0.9375f, 1, 0.5f, 0.5f, {1, 0, 0, -80, 240, -192}},
		{2, 2, 1, 1, {2, 0, 0, -20, 30, -12}},
		/* Half as fast as it would have to be, and too fast. */
		{1.25f, 1, 1, 1, {1, -2, 0, 2, -1, 0}},
		{3, 2, 1, 1, {2, -8, 12, -8, 2, 0}},
		{2, 1, 0.5f, 0.5f, {1, -8, 24, -32, 16, 0}},
		{1.3203125f, 1, 1, 1,
			{1, -2.5625f, 0.25f, 4.625f, -4.75f, 1.4375f}},
		{1.5625f, 1, 1, 1, {1, -4.5f, 8, -7, 3, -0.5f}},
		/* The time is cut so that it does not swing over. */
		{1.6875f, 1, 1, 1 / 1.1f,
			{1, -5.5f, 12.1f, -13.31f, 7.3205f, -1.61051f}},
		{4, 2, 1, 0.625f, {2, -16, 51.2f, -81.92f, 65.536f, -20.97152f}},
	};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		bool turns = i % 2;
		const float axis[3] = {0, 1, 0};
		struct inertia_offset *offset;
		struct fixture f;

		begin(&f);
		for (int k = 0; k < 2; k++) {
			float size = k ? rows[i / 2].last : rows[i / 2].older;

			local(&f, SHIFTED)->translation[0] = size;
			/* A quarter of it, in radians. */
			turn(&f, axis, 0.25f * size);
			keep(&f);
		}
		change(&f, rows[i / 2].duration_s, INERTIA_SMOOTH);
		offset = turns ? &f.inertia.turn[TURNED]
			       : &f.inertia.shift[SHIFTED];
		assert_near(offset->end_s, rows[i / 2].end_s, 1e-4);
		for (int k = 0; k < 6; k++) {
			double wanted = (double)rows[i / 2].coefficient[k] *
				(turns ? 0.25 : 1);

			assert_near(offset->coefficient[k], wanted,
				2e-3 * fmax(1, fabs(wanted)));
		}
		end(&f);
	}
}

/* After one pose there is none. */
static void test_one_pose_has_no_velocity(void **state)
{
	static const float axis[3] = {0, 1, 0};
	struct fixture f;

	(void)state;
	begin(&f);
	/* What it replaces is nothing that was shown. */
	for (int k = 0; k < NODES; k++) {
		f.inertia.last.local[k].translation[0] = 5;
		quat_from_axis_angle(axis, 2, f.inertia.last.local[k].rotation);
	}
	local(&f, SHIFTED)->translation[0] = 1;
	turn(&f, axis, 1);
	keep(&f);
	change(&f, 1, INERTIA_SMOOTH);
	assert_near(f.inertia.shift[SHIFTED].coefficient[1], 0, 0);
	assert_near(f.inertia.turn[TURNED].coefficient[1], 0, 0);
	assert_near(f.inertia.shift[SHIFTED].coefficient[2], 0, 0);
	assert_near(f.inertia.turn[TURNED].coefficient[2], 0, 0);
	end(&f);
}

/* About any axis, and not by more than half a turn. */
static void test_a_turn_goes_the_shorter_way(void **state)
{
	static const float axis[3] = {1.0f / 3, -2.0f / 3, 2.0f / 3};
	static const float angles[] = {0.5f, 2, 3, -0.5f, -3};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(angles); i++) {
		for (int sign = -1; sign <= 1; sign += 2) {
			struct inertia_offset *offset;
			struct fixture f;
			float *rotation, wanted[4], left;

			begin(&f);
			rotation = local(&f, TURNED)->rotation;
			turn(&f, axis, angles[i]);
			for (int k = 0; k < 4; k++) {
				rotation[k] *= (float)sign;
			}
			keep(&f);
			change(&f, 1, INERTIA_CUBIC);
			offset = &f.inertia.turn[TURNED];
			assert_near(offset->size, fabsf(angles[i]), 1e-5);
			for (int k = 0; k < 3; k++) {
				assert_near(offset->direction[k],
					axis[k] * (angles[i] > 0 ? 1 : -1),
					1e-5);
			}
			/* A quarter of the time leaves 1 - 0.15625. */
			inertia_apply(&f.inertia, 0.25f, &f.bones.pose);
			left = 0.84375f * angles[i];
			quat_from_axis_angle(axis, left, wanted);
			assert_all_near(rotation, wanted, 4, 1e-5);
			assert_true(f.bones.pose.animated[TURNED]);
			end(&f);
		}
	}
}

/* Each difference moves its own node, by what is left of it. */
static void test_only_nodes_that_differ_are_moved(void **state)
{
	static const float axis[3] = {0, 0, 1};

	(void)state;
	for (int which = 0; which < NODES; which++) {
		struct fixture f;

		begin(&f);
		memcpy(local(&f, SHIFTED)->translation,
			((float[]){0.3f, -0.6f, 0.6f}), 3 * sizeof(float));
		if (which == TURNED) {
			turn(&f, axis, 0.5f);
		}
		if (which != SHIFTED) {
			memset(local(&f, SHIFTED)->translation, 0,
				3 * sizeof(float));
		}
		if (which == SCALED) {
			local(&f, SCALED)->scale[1] = 2;
		}
		keep(&f);
		change(&f, 0.5f, INERTIA_LINEAR);
		assert_int_equal(f.inertia.scales, which == SCALED);
		inertia_apply(&f.inertia, 0.125f, &f.bones.pose);
		for (int i = 0; i < NODES; i++) {
			assert_int_equal(f.bones.pose.animated[i],
				i == which && which != SAME);
		}
		if (which == SHIFTED) {
			assert_all_near(local(&f, SHIFTED)->translation,
				((float[]){0.225f, -0.45f, 0.45f}), 3, 1e-6);
		}
		if (which == SCALED) {
			assert_all_near(local(&f, SCALED)->scale,
				((float[]){1, 1.75f, 1}), 3, 1e-6);
		}
		end(&f);
	}
}

static void test_small_differences_are_none(void **state)
{
	static const struct {
		float turn_rad, shift_m;
		bool counts;
	} rows[] = {{2e-4f, 2e-6f, true}, {5e-5f, 5e-7f, false}, {0, 0, false}};
	static const float axis[3] = {0, 1, 0};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;

		begin(&f);
		f.inertia.turn[TURNED].size = 7;
		f.inertia.shift[SHIFTED].size = 7;
		turn(&f, axis, rows[i].turn_rad);
		local(&f, SHIFTED)->translation[2] = rows[i].shift_m;
		keep(&f);
		change(&f, 1, INERTIA_SMOOTH);
		assert_near(f.inertia.turn[TURNED].size,
			rows[i].counts ? rows[i].turn_rad : 0, 1e-6);
		assert_near(f.inertia.shift[SHIFTED].size,
			rows[i].counts ? rows[i].shift_m : 0, 1e-9);
		end(&f);
	}
}

/* A transition that follows one has its own differences. */
static void test_a_scale_is_forgotten_by_the_next_transition(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	local(&f, SCALED)->scale[0] = 3;
	keep(&f);
	change(&f, 1, INERTIA_LINEAR);
	assert_true(f.inertia.scales);
	keep(&f);
	change(&f, 1, INERTIA_LINEAR);
	assert_false(f.inertia.scales);
	end(&f);
}

static void test_weights_end_with_the_transition(void **state)
{
	struct fixture f;
	const float *weight;

	(void)state;
	begin(&f);
	weight = f.bones.pose.weight;
	f.bones.pose.weight[0] = 9;
	f.bones.pose.weight[1] = 12;
	keep(&f);
	change(&f, 0.5f, INERTIA_LINEAR);
	inertia_apply(&f.inertia, 0.25f, &f.bones.pose);
	assert_all_near(weight, ((float[]){8.5f, 14}), 2, 1e-6);
	assert_true(f.inertia.running);
	pose_rest(&f.bones.pose, &f.bones.model);
	inertia_apply(&f.inertia, 0.25f, &f.bones.pose);
	assert_false(f.inertia.running);
	assert_all_near(weight, ((float[]){8, 16}), 2, 0);
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_it_counts_the_poses_that_give_a_velocity),
		cmocka_unit_test(
			test_a_difference_follows_a_polynomial_of_the_fifth_degree),
		cmocka_unit_test(test_one_pose_has_no_velocity),
		cmocka_unit_test(test_a_turn_goes_the_shorter_way),
		cmocka_unit_test(test_only_nodes_that_differ_are_moved),
		cmocka_unit_test(test_small_differences_are_none),
		cmocka_unit_test(
			test_a_scale_is_forgotten_by_the_next_transition),
		cmocka_unit_test(test_weights_end_with_the_transition),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
