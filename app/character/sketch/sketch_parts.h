/* Nodes of a model that a character file may turn. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_PARTS_H
#define APP_CHARACTER_SKETCH_SKETCH_PARTS_H

#include "app/model/model.h"

#include <stdio.h>

enum {
	/*
	 * If a model has more, the first parts are taken, or the joints that
	 * move most.
	 */
	SKETCH_PARTS = 12
};

struct sketch_parts {
	int node[SKETCH_PARTS];
	int count;
	bool bones; /* the parts are joints of skins */
	/* buttons move them; else they are suggestions in comments */
	bool moved;
};

/*
 * Finds the rigid parts that have a name that a file can hold: nodes with a
 * mesh, or the node without one that such meshes turn on. If nothing else
 * moves the model (still), buttons are to move the parts, provided that one of
 * them hangs on another; otherwise joints take their place, if there are any.
 * is_joint, [node_count], says which nodes are joints, is_named which can be
 * named (sketch_find_named_nodes()). Returns 0 or -ENOMEM.
 */
int sketch_find_parts(const struct model *model, const bool *is_joint,
	const bool *is_named, bool still, struct sketch_parts *out);

/* Writes a section [part] for each, in comments if buttons do not move them. */
void sketch_write_parts(
	const struct model *model, const struct sketch_parts *parts, FILE *out);

/* Writes what the arrows do with one part while the parameter arrows chooses it. */
void sketch_write_part_buttons(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out);

#endif
