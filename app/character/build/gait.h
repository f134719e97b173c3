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

struct gait_point {
	int node, vertex;
	const struct model_primitive *primitive;
	struct character_sole sole; /* without morph targets */
};

/* Vertices of a model, evenly spread. */
struct gait_body {
	int count;
	struct gait_point point[GAIT_POINTS_MAX];
};

/* All in metres, along x and z unless it says so. */
struct gait {
	/* Of the figure over the ground, m/s; 0 0 for a figure that stands. */
	float velocity[2];
	/*
	 * How far the clip itself carries the figure from its start to its end;
	 * 0 0 for a clip on the spot.
	 */
	float drift[2];
	float extent; /* the longest side of the figure's box at the start */
	/*
	 * How far the points end from where they started, on average and
	 * without the drift: near 0 for a clip that can be repeated.
	 */
	float gap;
	/*
	 * The height of its lowest point at steps + 1 equal times of a clip
	 * that climbs or falls by more than half the figure's height, above
	 * that at the start; steps is 0 for other clips.
	 */
	int steps;
	float rise[GAIT_STEPS_MOST + 1];
};

/*
 * Chooses at most GAIT_POINTS_MAX vertices of the model, which must outlive the
 * body.
 */
void gait_body_make(struct gait_body *body, const struct model *model);

/* Returns in how many steps to measure each clip of a model with this many. */
int gait_steps_for(int clip_count);

/*
 * Measures a clip at steps + 1 times. Points that touch the ground stand still
 * on it, so the figure moves opposite to their motion in the clip. A direction
 * close to an axis is replaced by that axis. Changes the instance's pose and
 * world matrices. The result is all zero for a clip below 0 or without a
 * duration.
 */
struct gait gait_measure(const struct gait_body *body,
	struct instance *instance, int clip, int steps);

#endif
