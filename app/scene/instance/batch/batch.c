#include "app/scene/instance/batch/batch.h"

#include "app/model/color.h"
#include "app/scene/instance/batch/facets.h"
#include "app/scene/instance/batch/index_order.h"
#include "app/scene/shadow/shadow_proxy.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	BATCH_VERTICES_MAX = 65536
};

static bool is_white(const float base_color[4])
{
	return base_color[0] == 1.0f && base_color[1] == 1.0f &&
		base_color[2] == 1.0f && base_color[3] == 1.0f;
}

int batch_vertex(
	const struct drawable *drawable, const struct batch *batch, int v)
{
	if (batch->source) {
		return (int)batch->source[v];
	}
	return drawable->fixed && drawable->fixed->order
		? (int)drawable->fixed->order[v]
		: v;
}

static bool in_primitive_order(
	const struct drawable *drawable, const struct batch *batch)
{
	return !batch->source && !(drawable->fixed && drawable->fixed->order);
}

/*
 * Sets vertex colours times the material's colour; without a copy if that is
 * white.
 */
static int tint(struct batch *batch, const struct drawable *drawable,
	const float base_color[4], struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	uint8_t(*color)[4];
	float factor[4];

	if (!primitive->color) {
		return 0;
	}
	if (in_primitive_order(drawable, batch) && is_white(base_color)) {
		batch->color = (const uint8_t(*)[4])primitive->color;
		return 0;
	}
	color = arena_alloc(
		arena, (size_t)batch_array_length(batch), sizeof(*color));
	if (!color) {
		return -ENOMEM;
	}
	for (int i = 0; i < 3; i++) {
		factor[i] = color_encode_srgb(base_color[i]);
	}
	factor[3] = scalar_clamp(base_color[3], 0.0f, 1.0f);
	for (int v = 0; v < batch_array_length(batch); v++) {
		int from = batch_vertex(drawable, batch, v);

		for (int i = 0; i < 4; i++) {
			color[v][i] =
				(uint8_t)(primitive->color[from][i] * factor[i] +
					0.5f);
		}
	}
	batch->color = (const uint8_t(*)[4])color;
	return 0;
}

static int copy_texcoords(struct batch *batch, const struct drawable *drawable,
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	float(*texcoord)[2];

	if (!primitive->texcoord || in_primitive_order(drawable, batch)) {
		batch->texcoord = (const float(*)[2])primitive->texcoord;
		return 0;
	}
	texcoord = arena_alloc(
		arena, (size_t)batch_array_length(batch), sizeof(*texcoord));
	if (!texcoord) {
		return -ENOMEM;
	}
	for (int v = 0; v < batch_array_length(batch); v++) {
		memcpy(texcoord[v],
			primitive->texcoord[batch_vertex(drawable, batch, v)],
			sizeof(texcoord[v]));
	}
	batch->texcoord = (const float(*)[2])texcoord;
	return 0;
}

static int fill_fixed(struct batch *batch, const struct drawable_fixed *fixed,
	struct arena *arena)
{
	size_t count = (size_t)batch_array_length(batch);

	batch->fixed_position = fixed->position;
	batch->fixed_normal = fixed->normal;
	if (!batch->source) {
		return 0;
	}
	batch->gathered_fixed = ARENA_ARRAY(arena, struct fixed_vector, count);
	batch->gathered_fixed_normal =
		ARENA_ARRAY(arena, struct fixed_vector, count);
	batch->fixed_position = batch->gathered_fixed;
	batch->fixed_normal = batch->gathered_fixed_normal;
	return batch->gathered_fixed && batch->gathered_fixed_normal ? 0
								     : -ENOMEM;
}

/* Sets the batch's arrays: copies attributes, allocates what updates write. */
static int fill(struct batch *batch, const struct drawable *drawable,
	const float base_color[4], struct arena *arena)
{
	int error = tint(batch, drawable, base_color, arena);
	size_t count;

	if (!error) {
		error = copy_texcoords(batch, drawable, arena);
	}
	if (error) {
		return error;
	}
	if (drawable->fixed) {
		return fill_fixed(batch, drawable->fixed, arena);
	}
	if (!batch->source) {
		batch->position = (const float(*)[3])drawable->position;
		batch->normal = (const float(*)[3])drawable->normal;
		return 0;
	}
	count = (size_t)batch_array_length(batch);
	batch->gathered_position =
		arena_alloc(arena, count, sizeof(*batch->gathered_position));
	batch->gathered_normal =
		arena_alloc(arena, count, sizeof(*batch->gathered_normal));
	if (!batch->gathered_position || !batch->gathered_normal) {
		return -ENOMEM;
	}
	batch->position = (const float(*)[3])batch->gathered_position;
	batch->normal = (const float(*)[3])batch->gathered_normal;
	return 0;
}

/*
 * Converts an index of the primitive's vertices to one of the arrays.
 * inverse_order is NULL if the arrays have the primitive's order. Triangles of
 * a blended surface keep their order, because a change of it would be visible.
 */
static const uint16_t *convert_list(const struct drawable *drawable,
	const uint32_t *inverse_order, const uint32_t *list, int count,
	struct arena *arena)
{
	uint16_t *index = ARENA_ARRAY(arena, uint16_t, (size_t)count);

	for (int i = 0; index && i < count; i++) {
		index[i] = (uint16_t)(inverse_order ? inverse_order[list[i]]
						    : list[i]);
	}
	if (index && drawable->alpha != MODEL_BLEND) {
		index_order_improve(index, count);
	}
	return index;
}

static int convert_lod(struct batch_lod *out, const struct drawable *drawable,
	const uint32_t *inverse_order, const struct model_lod *lod,
	struct arena *arena)
{
	*out = (struct batch_lod){
		.error = lod->error_m,
		.index_count = lod->index_count,
		.index = convert_list(drawable, inverse_order, lod->index,
			lod->index_count, arena),
		.posed_lod = model_lod_of_size(
			drawable->primitive, lod->index_count),
	};
	return out->index ? 0 : -ENOMEM;
}

/* Converts the model's coarser lists and its lists for shadows. */
static int convert_lods(struct batch *batch, const struct drawable *drawable,
	const uint32_t *inverse_order, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t count = (size_t)primitive->lod_count;
	int error = 0;

	batch->lod = ARENA_ARRAY(arena, struct batch_lod, count);
	batch->shadow = ARENA_ARRAY(arena, struct batch_lod, count + 1);
	if (!batch->lod || !batch->shadow) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < count && !error; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		error = convert_lod(lod->shadow_only
				? &batch->shadow[batch->shadow_count++]
				: &batch->lod[batch->lod_count++],
			drawable, inverse_order, lod, arena);
	}
	return error;
}

/* Makes the shadow's list of a primitive that has no lists for shadows. */
static int make_proxy(struct batch *batch,
	const struct model_primitive *primitive, const uint32_t *inverse_order,
	struct arena *arena)
{
	uint16_t *index;
	int error, index_count;

	if (batch->shadow_count > 0) {
		return 0;
	}
	error = shadow_proxy_make(
		primitive, inverse_order, arena, &index, &index_count);
	batch->shadow[0] = (struct batch_lod){
		.index_count = index_count,
		.index = index,
		.vertex_count = batch->source ? batch->vertex_count : 0,
	};
	batch->shadow_count = 1;
	return error;
}

/*
 * Makes the drawable's only batch from made, whose index holds all triangles,
 * and adds its coarser lists, lists for shadows and arrays.
 */
static int add_whole(struct drawable *drawable, const struct batch *made,
	const uint32_t *inverse_order, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	struct batch *batch = ARENA_NEW(arena, struct batch);
	int error;

	if (!batch || !made->index) {
		return -ENOMEM;
	}
	*batch = *made;
	drawable->batch = batch;
	drawable->batch_count = 1;
	error = batch->source
		? batch_add_levels(batch, drawable, arena)
		: convert_lods(batch, drawable, inverse_order, arena);
	if (!error) {
		error = make_proxy(batch, primitive, inverse_order, arena);
	}
	return error ? error : fill(batch, drawable, base_color, arena);
}

static int make_whole(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	const uint32_t *inverse_order =
		drawable->fixed ? drawable->fixed->inverse_order : NULL;

	return add_whole(drawable,
		&(struct batch){
			.vertex_count = primitive->vertex_count,
			.index_count = primitive->index_count,
			.index = convert_list(drawable, inverse_order,
				primitive->index, primitive->index_count, arena),
		},
		inverse_order, base_color, arena);
}

static int make_faceted(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	struct facets facets;
	int error = facets_make(drawable->primitive, arena, &facets);

	return error ? error
		     : add_whole(drawable,
			       &(struct batch){
				       .vertex_count = facets.vertex_count,
				       .source = facets.source,
				       .index_count =
					       drawable->primitive->index_count,
				       .index = facets.index,
			       },
			       facets.inverse_order, base_color, arena);
}

/*
 * The first batch gets all coarser lists, by whose errors they are chosen; the
 * others get empty ones.
 */
static int add_levels_to_unindexed(
	struct drawable *drawable, int number, struct arena *arena)
{
	struct batch *batch = &drawable->batch[number];
	const struct batch *first = drawable->batch;
	size_t count = (size_t)(first->lod_count + first->shadow_count);

	if (number == 0) {
		return batch_add_levels(batch, drawable, arena);
	}
	batch->lod = ARENA_ARRAY(arena, struct batch_lod, count);
	batch->lod_count = first->lod_count;
	batch->shadow_count = first->shadow_count;
	if (!batch->lod) {
		return -ENOMEM;
	}
	batch->shadow = batch->lod + first->lod_count;
	for (int i = 0; i < first->shadow_count; i++) {
		batch->shadow[i].posed_lod = first->shadow[i].posed_lod;
	}
	return 0;
}

/*
 * Makes batches of at most BATCH_VERTICES_MAX vertices without an index. Their
 * sources are parts of the primitive's index.
 */
static int make_unindexed(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	int max = BATCH_VERTICES_MAX / 3 * 3;
	int count = (primitive->index_count + max - 1) / max;

	drawable->batch = ARENA_ARRAY(arena, struct batch, (size_t)count);
	if (!drawable->batch) {
		return -ENOMEM;
	}
	drawable->batch_count = count;
	for (int i = 0; i < count; i++) {
		int first = i * max;
		int left = primitive->index_count - first;
		int error;

		drawable->batch[i] = (struct batch){
			.vertex_count = left < max ? left : max,
			.source = primitive->index + first,
		};
		error = add_levels_to_unindexed(drawable, i, arena);
		if (!error) {
			error = fill(&drawable->batch[i], drawable, base_color,
				arena);
		}
		if (error) {
			return error;
		}
	}
	return 0;
}

/* Returns true if flat shading does not change the vertex colours. */
static bool has_one_color_a_triangle(const struct model_primitive *primitive)
{
	const uint32_t *index = primitive->index;

	for (int i = 0; primitive->color && i + 2 < primitive->index_count;
		i += 3) {
		const uint8_t *first = primitive->color[index[i]];

		if (memcmp(first, primitive->color[index[i + 1]], 4) != 0 ||
			memcmp(first, primitive->color[index[i + 2]], 4) != 0) {
			return false;
		}
	}
	return true;
}

int batch_make(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	int error = -ERANGE;

	if (primitive->normal && primitive->vertex_count <= BATCH_VERTICES_MAX) {
		return make_whole(drawable, base_color, arena);
	}
	/* Facets change the order of triangles; blended ones must keep it. */
	if (!primitive->normal && drawable->alpha != MODEL_BLEND &&
		has_one_color_a_triangle(primitive)) {
		error = make_faceted(drawable, base_color, arena);
	}
	return error == -ERANGE ? make_unindexed(drawable, base_color, arena)
				: error;
}
