/* Parts that hang around an axis, as the blades of a turbine do. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_RING_H
#define APP_CHARACTER_SKETCH_SKETCH_RING_H

#include "app/character/sketch/sketch_body.h"

/*
 * Finds the nodes on which three parts or more hang, and nothing else, in a
 * ring: each is the first one turned by another multiple of the same part of a
 * turn. axis[node_count] is the ring's axis in the node's frame, or -1.
 * body[node_count] is what the nodes turn. Returns 0 or -ENOMEM.
 */
int sketch_find_rings(
	const struct model *model, const struct sketch_body *body, int *axis);

#endif
