#include "app/model/split/split_triangles.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>

/* A triangle and its coordinate on the axis that divides triangles. */
struct place {
	float at;
	uint32_t triangle;
};

struct work {
	const struct model_primitive *primitive;
	struct arena *arena; /* owns the parts */
	int vertices_max;
	struct place *place; /* [triangles] */
	/* [vertex_count]: number of the last set of triangles with it */
	uint32_t *seen;
	uint32_t set;
	bool *taken;     /* [vertex_count]: a part has the vertex */
	uint32_t *local; /* [vertex_count]: its number in the present part */
	struct split_part **last;
};

static int compare_places(const void *left, const void *right)
{
	const struct place *a = left, *b = right;

	if (a->at != b->at) {
		return a->at < b->at ? -1 : 1;
	}
	return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static const uint32_t *corners_of(
	const struct work *work, const struct place *place)
{
	return work->primitive->index + (size_t)place->triangle * 3;
}

/* Marks a set of triangles' vertices in seen[]; returns their number. */
static int see_vertices(struct work *work, const struct place *place, int count)
{
	int vertices = 0;

	work->set++;
	for (int i = 0; i < count; i++) {
		const uint32_t *corner = corners_of(work, &place[i]);

		for (int k = 0; k < 3; k++) {
			vertices += work->seen[corner[k]] != work->set;
			work->seen[corner[k]] = work->set;
		}
	}
	return vertices;
}

/* Returns a coordinate of a triangle's centre, times three. */
static float middle_of(
	const struct work *work, const struct place *place, int axis)
{
	const uint32_t *corner = corners_of(work, place);
	float(*position)[3] = work->primitive->position;

	return position[corner[0]][axis] + position[corner[1]][axis] +
		position[corner[2]][axis];
}

/* Sorts the triangles along the axis on which their centres extend farthest. */
static void sort_along(struct work *work, struct place *place, int count)
{
	int longest = 0;
	float side = -1.0f;

	for (int axis = 0; axis < 3; axis++) {
		float low = middle_of(work, &place[0], axis), high = low;

		for (int i = 1; i < count; i++) {
			float at = middle_of(work, &place[i], axis);

			low = scalar_min(at, low);
			high = scalar_max(at, high);
		}
		if (high - low > side) {
			side = high - low;
			longest = axis;
		}
	}
	for (int i = 0; i < count; i++) {
		place[i].at = middle_of(work, &place[i], longest);
	}
	qsort(place, (size_t)count, sizeof(*place), compare_places);
}

/* Lists the present set's vertices, first those that earlier parts have. */
static void number_vertices(struct work *work, struct split_part *part)
{
	int vertices = work->primitive->vertex_count;
	uint32_t next = 0;

	for (int pass = 0; pass < 2; pass++) {
		for (int v = 0; v < vertices; v++) {
			if (work->seen[v] == work->set &&
				work->taken[v] == (pass == 0)) {
				work->local[v] = next;
				part->vertex[next++] = (uint32_t)v;
			}
		}
		part->repeated_count = pass ? part->repeated_count : (int)next;
	}
	for (uint32_t i = 0; i < next; i++) {
		work->taken[part->vertex[i]] = true;
	}
}

static struct split_part *add_part(
	struct work *work, int vertices, int triangles)
{
	struct split_part *part = ARENA_NEW(work->arena, struct split_part);

	if (!part) {
		return NULL;
	}
	part->vertex_count = vertices;
	part->index_count = triangles * 3;
	part->vertex = ARENA_ARRAY(work->arena, uint32_t, vertices);
	part->index = ARENA_ARRAY(work->arena, uint32_t, part->index_count);
	*work->last = part;
	work->last = &part->next;
	return part->vertex && part->index ? part : NULL;
}

static int make_part(
	struct work *work, struct place *place, int count, int vertices)
{
	struct split_part *part = add_part(work, vertices, count);

	if (!part) {
		return -ENOMEM;
	}
	number_vertices(work, part);
	/* Restores the order of the file, which may suit vertex caches. */
	for (int i = 0; i < count; i++) {
		place[i].at = 0.0f;
	}
	qsort(place, (size_t)count, sizeof(*place), compare_places);
	for (int i = 0; i < count; i++) {
		const uint32_t *corner = corners_of(work, &place[i]);

		for (int k = 0; k < 3; k++) {
			part->index[3 * i + k] = work->local[corner[k]];
		}
	}
	return 0;
}

/* Divides triangles in two until each group has few enough vertices. */
static int divide(struct work *work, struct place *place, int count)
{
	int vertices = see_vertices(work, place, count);
	/* Borders repeat some vertices, so parts are planned smaller. */
	int comfort = work->vertices_max - work->vertices_max / 12;
	int parts, first, error;

	if (vertices <= work->vertices_max) {
		return count > 0 ? make_part(work, place, count, vertices) : 0;
	}
	parts = vertices / comfort + 1;
	first = (int)((int64_t)count * (parts / 2) / parts);
	first = first > 0 ? first : 1;
	sort_along(work, place, count);
	error = divide(work, place, first);
	return error ? error : divide(work, place + first, count - first);
}

/* Adds parts with the vertices that no triangle uses. */
static int add_unused(struct work *work)
{
	int vertices = work->primitive->vertex_count, unused = 0;
	struct split_part *part = NULL;
	int at = 0;

	for (int v = 0; v < vertices; v++) {
		unused += !work->taken[v];
	}
	for (int v = 0; v < vertices; v++) {
		if (work->taken[v]) {
			continue;
		}
		if (!part || at == part->vertex_count) {
			part = add_part(work,
				unused < work->vertices_max ? unused
							    : work->vertices_max,
				0);
			if (!part) {
				return -ENOMEM;
			}
			unused -= part->vertex_count;
			at = 0;
		}
		part->vertex[at++] = (uint32_t)v;
	}
	return 0;
}

int split_triangles(const struct model_primitive *primitive, int vertices_max,
	struct arena *arena, struct split_part **out)
{
	size_t vertices = (size_t)primitive->vertex_count;
	int triangles = primitive->index_count / 3;
	struct arena scratch = arena_within(arena->budget);
	struct work work = {
		.primitive = primitive,
		.arena = arena,
		.vertices_max = vertices_max,
		.place = ARENA_ARRAY(&scratch, struct place, triangles),
		.seen = ARENA_ARRAY(&scratch, uint32_t, vertices),
		.taken = ARENA_ARRAY(&scratch, bool, vertices),
		.local = ARENA_ARRAY(&scratch, uint32_t, vertices),
		.last = out,
	};
	int error = -ENOMEM;

	*out = NULL;
	if (work.place && work.seen && work.taken && work.local) {
		for (int i = 0; i < triangles; i++) {
			work.place[i].triangle = (uint32_t)i;
		}
		error = divide(&work, work.place, triangles);
	}
	if (!error) {
		error = add_unused(&work);
	}
	arena_release(&scratch);
	return error;
}
