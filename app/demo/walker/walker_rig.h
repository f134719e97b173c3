/*
 * The procedural layers on top of the walker's clips.
 *
 * Each feature is a layer that can be switched on and off and then fades in or
 * out. A layer is applied after those it depends on: first shake and breath,
 * then the feet, then look-at and reach, last ponytail and cape.
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
	RIG_LOOK,   /* neck and head turn to the ball */
	RIG_REACH,  /* the right hand reaches for the ball */
	RIG_GROUND, /* the ground is uneven and the feet stay on it */
	RIG_SHAKE,  /* the arms shake */
	RIG_BREATH, /* the chest breathes and bent arms bulge */
	RIG_HAIR,   /* the ponytail swings */
	RIG_CAPE,   /* a cape hangs from the shoulders */
	RIG_FACE,   /* expressions follow each other: morph and skin */
	RIG_SHADOW, /* a shadow, which the demo draws */
	RIG_BUMPS,  /* the belt's normal map, which the demo draws */
	RIG_FEATURE_COUNT,
};

struct walker_rig {
	bool on[RIG_FEATURE_COUNT];
	float weight[RIG_FEATURE_COUNT]; /* fades to 0 or 1 */
	float ball[3];                   /* scene units */

	struct lookat neck, head;
	struct ik_limb arm, leg[2];
	int fingers, thumb; /* of the hand that reaches */
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
 * Finds the bones of an instance in its rest pose. Memory comes from the
 * instance's arena. Returns 0, or -errno after logging an error, which names a
 * missing bone.
 */
int walker_rig_init(struct walker_rig *rig, struct instance *instance,
	const struct log *log);

/* Selects the next shake preset of assets/presets.ini. */
void walker_rig_next_preset(struct walker_rig *rig);

/* Returns the feature's name on the display, such as "look at". */
const char *walker_rig_feature_name(enum walker_rig_feature feature);

/* The input of a frame. */
struct walker_rig_frame {
	double time_s;
	float step_s;
	float speed_m_per_s; /* at which the floor scrolls */
	struct floor *floor; /* its waves follow RIG_GROUND */
};

/*
 * Applies the layers to the instance's pose, which holds the clip's. Leaves the
 * world matrices up to date.
 */
void walker_rig_apply(struct walker_rig *rig, struct instance *instance,
	const struct walker_rig_frame *frame);

#endif
