/*
 * A primitive's weighted targets in fixed point.
 *
 *   load:   fixed_morph_init(&morph, primitive, target_count, FIXED_NORMALS,
 *               &arena)
 *   frame:  fixed_morph_set_weights(&morph, weight)
 *           fixed_morph_run(&morph, loops, FIXED_POSITION, position)
 *           fixed_morph_run(&morph, loops, FIXED_NORMAL, normal)
 *           positions are to be taken by morph.placement
 *
 * Targets are kept two by two, so that one multiplication weighs both. Of a
 * pair only the vertices are kept that it moves, and a pair without weight
 * costs nothing. Vertices come out in the primitive's order, in the
 * primitive's unit.
 */
#ifndef APP_ANIM_KERNEL_FIXED_MORPH_H
#define APP_ANIM_KERNEL_FIXED_MORPH_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"

/* Vertices in a row; their pairs begin at pair[first_pair]. */
struct fixed_span {
	int first, count;
	int first_pair;
};

/* Two targets' deltas of one attribute. */
struct fixed_deltas {
	int span_count;
	const struct fixed_span *span;
	struct fixed_pair (*pair)[3];
	float scale[2]; /* of what a weight of 1 adds, in the numbers' unit */
	struct fixed_weights weights; /* this frame's */
};

struct fixed_morph_stream {
	struct fixed_vector *base;   /* [vertex_count], or NULL: not wanted */
	struct fixed_deltas *deltas; /* [pair_count] */
	float fits;                  /* the numbers that 1 is, at reach 1 */
	float unit;                  /* and at the present reach */
};

struct fixed_morph {
	const struct model_primitive *primitive;
	int vertex_count, target_count, pair_count;
	float reach; /* weights from -reach to reach fit; 1 at first */
	struct fixed_placement placement; /* of positions */
	struct fixed_morph_stream stream[FIXED_ATTRIBUTES];
};

/*
 * streams (enum fixed_streams) says which directions are wanted besides
 * positions; the primitive must have them. 0; -ENOMEM; -ERANGE for what are
 * not finite numbers of sensible size: such a primitive stays in float.
 */
int fixed_morph_init(struct fixed_morph *morph,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena);

/*
 * The frame's weights, target_count of them. Those beyond reach make all
 * numbers coarser for good, which takes about as long as a frame in float. 0,
 * or -ERANGE for weights beyond 1024 and for NaN; nothing has changed then.
 */
int fixed_morph_set_weights(struct fixed_morph *morph, const float *weight);

/* One attribute: base + weight * delta, vertex_count vectors. */
void fixed_morph_run(const struct fixed_morph *morph,
	const struct fixed_loops *loops, enum fixed_attribute attribute,
	struct fixed_vector *out);

/* Bytes of base vectors, pairs and spans, for reports. */
size_t fixed_morph_bytes(const struct fixed_morph *morph);

#endif
