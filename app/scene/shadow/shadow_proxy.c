#include "app/scene/shadow/shadow_proxy.h"

#include "app/anim/math/vec.h"
#include "app/anim/skin.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	CELLS = 40, /* along the longest side */
};

struct member {
	uint64_t key; /* cell, octant and joint */
	uint32_t vertex;
	float distance; /* along the octant's diagonal */
};

/* Sorts by key, and within a key the outermost vertex first. */
static int compare_members(const void *left, const void *right)
{
	const struct member *a = left, *b = right;

	if (a->key != b->key) {
		return a->key < b->key ? -1 : 1;
	}
	if (a->distance != b->distance) {
		return a->distance > b->distance ? -1 : 1;
	}
	return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static float find_box(const struct model_primitive *primitive, float low[3])
{
	float longest = 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		float high = primitive->position[0][axis];

		low[axis] = high;
		for (int v = 1; v < primitive->vertex_count; v++) {
			float at = primitive->position[v][axis];

			low[axis] = scalar_min(at, low[axis]);
			high = scalar_max(at, high);
		}
		longest =
			high - low[axis] > longest ? high - low[axis] : longest;
	}
	return longest;
}

static uint32_t main_joint(const struct model_primitive *primitive, int vertex)
{
	struct skin_influence influence[SKIN_INFLUENCES_MAX];

	if (primitive->influences == 0) {
		return 0;
	}
	skin_gather_influences(primitive, (uint32_t)vertex, influence);
	return influence[0].joint;
}

/* A vertex's place, and the sum of the normals of all vertices at that place. */
struct spot {
	float at[3];
	uint32_t vertex;
	float normal[3];
};

static int compare_spots(const void *left, const void *right)
{
	const struct spot *a = left, *b = right;
	int order = memcmp(a->at, b->at, sizeof(a->at));

	return order != 0 ? order
			  : (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

/*
 * Vertices at one place, where a hard edge or a seam divides them, get the same
 * normal: they have to be merged into the same vertex, or the proxy has gaps.
 */
static void sum_normals(
	const struct model_primitive *primitive, struct spot *spot)
{
	int count = primitive->vertex_count, end;

	for (int v = 0; v < count; v++) {
		memcpy(spot[v].at, primitive->position[v], sizeof(spot[v].at));
		spot[v].vertex = (uint32_t)v;
	}
	qsort(spot, (size_t)count, sizeof(*spot), compare_spots);
	for (int first = 0; first < count; first = end) {
		float sum[3] = {0.0f, 0.0f, 0.0f};

		for (end = first; end < count &&
			memcmp(spot[end].at, spot[first].at,
				sizeof(spot->at)) == 0;
			end++) {
			vec_add_scaled(sum, primitive->normal[spot[end].vertex],
				1.0f, sum);
		}
		for (int i = first; i < end; i++) {
			memcpy(spot[i].normal, sum, sizeof(sum));
		}
	}
}

/* Clamps to 0..CELLS, because a file may hold any number, NaN included. */
static uint64_t cell_at(float at)
{
	return at > 0.0f ? at < (float)CELLS ? (uint64_t)at : CELLS : 0;
}

static void describe(const struct model_primitive *primitive,
	const struct spot *spot, const float low[3], float scale,
	struct member *out)
{
	*out = (struct member){.key = main_joint(primitive, (int)spot->vertex),
		.vertex = spot->vertex};
	for (int axis = 0; axis < 3; axis++) {
		float at = spot->at[axis] - low[axis];
		bool back = spot->normal[axis] < 0.0f;

		out->key = out->key << 8 | cell_at(at * scale);
		out->key = out->key << 1 | back;
		out->distance += back ? -at : at;
	}
}

/* leader[v] becomes the vertex that vertex v is merged into. */
static void find_leaders(const struct model_primitive *primitive,
	struct spot *spot, struct member *members, uint32_t *leader)
{
	float low[3], longest = find_box(primitive, low);
	float scale = longest > 0.0f ? (float)CELLS / longest : 0.0f;
	int count = primitive->vertex_count, first = 0;

	sum_normals(primitive, spot);
	for (int v = 0; v < count; v++) {
		describe(primitive, &spot[v], low, scale, &members[v]);
	}
	qsort(members, (size_t)count, sizeof(*members), compare_members);
	for (int i = 0; i < count; i++) {
		first = members[i].key == members[first].key ? first : i;
		leader[members[i].vertex] = members[first].vertex;
	}
}

static int list_triangles(const struct model_primitive *primitive,
	const uint32_t *leader, uint32_t *out)
{
	int count = 0;

	for (int i = 0; i + 2 < primitive->index_count; i += 3) {
		uint32_t a = leader[primitive->index[i]];
		uint32_t b = leader[primitive->index[i + 1]];
		uint32_t c = leader[primitive->index[i + 2]];

		if (a != b && a != c && b != c) {
			out[count++] = a;
			out[count++] = b;
			out[count++] = c;
		}
	}
	return count;
}

/* Copies a list of vertices to the arena, in the order of the arrays. */
static int copy_list(int count, const uint32_t *list,
	const uint32_t *inverse_order, struct arena *arena, uint16_t **out)
{
	*out = ARENA_ARRAY(arena, uint16_t, (size_t)count);
	for (int i = 0; *out && i < count; i++) {
		(*out)[i] = (uint16_t)(inverse_order ? inverse_order[list[i]]
						     : list[i]);
	}
	return count > 0 && !*out ? -ENOMEM : 0;
}

static int make_clusters(const struct model_primitive *primitive,
	const uint32_t *inverse_order, struct arena *arena, uint16_t **index,
	int *index_count)
{
	size_t count = (size_t)primitive->vertex_count;
	struct spot *spot = malloc((count + 1) * sizeof(*spot));
	struct member *members = malloc((count + 1) * sizeof(*members));
	uint32_t *leader = malloc((count + 1) * sizeof(*leader));
	uint32_t *list =
		malloc(((size_t)primitive->index_count + 1) * sizeof(*list));
	int error = -ENOMEM;

	*index = NULL;
	*index_count = 0;
	if (spot && members && leader && list) {
		find_leaders(primitive, spot, members, leader);
		*index_count = list_triangles(primitive, leader, list);
		error = copy_list(
			*index_count, list, inverse_order, arena, index);
	}
	free(list);
	free(leader);
	free(members);
	free(spot);
	return error;
}

int shadow_proxy_make(const struct model_primitive *primitive,
	const uint32_t *inverse_order, struct arena *arena, uint16_t **index,
	int *index_count)
{
	if (primitive->normal) {
		return make_clusters(
			primitive, inverse_order, arena, index, index_count);
	}
	*index_count = primitive->index_count;
	return copy_list(
		*index_count, primitive->index, inverse_order, arena, index);
}
