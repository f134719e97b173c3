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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_transition_needs_a_pose_that_was_shown),
		cmocka_unit_test(test_velocity_needs_two_poses),
		cmocka_unit_test(test_differences_end_at_the_duration),
		cmocka_unit_test(
			test_a_difference_in_scale_replaces_the_nodes_matrix),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
