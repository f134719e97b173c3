/*
 * A bone that looks at a point, within limits, and takes its time.
 *
 * The turn is added to what a clip made of the bone: yaw about the bone's up
 * axis, then pitch about its right one. For a neck and a head, use one each
 * with a share of the weight, the neck first.
 */
#ifndef APP_ANIM_PROCEDURAL_LOOKAT_H
#define APP_ANIM_PROCEDURAL_LOOKAT_H

#include "app/anim/pose.h"

struct lookat {
	int node;            /* has a parent or the root's frame is the world */
	float forward[3];    /* unit, in the bone's own axes */
	float up[3];         /* unit, at right angles to forward */
	float yaw_limit_rad; /* to either side, below pi */
	float pitch_limit_rad; /* up and down, below pi / 2 */
	float release_rad; /* a target further aside is given up and the bone
			      looks ahead; 0: never */
	float rate;   /* how fast it follows: the rest of the way shrinks by
			 e in 1 / rate seconds; 0 or less: at once */
	float weight; /* 0..1 */

	float yaw_rad, pitch_rad; /* the turn shown last */
};

/*
 * A bone that looks along +Z with +Y up: 80 degrees aside, 50 up and down,
 * given up beyond 120, rate 8 a second, full weight.
 */
struct lookat lookat_default(int node);

/*
 * Turns towards the point by as much as step_s allows and changes the node's
 * rotation. world are the pose's matrices before the change; those from the
 * node on are out of date after it. target NULL: looks ahead again.
 */
void lookat_update(struct lookat *lookat, const float target[3], float step_s,
	const mat4 *world, struct pose *pose);

#endif
