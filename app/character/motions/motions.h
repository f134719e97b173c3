/*
 * What demos play of any model: the clips in which it stands, walks and runs,
 * and the bones that it shakes.
 *
 * The model's character file says so: by a state that blends clips over a
 * speed, and by [shake] sections. Without a file, the clips' names tell, and
 * the motion of their lowest vertices over the ground.
 */
#ifndef APP_CHARACTER_MOTIONS_MOTIONS_H
#define APP_CHARACTER_MOTIONS_MOTIONS_H

#include "app/character/build/gait.h"
#include "app/character/character_open.h"
#include "app/scene/instance/bounds.h"

enum motion_role {
	MOTION_STAND,
	MOTION_WALK,
	MOTION_RUN,
	MOTION_ROLES
};

enum {
	MOTION_BONES_MAX = 4
};

/* A clip and where it goes. Lengths are in scene units. */
struct motion {
	int clip;         /* -1: the rest pose */
	bool repeats;     /* it ends about as it begins, unlike a fall */
	float speed;      /* over the ground, units a second */
	float facing_rad; /* where it goes: 0 is +Z, to +X */
	float drift[2]; /* x and z, how far the clip itself moves the figure */
	/* How high it carries the figure, at rise_steps + 1 equal times. */
	int rise_steps; /* 0: it neither climbs nor falls */
	float rise[GAIT_STEPS_MOST + 1];
};

/* A model without a clip for a role has that of the next best one. */
struct motions {
	struct motion role[MOTION_ROLES];
	/* [bone_count], nodes that the character file shakes */
	int bone[MOTION_BONES_MAX];
	int bone_count;
};

/*
 * Finds the motions of the instance's model; if the request has a clip, all are
 * that one. Leaves the instance in the rest pose. Returns 0, or -errno after
 * logging an error in the character file or in the clip's name.
 */
int motions_find(const struct character_request *request,
	struct instance *instance, const struct log *log, struct motions *out);

/* Measures a clip of the model and leaves the instance in the rest pose. */
struct motion motion_of_clip(struct instance *instance, int clip);

/* Returns the figure's box in this motion, scene units, without its drift and rise. */
struct bounds motion_bounds(
	struct instance *instance, const struct motion *motion);

/*
 * Computes how far the drift and the rise have moved the figure at this time:
 * x, y and z.
 */
void motion_drift_at(const struct motion *motion, const struct model *model,
	float time_s, float out[3]);

#endif
