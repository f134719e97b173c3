/*
 * Morph targets that are key frames of an animation: recognising them, and
 * storing them as such.
 */
#ifndef APP_MODEL_MODEL_KEYS_H
#define APP_MODEL_MODEL_KEYS_H

#include "app/model/model.h"

/*
 * Whether the targets of the node's mesh are used as key frames. Three
 * conditions must hold. There are two targets or more, and at least one clip
 * has weights for the node. In each such clip, weights are linear or in steps,
 * and each moment shows a mix of at most two shapes; a shape is a target or the
 * mesh without targets. This is so if each key shows one target, and if a tool
 * has sampled the way from one target to the next. On average a target moves
 * half of the vertices: targets that each move a small part, as those of a face
 * do, take less memory as weighted targets. The third condition does not count
 * if the file says that the targets are key frames (model_mesh.key_frames), as
 * files of limber compare do.
 */
bool model_has_key_frames(const struct model *model, int node);

/*
 * Stores a primitive's targets as key frames (struct model_keys), to which the
 * deltas of its targets refer from then on. Without rounded, displacements stay
 * the same to the bit. For that the file must have integers, as with
 * KHR_mesh_quantization (positions of one unit, directions in bytes), and all
 * key frames must fit into 16 bits. With rounded, numbers are rounded to 15
 * bits of the box around all key frames. If key frames are not possible, the
 * primitive stays as it is. tangents says whether to store tangents, which only
 * normal maps need. Returns 0 or -ENOMEM.
 */
int model_keys_store(struct model_primitive *primitive, int target_count,
	bool tangents, bool rounded, struct arena *arena);

/*
 * Rounds key frames that the file has as floats to 16 bits (model_keys_store()
 * with rounded) and releases the floats. This is for players whose loops have
 * 16 bits anyway. It leaves out skinned meshes, meshes whose targets are not
 * key frames, and those for which the model's budget has no room. Returns 0, or
 * -ENOMEM after an error on the log if the machine has no memory.
 */
int model_keys_round(struct model *model, const struct log *log);

/* Returns the bytes of all keys. */
size_t model_keys_bytes(const struct model_keys *keys, int target_count);

#endif
