/*
 * A primitive's weighted morph targets, laid out for the fixed-point loops.
 *
 *   load:   fixed_morph_init(&morph, primitive, target_count, FIXED_NORMALS,
 *               &arena)
 *   frame:  run/fixed_morph_run.h
 *
 * Targets are stored in pairs, so that one multiplication weighs both. A pair
 * has only the vertices that it moves, in spans; a pair without weight costs
 * nothing. Vertices come out in the primitive's order and, with placement, in
 * the primitive's unit.
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_MORPH_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_MORPH_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"

/* Consecutive vertices; their pairs begin at pair[first_pair]. */
struct fixed_span {
	int first, count;
	int first_pair;
};

/* Two targets' deltas of one attribute. */
struct fixed_deltas {
	int span_count;
	const struct fixed_span *span;
	struct fixed_pair (*pair)[3];
	float scale[2]; /* what a weight of 1 adds, in the attribute's unit */
	struct fixed_weights weights; /* of the frame */
};

struct fixed_morph_stream {
	struct fixed_vector *base;   /* [vertex_count]; NULL: not wanted */
	struct fixed_deltas *deltas; /* [pair_count] */
	float unit_at_1; /* the number that 1 becomes, at weight limit 1 */
	float unit;      /* and at the present one */
};

struct fixed_morph {
	const struct model_primitive *primitive;
	int vertex_count, target_count, pair_count;
	float weight_limit; /* weights from -limit to limit fit; 1 at first */
	struct fixed_placement placement; /* of positions */
	struct fixed_morph_stream stream[FIXED_ATTRIBUTES];
};

/*
 * streams (enum fixed_streams) says which directions to morph besides
 * positions; the primitive must have them. Without targets, stream[].base is
 * the primitive itself in fixed point. 0; -ENOMEM; -ERANGE if coordinates are
 * not finite numbers of sensible size: such a primitive is posed in float.
 */
int fixed_morph_init(struct fixed_morph *morph,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena);

/*
 * Writes the base vectors again for another weight limit, a power of two. A
 * larger limit makes all numbers coarser.
 */
void fixed_morph_set_limit(struct fixed_morph *morph, float weight_limit);

/* Bytes of base vectors, pairs and spans, for reports. */
size_t fixed_morph_bytes(const struct fixed_morph *morph);

#endif
