/*
 * Recognises morph targets that are key frames of an animation.
 */
#ifndef APP_MODEL_MODEL_KEYS_H
#define APP_MODEL_MODEL_KEYS_H

#include "app/model/model.h"

/*
 * Whether the targets of the node's mesh are key frames: in each clip that has
 * weights for the node, each moment shows a mix of at most two shapes, which are
 * the targets and the mesh without them, and values change linearly or in steps.
 * So it is where each key shows one target, and where a tool has sampled the way
 * from one target to the next, eased or not. At least one clip must have such
 * weights, there must be two targets or more, and on average a target must move
 * half of the vertices: targets that each move a small part, as those of a face
 * do, take less memory as weighted targets.
 */
bool model_has_key_frames(const struct model *model, int node);

#endif
