/* Finds which triangles and vertices of a simplification touch each other. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_MESH_H
#define APP_MODEL_LEVELS_SIMPLIFY_MESH_H

#include "app/model/levels/simplify.h"

enum {
	SIMPLIFY_RING_MAX = 24, /* the most neighbours of a vertex that may
				   collapse */
	/*
	 * The most triangles of a vertex that others may collapse to, which
	 * limits the time.
	 */
	SIMPLIFY_VALENCE_MAX = 64
};

/* The neighbours of a leader, which are leaders. */
struct simplify_ring {
	int count;
	uint32_t neighbour[SIMPLIFY_RING_MAX];
	bool border[SIMPLIFY_RING_MAX]; /* whether the edge to it has one
					   triangle, not two */
	int border_count;
};

/*
 * Fills in leader and next. Vertices whose positions round to the same
 * multiples of 1/65,536 of the extent count as being at one position. Returns
 * 0, -ENOMEM or -EINTR (base/interrupt.h).
 */
int simplify_mesh_weld(struct simplify *simplify);

/* Fills in first_triangle and triangle from the present index list. */
void simplify_mesh_link(struct simplify *simplify);

/*
 * Lists the neighbours of a leader. Returns false if it has too many, or if its
 * triangles do not form one disc or half a disc; a leader without triangles has
 * a ring of none.
 */
bool simplify_mesh_ring(const struct simplify *simplify, uint32_t leader,
	struct simplify_ring *out);

/*
 * Returns which corner of a triangle, 0 to 2, is at a leader. triangle is the
 * place of its first corner in index.
 */
static inline int simplify_mesh_corner(
	const struct simplify *simplify, uint32_t triangle, uint32_t leader)
{
	const uint32_t *at = simplify->index + triangle;

	return simplify->leader[at[0]] == leader    ? 0
		: simplify->leader[at[1]] == leader ? 1
						    : 2;
}

/* Returns the number of triangles that have a leader as a corner. */
static inline uint32_t simplify_mesh_valence(
	const struct simplify *simplify, uint32_t leader)
{
	return simplify->first_triangle[leader + 1] -
		simplify->first_triangle[leader];
}

/* Whether a triangle has a leader as a corner. */
static inline bool simplify_mesh_has(
	const struct simplify *simplify, uint32_t triangle, uint32_t leader)
{
	const uint32_t *at = simplify->index + triangle;

	return simplify->leader[at[0]] == leader ||
		simplify->leader[at[1]] == leader ||
		simplify->leader[at[2]] == leader;
}

#endif
