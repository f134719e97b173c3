/*
 * What is put on top of the walker's clips, frame by frame.
 *
 * Each feature is a layer that can be switched; a switched layer comes and
 * goes smoothly. The order is that of dependence: shaken and breathing bones
 * first, then the feet, then what looks and reaches, last what only trails
 * behind.
 */
#ifndef APP_DEMO_WALKER_RIG_H
#define APP_DEMO_WALKER_RIG_H

#include "app/anim/ik.h"
#include "app/anim/lookat.h"
#include "app/anim/procedural.h"
#include "app/scene/floor.h"
#include "app/scene/instance.h"

enum rig_feature {
	RIG_LOOK,   /* neck and head follow the ball */
	RIG_REACH,  /* the right hand goes to it */
	RIG_GROUND, /* the ground is uneven, feet stay on it */
	RIG_SHAKE,  /* the arms shake as on harsh snow */
	RIG_FEATURE_COUNT,
};

struct walker_rig {
	bool on[RIG_FEATURE_COUNT];
	float weight[RIG_FEATURE_COUNT]; /* on its way to 0 or 1 */
	float ball[3];                   /* scene units */

	struct lookat neck, head;
	struct ik_limb arm, leg[2];
	struct procedural shake[2];
	int hips;
};

/* Finds the bones. 0, or -EINVAL after a sentence that names a missing one. */
int walker_rig_init(struct walker_rig *rig, const struct model *model,
	const struct log *log);

/* "look at" and so on. */
const char *rig_feature_name(enum rig_feature feature);

/*
 * Changes the instance's pose, which a clip has been sampled into; leaves its
 * world matrices up to date. The floor's relief follows RIG_GROUND.
 */
void walker_rig_apply(struct walker_rig *rig, struct instance *instance,
	struct floor *floor, double time_s, float step_s);

#endif
