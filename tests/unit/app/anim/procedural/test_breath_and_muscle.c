#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/anim/procedural/breath.h"
#include "app/anim/procedural/muscle.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	CHEST,
	NECK,
	UPPER,
	FOREARM
};

static const float ROOT_HALF = 0.70710678f;

static void set_up(struct bones *bones)
{
	bones_begin(bones);
	bones_add(bones, -1, 0, 1, 0);
	bones_add(bones, CHEST, 0, 0.4f, 0);
	bones_add(bones, CHEST, 0.2f, 0.3f, 0);
	bones_add(bones, UPPER, 0, 0.3f, 0);
	/* The arm is rotated by 90 degrees about z. */
	bones->node[UPPER].rest.rotation[2] = -ROOT_HALF;
	bones->node[UPPER].rest.rotation[3] = ROOT_HALF;
	bones->model.weight_count = 2;
	bones_pose(bones);
}

static void test_a_breath_is_empty_at_its_ends_and_full_once(void **state)
{
	struct breath breath = breath_default(CHEST);

	(void)state;
	/* A breath takes 4 s: 1.6 s in and 2.4 s out. */
	assert_near(breath_at(&breath, 0), 0, 1e-6);
	assert_near(breath_at(&breath, 0.8), 0.5, 1e-5);
	assert_near(breath_at(&breath, 1.6), 1, 1e-5);
	assert_near(breath_at(&breath, 2.8), 0.5, 1e-5);
	assert_near(breath_at(&breath, 4), 0, 1e-5);
	assert_near(breath_at(&breath, 0.4), 0.15625, 1e-5);
	assert_near(breath_at(&breath, 4000.8), 0.5, 1e-5);
	assert_near(breath_at(&breath, -3.2), 0.5, 1e-5);
	assert_true(breath_at(&breath, (double)NAN) == 0);
	assert_true(breath_at(&breath, 1e300) == 0);
}

static void test_a_full_breath_swells_the_chest_alone(void **state)
{
	struct bones bones;
	struct breath breath = breath_default(CHEST);

	(void)state;
	set_up(&bones);
	breath_apply(&breath, 1.6, &bones.pose);
	bones_update(&bones);
	assert_near(bones.pose.local[CHEST].scale[0], 1.02, 1e-6);
	assert_near(bones.pose.local[CHEST].scale[1], 1.01, 1e-6);
	assert_near(bones.pose.local[CHEST].scale[2], 1.05, 1e-6);
	/* Children keep their size, also the one that is rotated. */
	for (int c = NECK; c <= FOREARM; c++) {
		for (int axis = 0; axis < 3; axis++) {
			assert_near(vec_length(bones.world[c][axis]), 1, 1e-5);
		}
	}
	/* But their positions move with the chest. */
	assert_near(bones.pose.local[CHEST].rotation[0], sin(-0.0175 / 2), 1e-6);
	assert_near(bones.world[NECK][3][1], 1 + 0.4 * 1.01 * cos(0.0175), 1e-5);
	bones_end(&bones);
}

/* A file may place nodes by matrices, which count until a bone is changed. */
static void test_nodes_with_matrices_swell_alike(void **state)
{
	static const float factor[3] = {2, 4, 0.5f};
	struct bones by_matrix, bones;
	mat4 matrix[4];

	(void)state;
	set_up(&bones);
	set_up(&by_matrix);
	for (int i = CHEST; i <= FOREARM; i++) {
		transform_to_matrix(&by_matrix.node[i].rest, matrix[i]);
		by_matrix.node[i].matrix = (const float(*)[4])matrix[i];
	}
	bones_pose(&by_matrix);
	bone_swell(&bones.pose, CHEST, factor);
	bone_swell(&by_matrix.pose, CHEST, factor);
	bones_update(&bones);
	bones_update(&by_matrix);
	assert_all_near(by_matrix.world, bones.world, 4 * 16, 1e-5);
	assert_near(vec_length(bones.world[CHEST][1]), 4, 1e-5);
	assert_near(vec_length(by_matrix.world[NECK][1]), 1, 1e-5);
	/* Below the children nothing is changed. */
	assert_false(by_matrix.pose.animated[FOREARM]);
	bones_end(&bones);
	bones_end(&by_matrix);
}

static void test_weight_scales_a_breath(void **state)
{
	struct bones bones;
	struct breath breath = breath_default(CHEST);

	(void)state;
	set_up(&bones);
	breath.weight = 0;
	breath_apply(&breath, 1.6, &bones.pose);
	assert_all_near(
		bones.pose.local, (const float *)&bones.node[0].rest, 10, 1e-6);
	breath.weight = 2;
	breath_apply(&breath, 1.6, &bones.pose);
	assert_near(bones.pose.local[CHEST].scale[2], 1.1, 1e-6);
	bones_end(&bones);
}

static void test_the_part_of_inhaling_is_limited(void **state)
{
	static const struct {
		float inhale;
		double time_s, full;
	} cases[] = {{0.95f, 0.475, 0.5}, {0.95f, 0.975, 0.5},
		{1.5f, 0.475, 0.5}, {1.5f, 0.975, 0.5}, {0.9f, 0.45, 0.5},
		{0.05f, 0.025, 0.5}, {0.05f, 0.525, 0.5}, {-1, 0.025, 0.5},
		{-1, 0.525, 0.5}, {0.1f, 0.05, 0.5}, {0.1f, 0.55, 0.5},
		{0.5f, -0.25, 0.5}, {0.5f, -0.5, 1}, {0.5f, -1, 0}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct breath breath = breath_default(CHEST);

		breath.rate_hz = 1;
		breath.inhale = cases[i].inhale;
		assert_near(breath_at(&breath, cases[i].time_s), cases[i].full,
			1e-5);
	}
}

static void test_breaths_are_counted_up_to_an_int(void **state)
{
	static const struct {
		double time_s, full;
	} cases[] = {{2147483646.25, 0.5}, {2147483647.25, 0},
		{-2147483646.75, 0.5}, {-2147483647.75, 0}, {-1e300, 0}};
	struct breath breath = breath_default(CHEST);

	(void)state;
	breath.rate_hz = 1;
	breath.inhale = 0.5f;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		assert_near(breath_at(&breath, cases[i].time_s), cases[i].full,
			1e-5);
	}
}

/* Half a breath turns by half the angle, and the rotation has unit length. */
static void test_lungs_lift_the_chest_as_they_are_full(void **state)
{
	static const float axis[3] = {1, 0, 0};
	struct bones bones;
	struct breath breath = breath_default(CHEST);
	float *rotation;

	(void)state;
	set_up(&bones);
	rotation = bones.pose.local[CHEST].rotation;
	assert_all_near(breath.lift_axis, axis, 3, 0);
	breath.lift_rad = 0.8f;
	breath.weight = 0.25f;
	rotation[3] = 3;
	breath_apply(&breath, 1.6, &bones.pose);
	assert_near(rotation[0], sin(0.1), 1e-6);
	assert_near(rotation[1], 0, 1e-6);
	assert_near(rotation[2], 0, 1e-6);
	assert_near(rotation[3], cos(0.1), 1e-6);
	bones_end(&bones);
}

static struct muscle biceps(void)
{
	return (struct muscle){.joint = FOREARM,
		.from_rad = 0.2f,
		.to_rad = 2.2f,
		.node = UPPER,
		.swell = {0.3f, 0, 0.2f},
		.weight = 1,
		.amount = 0.8f};
}

static void bend(struct bones *bones, float angle_rad)
{
	float *q = bones->pose.local[FOREARM].rotation;
	const float axis[3] = {1, 0, 0};

	pose_rest(&bones->pose, &bones->model);
	quat_from_axis_angle(axis, angle_rad, q);
}

static void test_a_muscle_is_drawn_by_the_joints_bend(void **state)
{
	struct bones bones;
	struct muscle muscle = biceps();

	(void)state;
	set_up(&bones);
	bend(&bones, 0);
	assert_near(muscle_bend_rad(&bones.pose, FOREARM), 0, 1e-6);
	assert_near(muscle_at(&muscle, &bones.pose), 0, 1e-6);
	bend(&bones, 0.7f);
	assert_near(muscle_bend_rad(&bones.pose, FOREARM), 0.7, 4e-6);
	/* A quarter of the range, with easing. */
	assert_near(muscle_at(&muscle, &bones.pose), 0.15625, 1e-5);
	bend(&bones, -1.2f);
	assert_near(muscle_at(&muscle, &bones.pose), 0.5, 1e-5);
	bend(&bones, 3);
	assert_near(muscle_at(&muscle, &bones.pose), 1, 1e-6);
	bones_end(&bones);
}

static void test_a_drawn_muscle_swells_and_morphs(void **state)
{
	struct bones bones;
	struct muscle muscle = biceps();

	(void)state;
	set_up(&bones);
	bones.rest_weights[1] = 0.1f;
	bend(&bones, 1.2f);
	muscle_apply(&muscle, &bones.pose);
	bones_update(&bones);
	assert_near(bones.pose.local[UPPER].scale[0], 1.15, 1e-5);
	assert_near(bones.pose.local[UPPER].scale[1], 1, 1e-5);
	assert_near(bones.pose.local[UPPER].scale[2], 1.1, 1e-5);
	assert_near(bones.pose.weight[1], 0.1 + 0.4, 1e-5);
	/* The forearm keeps its size. */
	for (int axis = 0; axis < 3; axis++) {
		assert_near(vec_length(bones.world[FOREARM][axis]), 1, 1e-5);
	}
	muscle.node = -1;
	muscle.weight = -1;
	muscle_apply(&muscle, &bones.pose);
	bones_end(&bones);
}

static void test_a_muscle_without_range_switches(void **state)
{
	struct bones bones;
	struct muscle muscle = biceps();

	(void)state;
	set_up(&bones);
	muscle.from_rad = muscle.to_rad = 1;
	bend(&bones, 0.9f);
	assert_true(muscle_at(&muscle, &bones.pose) == 0);
	bend(&bones, 1.1f);
	assert_true(muscle_at(&muscle, &bones.pose) == 1);
	muscle.from_rad = muscle.to_rad = muscle_bend_rad(&bones.pose, FOREARM);
	assert_true(muscle_at(&muscle, &bones.pose) == 1);
	/* A range of 1 is one like any other. */
	muscle.from_rad = 0.5f;
	muscle.to_rad = 1.5f;
	bend(&bones, 1);
	assert_near(muscle_at(&muscle, &bones.pose), 0.5, 1e-4);
	bones_end(&bones);
}

static void test_the_first_node_and_weight_are_some_too(void **state)
{
	struct bones bones;
	struct muscle muscle = biceps();

	(void)state;
	set_up(&bones);
	muscle.node = CHEST;
	muscle.weight = 0;
	bend(&bones, 3);
	muscle_apply(&muscle, &bones.pose);
	assert_near(bones.pose.local[CHEST].scale[0], 1.3, 1e-5);
	assert_near(bones.pose.weight[0], 0.8, 1e-5);
	assert_near(bones.pose.weight[1], 0, 0);
	bones_end(&bones);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_breath_is_empty_at_its_ends_and_full_once),
		cmocka_unit_test(test_a_full_breath_swells_the_chest_alone),
		cmocka_unit_test(test_nodes_with_matrices_swell_alike),
		cmocka_unit_test(test_weight_scales_a_breath),
		cmocka_unit_test(test_the_part_of_inhaling_is_limited),
		cmocka_unit_test(test_breaths_are_counted_up_to_an_int),
		cmocka_unit_test(test_lungs_lift_the_chest_as_they_are_full),
		cmocka_unit_test(test_a_muscle_is_drawn_by_the_joints_bend),
		cmocka_unit_test(test_a_drawn_muscle_swells_and_morphs),
		cmocka_unit_test(test_a_muscle_without_range_switches),
		cmocka_unit_test(test_the_first_node_and_weight_are_some_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
