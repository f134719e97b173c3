/*
 * Simplification of a triangle list by edge collapses.
 *
 * A collapse moves the corners of all triangles at a vertex to a neighbour. So
 * the result is a shorter list over the same vertices, and every coarser list
 * uses a subset of the vertices of the finer ones. Vertices at one position,
 * which differ in their normals or texture coordinates, collapse together along
 * their seam. One of them, their leader, represents them.
 *
 * Collapses of small error come first. The error has two parts: the distance
 * from the planes of all triangles that the vertex has replaced so far (Garland
 * and Heckbert, Surface Simplification Using Quadric Error Metrics, 1997), and
 * the difference between the attributes of the removed vertex and those that
 * are then interpolated at its place, converted to a distance
 * (simplify_error.c). Lengths are fractions of an extent: the longest side of
 * the box around all primitives that belong together.
 */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_H
#define APP_MODEL_LEVELS_SIMPLIFY_H

#include "app/model/model.h"

/*
 * A weighted sum of squared distances from planes, v'Av + 2 b'v + c with A in
 * xx..yz, b in x..z and c in constant, and the sum of the weights.
 */
struct simplify_quadric {
	float xx, yy, zz, xy, xz, yz;
	float x, y, z, constant;
	float weight;
};

struct simplify_collapse {
	uint32_t from, to;
	float error;
};

/*
 * What is known of a leader's best collapse: SIMPLIFY_NOTHING after its
 * triangles changed, SIMPLIFY_BOUND if best.error is only a lower bound,
 * SIMPLIFY_BEST if best is computed.
 */
enum simplify_known {
	SIMPLIFY_NOTHING,
	SIMPLIFY_BOUND,
	SIMPLIFY_BEST,
};

/* A target's displacements as floats; either may be NULL. */
struct simplify_target {
	const float (*position)[3], (*normal)[3];
};

struct simplify {
	struct arena arena; /* owns all arrays below */
	const struct model_primitive *primitive;
	int target_count;
	struct simplify_target *target; /* [target_count] */
	const uint32_t *source; /* NULL, or the vertices' numbers in targets */
	bool shape_only;
	bool divided; /* most positions have several vertices, to be merged */

	float (*position)[3]; /* in fractions of the extent */
	float extent;
	float texture_scale; /* length that a unit of texture coordinates covers
				on average, in fractions of the extent */

	int index_count;
	uint32_t *index;

	/*
	 * Arrays below are [vertex_count] unless they say otherwise. leader[]
	 * is the vertex that represents all vertices at the same position.
	 */
	uint32_t *leader;
	uint32_t *next; /* links the vertices of one leader in a ring */
	bool *locked;   /* [leader]: it may not collapse */
	struct simplify_quadric *quadric;

	/*
	 * The triangles that have a leader as a corner are triangle[i] for i
	 * from first_triangle[leader] to first_triangle[leader + 1] - 1.
	 */
	uint32_t *first_triangle; /* [vertex_count + 1] */
	uint32_t *triangle;       /* [index_count]: places in index[] of first
				     corners */

	/* [leader]: its best collapse, to itself if it has none. */
	struct simplify_collapse *best;
	uint8_t *known; /* [leader]: enum simplify_known */

	/* Used during a pass. */
	struct simplify_collapse *collapse;
	uint32_t *to;  /* the vertex that each vertex collapses to, or itself */
	bool *touched; /* [leader]: a collapse of this pass has changed it */
	uint32_t *mark;
	uint32_t mark_value;
};

/* The list to simplify, with its vertices. */
struct simplify_input {
	const struct model_primitive *primitive; /* with normals, if shaded */
	int target_count;                        /* morph targets of its mesh */
	const uint32_t *index;                   /* the list to begin with */
	int index_count;
	float extent;       /* length that counts as 1, above 0 */
	const bool *shared; /* [vertex_count]: the vertex must stay */
	/*
	 * NULL, or [vertex_count]: the vertex of `whole` of which each is a copy.
	 * Then the targets are those of that primitive, without their normals.
	 */
	const uint32_t *source;
	const struct model_primitive *whole;
	bool shape_only; /* ignore shading, for lists for shadows */
};

/*
 * Begins with the input's list. The input's arrays must stay valid. Memory
 * comes from the budget, which may be NULL. Returns 0, -ENOMEM or -EINTR
 * (base/interrupt.h); in all cases the caller calls simplify_end().
 */
int simplify_begin(struct simplify *simplify,
	const struct simplify_input *input, struct memory_budget *budget);

/*
 * Collapses until every further collapse would have a larger error than limit,
 * a fraction of the extent, or hardly any is left. The result is in index and
 * index_count. May be called again with a larger limit.
 */
void simplify_until(struct simplify *simplify, float limit);

void simplify_end(struct simplify *simplify);

#endif
