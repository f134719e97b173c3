/*
 * The heights of uneven ground that a model has itself: a grid of nodes over
 * the ground's box, between which heights are interpolated.
 *
 * The grid is made once, from the triangles of the rest pose. A look-up takes
 * the same time for any ground.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_RELIEF_H
#define APP_SCENE_SHADOW_SHADOW_RELIEF_H

#include "app/scene/instance/instance.h"

enum {
	SHADOW_RELIEF_NODES = 64 /* on each side */
};

/* Scene units. height is NULL if there is no relief. */
struct shadow_relief {
	float low[2];  /* x, z of the first node */
	float cell[2]; /* distances of neighbouring nodes along x and z */
	float y;       /* the mean height */
	float error;   /* by which the ground's vertices are off the grid */
	float (*height)[SHADOW_RELIEF_NODES]; /* [z][x] */
};

/*
 * Makes the relief of these drawables of the instance, as it is posed now; the
 * higher surface counts. Memory comes from the instance's arena. Returns 0 or
 * -ENOMEM.
 */
int shadow_relief_make(struct shadow_relief *relief, struct instance *instance,
	const int *drawable, int count);

/* Returns the height at a point; outside the box that of the nearest edge. */
float shadow_relief_height(const struct shadow_relief *relief, float x, float z);

/*
 * Moves a point on the relief towards the eye, which leaves its place in the
 * picture as it is, so far that the ground's triangles do not hide it.
 */
void shadow_relief_lift(
	const struct shadow_relief *relief, const float eye[3], float point[3]);

#endif
