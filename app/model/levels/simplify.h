/*
 * Simplification of a triangle list by edge collapses.
 *
 * A collapse moves all triangles of a vertex to a neighbour, so the result is a
 * shorter list over the same vertices, and every coarser list uses a subset of
 * the vertices of the finer ones. Vertices at one position, which differ in
 * their normals or texture coordinates, collapse together along their seam.
 *
 * The order of collapses is that of their error: the distance from the planes of
 * the triangles that a vertex stands for (Garland and Heckbert, Surface
 * Simplification Using Quadric Error Metrics, 1997), and what the attributes of
 * the removed vertex differ from those that are interpolated where it was,
 * converted to distances (simplify_error.c). Lengths are fractions of
 * an extent: the longest side of all primitives that belong together.
 */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_H
#define APP_MODEL_LEVELS_SIMPLIFY_H

#include "app/model/model.h"

/* A sum of squared distances from planes: v'Av + 2 b'v + c, and its weight. */
struct simplify_quadric {
	float xx, yy, zz, xy, xz, yz;
	float x, y, z, constant;
	float weight;
};

struct simplify_collapse {
	uint32_t from, to;
	float error;
};

/* What is known of a leader's best collapse since its triangles changed. */
enum simplify_known {
	SIMPLIFY_NOTHING,
	SIMPLIFY_BOUND,
	SIMPLIFY_BEST,
};

/* A target's displacements as floats, or NULL. */
struct simplify_target {
	const float (*position)[3], (*normal)[3];
};

struct simplify {
	struct arena arena; /* of all that follows */
	const struct model_primitive *primitive;
	int target_count;
	struct simplify_target *target; /* [target_count] */
	bool shape_only;

	float (*position)[3]; /* in fractions of the extent */
	float extent;
	float texture_scale; /* what a unit of texture coordinates covers */

	int index_count;
	uint32_t *index;

	/* A vertex stands for those at its position: the leader. */
	uint32_t *leader;
	uint32_t *next; /* a ring of the vertices with one leader */
	bool *locked;   /* by leader, as what follows */
	struct simplify_quadric *quadric;

	/* For each leader the triangles that have it as a corner. */
	uint32_t *first_triangle; /* [vertex_count + 1] */
	uint32_t *triangle;       /* [index_count], by their first corner */

	/*
	 * The best collapse of each leader, to itself if it has none. While
	 * only its shape is known, the error is a lower bound.
	 */
	struct simplify_collapse *best;
	uint8_t *known; /* by leader: enum simplify_known */

	/* Of a pass. */
	struct simplify_collapse *collapse;
	uint32_t *to;  /* where each vertex goes: itself, or its neighbour */
	bool *touched; /* by leader */
	uint32_t *mark;
	uint32_t mark_value;
};

/* What to simplify. */
struct simplify_input {
	const struct model_primitive *primitive; /* with normals */
	int target_count;                        /* its mesh's */
	const uint32_t *index;                   /* of the list to begin with */
	int index_count;
	float extent;       /* what lengths are fractions of, more than 0 */
	const bool *shared; /* by vertex: it stays as it is */
	bool shape_only;    /* shading does not count, for lists for shadows */
};

/*
 * Begins with the input's list. Memory comes from the budget, which may be
 * NULL. 0 or -ENOMEM; after either the caller ends it by simplify_end().
 */
int simplify_begin(struct simplify *simplify,
	const struct simplify_input *input, struct memory_budget *budget);

/*
 * Collapses until each further collapse would have a larger error than the
 * limit, a fraction of the extent. index and index_count are the result.
 */
void simplify_until(struct simplify *simplify, float limit);

void simplify_end(struct simplify *simplify);

#endif
