/*
 * Springy bones: ponytails, tails, antennas.
 *
 * A damped spring pulls the end of each bone to its animated position, relative
 * to the bone above, so that the end lags, swings and hangs. The ends keep
 * their distances, so no bone stretches. A step is divided into parts
 * (substep.h), and the spring is integrated by a rule that is stable for parts
 * of any length: nothing flies away, whatever the frame time.
 */
#ifndef APP_ANIM_PROCEDURAL_SPRING_H
#define APP_ANIM_PROCEDURAL_SPRING_H

#include "app/anim/procedural/capsule.h"

enum {
	SPRING_MAX = 16
};

struct spring {
	int count;            /* number of bones */
	int node[SPRING_MAX]; /* each the parent of the next */
	float end[3];         /* the last bone's end, in its own frame */

	float frequency_hz; /* of the undamped spring, at most 15; 0: the bones
			       hang limp */
	float damping;      /* damping ratio; 1 is critical damping */
	float gravity[3];   /* the world's units a second squared */
	float limit_rad;    /* the largest angle from the animated direction;
			       0 or less: no limit */
	float radius;       /* distance kept from capsules */
	float weight;       /* 0: as animated, 1: all of the motion */

	/* Private. */
	bool begun;
	float position[SPRING_MAX][3]; /* of the bones' ends, in the world */
	float velocity[SPRING_MAX][3];
	float origin[3];   /* the first bone's position in the last frame */
	float rotation[4]; /* world rotation of its parent then */
};

/*
 * Makes a spring of the count bones that end with the node last: 2 Hz, damping
 * 0.3, gravity 9.81 downwards, weight 1. The last bone gets the length and
 * direction of its offset from its parent. Returns 0, or -EINVAL if last has
 * too few ancestors or count is out of range.
 */
int spring_init(
	struct spring *spring, const struct model *model, int last, int count);

/*
 * Advances by step_s, at most 0.2 s, and rotates the bones. world has the
 * pose's matrices from before the call; those of the first bone and its
 * descendants are out of date after it. If the first bone has moved by more
 * than four times the chain's length since the last update, the motion begins
 * anew.
 */
void spring_update(struct spring *spring, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world, struct pose *pose);

#endif
