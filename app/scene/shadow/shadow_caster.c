#include "app/scene/shadow/shadow_caster.h"

#include "app/scene/shadow/shadow_proxy.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* An edge of one triangle between welded vertices. */
struct half_edge {
	uint32_t low, high;
	uint32_t a, b; /* the same in the triangle's order */
	int32_t triangle;
};

struct welded {
	float position[3];
	uint32_t vertex;
};

static int compare_welded(const void *left, const void *right)
{
	const struct welded *a = left, *b = right;

	for (int axis = 0; axis < 3; axis++) {
		if (a->position[axis] != b->position[axis]) {
			return a->position[axis] < b->position[axis] ? -1 : 1;
		}
	}
	return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static int compare_edges(const void *left, const void *right)
{
	const struct half_edge *a = left, *b = right;

	if (a->low != b->low) {
		return a->low < b->low ? -1 : 1;
	}
	if (a->high != b->high) {
		return a->high < b->high ? -1 : 1;
	}
	return a->triangle < b->triangle ? -1 : a->triangle > b->triangle;
}

/*
 * Returns for each vertex the first one at the same position, because seams of
 * texture or colour are not borders. The caller frees it; NULL when memory is
 * short.
 */
static uint32_t *weld(const struct model_primitive *primitive)
{
	size_t count = (size_t)primitive->vertex_count;
	struct welded *sorted = malloc(count * sizeof(*sorted));
	uint32_t *first = malloc(count * sizeof(*first));

	if (!sorted || !first) {
		free(sorted);
		free(first);
		return NULL;
	}
	for (size_t i = 0; i < count; i++) {
		memcpy(sorted[i].position, primitive->position[i],
			sizeof(float[3]));
		sorted[i].vertex = (uint32_t)i;
	}
	qsort(sorted, count, sizeof(*sorted), compare_welded);
	for (size_t i = 0; i < count; i++) {
		bool same = i > 0 &&
			memcmp(sorted[i].position, sorted[i - 1].position,
				sizeof(float[3])) == 0;

		first[sorted[i].vertex] =
			same ? first[sorted[i - 1].vertex] : sorted[i].vertex;
	}
	free(sorted);
	return first;
}

static void list_half_edges(const struct shadow_caster *caster,
	const uint32_t *first, struct half_edge *out)
{
	for (int i = 0; i < caster->corner_count; i++) {
		int triangle = i / 3;
		uint32_t a = first[caster->corner[i]];
		uint32_t b = first[caster->corner[triangle * 3 + (i + 1) % 3]];

		out[i] = (struct half_edge){
			.low = a < b ? a : b,
			.high = a < b ? b : a,
			.a = a,
			.b = b,
			.triangle = triangle,
		};
	}
}

/*
 * Pairs half edges of opposite directions; an unpaired one is a border. More
 * than two triangles at one edge become several pairs.
 */
static void join_half_edges(
	struct half_edge *half, int count, struct shadow_caster *caster)
{
	int i = 0;

	qsort(half, (size_t)count, sizeof(*half), compare_edges);
	while (i < count) {
		const struct half_edge *h = &half[i];
		bool pair = i + 1 < count && h[1].low == h->low &&
			h[1].high == h->high && h[1].a == h->b;

		if (h->low != h->high) {
			caster->edge[caster->edge_count++] =
				(struct shadow_edge){
					.a = h->a,
					.b = h->b,
					.left = h->triangle,
					.right = pair ? h[1].triangle : -1,
				};
		}
		i += pair ? 2 : 1;
	}
}

static int find_edges(struct shadow_caster *caster, struct arena *arena)
{
	const struct model_primitive *primitive = caster->drawable->primitive;
	size_t count = (size_t)caster->corner_count;
	struct half_edge *half = malloc((count + 1) * sizeof(*half));
	uint32_t *first = weld(primitive);
	int error = -ENOMEM;

	caster->edge = ARENA_ARRAY(arena, struct shadow_edge, count);
	if (half && first && caster->edge) {
		list_half_edges(caster, first, half);
		join_half_edges(half, (int)count, caster);
		error = 0;
	}
	free(half);
	free(first);
	return error;
}

/*
 * Edges use welded vertices, which no triangle need have as a corner. Numbers
 * the vertices that are used, and lets corners and edges refer to the numbers.
 */
static int number_vertices(struct shadow_caster *caster, struct arena *arena)
{
	size_t count = (size_t)caster->drawable->primitive->vertex_count;
	bool *used = calloc(count + 1, sizeof(*used));
	uint16_t *place = calloc(count + 1, sizeof(*place));

	caster->vertex = ARENA_ARRAY(arena, uint16_t, count);
	if (!used || !place || !caster->vertex) {
		free(place);
		free(used);
		return -ENOMEM;
	}
	for (int i = 0; i < caster->corner_count; i++) {
		used[caster->corner[i]] = true;
	}
	for (int i = 0; i < caster->edge_count; i++) {
		used[caster->edge[i].a] = true;
		used[caster->edge[i].b] = true;
	}
	for (size_t v = 0; v < count; v++) {
		if (used[v]) {
			place[v] = (uint16_t)caster->vertex_count;
			caster->vertex[caster->vertex_count++] = (uint16_t)v;
		}
	}
	for (int i = 0; i < caster->corner_count; i++) {
		caster->corner[i] = place[caster->corner[i]];
	}
	for (int i = 0; i < caster->edge_count; i++) {
		caster->edge[i].a = place[caster->edge[i].a];
		caster->edge[i].b = place[caster->edge[i].b];
	}
	free(place);
	free(used);
	return 0;
}

int shadow_caster_init(struct shadow_caster *caster,
	const struct drawable *drawable, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t triangles;
	int error;

	caster->drawable = drawable;
	error = shadow_proxy_make(
		primitive, NULL, arena, &caster->corner, &caster->corner_count);
	if (error) {
		return error;
	}
	triangles = (size_t)caster->corner_count / 3;
	error = find_edges(caster, arena);
	if (!error) {
		error = number_vertices(caster, arena);
	}
	if (error) {
		return error;
	}
	caster->lit = ARENA_ARRAY(arena, bool, triangles);
	caster->position = arena_alloc(
		arena, 2 * (size_t)caster->vertex_count, sizeof(float[3]));
	/* Every triangle may be in both caps; an edge may become two triangles. */
	caster->index = ARENA_ARRAY(
		arena, uint16_t, 6 * (triangles + (size_t)caster->edge_count));
	return caster->lit && caster->position && caster->index ? 0 : -ENOMEM;
}
