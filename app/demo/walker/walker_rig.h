/*
 * What is put on top of the walker's clips, frame by frame.
 *
 * Each feature is a layer that can be switched; a switched layer comes and
 * goes smoothly. The order is that of dependence: shaken and breathing bones
 * first, then the feet, then what looks and reaches, last what only trails
 * behind.
 */
#ifndef APP_DEMO_WALKER_WALKER_RIG_H
#define APP_DEMO_WALKER_WALKER_RIG_H

#include "app/anim/procedural/breath.h"
#include "app/anim/procedural/ik.h"
#include "app/anim/procedural/lookat.h"
#include "app/anim/procedural/muscle.h"
#include "app/anim/procedural/procedural.h"
#include "app/demo/preset_file.h"
#include "app/demo/walker/walker_secondary.h"
#include "app/scene/instance/instance.h"
#include "app/scene/stage/floor.h"

enum walker_rig_feature {
	RIG_LOOK,   /* neck and head follow the ball */
	RIG_REACH,  /* the right hand goes to it */
	RIG_GROUND, /* the ground is uneven, feet stay on it */
	RIG_SHAKE,  /* the arms shake as on harsh snow */
	RIG_BREATH, /* the chest heaves, bent arms bulge */
	RIG_HAIR,   /* the ponytail swings */
	RIG_CAPE,   /* a cape hangs from the shoulders */
	RIG_FACE,   /* expressions follow each other: morph and skin */
	RIG_SHADOW, /* drawn by the demo, as is the next */
	RIG_BUMPS,  /* the belt's normal map */
	RIG_FEATURE_COUNT,
};

struct walker_rig {
	bool on[RIG_FEATURE_COUNT];
	float weight[RIG_FEATURE_COUNT]; /* on its way to 0 or 1 */
	float ball[3];                   /* scene units */

	struct lookat neck, head;
	struct ik_limb arm, leg[2];
	struct procedural shake[2];
	struct preset_file presets;
	int preset_chosen;
	struct breath breath;
	struct muscle biceps[2];
	struct walker_secondary secondary;
	int hips;
	int face;       /* the node whose targets are expressions, or -1 */
	int expression; /* the one shown now */
};

/*
 * Finds the bones; the instance stands at rest, and its arena gives memory. 0,
 * or -errno after a sentence, which names a missing bone.
 */
int walker_rig_init(struct walker_rig *rig, struct instance *instance,
	const struct log *log);

/* Shakes by the next of the presets in assets/presets.ini. */
void walker_rig_next_preset(struct walker_rig *rig);

/* "look at" and so on. */
const char *walker_rig_feature_name(enum walker_rig_feature feature);

/* What a frame brings. */
struct walker_rig_frame {
	double time_s;
	float step_s;
	float speed_m_per_s; /* of the floor underneath */
	struct floor *floor; /* its relief follows RIG_GROUND */
};

/*
 * Changes the instance's pose, which a clip has been sampled into; leaves its
 * world matrices up to date.
 */
void walker_rig_apply(struct walker_rig *rig, struct instance *instance,
	const struct walker_rig_frame *frame);

#endif
