/*
 * Morph targets that are key frames of an animation: recognising them, and
 * storing them as such.
 */
#ifndef APP_MODEL_MODEL_KEYS_H
#define APP_MODEL_MODEL_KEYS_H

#include "app/model/model.h"

/*
 * Whether the targets of the node's mesh are key frames: in each clip that has
 * weights for the node, each moment shows a mix of at most two shapes, which
 * are the targets and the mesh without them, and values change linearly or in
 * steps. So it is where each key shows one target, and where a tool has sampled
 * the way from one target to the next, eased or not. At least one clip must
 * have such weights, there must be two targets or more, and on average a target
 * must move half of the vertices: targets that each move a small part, as those
 * of a face do, take less memory as weighted targets.
 */
bool model_has_key_frames(const struct model *model, int node);

/*
 * Stores a primitive's targets as key frames (struct model_keys), which its
 * targets refer to from then on, with the same displacements to the bit. It is
 * done only if the file has integers, as files with KHR_mesh_quantization have,
 * and 16 bits hold all of them: positions of one unit and directions in bytes.
 * Else the primitive stays as it is. Tangents are needed for normal maps only.
 * 0 or -ENOMEM.
 */
int model_keys_store(struct model_primitive *primitive, int target_count,
	bool tangents, struct arena *arena);

/* The memory of the keys. */
size_t model_keys_bytes(const struct model_keys *keys, int target_count);

#endif
