/* Nodes of a model that a character file may turn. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_PARTS_H
#define APP_CHARACTER_SKETCH_SKETCH_PARTS_H

#include "app/character/sketch/sketch_turn.h"

#include <stdio.h>

enum {
	/*
	 * If a model has more, the first parts are taken, or the joints that
	 * move most.
	 */
	SKETCH_PARTS = 12
};

/* What buttons do that move the camera. */
#define SKETCH_CAMERA_UP   "camera tilt 80 \"tilt the camera up\""
#define SKETCH_CAMERA_DOWN "camera tilt -80 \"tilt the camera down\""
#define SKETCH_CAMERA_TILTS \
	"UP = " SKETCH_CAMERA_UP "\nDOWN = " SKETCH_CAMERA_DOWN "\n"
#define SKETCH_CAMERA_TURNS                                 \
	"LEFT = camera turn -80 \"turn the camera left\"\n" \
	"RIGHT = camera turn 80 \"turn the camera right\"\n"

struct sketch_parts {
	int node[SKETCH_PARTS];
	struct sketch_turn turn[SKETCH_PARTS];
	int count;
	bool bones; /* the parts are joints of skins */
	/* buttons move them; else they are suggestions in comments */
	bool moved;
};

/*
 * Finds the rigid parts that have a name that a file can hold: nodes with a
 * mesh, or the node without one that such meshes turn on. First come needles
 * on which no other part hangs, then all others in the model's order. If
 * nothing else moves the model (still), buttons are to move the parts, provided
 * that one of them hangs on another, or that one of several is such a needle,
 * or a disc as of a wheel; otherwise joints take their place, if there are any.
 * is_joint, [node_count], says which nodes are joints, is_named which can be
 * named (sketch_find_named_nodes()). Returns 0 or -ENOMEM.
 */
int sketch_find_parts(const struct model *model, const bool *is_joint,
	const bool *is_named, bool still, struct sketch_parts *out);

/* Writes a section [part] for each, in comments if buttons do not move them. */
void sketch_write_parts(
	const struct model *model, const struct sketch_parts *parts, FILE *out);

/*
 * Writes what the arrows do while the parameter arrows chooses one part. Those
 * that do not turn a disc, a needle or a hinge move the camera.
 */
void sketch_write_part_buttons(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out);

#endif
