/*
 * The robot arm's pick-up sequence: joint values step by step.
 *
 * Pure data and its interpolation; the demo applies the values to pivots. The
 * angles come from the arm's geometry, see assets/README.md.
 */
#ifndef APP_DEMO_ARM_PROGRAM_H
#define APP_DEMO_ARM_PROGRAM_H

/* What moves. Angles in degrees, the truck's way in metres. */
enum arm_joint {
	ARM_HEADING,
	ARM_PITCH,
	FOREARM_PITCH,
	HAND_PITCH,
	HAND_BANK,
	FINGER_HEADING,
	TRUCK_WAY,
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

/* The whole sequence's length. */
float arm_program_duration_s(void);

/* Joint values at rest. */
extern const float arm_home[ARM_JOINT_COUNT];

/*
 * Joint values on the way from one set to a step's, fraction in 0..1, starting
 * and ending softly.
 */
void arm_step_blend(const float from[ARM_JOINT_COUNT],
	const struct arm_step *step, float fraction, float out[ARM_JOINT_COUNT]);

#endif
