/* Nodes of a model that a character file may turn. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_PARTS_H
#define APP_CHARACTER_SKETCH_SKETCH_PARTS_H

#include "app/model/model.h"

#include <stdio.h>

enum {
	SKETCH_PARTS = 12 /* of a model that has more, the first ones */
};

struct sketch_parts {
	int node[SKETCH_PARTS];
	int count;
	bool moved; /* buttons move them; else they are suggestions */
};

/*
 * Finds nodes with a name that a file can hold: rigid parts. Where nothing
 * moves the model, buttons are to move them if one part hangs on another; and
 * without rigid parts, joints. is_joint has an entry a node.
 */
void sketch_find_parts(const struct model *model, const bool *is_joint,
	bool still, struct sketch_parts *out);

/* Writes a section for each. */
void sketch_write_parts(
	const struct model *model, const struct sketch_parts *parts, FILE *out);

/* Writes what the arrows do with one part while the parameter arrows chooses it. */
void sketch_write_part_buttons(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out);

#endif
