/*
 * Springy bones: ponytails, tails, antennas.
 *
 * The end of each bone is pulled to where the animation puts it, as far as
 * the bones above let it, and lags, swings and hangs on the way. Ends stay at
 * their bone's length, so that nothing stretches and nothing can fly away,
 * whatever the frame time: a step
 * is cut into up to 12 parts of 1/120 s or more, and the spring is solved by a
 * rule that is stable for any of them.
 */
#ifndef APP_ANIM_PROCEDURAL_SPRING_H
#define APP_ANIM_PROCEDURAL_SPRING_H

#include "app/anim/procedural/capsule.h"

enum {
	SPRING_MAX = 16
};

struct spring {
	int count;            /* bones */
	int node[SPRING_MAX]; /* each the parent of the next */
	float end[3];         /* the last bone's end, in its own frame */

	float frequency_hz; /* swings a second if nothing damped it, at most 15;
			       0: limp */
	float damping;      /* 1: comes to rest without swinging over */
	float gravity[3];   /* the world's units a second squared */
	float limit_rad;    /* how far a bone leaves its animated direction;
			       0 or less: freely */
	float radius;       /* kept from capsules */
	float weight;       /* 0: as animated */

	/* Below: for spring_update(). */
	bool begun;
	float place[SPRING_MAX][3]; /* of the ends, in the world */
	float velocity[SPRING_MAX][3];
	float origin[3];   /* of the first bone, in the last frame */
	float rotation[4]; /* above it */
};

/*
 * The count bones that end with the node last, at 2 swings a second, damping
 * 0.3, gravity 9.81 downwards, weight 1. The last bone is taken to be as long
 * as it is away from its parent. 0, or -EINVAL when there are too few
 * ancestors or count is out of range.
 */
int spring_init(
	struct spring *spring, const struct model *model, int last, int count);

/* Forgets the motion; the next update begins at the animated pose. */
void spring_reset(struct spring *spring);

/*
 * Goes on by step_s (at most 0.2 s of it count) and turns the bones. world
 * are the pose's matrices before the change; those of the first bone and all
 * behind it are out of date afterwards. A jump of the first bone by more than
 * four times the chain's length begins anew.
 */
void spring_update(struct spring *spring, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world, struct pose *pose);

#endif
