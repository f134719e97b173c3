/* What a transition needs to have been shown, and how its differences end. */
#include "app/character/state/inertia.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>

/* The pose of one node that moves along x by 1 m a second. */
struct fixture {
	struct bones bones;
	struct inertia inertia;
};

static void begin(struct fixture *f)
{
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 0, 0);
	bones_pose(&f->bones);
	assert_int_equal(inertia_init(&f->inertia, &f->bones.model,
				 &f->bones.model.arena),
		0);
}

static float *place(struct fixture *f)
{
	return f->bones.pose.local[0].translation;
}

/* Shows the node at x, a tenth of a second after the last frame. */
static void show(struct fixture *f, float x)
{
	place(f)[0] = x;
	inertia_keep(&f->inertia, &f->bones.pose, 0.1f);
}

/* Begins a transition to a motion whose node stands at 0. */
static void change(struct fixture *f, float duration_s)
{
	place(f)[0] = 0;
	inertia_begin(&f->inertia, &f->bones.pose, duration_s, INERTIA_SMOOTH);
}

/* Where the node of the new motion is shown after a step. */
static float after(struct fixture *f, float step_s)
{
	place(f)[0] = 0;
	inertia_apply(&f->inertia, step_s, &f->bones.pose);
	return place(f)[0];
}

static void test_a_transition_needs_a_pose_that_was_shown(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	change(&f, 1.0f);
	assert_false(f.inertia.running);
	show(&f, 2.0f);
	change(&f, 0.0f);
	assert_false(f.inertia.running);
	change(&f, 1.0f);
	assert_true(f.inertia.running);
	assert_near(after(&f, 1e-4f), 2.0, 1e-3);
	inertia_reset(&f.inertia);
	assert_false(f.inertia.running);
	change(&f, 1.0f);
	assert_false(f.inertia.running);
	assert_near(after(&f, 0.1f), 0, 0);
	bones_end(&f.bones);
}

/* Two poses say how fast the node moves; poses before a reset say nothing. */
static void test_velocity_needs_two_poses(void **state)
{
	const float step_s = 0.01f;

	(void)state;
	for (int poses = 1; poses <= 3; poses++) {
		struct fixture f;
		float moved;

		begin(&f);
		show(&f, 9.0f);
		inertia_reset(&f.inertia);
		for (int i = 0; i < poses; i++) {
			show(&f, 1.0f - 0.1f * (float)i);
		}
		change(&f, 1.0f);
		moved = after(&f, step_s) - (1.0f - 0.1f * (float)(poses - 1));
		assert_near(moved, poses > 1 ? -1.0f * step_s : 0, 1e-3);
		bones_end(&f.bones);
	}
}

static void test_differences_end_at_the_duration(void **state)
{
	struct fixture f;
	float last = 2.0f;

	(void)state;
	begin(&f);
	show(&f, last);
	change(&f, 1.0f);
	for (int i = 1; i < 10; i++) {
		float now = after(&f, 0.1f);

		assert_true(now < last && now > 0);
		last = now;
	}
	assert_true(last < 0.02f);
	assert_near(after(&f, 0.11f), 0, 0);
	assert_false(f.inertia.running);
	bones_end(&f.bones);
}

/* The matrix that a file gives a node holds neither of the scales. */
static void test_a_difference_in_scale_replaces_the_nodes_matrix(void **state)
{
	struct fixture f;
	struct pose *pose = &f.bones.pose;

	(void)state;
	begin(&f);
	pose->local[0].scale[1] = 3.0f;
	inertia_keep(&f.inertia, pose, 0.1f);
	pose->local[0].scale[1] = 1.0f;
	pose->animated[0] = false;
	change(&f, 1.0f);
	after(&f, 0.0f);
	assert_near(pose->local[0].scale[1], 3.0, 1e-6);
	assert_true(pose->animated[0]);
	bones_end(&f.bones);
}

/* A quintic from x with velocity v and acceleration a to rest at 0, at u of t. */
static double quintic(double x, double v, double a, double t, double u)
{
	double p = 1 + u * (3 + 6 * u), q = u * (1 + 3 * u), r = 0.5 * u * u;

	return pow(1 - u, 3) * (x * p + v * t * q + a * t * t * r);
}

/* What velocity lets it fall to 0 without overshooting, and the time it takes. */
static void test_a_difference_keeps_its_velocity_and_does_not_overshoot(
	void **state)
{
	/* velocity, acceleration and end */
	static const double course[][3] = {{0, 0, 1}, {3, 0, 1}, {-1, 0, 1},
		{-2, 0, 1}, {-4, 12, 1}, {-5, 20, 1}, {-10, 80, 0.5}};

	(void)state;
	for (size_t i = 0; i < sizeof(course) / sizeof(course[0]); i++) {
		double v = course[i][0] > 0 ? 0 : course[i][0];
		double end_s = course[i][2];
		struct fixture f;

		begin(&f);
		show(&f, 1.0f - 0.1f * (float)course[i][0]);
		show(&f, 1.0f);
		change(&f, 1.0f);
		for (int step = 1; step < 20; step++) {
			double u = step / 20.0 / end_s;

			assert_near(after(&f, 0.05f),
				u >= 1 ? 0
				       : quintic(1, v, course[i][1], end_s, u),
				1e-4);
		}
		bones_end(&f.bones);
	}
}

/* Turns the node about y. */
static void turn(struct fixture *f, double rad)
{
	float *rotation = f->bones.pose.local[0].rotation;

	rotation[0] = rotation[2] = 0.0f;
	rotation[1] = (float)sin(rad / 2);
	rotation[3] = (float)cos(rad / 2);
}

static double turned(const struct fixture *f)
{
	const float *rotation = f->bones.pose.local[0].rotation;

	return 2 * atan2(rotation[1], rotation[3]);
}

static void test_a_turn_keeps_its_velocity_too(void **state)
{
	(void)state;
	for (int poses = 1; poses <= 2; poses++) {
		struct fixture f;
		double v = poses == 1 ? 0 : -4;

		begin(&f);
		for (int i = poses - 1; i >= 0; i--) {
			turn(&f, 1.0 + 0.4 * i);
			inertia_keep(&f.inertia, &f.bones.pose, 0.1f);
		}
		turn(&f, 0);
		change(&f, 1.0f);
		for (int step = 1; step < 20; step++) {
			turn(&f, 0);
			f.bones.pose.animated[0] = false;
			after(&f, 0.05f);
			assert_near(turned(&f),
				quintic(1, v, poses == 1 ? 0 : 12, 1,
					step / 20.0),
				1e-3);
			assert_true(f.bones.pose.animated[0]);
		}
		bones_end(&f.bones);
	}
}

static double smooth(double u)
{
	return u * u * (3 - 2 * u);
}

/* In a straight line or softly, and scales softly in any case. */
static void test_other_curves_know_no_velocity(void **state)
{
	static const enum inertia_curve curve[] = {
		INERTIA_LINEAR, INERTIA_CUBIC};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct fixture f;
		struct transform *local;

		begin(&f);
		local = f.bones.pose.local;
		show(&f, 5.0f);
		turn(&f, 1.0);
		local->scale[2] = 2.0f;
		show(&f, 1.0f);
		turn(&f, 0);
		local->scale[2] = 1.0f;
		local->translation[0] = 0;
		inertia_begin(&f.inertia, &f.bones.pose, 2.0f, curve[i]);
		for (int step = 1; step < 20; step++) {
			double u = step / 20.0;
			double left = 1 - (i == 0 ? u : smooth(u));

			turn(&f, 0);
			local->scale[2] = 1.0f;
			assert_near(after(&f, 0.1f), left, 1e-4);
			assert_near(turned(&f), left, 1e-3);
			assert_near(local->scale[2], 1 + left, 1e-4);
		}
		bones_end(&f.bones);
	}
}

/* Not even the velocity, if the last frame took no time. */
static void test_a_frame_without_a_step_has_no_velocity(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	show(&f, 1.4f);
	show(&f, 1.2f);
	place(&f)[0] = 1.0f;
	inertia_keep(&f.inertia, &f.bones.pose, 0.0f);
	change(&f, 1.0f);
	assert_near(after(&f, 0.1f), quintic(1, 0, 0, 1, 0.1), 1e-4);
	bones_end(&f.bones);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_transition_needs_a_pose_that_was_shown),
		cmocka_unit_test(test_velocity_needs_two_poses),
		cmocka_unit_test(test_differences_end_at_the_duration),
		cmocka_unit_test(
			test_a_difference_keeps_its_velocity_and_does_not_overshoot),
		cmocka_unit_test(test_a_turn_keeps_its_velocity_too),
		cmocka_unit_test(test_other_curves_know_no_velocity),
		cmocka_unit_test(test_a_frame_without_a_step_has_no_velocity),
		cmocka_unit_test(
			test_a_difference_in_scale_replaces_the_nodes_matrix),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
