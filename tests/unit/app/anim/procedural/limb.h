/*
 * A limb of three nodes below a torso, and what tests do with it.
 */
#ifndef TESTS_UNIT_APP_ANIM_PROCEDURAL_LIMB_H
#define TESTS_UNIT_APP_ANIM_PROCEDURAL_LIMB_H

#include "app/anim/procedural/ik.h"
#include "tests/support/model/bones.h"

enum {
	TORSO,
	UPPER,
	LOWER,
	TIP
};

struct fixture {
	struct bones bones;
	struct ik_limb limb;
};

static inline void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

/* Puts the limb back into its pose at rest. */
static inline void reset(struct fixture *f)
{
	pose_rest(&f->bones.pose, &f->bones.model);
	bones_update(&f->bones);
}

/* Returns how far the tip stays from the target. */
static inline float solve_limb(
	struct fixture *f, const float target[3], const float pole[3])
{
	float left = ik_limb_solve(&f->limb, target, pole,
		(const mat4 *)f->bones.world, &f->bones.pose);

	bones_update(&f->bones);
	return left;
}

#endif
