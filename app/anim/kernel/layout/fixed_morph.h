/*
 * A primitive's weighted morph targets, laid out for the fixed-point loops.
 *
 *   load:   fixed_morph_init(&morph, primitive, target_count, FIXED_NORMALS,
 *               &arena)
 *   frame:  run/fixed_morph_run.h
 *
 * Targets are stored in pairs, so that one SMLAD weighs both. A pair has only
 * the vertices that it moves, in spans; a pair whose weights are 0 is skipped.
 * Vertices come out in the primitive's order and, with placement, in the
 * primitive's unit.
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_MORPH_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_MORPH_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"

/*
 * Consecutive vertices that a pair of targets moves. Their deltas begin at
 * fixed_deltas.pair[first_pair].
 */
struct fixed_span {
	int first, count;
	int first_pair;
};

/* A pair of targets: their deltas of one attribute. */
struct fixed_deltas {
	int span_count;
	const struct fixed_span *span;
	struct fixed_pair (*pair)[3];
	float scale[2]; /* weights = target's weight * scale * stream's unit */
	struct fixed_weights weights; /* those of the present frame */
};

struct fixed_morph_stream {
	struct fixed_vector *base;   /* [vertex_count]; NULL: this attribute is
					not morphed */
	struct fixed_deltas *deltas; /* [pair_count] */
	float unit_at_1; /* the integer that 1 becomes at weight limit 1 */
	float unit;      /* the same at the present weight limit */
};

struct fixed_morph {
	const struct model_primitive *primitive;
	int vertex_count, target_count, pair_count;
	float weight_limit; /* the largest |weight| that fits; 1 at first */
	struct fixed_placement placement; /* of positions */
	struct fixed_morph_stream stream[FIXED_ATTRIBUTES];
};

/*
 * streams (enum fixed_streams) says which directions to morph besides
 * positions; the primitive must have them. target_count may be 0; then
 * stream[].base is the primitive itself in fixed point. Returns 0, -ENOMEM, or
 * -ERANGE if coordinates are not finite or not below 1e18: the caller poses
 * such a primitive in float.
 */
int fixed_morph_init(struct fixed_morph *morph,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena);

/*
 * Writes the base vectors again for another weight limit, a power of two. With
 * a larger limit, the unit and so the precision of all numbers is smaller.
 */
void fixed_morph_set_limit(struct fixed_morph *morph, float weight_limit);

/* Bytes of base vectors, pairs and spans, for reports. */
size_t fixed_morph_bytes(const struct fixed_morph *morph);

#endif
