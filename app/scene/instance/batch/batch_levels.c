#include "app/scene/instance/batch/batch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	LIST_VERTICES_MAX = 65536
};

/* Vertices of lists under construction. */
struct adding {
	const struct model_primitive *primitive;
	struct arena *arena;
	/* both with room for all corners; see struct batch */
	uint32_t *source, *corner;
	int count;
	/* [key]: 1 + the number of a list's vertex of this key, or 0 */
	uint32_t *place;
	size_t key_count;
};

static size_t greater(size_t a, size_t b)
{
	return a > b ? a : b;
}

static int begin(struct adding *adding, const struct batch *batch)
{
	const struct model_primitive *primitive = adding->primitive;
	size_t room = (size_t)batch->vertex_count;
	size_t keys = greater((size_t)primitive->vertex_count,
		(size_t)primitive->index_count);

	for (int i = 0; i < primitive->lod_count; i++) {
		size_t corners = (size_t)primitive->lod[i].index_count;

		room += corners;
		/* a file's level may have more corners than its finest list */
		keys = greater(keys, corners);
	}
	adding->source = malloc(room * sizeof(*adding->source) + 1);
	adding->corner = calloc(room + 1, sizeof(*adding->corner));
	adding->place = malloc(keys * sizeof(*adding->place) + 1);
	adding->key_count = keys;
	if (!adding->source || !adding->corner || !adding->place) {
		return -ENOMEM;
	}
	memcpy(adding->source, batch->source,
		(size_t)batch->vertex_count * sizeof(*adding->source));
	adding->count = batch->vertex_count;
	return 0;
}

static void forget_places(struct adding *adding)
{
	memset(adding->place, 0, adding->key_count * sizeof(*adding->place));
}

/* A level of facets: its triangles have normals of their own. */
static bool is_flat(
	const struct model_primitive *primitive, const struct model_lod *lod)
{
	return !lod->shadow_only && !primitive->normal && !lod->corner;
}

/*
 * Returns what corner i of a list has in common with others that are one
 * vertex: the primitive's vertex, or the corner with the normal.
 */
static uint32_t key_of(const struct model_primitive *primitive,
	const struct model_lod *lod, int i)
{
	return is_flat(primitive, lod) ? (uint32_t)i
		: lod->corner          ? lod->corner[i]
				       : lod->index[i];
}

/*
 * Converts a list, whose vertices count from first on. Returns 0, -ENOMEM, or
 * -ERANGE if it has too many vertices, of which none is kept.
 */
static int add_list(struct adding *adding, const struct model_lod *lod,
	int first, struct batch_lod *out)
{
	uint16_t *index =
		ARENA_ARRAY(adding->arena, uint16_t, (size_t)lod->index_count);
	int before = adding->count;

	if (!index) {
		return -ENOMEM;
	}
	for (int i = 0; i < lod->index_count; i++) {
		uint32_t *place =
			&adding->place[key_of(adding->primitive, lod, i)];

		if (*place == 0) {
			adding->corner[adding->count] =
				lod->corner ? lod->corner[i] : 0;
			adding->source[adding->count++] = lod->index[i];
			*place = (uint32_t)(adding->count - first);
		}
		index[i] = (uint16_t)(*place - 1);
	}
	*out = (struct batch_lod){
		.error = lod->error_m,
		.index_count = lod->index_count,
		.index = index,
		.posed_lod =
			model_lod_of_size(adding->primitive, lod->index_count),
		.first_vertex = first,
		.vertex_count = adding->count - first,
		.flat = is_flat(adding->primitive, lod),
	};
	if (out->vertex_count > LIST_VERTICES_MAX) {
		adding->count = before;
		return -ERANGE;
	}
	return 0;
}

static int add_shaded(struct adding *adding, struct batch *batch)
{
	const struct model_primitive *primitive = adding->primitive;

	for (int i = 0; i < primitive->lod_count; i++) {
		struct batch_lod *out = &batch->lod[batch->lod_count];
		int error;

		if (primitive->lod[i].shadow_only) {
			break;
		}
		forget_places(adding);
		error = add_list(adding, &primitive->lod[i], adding->count, out);
		if (error == -ENOMEM) {
			return error;
		}
		batch->lod_count += !error;
	}
	return 0;
}

/*
 * Lists for shadows share vertices. Those of the coarsest list come first, so
 * that only as many need be copied as the chosen list has.
 */
static int add_shadows(struct adding *adding, struct batch *batch)
{
	const struct model_primitive *primitive = adding->primitive;
	int first = adding->count, end = primitive->lod_count, begin = end;

	while (begin > 0 && primitive->lod[begin - 1].shadow_only) {
		begin--;
	}
	forget_places(adding);
	for (int i = end - 1; i >= begin; i--) {
		struct batch_lod list;
		int error = add_list(adding, &primitive->lod[i], first, &list);

		if (error) {
			return error == -ERANGE ? 0 : error;
		}
		memmove(batch->shadow + 1, batch->shadow,
			(size_t)batch->shadow_count * sizeof(list));
		batch->shadow[0] = list;
		batch->shadow_count++;
	}
	return 0;
}

static const uint32_t *keep(
	const uint32_t *from, size_t count, struct arena *arena)
{
	uint32_t *out = ARENA_ARRAY(arena, uint32_t, count);

	return out ? memcpy(out, from, count * sizeof(*out)) : NULL;
}

static int keep_all(const struct adding *adding, struct batch *batch)
{
	size_t count = (size_t)adding->count;

	if (adding->count == batch->vertex_count) {
		return 0;
	}
	batch->level_vertex_count = adding->count - batch->vertex_count;
	batch->source = keep(adding->source, count, adding->arena);
	if (!adding->primitive->normal) {
		batch->corner = keep(adding->corner, count, adding->arena);
	}
	return batch->source && (batch->corner || adding->primitive->normal)
		? 0
		: -ENOMEM;
}

int batch_add_levels(struct batch *batch, const struct drawable *drawable,
	struct arena *arena)
{
	struct adding adding = {
		.primitive = drawable->primitive, .arena = arena};
	size_t count = (size_t)drawable->primitive->lod_count + 1;
	int error;

	batch->lod = ARENA_ARRAY(arena, struct batch_lod, count);
	batch->shadow = ARENA_ARRAY(arena, struct batch_lod, count);
	if (!batch->lod || !batch->shadow) {
		return -ENOMEM;
	}
	error = begin(&adding, batch);
	if (!error) {
		error = add_shaded(&adding, batch);
	}
	if (!error) {
		error = add_shadows(&adding, batch);
	}
	if (!error) {
		error = keep_all(&adding, batch);
	}
	free(adding.source);
	free(adding.corner);
	free(adding.place);
	return error;
}
