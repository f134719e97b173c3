#include "app/scene/coarse.h"

#include <errno.h>
#include <stdlib.h>

enum {
	CORNERS = 3
};

/* Where a vertex is at rest, and which one it is. */
struct place {
	int cell[3];
	int joint;
	int vertex;
};

static int compare_places(const void *a, const void *b)
{
	const struct place *p = a, *q = b;

	if (p->joint != q->joint) {
		return p->joint < q->joint ? -1 : 1;
	}
	for (int axis = 0; axis < 3; axis++) {
		if (p->cell[axis] != q->cell[axis]) {
			return p->cell[axis] < q->cell[axis] ? -1 : 1;
		}
	}
	return p->vertex - q->vertex;
}

static bool share_cell(const struct place *p, const struct place *q)
{
	return p->joint == q->joint && p->cell[0] == q->cell[0] &&
		p->cell[1] == q->cell[1] && p->cell[2] == q->cell[2];
}

/* The joint that carries most of it; 0 without a skin. */
static int joint_of(const struct model_primitive *primitive, int vertex)
{
	const float *weight = primitive->weight + vertex * primitive->influences;
	int most = 0;

	if (primitive->influences == 0) {
		return 0;
	}
	for (int i = 1; i < primitive->influences; i++) {
		most = weight[i] > weight[most] ? i : most;
	}
	return primitive->joint[vertex * primitive->influences + most];
}

static int cell_of(float at, float cell)
{
	float scaled = at / cell;
	int whole = (int)scaled;

	return scaled < (float)whole ? whole - 1 : whole;
}

/* stands_for[v]: the first vertex of v's cell. */
static void find_representatives(const struct model_primitive *primitive,
	float cell, struct place *place, int *stands_for)
{
	int count = primitive->vertex_count;

	for (int v = 0; v < count; v++) {
		place[v].vertex = v;
		place[v].joint = joint_of(primitive, v);
		for (int axis = 0; axis < 3; axis++) {
			place[v].cell[axis] =
				cell_of(primitive->position[v][axis], cell);
		}
	}
	qsort(place, (size_t)count, sizeof(*place), compare_places);
	for (int i = 0; i < count; i++) {
		bool first = i == 0 || !share_cell(&place[i - 1], &place[i]);

		stands_for[place[i].vertex] = first
			? place[i].vertex
			: stands_for[place[i - 1].vertex];
	}
}

/* Returns how many indices are left. */
static int shorten(
	const struct drawable *drawable, const int *stands_for, uint16_t *index)
{
	const struct model_primitive *primitive = drawable->primitive;
	const uint32_t *place = drawable->fixed ? drawable->fixed->place : NULL;
	int count = 0;

	for (int t = 0; t + 2 < primitive->index_count; t += CORNERS) {
		int v[CORNERS];

		for (int corner = 0; corner < CORNERS; corner++) {
			v[corner] = stands_for[primitive->index[t + corner]];
		}
		if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
			continue;
		}
		for (int corner = 0; corner < CORNERS; corner++) {
			index[count++] = (uint16_t)(place ? place[v[corner]]
							  : (uint32_t)v[corner]);
		}
	}
	return count;
}

static int make_part(struct coarse_part *part, const struct drawable *drawable,
	float cell, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t count = (size_t)primitive->vertex_count;
	struct place *place = malloc(count * sizeof(*place));
	int *stands_for = malloc(count * sizeof(*stands_for));
	uint16_t *index =
		ARENA_ARRAY(arena, uint16_t, (size_t)primitive->index_count);
	int error = -ENOMEM;

	if (place && stands_for && index) {
		find_representatives(primitive, cell, place, stands_for);
		part->index_count = shorten(drawable, stands_for, index);
		part->index = index;
		error = 0;
	}
	free(place);
	free(stands_for);
	return error;
}

/* One batch of the drawable's own vertices, drawn by indices. */
static bool can_shorten(const struct drawable *drawable)
{
	return drawable->batch_count == 1 && !drawable->batch[0].source &&
		drawable->batch[0].index &&
		drawable->primitive->vertex_count > 0;
}

static int begin(struct coarse *coarse, const struct instance *instance,
	struct arena *arena)
{
	*coarse = (struct coarse){.count = instance->drawable_count};
	coarse->part =
		ARENA_ARRAY(arena, struct coarse_part, (size_t)coarse->count);
	return coarse->part ? 0 : -ENOMEM;
}

int coarse_init(struct coarse *coarse, const struct instance *instance,
	float cell, struct arena *arena)
{
	int error = begin(coarse, instance, arena);

	for (int i = 0; i < coarse->count && !error; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (can_shorten(drawable)) {
			error = make_part(
				&coarse->part[i], drawable, cell, arena);
			coarse->triangles +=
				coarse->part[i].index_count / CORNERS;
		} else {
			coarse->triangles +=
				drawable->primitive->index_count / CORNERS;
		}
	}
	return error;
}

int coarse_keep(struct coarse *full, const struct instance *instance,
	struct arena *arena)
{
	int error = begin(full, instance, arena);

	for (int i = 0; i < full->count && !error; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (can_shorten(drawable)) {
			full->part[i].index = drawable->batch[0].index;
			full->part[i].index_count =
				drawable->batch[0].index_count;
		}
		full->triangles += drawable->primitive->index_count / CORNERS;
	}
	return error;
}

void coarse_use(const struct coarse *coarse, struct instance *instance)
{
	for (int i = 0; i < coarse->count; i++) {
		if (coarse->part[i].index) {
			struct batch *batch = instance->drawable[i].batch;

			batch->index = coarse->part[i].index;
			batch->index_count = coarse->part[i].index_count;
		}
	}
}
