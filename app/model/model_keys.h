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
 * of a face do, take less memory as weighted targets. Files of limber compare
 * say of a mesh that its targets are key frames, however few vertices move,
 * because it has predicted what key frames cost (model_mesh.key_frames).
 */
bool model_has_key_frames(const struct model *model, int node);

/*
 * Stores a primitive's targets as key frames (struct model_keys), which its
 * targets refer to from then on. Unless rounded is set, their displacements
 * stay the same to the bit; the file must have integers for that, as files with
 * KHR_mesh_quantization have, and 16 bits must hold all of them: positions of
 * one unit and directions in bytes. With rounded, numbers are rounded to 15
 * bits of the box around all key frames. The primitive stays as it is if this
 * cannot be. Tangents are needed for normal maps only. 0 or -ENOMEM.
 */
int model_keys_store(struct model_primitive *primitive, int target_count,
	bool tangents, bool rounded, struct arena *arena);

/*
 * Stores key frames that the file has as floats in 16 bits too, each number
 * rounded to 15 bits of the box around all of them, and releases the floats:
 * for a player whose loops have 16 bits anyway. Skinned meshes and those with
 * other weights stay as they are, and so does what the model's budget has no room
 * for. 0, or -ENOMEM after an error on the log when the machine has no memory.
 */
int model_keys_round(struct model *model, const struct log *log);

/* The memory of the keys. */
size_t model_keys_bytes(const struct model_keys *keys, int target_count);

#endif
