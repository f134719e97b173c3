/*
 * A candidate of rigid parts on pivots: AN4044's hierarchical technique
 * (section 2), with the joints as pivots.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_RIGID_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_RIGID_H

#include "app/compare/candidate/candidate.h"

/* The triangles of one primitive that move with one node. */
struct rigid_part {
	int node;
	int first_vertex, vertex_count;
	int first_index, index_count;
	int part; /* of the reference, which gives material and normals */
};

/* Positions and normals are in the space of the node that moves them. */
struct rigid_bake {
	struct arena arena;
	const struct reference *reference;
	struct pose pose;
	struct clip_cursor cursor;
	mat4 *world; /* [node_count] */

	int part_count;
	struct rigid_part *part;
	int vertex_count;
	int *source;          /* [vertex_count] of the reference */
	float (*position)[3]; /* [vertex_count] */
	float (*normal)[3];   /* [vertex_count] */
	int *node;            /* [vertex_count] */
	int index_count;
	uint32_t *index; /* relative to the part's first vertex */
};

/*
 * Each triangle moves with the joint that has the largest sum of weights at its
 * corners; a vertex of triangles of several joints is stored once for each. The
 * reference must outlive the candidate. Returns 0, -EINTR (base/interrupt.h),
 * or -ENOMEM after logging an error.
 */
int candidate_rigid(struct candidate *candidate, struct reference *reference,
	const struct log *log);

/* The baked parts; they belong to the candidate. */
const struct rigid_bake *candidate_rigid_bake(const struct candidate *candidate);

#endif
