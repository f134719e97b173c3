#include "app/scene/instance/batch/batch.h"

#include "app/scene/instance/batch/facets.h"

/* Vertices of a batch, and the triangles that give them their normals. */
struct range {
	int first, count;
	const uint16_t *index; /* counts from first on; or NULL */
	int corner_count;
	/* normals are those of the primitive's triangles at batch.corner */
	bool by_corner;
	bool lit;
};

static struct range range_of(
	const struct batch *batch, const struct batch_lod *list, bool lit)
{
	if (list) {
		return (struct range){list->first_vertex, list->vertex_count,
			list->index, list->index_count, !list->flat, lit};
	}
	return (struct range){0, batch->vertex_count, batch->index,
		batch->index ? batch->index_count : batch->vertex_count, false,
		lit};
}

static void copy_fixed(const struct drawable_fixed *fixed, struct batch *batch,
	const struct range *range)
{
	struct fixed_vector *position = batch->gathered_fixed;
	struct fixed_vector *normal = batch->gathered_fixed_normal;
	bool with_normals = range->lit && fixed->normal;

	for (int v = range->first; v < range->first + range->count; v++) {
		uint32_t from = batch->source[v];

		from = fixed->inverse_order ? fixed->inverse_order[from] : from;
		position[v] = fixed->position[from];
		if (with_normals) {
			normal[v] = fixed->normal[from];
		}
	}
}

static void copy(const struct drawable *drawable, struct batch *batch,
	const struct range *range)
{
	bool with_normals = range->lit && drawable->normal;

	for (int v = range->first; v < range->first + range->count; v++) {
		uint32_t from = batch->source[v];

		memcpy(batch->gathered_position[v], drawable->position[from],
			sizeof(float[3]));
		if (with_normals) {
			memcpy(batch->gathered_normal[v],
				drawable->normal[from], sizeof(float[3]));
		}
	}
}

static struct facets_corners corners_of(const struct drawable *drawable,
	const struct batch *batch, const struct range *range)
{
	return (struct facets_corners){
		.count = range->count,
		.corner = batch->corner + range->first,
		.index = drawable->primitive->index,
		.inverse_order =
			drawable->fixed ? drawable->fixed->inverse_order : NULL,
	};
}

/* Where winding is reversed (mirrored), normals are negated to point outwards. */
static void find_fixed_normals(const struct drawable *drawable,
	const struct batch *batch, const struct range *range)
{
	struct fixed_vector *normal =
		batch->gathered_fixed_normal + range->first;

	if (range->by_corner) {
		const struct facets_corners corners =
			corners_of(drawable, batch, range);

		facets_find_fixed_normals_at(
			&corners, drawable->fixed->position, normal);
	} else {
		facets_find_fixed_normals(range->index, range->corner_count,
			batch->gathered_fixed + range->first, normal);
	}
	if (drawable->mirrored) {
		facets_turn_fixed_normals(range->count, normal);
	}
}

static void find_normals(const struct drawable *drawable,
	const struct batch *batch, const struct range *range)
{
	float(*normal)[3] = batch->gathered_normal + range->first;

	if (range->by_corner) {
		const struct facets_corners corners =
			corners_of(drawable, batch, range);

		facets_find_normals_at(&corners,
			(const float(*)[3])drawable->position, normal);
	} else {
		facets_find_normals(range->index, range->corner_count,
			(const float(*)[3])batch->gathered_position +
				range->first,
			normal);
	}
	if (drawable->mirrored) {
		facets_turn_normals(range->count, normal);
	}
}

static void gather(struct drawable *drawable, struct batch *batch,
	const struct batch_lod *list, bool lit)
{
	struct range range = range_of(batch, list, lit);
	const struct drawable_fixed *fixed = drawable->fixed;

	if (fixed) {
		copy_fixed(fixed, batch, &range);
		if (lit && !fixed->normal) {
			find_fixed_normals(drawable, batch, &range);
		}
		return;
	}
	copy(drawable, batch, &range);
	if (lit && !drawable->normal) {
		find_normals(drawable, batch, &range);
	}
}

void batch_gather(struct drawable *drawable)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		struct batch *batch = &drawable->batch[i];
		const struct batch_lod *shaded =
			drawable_shaded(drawable, batch);
		const struct batch_lod *shadow =
			drawable_shadow(drawable, batch);

		if (!batch->source) {
			continue;
		}
		gather(drawable, batch, shaded, true);
		/* A list for shadows may have the vertices of the full list. */
		if (shadow != shaded &&
			(shaded || !shadow || shadow->first_vertex > 0)) {
			gather(drawable, batch, shadow, false);
		}
	}
}

void batch_gather_all(struct drawable *drawable)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		struct batch *batch = &drawable->batch[i];

		if (!batch->source) {
			continue;
		}
		gather(drawable, batch, NULL, true);
		for (int k = 0; k < batch->lod_count; k++) {
			gather(drawable, batch, &batch->lod[k], true);
		}
		for (int k = 0; k < batch->shadow_count; k++) {
			gather(drawable, batch, &batch->shadow[k], false);
		}
	}
}
