#include "app/model/levels/simplify_choose.h"

#include "app/model/levels/simplify_attributes.h"
#include "app/model/levels/simplify_error.h"
#include "app/model/levels/simplify_vector.h"
#include "platform/base/scalar.h"

#include <float.h>

enum {
	TRIES = 3 /* how many neighbours are compared */
};

/*
 * A factor of the error of border vertices: the planes of the adjacent
 * triangles outweigh those of the border, which makes the error too small, and
 * a gap shows what is behind both parts.
 */
static const float border_factor = 3.0f;

/* The cosine of the largest angle by which a collapse may turn a triangle. */
static const float least_cosine = 0.25f;

static void keep(struct simplify *simplify, uint32_t leader)
{
	uint32_t vertex = leader;

	do {
		simplify->to[vertex] = vertex;
		vertex = simplify->next[vertex];
	} while (vertex != leader);
}

/* Whether any triangle still has this vertex of the leader as a corner. */
static bool is_used(
	const struct simplify *simplify, uint32_t leader, uint32_t vertex)
{
	for (uint32_t i = simplify->first_triangle[leader];
		i < simplify->first_triangle[leader + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		int corner = simplify_mesh_corner(simplify, t, leader);

		if (simplify->index[t + (uint32_t)corner] == vertex) {
			return true;
		}
	}
	return false;
}

/*
 * Sets the vertex that each vertex of leader `from` collapses to: the vertex of
 * leader `to` in a triangle that has both. Returns false if a vertex has no
 * such triangle or if two triangles differ.
 */
static bool pair_vertices(struct simplify *simplify, uint32_t from, uint32_t to)
{
	uint32_t vertex = from;

	for (uint32_t i = simplify->first_triangle[from];
		i < simplify->first_triangle[from + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		const uint32_t *at = simplify->index + t;
		uint32_t v, u;

		if (!simplify_mesh_has(simplify, t, to)) {
			continue;
		}
		v = at[simplify_mesh_corner(simplify, t, from)];
		u = at[simplify_mesh_corner(simplify, t, to)];
		if (simplify->to[v] != v && simplify->to[v] != u) {
			return false;
		}
		simplify->to[v] = u;
	}
	do {
		if (simplify->to[vertex] == vertex &&
			is_used(simplify, from, vertex)) {
			return false;
		}
		vertex = simplify->next[vertex];
	} while (vertex != from);
	return true;
}

/* Whether a collapse would turn a triangle too far, or make it a line. */
static bool turns_over(
	const struct simplify *simplify, uint32_t from, uint32_t to)
{
	for (uint32_t i = simplify->first_triangle[from];
		i < simplify->first_triangle[from + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		int corner = simplify_mesh_corner(simplify, t, from);
		uint32_t b = simplify->index[t + (uint32_t)(corner + 1) % 3];
		uint32_t c = simplify->index[t + (uint32_t)(corner + 2) % 3];
		float old[3], new[3], product, lengths;

		/* Neighbours may have collapsed in this pass. */
		b = simplify->leader[simplify->to[b]];
		c = simplify->leader[simplify->to[c]];
		if (b == to || c == to || b == c || b == from || c == from) {
			continue;
		}
		simplify_normal(simplify->position[from], simplify->position[b],
			simplify->position[c], old);
		simplify_normal(simplify->position[to], simplify->position[b],
			simplify->position[c], new);
		product = simplify_dot(old, new);
		if (old[0] == 0.0f && old[1] == 0.0f && old[2] == 0.0f) {
			continue;
		}
		lengths = simplify_dot(old, old) * simplify_dot(new, new);
		if (product <= least_cosine * scalar_sqrt(lengths)) {
			return true;
		}
	}
	return false;
}

/*
 * Whether the surface stays one: the ends of the edge may have no neighbours in
 * common but the third corners of the edge's triangles.
 */
static bool stays_surface(struct simplify *simplify,
	const struct simplify_ring *ring, uint32_t to, bool border)
{
	uint32_t mark = ++simplify->mark_value;
	int common = 0;

	if (simplify_mesh_valence(simplify, to) > SIMPLIFY_VALENCE_MAX) {
		return false;
	}
	for (int i = 0; i < ring->count; i++) {
		simplify->mark[ring->neighbour[i]] = mark;
	}
	for (uint32_t i = simplify->first_triangle[to];
		i < simplify->first_triangle[to + 1]; i++) {
		const uint32_t *at = simplify->index + simplify->triangle[i];

		for (int j = 0; j < 3; j++) {
			uint32_t leader = simplify->leader[at[j]];

			if (leader != to && simplify->mark[leader] == mark) {
				common++;
				simplify->mark[leader] = mark - 1;
			}
		}
	}
	return common == (border ? 1 : 2);
}

/*
 * Whether at most two edges of a leader lie between triangles with different
 * vertices of it, as where a seam passes. Where colours of triangles alternate,
 * merged vertices have more, and a collapse would change the pattern.
 */
static bool has_one_seam(const struct simplify *simplify, uint32_t leader)
{
	const uint32_t *triangle = simplify->triangle;
	uint32_t first = simplify->first_triangle[leader];
	uint32_t end = simplify->first_triangle[leader + 1];
	int edges = 0;

	for (uint32_t i = first; i < end; i++) {
		const uint32_t *a = simplify->index + triangle[i];
		int at = simplify_mesh_corner(simplify, triangle[i], leader);

		for (uint32_t j = first; j < end; j++) {
			const uint32_t *b = simplify->index + triangle[j];
			int own = simplify_mesh_corner(
				simplify, triangle[j], leader);

			edges += a[at] != b[own] &&
				simplify->leader[a[(at + 1) % 3]] ==
					simplify->leader[b[(own + 2) % 3]];
		}
	}
	return edges <= 2;
}

static bool is_allowed(struct simplify *simplify,
	const struct simplify_ring *ring, uint32_t from, uint32_t to)
{
	int i = 0;

	while (i < ring->count && ring->neighbour[i] != to) {
		i++;
	}
	return i < ring->count && (ring->border_count == 0 || ring->border[i]) &&
		stays_surface(simplify, ring, to, ring->border[i]) &&
		!turns_over(simplify, from, to) &&
		(!simplify->divided || has_one_seam(simplify, from)) &&
		pair_vertices(simplify, from, to);
}

/*
 * Returns the error of a collapse, given that of its shape; negative if it is
 * not allowed.
 */
static float measure(struct simplify *simplify, const struct simplify_ring *ring,
	uint32_t from, uint32_t to, float shape)
{
	float attributes = -1.0f;

	if (is_allowed(simplify, ring, from, to)) {
		attributes = simplify_error_of_attributes(simplify, from, to);
	}
	keep(simplify, from);
	return attributes < 0.0f
		? -1.0f
		: scalar_sqrt(shape * shape + attributes * attributes);
}

/*
 * Lists the neighbours with the smallest errors of shape. From a border, only
 * neighbours along the border count.
 */
static int list_nearest(const struct simplify *simplify,
	const struct simplify_ring *ring, uint32_t from,
	struct simplify_collapse nearest[TRIES])
{
	bool at_border = ring->border_count > 0;
	float factor = at_border ? border_factor : 1.0f;
	int count = 0;

	for (int i = 0; i < ring->count; i++) {
		uint32_t to = ring->neighbour[i];
		struct simplify_collapse own = {from, to,
			simplify_error_of_shape(simplify, from, to) * factor};
		int at;

		if (at_border && !ring->border[i]) {
			continue;
		}
		at = count < TRIES ? count++ : TRIES;
		for (; at > 0 && own.error < nearest[at - 1].error; at--) {
			if (at < TRIES) {
				nearest[at] = nearest[at - 1];
			}
		}
		if (at < TRIES) {
			nearest[at] = own;
		}
	}
	return count;
}

void simplify_choose(struct simplify *simplify, uint32_t from, float limit)
{
	struct simplify_collapse nearest[TRIES];
	struct simplify_collapse best = {from, from, FLT_MAX};
	struct simplify_ring ring;
	int tries = 0;

	if (simplify_mesh_ring(simplify, from, &ring)) {
		tries = list_nearest(simplify, &ring, from, nearest);
	}
	if (tries > 0 && nearest[0].error > limit) {
		simplify->best[from] = nearest[0];
		simplify->known[from] = SIMPLIFY_BOUND;
		return;
	}
	for (int i = 0; i < tries && nearest[i].error < best.error; i++) {
		float error = measure(
			simplify, &ring, from, nearest[i].to, nearest[i].error);

		if (error >= 0.0f && error < best.error) {
			best.to = nearest[i].to;
			best.error = error;
		}
	}
	simplify->best[from] = best;
	simplify->known[from] = SIMPLIFY_BEST;
}

bool simplify_choose_again(struct simplify *simplify, uint32_t from, uint32_t to)
{
	struct simplify_ring ring;

	if (simplify_mesh_ring(simplify, from, &ring) &&
		is_allowed(simplify, &ring, from, to)) {
		return true;
	}
	keep(simplify, from);
	return false;
}
