/* How flat parts of a model turn: wheels, needles, the hands of a clock. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_TURN_H
#define APP_CHARACTER_SKETCH_SKETCH_TURN_H

#include "app/model/model.h"

enum sketch_turn_form {
	SKETCH_TURN_FREE, /* not flat, or its pivot is at an edge, as a door's */
	SKETCH_TURN_DISC,  /* flat, about as wide as long, around its pivot */
	SKETCH_TURN_NEEDLE /* flat, long and narrow, its pivot within it */
};

struct sketch_turn {
	enum sketch_turn_form form;
	int axis; /* of the node's frame, across the flat side; 0 if free */
	/*
	 * The axis of the model at rest to which it is nearest, and 1 or, if it
	 * points the other way, -1.
	 */
	int seen, sign;
};

/*
 * Judges the form of what each node turns: its rigid mesh or, if it has none,
 * those of its children, around the node's origin. A flat part turns in its
 * plane. Fills turn[node_count]. Returns 0 or -ENOMEM.
 */
int sketch_find_turns(const struct model *model, struct sketch_turn *turn);

#endif
