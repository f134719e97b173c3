/* Which triangles and vertices of a simplification touch each other. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_MESH_H
#define APP_MODEL_LEVELS_SIMPLIFY_MESH_H

#include "app/model/levels/simplify.h"

enum {
	SIMPLIFY_RING_MAX = 24, /* neighbours of a vertex that may collapse */
	/* Triangles of a vertex that others may collapse to; limits the time. */
	SIMPLIFY_VALENCE_MAX = 64
};

/* The neighbours of a leader, which are leaders. */
struct simplify_ring {
	int count;
	uint32_t neighbour[SIMPLIFY_RING_MAX];
	bool border[SIMPLIFY_RING_MAX]; /* one triangle has the edge, not two */
	int border_count;
};

/*
 * Fills leader and next: vertices count as being at one position if they differ
 * by less than some hundred-thousandth of the extent. 0 or -ENOMEM.
 */
int simplify_mesh_weld(struct simplify *simplify);

/* Fills first_triangle and triangle for the present index. */
void simplify_mesh_link(struct simplify *simplify);

/*
 * Lists the neighbours of a leader. False if it has too many, or if its
 * triangles do not form one disc or half a disc.
 */
bool simplify_mesh_ring(const struct simplify *simplify, uint32_t leader,
	struct simplify_ring *out);

/* The corner, 0 to 2, of a triangle (its first corner's place) at a leader. */
static inline int simplify_mesh_corner(
	const struct simplify *simplify, uint32_t triangle, uint32_t leader)
{
	const uint32_t *at = simplify->index + triangle;

	return simplify->leader[at[0]] == leader    ? 0
		: simplify->leader[at[1]] == leader ? 1
						    : 2;
}

/* The number of triangles that have a leader as a corner. */
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
