#include "app/model/levels/simplify_merge.h"

#include "app/model/levels/simplify_attributes.h"
#include "app/model/levels/simplify_mesh.h"
#include "app/model/levels/simplify_vector.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <float.h>

enum {
	/* vertices a position, on average, beyond which they are merged */
	VERTICES_MOST = 2
};

/*
 * The error of a normal's change is this factor times the change times the size
 * of the triangles around.
 */
static const float normal_factor = 3.0f;
/* Edges at which normals differ by about 29 degrees or more stay sharp. */
static const float most_change = 0.5f;

/* The vertices of a leader that are corners of triangles. */
struct corners {
	int count;
	uint32_t vertex[SIMPLIFY_VALENCE_MAX];
	float size; /* side of a square as large as the largest triangle */
};

static float square_of_area(
	const struct simplify *simplify, const uint32_t corner[3])
{
	const float *a = simplify->position[corner[0]];
	const float *b = simplify->position[corner[1]];
	const float *c = simplify->position[corner[2]];
	float square = 0.0f;

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3;
		float n = (b[i] - a[i]) * (c[j] - a[j]) -
			(b[j] - a[j]) * (c[i] - a[i]);

		square += 0.25f * n * n;
	}
	return square;
}

/* Returns false if a leader has one vertex alone, or too many triangles. */
static bool list_corners(
	const struct simplify *simplify, uint32_t leader, struct corners *out)
{
	float most = 0.0f;

	out->count = 0;
	if (simplify->next[leader] == leader ||
		simplify_mesh_valence(simplify, leader) > SIMPLIFY_VALENCE_MAX) {
		return false;
	}
	for (uint32_t i = simplify->first_triangle[leader];
		i < simplify->first_triangle[leader + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		uint32_t vertex = simplify->index[t +
			(uint32_t)simplify_mesh_corner(simplify, t, leader)];
		float square = square_of_area(simplify, simplify->index + t);
		int at = 0;

		while (at < out->count && out->vertex[at] != vertex) {
			at++;
		}
		out->vertex[at] = vertex;
		out->count += at == out->count;
		most = scalar_max(square, most);
	}
	out->size = scalar_sqrt(scalar_sqrt(most));
	return true;
}

static bool may_merge(const struct simplify *simplify,
	const struct corners *corners, uint32_t a, uint32_t b, float limit)
{
	const float(*normal)[3] = (const float(*)[3])simplify->primitive->normal;
	float change = 0.0f, error, other;

	for (int i = 0; i < 3; i++) {
		float d = normal[a][i] - normal[b][i];

		change += d * d;
	}
	if (change > most_change * most_change) {
		return false;
	}
	error = normal_factor * corners->size * scalar_sqrt(change);
	if (error > limit) {
		return false;
	}
	other = simplify_square_of_merge(simplify, a, b);
	return error * error + other <= limit * limit;
}

/* Moves the corners at a leader from a vertex to another one of the leader. */
static void move(
	struct simplify *simplify, uint32_t leader, uint32_t from, uint32_t to)
{
	for (uint32_t i = simplify->first_triangle[leader];
		i < simplify->first_triangle[leader + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		uint32_t *at = &simplify->index[t +
			(uint32_t)simplify_mesh_corner(simplify, t, leader)];

		*at = *at == from ? to : *at;
	}
}

/*
 * Marks a vertex and those that may merge with it. Returns how many others
 * there are.
 */
static int mark_near(const struct simplify *simplify,
	const struct corners *corners, int own, float limit,
	bool near[SIMPLIFY_VALENCE_MAX])
{
	int count = 0;

	for (int i = 0; i < corners->count; i++) {
		near[i] = i == own ||
			may_merge(simplify, corners, corners->vertex[own],
				corners->vertex[i], limit);
		count += i != own && near[i];
	}
	return count;
}

/* Returns the marked vertex whose normal is nearest to the mean of theirs. */
static int find_middle(const struct simplify *simplify,
	const struct corners *corners, const bool near[SIMPLIFY_VALENCE_MAX])
{
	const float(*normal)[3] = (const float(*)[3])simplify->primitive->normal;
	float sum[3] = {0.0f, 0.0f, 0.0f}, most = -FLT_MAX;
	int middle = 0;

	for (int i = 0; i < corners->count; i++) {
		for (int axis = 0; near[i] && axis < 3; axis++) {
			sum[axis] += normal[corners->vertex[i]][axis];
		}
	}
	for (int i = 0; i < corners->count; i++) {
		const float *n = normal[corners->vertex[i]];
		float along = simplify_dot(n, sum);

		if (near[i] && along > most) {
			most = along;
			middle = i;
		}
	}
	return middle;
}

/*
 * Merges as many vertices as possible into one. Returns false if none may, and
 * removes those merged from the list otherwise.
 */
static bool merge_most(struct simplify *simplify, uint32_t leader,
	struct corners *corners, float limit)
{
	bool near[SIMPLIFY_VALENCE_MAX];
	int best = 0, most = 0, left = 0;
	uint32_t kept;

	for (int i = 0; i < corners->count; i++) {
		int count = mark_near(simplify, corners, i, limit, near);

		if (count > most) {
			most = count;
			best = i;
		}
	}
	if (most == 0) {
		return false;
	}
	mark_near(simplify, corners, best, limit, near);
	best = find_middle(simplify, corners, near);
	mark_near(simplify, corners, best, limit, near);
	kept = corners->vertex[best];
	for (int i = 0; i < corners->count; i++) {
		if (!near[i]) {
			corners->vertex[left++] = corners->vertex[i];
		} else if (i != best) {
			move(simplify, leader, corners->vertex[i], kept);
		}
	}
	corners->count = left;
	return true;
}

/* Collapses of the leader and to it may have other errors now. */
static void forget_choices(struct simplify *simplify, uint32_t leader)
{
	for (uint32_t i = simplify->first_triangle[leader];
		i < simplify->first_triangle[leader + 1]; i++) {
		const uint32_t *at = simplify->index + simplify->triangle[i];

		for (int j = 0; j < 3; j++) {
			simplify->known[simplify->leader[at[j]]] =
				SIMPLIFY_NOTHING;
		}
	}
}

bool simplify_merge_is_wanted(struct simplify *simplify)
{
	uint32_t mark = ++simplify->mark_value;
	int vertices = 0, leaders = 0;

	for (int i = 0; i < simplify->index_count; i++) {
		uint32_t vertex = simplify->index[i];

		vertices += simplify->mark[vertex] != mark;
		simplify->mark[vertex] = mark;
	}
	for (int v = 0; v < simplify->primitive->vertex_count; v++) {
		leaders += simplify_mesh_valence(simplify, (uint32_t)v) > 0;
	}
	return vertices > VERTICES_MOST * leaders;
}

void simplify_merge(struct simplify *simplify, float limit)
{
	uint32_t count = (uint32_t)simplify->primitive->vertex_count;

	for (uint32_t v = 0;
		simplify->divided && v < count && !interrupt_pending(); v++) {
		struct corners corners;

		if (!list_corners(simplify, v, &corners)) {
			continue;
		}
		while (merge_most(simplify, v, &corners, limit)) {
			forget_choices(simplify, v);
		}
	}
}
