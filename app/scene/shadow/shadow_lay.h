/*
 * Points of a shadow on uneven ground: where the light through points of a
 * figure meets the ground.
 *
 * Such a point depends only on where the light would meet level ground. For
 * many points, the nodes of a grid on level ground are laid upon the uneven
 * ground, and the points are interpolated between them.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_LAY_H
#define APP_SCENE_SHADOW_SHADOW_LAY_H

#include "app/scene/shadow/shadow_relief.h"
#include "app/scene/stage/floor.h"

enum {
	SHADOW_NODES_MAX = 1024
};

/* Scene units. */
struct shadow_light {
	float towards[3]; /* unit vector to the light, towards[1] > 0 */
	float eye[3];
	const struct floor *ground;
	const struct shadow_relief *relief; /* replaces ground; or NULL */
};

/* Memory for the grid's nodes, of which node_count are in use; 0: no grid. */
struct shadow_grid {
	float (*node)[3]; /* [SHADOW_NODES_MAX] */
	int node_count;
};

/*
 * Moves points down the light to the ground, and towards the eye by as much as
 * keeps the ground's triangles from hiding them; a grid adds an error of less
 * than a hundredth of the waves' height. Adds a box around the results to box.
 */
void shadow_lay(struct shadow_grid *grid, const struct shadow_light *light,
	const float (*from)[3], int count, float (*to)[3], struct bounds *box);

#endif
