/*
 * The pick-up sequence and the arm's geometry (assets/arm.md): the crate
 * must be where the pivots put the grip.
 */
#include "app/anim/hierarchy.h"
#include "app/demo/arm_program.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	ARM,
	FOREARM,
	HAND,
	GRIP,
	PIVOTS
};

static const float crate_on_floor[3] = {0.34f, 0.06f, 0.40f};
static const float crate_on_truck[3] = {-0.42f, 0.194f, 0.102f};

static float radians(float degrees)
{
	return degrees * 3.14159265f / 180.0f;
}

static void grip_matrix(const float joint[ARM_JOINT_COUNT], mat4 out)
{
	struct hierarchy_pivot pivot[PIVOTS];
	struct hierarchy hierarchy = {PIVOTS, pivot};
	mat4 world[PIVOTS];

	for (int i = 0; i < PIVOTS; i++) {
		pivot[i] = hierarchy_pivot_default();
		pivot[i].parent = i - 1;
	}
	pivot[ARM].order = HIERARCHY_HEADING_PITCH_BANK;
	pivot[ARM].position[1] = 0.32f;
	pivot[ARM].heading_rad = radians(joint[ARM_HEADING]);
	pivot[ARM].pitch_rad = radians(joint[ARM_PITCH]);
	pivot[FOREARM].order = HIERARCHY_PITCH_HEADING_BANK;
	pivot[FOREARM].position[1] = 0.56f;
	pivot[FOREARM].pitch_rad = radians(joint[FOREARM_PITCH]);
	pivot[HAND].order = HIERARCHY_PITCH_BANK_HEADING;
	pivot[HAND].position[2] = 0.46f;
	pivot[HAND].pitch_rad = radians(joint[HAND_PITCH]);
	pivot[HAND].bank_rad = radians(joint[HAND_BANK]);
	pivot[GRIP].position[2] = 0.275f;
	pivot[GRIP].pitch_rad = radians(-90.0f);
	hierarchy_world(&hierarchy, world);
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 4; j++) {
			out[i][j] = world[GRIP][i][j];
		}
	}
}

static void test_the_grip_is_at_the_crate_whenever_it_changes_hands(void **state)
{
	enum crate_place before = CRATE_ON_FLOOR;
	int changes = 0;

	(void)state;
	for (int i = 0; i < arm_program_length; i++) {
		const struct arm_step *step = &arm_program[i];
		enum crate_place other =
			step->crate == CRATE_IN_HAND ? before : step->crate;
		mat4 grip;

		if (step->crate == before) {
			continue;
		}
		changes++;
		grip_matrix(step->joint, grip);
		assert_all_near(grip[3],
			other == CRATE_ON_FLOOR ? crate_on_floor
						: crate_on_truck,
			3, 0.002);
		before = step->crate;
	}
	assert_int_equal(changes, 4);
	assert_int_equal(before, CRATE_ON_FLOOR);
}

static void test_the_crate_keeps_its_bearing_while_it_is_carried(void **state)
{
	(void)state;
	for (int i = 0; i < arm_program_length; i++) {
		mat4 grip;

		if (arm_program[i].crate != CRATE_IN_HAND) {
			continue;
		}
		grip_matrix(arm_program[i].joint, grip);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(grip[axis][axis], 1.0, 0.001);
		}
	}
}

static void test_the_truck_stands_still_while_it_is_loaded(void **state)
{
	(void)state;
	for (int i = 1; i < arm_program_length; i++) {
		if (arm_program[i].crate != arm_program[i - 1].crate) {
			assert_near(
				arm_program[i].joint[TRUCK_POSITION], 0.0, 0.0);
			assert_near(arm_program[i - 1].joint[TRUCK_POSITION],
				0.0, 0.0);
		}
	}
}

static void test_the_program_ends_as_it_began(void **state)
{
	const struct arm_step *last = &arm_program[arm_program_length - 1];

	(void)state;
	assert_all_near(last->joint, arm_home, ARM_JOINT_COUNT, 0.0);
	assert_near(arm_program_duration_s(), 14.4, 1e-4);
}

static void test_a_step_starts_and_ends_softly(void **state)
{
	float from[ARM_JOINT_COUNT] = {0};
	float out[ARM_JOINT_COUNT];

	(void)state;
	arm_step_blend(from, &arm_program[0], 0.0f, out);
	assert_all_near(out, from, ARM_JOINT_COUNT, 0.0);
	arm_step_blend(from, &arm_program[0], 1.0f, out);
	assert_all_near(out, arm_program[0].joint, ARM_JOINT_COUNT, 1e-5);
	arm_step_blend(from, &arm_program[0], 0.01f, out);
	assert_true(fabsf(out[0]) < 0.0005f * arm_program[0].joint[0]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_grip_is_at_the_crate_whenever_it_changes_hands),
		cmocka_unit_test(
			test_the_crate_keeps_its_bearing_while_it_is_carried),
		cmocka_unit_test(test_the_truck_stands_still_while_it_is_loaded),
		cmocka_unit_test(test_the_program_ends_as_it_began),
		cmocka_unit_test(test_a_step_starts_and_ends_softly),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
