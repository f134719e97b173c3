/*
 * How a clip moves over the ground, measured from the vertices that touch it.
 */
#ifndef APP_CHARACTER_BUILD_GAIT_H
#define APP_CHARACTER_BUILD_GAIT_H

#include "app/character/run/sole.h"

enum {
	GAIT_POINTS_MAX = 512,
	GAIT_STEPS_MOST = 20
};

/* Vertices of a model, evenly spread. */
struct gait_body {
	int count;
	struct character_sole point[GAIT_POINTS_MAX];
};

/* All in metres, along x and z. */
struct gait {
	/* Of the figure over the ground, a second; 0 0 for one that stands. */
	float velocity[2];
	/*
	 * How far the clip itself carries the figure from its start to its end;
	 * 0 0 for one on the spot.
	 */
	float drift[2];
};

void gait_body_make(struct gait_body *body, const struct model *model);

/* Returns in how many steps to measure each of so many clips. */
int gait_steps_for(int clip_count);

/*
 * Measures a clip at steps + 1 times. Where the lowest points stand on the
 * ground, the figure moves against them. A direction near to an axis is that
 * axis. Changes the instance's pose and its nodes. A clip below 0, or without a
 * duration, stands.
 */
struct gait gait_measure(const struct gait_body *body,
	struct instance *instance, int clip, int steps);

#endif
