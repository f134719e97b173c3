/*
 * The division of a frame's step into parts, for springs and cloth.
 */
#ifndef APP_ANIM_PROCEDURAL_SUBSTEP_H
#define APP_ANIM_PROCEDURAL_SUBSTEP_H

#include "platform/base/scalar.h"

struct substep {
	float step_s; /* 0.0001 to 0.2 */
	float part_s; /* step_s / count */
	int count;    /* of parts */
};

/*
 * Divides a step into parts of at most 1/120 s, but into no more than 12 parts:
 * otherwise a slow frame would make the next frame slower. A step is limited to
 * 0.0001 to 0.2 s.
 */
static inline struct substep substep_divide(float step_s)
{
	const float longest_part_s = 1.0f / 120;
	struct substep substep = {.step_s = scalar_clamp(step_s, 1e-4f, 0.2f)};

	substep.count = (int)(substep.step_s / longest_part_s) + 1;
	substep.count = substep.count < 12 ? substep.count : 12;
	substep.part_s = substep.step_s / (float)substep.count;
	return substep;
}

#endif
