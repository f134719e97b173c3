#include "app/model/levels/simplify_mesh.h"

#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * A vertex and its cell of a grid. Vertices in one cell count as equal, since
 * the two sides of a seam may differ by the rounding of floats.
 */
struct spot {
	int32_t cell[3];
	uint32_t vertex;
};

static const float cells = 65536.0f; /* cells of the grid along the extent */

static bool are_together(const struct spot *a, const struct spot *b)
{
	return memcmp(a->cell, b->cell, sizeof(a->cell)) == 0;
}

static int compare_spots(const void *left, const void *right)
{
	const struct spot *a = left, *b = right;

	for (int i = 0; i < 3; i++) {
		if (a->cell[i] != b->cell[i]) {
			return a->cell[i] < b->cell[i] ? -1 : 1;
		}
	}
	return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

/* Sorts, because files may have cells that collide in any hash table. */
int simplify_mesh_weld(struct simplify *simplify)
{
	uint32_t count = (uint32_t)simplify->primitive->vertex_count;
	struct spot *spot =
		ARENA_ARRAY(&simplify->arena, struct spot, (size_t)count);
	uint32_t leader = 0;

	if (!spot) {
		return -ENOMEM;
	}
	for (uint32_t v = 0; v < count; v++) {
		spot[v].vertex = v;
		for (int i = 0; i < 3; i++) {
			spot[v].cell[i] = (int32_t)scalar_floor(
				simplify->position[v][i] * cells + 0.5f);
		}
	}
	qsort(spot, count, sizeof(*spot), compare_spots);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t v = spot[i].vertex;

		if (interrupt_pending()) {
			return -EINTR;
		}
		if (i == 0 || !are_together(&spot[i - 1], &spot[i])) {
			leader = v;
			simplify->next[v] = v;
		} else {
			simplify->next[v] = simplify->next[leader];
			simplify->next[leader] = v;
		}
		simplify->leader[v] = leader;
	}
	return 0;
}

void simplify_mesh_link(struct simplify *simplify)
{
	uint32_t count = (uint32_t)simplify->primitive->vertex_count;
	uint32_t *first = simplify->first_triangle;

	memset(first, 0, ((size_t)count + 1) * sizeof(*first));
	for (int i = 0; i < simplify->index_count; i++) {
		first[simplify->leader[simplify->index[i]] + 1]++;
	}
	for (uint32_t v = 0; v < count; v++) {
		first[v + 1] += first[v];
	}
	/* Filling moves each entry of first to the start of the next leader. */
	for (int i = 0; i < simplify->index_count; i++) {
		uint32_t leader = simplify->leader[simplify->index[i]];

		simplify->triangle[first[leader]++] = (uint32_t)(i - i % 3);
	}
	for (uint32_t v = count; v > 0; v--) {
		first[v] = first[v - 1];
	}
	first[0] = 0;
}

static int find_neighbour(const struct simplify_ring *ring, uint32_t leader)
{
	int i = 0;

	while (i < ring->count && ring->neighbour[i] != leader) {
		i++;
	}
	return i;
}

/*
 * Adds the edge to a neighbour. bit says its direction: 1 away from the leader,
 * 2 towards it. Returns false if there are too many neighbours or the edge
 * occurs twice.
 */
static bool add_edge(struct simplify_ring *ring, uint32_t neighbour,
	uint8_t uses[SIMPLIFY_RING_MAX], int bit)
{
	int i = find_neighbour(ring, neighbour);

	if (i == SIMPLIFY_RING_MAX) {
		return false;
	}
	if (i == ring->count) {
		ring->neighbour[ring->count++] = neighbour;
		uses[i] = 0;
	}
	if (uses[i] & bit) {
		return false;
	}
	uses[i] = (uint8_t)(uses[i] | bit);
	return true;
}

bool simplify_mesh_ring(const struct simplify *simplify, uint32_t leader,
	struct simplify_ring *out)
{
	uint8_t uses[SIMPLIFY_RING_MAX];
	uint32_t first = simplify->first_triangle[leader];
	uint32_t end = simplify->first_triangle[leader + 1];

	out->count = out->border_count = 0;
	for (uint32_t i = first; i < end; i++) {
		uint32_t t = simplify->triangle[i];
		int corner = simplify_mesh_corner(simplify, t, leader);
		const uint32_t *at = simplify->index + t;
		uint32_t after = simplify->leader[at[(corner + 1) % 3]];
		uint32_t before = simplify->leader[at[(corner + 2) % 3]];

		if (!add_edge(out, after, uses, 1) ||
			!add_edge(out, before, uses, 2)) {
			return false;
		}
	}
	for (int i = 0; i < out->count; i++) {
		out->border[i] = uses[i] != 3;
		out->border_count += out->border[i];
	}
	/* A disc has as many edges as triangles, half a disc one more. */
	return (out->border_count == 0 && (uint32_t)out->count == end - first) ||
		(out->border_count == 2 &&
			(uint32_t)out->count == end - first + 1);
}
