/* How parts of a model turn: wheels, needles, doors, rods. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_TURN_H
#define APP_CHARACTER_SKETCH_SKETCH_TURN_H

#include "app/model/model.h"

enum sketch_turn_form {
	/* none of these */
	SKETCH_TURN_FREE,
	/* around its pivot: flat and about as wide as long, or round */
	SKETCH_TURN_DISC,
	/* long and narrow, its pivot within it: flat, or over a disc */
	SKETCH_TURN_NEEDLE,
	/* flat, its pivot at an edge, as a door's, a flap's or a wing's */
	SKETCH_TURN_HINGE,
	/* long and narrow, its pivot within it, and not flat */
	SKETCH_TURN_ROD
};

/*
 * An axis of a node's frame, the axis of the model at rest to which it is
 * nearest, and 1 or, if it points the other way, -1.
 */
struct sketch_turn_axis {
	int axis, seen, sign;
};

struct sketch_turn {
	enum sketch_turn_form form;
	/*
	 * About which a disc, a needle or a hinge turns; along a rod, towards
	 * the end that is farther from its pivot. That of x if free.
	 */
	struct sketch_turn_axis axis;
	/*
	 * About which a rod swings: first in the upright plane that goes
	 * through it, of an upright rod forward and back, then across it.
	 */
	struct sketch_turn_axis across[2];
};

/*
 * Judges the form of what each node turns, around the node's origin: its rigid
 * mesh or, if it has none, those of its children. A flat part turns in its
 * plane, and a round one, such as a thick wheel, about its axle. A node is also
 * a disc if all that hangs on it hangs around one of its axes at equal angles,
 * as the blades of a turbine do. Fills turn[node_count]. Returns 0 or -ENOMEM.
 */
int sketch_find_turns(const struct model *model, struct sketch_turn *turn);

#endif
