/* Joints of a model that a character file may turn. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_JOINTS_H
#define APP_CHARACTER_SKETCH_SKETCH_JOINTS_H

#include "app/model/model.h"

/*
 * Finds the joints that move most, of those for which may_be_part,
 * [node_count], is true: those with the largest surface of their own. Joints
 * that move nothing, such as the ends of limbs in many exports, are left out.
 * Fills node[most] in the model's order and *count. Returns 0 or -ENOMEM.
 */
int sketch_find_joints(const struct model *model, const bool *may_be_part,
	int most, int *node, int *count);

#endif
