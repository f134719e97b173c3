/* What a node of a model turns, around the node's origin. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_BODY_H
#define APP_CHARACTER_SKETCH_SKETCH_BODY_H

#include "app/scene/instance/bounds.h"

/* In the node's frame. */
struct sketch_body {
	struct bounds box;
	float reach[3]; /* how far a vertex is from each axis, squared */
};

/*
 * Measures what each node turns: its rigid mesh or, if it has none, those of
 * its children. Fills body[node_count]; the box of a node that turns nothing
 * is empty.
 */
void sketch_measure_bodies(const struct model *model, struct sketch_body *body);

/* The length of a box along an axis. */
float sketch_side(const struct bounds *box, int axis);

/* Where the pivot is along an axis: 0 at the lower side, 1 at the upper one. */
float sketch_pivot(const struct bounds *box, int axis);

/*
 * Whether both sides of the pivot have at least this part of the box. Nothing
 * is within a box without length.
 */
bool sketch_is_pivot_within(const struct bounds *box, int axis, float part);

#endif
