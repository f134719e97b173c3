#include "app/demo/arm_program.h"

/* Poses: arm heading and pitch, forearm pitch, hand pitch and bank. */
#define HOME       0.0f, -28.0f, 38.0f, 50.0f, 0.0f
#define OVER_FLOOR 40.36f, 16.71f, 20.99f, 52.29f, 40.36f
#define AT_FLOOR   40.36f, 38.33f, 28.95f, 22.72f, 40.36f
#define LIFTED     40.36f, 13.09f, 16.97f, 59.94f, 40.36f
#define OVER_TRUCK -76.35f, 1.13f, 22.57f, 66.30f, -76.35f
#define AT_TRUCK   -76.35f, 18.38f, 37.86f, 33.76f, -76.35f

enum {
	HOLD = -6,
	FREE = 4,
	WIDE = 14
};

#define DRIVE_M 0.4f

const float arm_home[ARM_JOINT_COUNT] = {HOME, 0.0f, 0.0f};

/* clang-format off */
const struct arm_step arm_program[] = {
	{"reach over", 0.9f, {OVER_FLOOR, WIDE, 0.0f},    CRATE_ON_FLOOR},
	{"reach down", 0.7f, {AT_FLOOR,   WIDE, 0.0f},    CRATE_ON_FLOOR},
	{"close",      0.4f, {AT_FLOOR,   HOLD, 0.0f},    CRATE_IN_HAND},
	{"lift",       0.7f, {LIFTED,     HOLD, 0.0f},    CRATE_IN_HAND},
	{"turn",       1.4f, {OVER_TRUCK, HOLD, 0.0f},    CRATE_IN_HAND},
	{"put down",   0.7f, {AT_TRUCK,   HOLD, 0.0f},    CRATE_IN_HAND},
	{"open",       0.3f, {AT_TRUCK,   FREE, 0.0f},    CRATE_ON_TRUCK},
	{"up",         0.5f, {OVER_TRUCK, FREE, 0.0f},    CRATE_ON_TRUCK},
	{"drive",      1.5f, {HOME,       FREE, DRIVE_M}, CRATE_ON_TRUCK},
	{"wait",       0.3f, {HOME,       FREE, DRIVE_M}, CRATE_ON_TRUCK},
	{"drive back", 1.5f, {OVER_TRUCK, FREE, 0.0f},    CRATE_ON_TRUCK},
	{"reach down", 0.6f, {AT_TRUCK,   FREE, 0.0f},    CRATE_ON_TRUCK},
	{"close",      0.3f, {AT_TRUCK,   HOLD, 0.0f},    CRATE_IN_HAND},
	{"lift",       0.6f, {OVER_TRUCK, HOLD, 0.0f},    CRATE_IN_HAND},
	{"turn back",  1.4f, {LIFTED,     HOLD, 0.0f},    CRATE_IN_HAND},
	{"put down",   0.7f, {AT_FLOOR,   HOLD, 0.0f},    CRATE_IN_HAND},
	{"open",       0.4f, {AT_FLOOR,   WIDE, 0.0f},    CRATE_ON_FLOOR},
	{"up",         0.5f, {OVER_FLOOR, WIDE, 0.0f},    CRATE_ON_FLOOR},
	{"home",       1.0f, {HOME,       0.0f, 0.0f},    CRATE_ON_FLOOR},
};
/* clang-format on */

const int arm_program_length = sizeof(arm_program) / sizeof(arm_program[0]);

float arm_program_duration_s(void)
{
	float sum = 0.0f;

	for (int i = 0; i < arm_program_length; i++) {
		sum += arm_program[i].duration_s;
	}
	return sum;
}

void arm_step_blend(const float from[ARM_JOINT_COUNT],
	const struct arm_step *step, float fraction, float out[ARM_JOINT_COUNT])
{
	float eased = fraction * fraction * (3.0f - 2.0f * fraction);

	for (int i = 0; i < ARM_JOINT_COUNT; i++) {
		out[i] = from[i] + (step->joint[i] - from[i]) * eased;
	}
}
