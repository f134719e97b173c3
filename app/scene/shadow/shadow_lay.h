/*
 * Points of a shadow on uneven ground: where the light through points of a
 * figure meets it.
 *
 * Where it does depends only on where the light would meet level ground. For
 * many points it is found at the nodes of a grid there, and between them by
 * interpolation.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_LAY_H
#define APP_SCENE_SHADOW_SHADOW_LAY_H

#include "app/scene/stage/floor.h"

enum {
	SHADOW_NODES_MAX = 1024
};

/* Scene units. */
struct shadow_light {
	float towards[3]; /* unit vector to the light, towards[1] > 0 */
	float eye[3];
	const struct floor *ground;
};

/* What is kept for the grid, of which node_count are in use; 0 without one. */
struct shadow_grid {
	float (*node)[3]; /* [SHADOW_NODES_MAX] */
	int node_count;
};

/*
 * Moves points down the light to the ground, and towards the eye by as much as
 * keeps the ground's triangles from hiding them; what a grid adds to their
 * error is less than a hundredth of the waves' height. Adds a box around the
 * results to box.
 */
void shadow_lay(struct shadow_grid *grid, const struct shadow_light *light,
	const float (*from)[3], int count, float (*to)[3], struct bounds *box);

#endif
