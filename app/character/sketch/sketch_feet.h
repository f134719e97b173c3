/* Legs of a model that a character file may let stand on the ground. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_FEET_H
#define APP_CHARACTER_SKETCH_SKETCH_FEET_H

#include "app/model/model.h"

#include <stdio.h>

/*
 * Writes a section [feet], in comments, for each pair of legs that is found at
 * rest: chains of two bones that hang from the same one, mirror each other and
 * end near the lowest joint. is_joint, [node_count], says which nodes are
 * joints, is_named which can be named (sketch_find_named_nodes()); world,
 * [node_count], has their places at rest.
 */
void sketch_write_feet(const struct model *model, const bool *is_joint,
	const bool *is_named, const mat4 *world, FILE *out);

#endif
