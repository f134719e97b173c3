/*
 * A bone that turns to look at a point, within limits and at a limited rate.
 *
 * The turn is added to the rotation that a clip gives the bone: yaw about the
 * bone's up axis, then pitch about its right axis. A neck and a head take one
 * struct lookat each, the neck first, with weights that sum to 1.
 */
#ifndef APP_ANIM_PROCEDURAL_LOOKAT_H
#define APP_ANIM_PROCEDURAL_LOOKAT_H

#include "app/anim/pose.h"

struct lookat {
	int node;
	float forward[3];      /* unit length, in the bone's own axes */
	float up[3];           /* unit length, at right angles to forward */
	float yaw_limit_rad;   /* to either side, below pi */
	float pitch_limit_rad; /* up and down, below pi / 2 */
	float release_rad;     /* for a target with a larger yaw the bone looks
				  ahead instead; 0: no such limit */
	float rate;   /* the remaining angle falls to 1 / e in 1 / rate seconds;
			 0 or less: the bone follows at once */
	float weight; /* 0..1 */

	float yaw_rad, pitch_rad; /* the present turn, before weight */
};

/*
 * A bone that looks along +Z with +Y up: yaw limit 80 degrees, pitch limit 50,
 * release angle 120, rate 8 a second, weight 1.
 */
struct lookat lookat_default(int node);

/*
 * Turns the node towards target, a point in the world, by as much as step_s
 * allows. With target NULL the bone looks ahead. world has the pose's matrices
 * from before the call; those of the node and its descendants are out of date
 * after it.
 */
void lookat_update(struct lookat *lookat, const float target[3], float step_s,
	const mat4 *world, struct pose *pose);

#endif
