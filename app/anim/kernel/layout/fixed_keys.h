/*
 * A primitive's morph targets as key frames, for the loop lerp_keys().
 *
 *   load:   fixed_keys_init(&keys, primitive, target_count, FIXED_NORMALS,
 *               &arena)
 *   frame:  run/fixed_keys_run.h
 *
 * This is for targets that a clip shows one after the other, each at its full
 * weight (model_keys.h). Each target is stored as the vertices at its full
 * weight, 6 bytes a vertex and attribute, so a frame reads only two of them.
 * fixed_morph.h is for targets that are mixed. If the file has integers, the
 * model may hold its targets in this format (struct model_keys); then nothing
 * is copied, and all instances share the model's arrays.
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_KEYS_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_KEYS_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"

struct fixed_keys {
	int vertex_count;
	int stride; /* vertices from one key to the next: vertex_count, rounded
		       up to an even number */
	int target_count;
	struct fixed_placement placement; /* of positions */
	/*
	 * Key 0 is the primitive without targets, key 1 + t is target t. [1 +
	 * target_count][stride]; NULL: this attribute is not kept. The arena or
	 * the model owns the arrays.
	 */
	const struct fixed_key *key[FIXED_ATTRIBUTES];
};

/*
 * streams (enum fixed_streams) says which directions to keep besides positions;
 * the primitive must have them. Returns 0, -ENOMEM, or -ERANGE if coordinates
 * are not finite or not below 1e18.
 */
int fixed_keys_init(struct fixed_keys *keys,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena);

/* Converts vectors to the format of keys; numbers are clamped to 15 bits. */
void fixed_keys_convert(int count, const float (*vector)[3],
	const struct fixed_placement *placement, struct fixed_key *out);

/* The placement of directions: a length of 1 becomes 16383. */
extern const struct fixed_placement fixed_keys_directions;

/* Bytes of all keys, for reports. */
size_t fixed_keys_bytes(const struct fixed_keys *keys);

#endif
