/*
 * How a clip moves over the ground, measured from the vertices that touch it.
 */
#ifndef APP_DEMO_GAIT_H
#define APP_DEMO_GAIT_H

#include "app/scene/instance/instance.h"

/* All in scene units, along x and z. */
struct gait {
	float velocity[2]; /* of the figure over the ground, a second */
	float drift[2]; /* how far the clip itself carries the figure from its
			   start to its end; 0 0 for one on the spot */
};

/*
 * Measures a clip with a duration at steps + 1 times. Where the lowest vertices
 * stand on the ground, the figure moves against them. Poses the instance.
 */
struct gait gait_measure(struct instance *instance, int clip, int steps);

/* The length of the velocity. */
float gait_speed(const struct gait *gait);

#endif
