/*
 * The robot arm's pick-up sequence: joint values for each step.
 *
 * This is data and its interpolation; arm.c applies the values to pivots. The
 * angles follow from the arm's geometry, see assets/arm.md.
 */
#ifndef APP_DEMO_ARM_PROGRAM_H
#define APP_DEMO_ARM_PROGRAM_H

/* The joints. Values are in degrees, the truck's position in metres. */
enum arm_joint {
	ARM_HEADING,
	ARM_PITCH,
	FOREARM_PITCH,
	HAND_PITCH,
	HAND_BANK,
	FINGER_HEADING,
	TRUCK_POSITION,
	ARM_JOINT_COUNT,
};

/* Where the crate is after a step. */
enum crate_place {
	CRATE_ON_FLOOR,
	CRATE_IN_HAND,
	CRATE_ON_TRUCK,
};

struct arm_step {
	const char *name;
	float duration_s;
	float joint[ARM_JOINT_COUNT]; /* at the end of the step */
	enum crate_place crate;       /* from the end of the step on */
};

extern const struct arm_step arm_program[];
extern const int arm_program_length;

/* Returns the duration of the whole sequence. */
float arm_program_duration_s(void);

/* The joint values at rest. */
extern const float arm_home[ARM_JOINT_COUNT];

/*
 * Blends from joint values to those at the end of a step, easing in and out.
 * The fraction is in 0..1.
 */
void arm_step_blend(const float from[ARM_JOINT_COUNT],
	const struct arm_step *step, float fraction, float out[ARM_JOINT_COUNT]);

#endif
