#include "app/scene/batch.h"

#include "app/model/color.h"
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

/* Vertex colours times the material's, or the model's own array. */
static int tint(struct batch *batch, const struct model_primitive *primitive,
	const float base_color[4], struct arena *arena)
{
	uint8_t(*color)[4];
	float factor[4];

	if (!primitive->color) {
		return 0;
	}
	if (!batch->source && is_white(base_color)) {
		batch->color = (const uint8_t(*)[4])primitive->color;
		return 0;
	}
	color = arena_alloc(arena, (size_t)batch->vertex_count, sizeof(*color));
	if (!color) {
		return -ENOMEM;
	}
	for (int i = 0; i < 3; i++) {
		factor[i] = color_encode_srgb(base_color[i]);
	}
	factor[3] = scalar_clamp(base_color[3], 0.0f, 1.0f);
	for (int v = 0; v < batch->vertex_count; v++) {
		size_t from = batch->source ? batch->source[v] : (size_t)v;

		for (int i = 0; i < 4; i++) {
			color[v][i] =
				(uint8_t)(primitive->color[from][i] * factor[i] +
					0.5f);
		}
	}
	batch->color = (const uint8_t(*)[4])color;
	return 0;
}

static int copy_texcoords(struct batch *batch,
	const struct model_primitive *primitive, struct arena *arena)
{
	float(*texcoord)[2];

	if (!primitive->texcoord || !batch->source) {
		batch->texcoord = (const float(*)[2])primitive->texcoord;
		return 0;
	}
	texcoord = arena_alloc(
		arena, (size_t)batch->vertex_count, sizeof(*texcoord));
	if (!texcoord) {
		return -ENOMEM;
	}
	for (int v = 0; v < batch->vertex_count; v++) {
		memcpy(texcoord[v], primitive->texcoord[batch->source[v]],
			sizeof(texcoord[v]));
	}
	batch->texcoord = (const float(*)[2])texcoord;
	return 0;
}

/* Attributes that do not move, and room for those that do. */
static int fill(struct batch *batch, const struct drawable *drawable,
	const float base_color[4], struct arena *arena)
{
	int error = tint(batch, drawable->primitive, base_color, arena);

	if (!error) {
		error = copy_texcoords(batch, drawable->primitive, arena);
	}
	if (error) {
		return error;
	}
	if (!batch->source) {
		batch->position = (const float(*)[3])drawable->position;
		batch->normal = (const float(*)[3])drawable->normal;
		return 0;
	}
	batch->gathered_position = arena_alloc(arena,
		(size_t)batch->vertex_count, sizeof(*batch->gathered_position));
	batch->gathered_normal = arena_alloc(arena, (size_t)batch->vertex_count,
		sizeof(*batch->gathered_normal));
	if (!batch->gathered_position || !batch->gathered_normal) {
		return -ENOMEM;
	}
	batch->position = (const float(*)[3])batch->gathered_position;
	batch->normal = (const float(*)[3])batch->gathered_normal;
	return 0;
}

static int make_whole(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	struct batch *batch = ARENA_NEW(arena, struct batch);
	uint16_t *index =
		ARENA_ARRAY(arena, uint16_t, (size_t)primitive->index_count);

	if (!batch || !index) {
		return -ENOMEM;
	}
	for (int i = 0; i < primitive->index_count; i++) {
		index[i] = (uint16_t)primitive->index[i];
	}
	*batch = (struct batch){
		.vertex_count = primitive->vertex_count,
		.index_count = primitive->index_count,
		.index = index,
	};
	drawable->batch = batch;
	drawable->batch_count = 1;
	return fill(batch, drawable, base_color, arena);
}

/*
 * Unshared triangles in runs of at most BATCH_VERTICES_MAX vertices: the index
 * list itself says where each vertex comes from.
 */
static int make_unshared(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	int most = BATCH_VERTICES_MAX / 3 * 3;
	int count = (primitive->index_count + most - 1) / most;

	drawable->batch = ARENA_ARRAY(arena, struct batch, (size_t)count);
	if (!drawable->batch) {
		return -ENOMEM;
	}
	drawable->batch_count = count;
	for (int i = 0; i < count; i++) {
		int first = i * most;
		int left = primitive->index_count - first;
		int error;

		drawable->batch[i] = (struct batch){
			.vertex_count = left < most ? left : most,
			.source = primitive->index + first,
		};
		error = fill(&drawable->batch[i], drawable, base_color, arena);
		if (error) {
			return error;
		}
	}
	return 0;
}

int batch_make(struct drawable *drawable, const float base_color[4],
	struct arena *arena)
{
	bool whole = drawable->normal &&
		drawable->primitive->vertex_count <= BATCH_VERTICES_MAX;

	return whole ? make_whole(drawable, base_color, arena)
		     : make_unshared(drawable, base_color, arena);
}

static void face_normal(
	const float a[3], const float b[3], const float c[3], float out[3])
{
	float u[3], v[3], length;

	for (int i = 0; i < 3; i++) {
		u[i] = b[i] - a[i];
		v[i] = c[i] - a[i];
	}
	out[0] = u[1] * v[2] - u[2] * v[1];
	out[1] = u[2] * v[0] - u[0] * v[2];
	out[2] = u[0] * v[1] - u[1] * v[0];
	length = scalar_sqrt(
		out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
	for (int i = 0; i < 3; i++) {
		out[i] = length > 0.0f ? out[i] / length : 0.0f;
	}
}

static void gather_flat_normals(struct batch *batch)
{
	for (int v = 0; v + 2 < batch->vertex_count; v += 3) {
		face_normal(batch->gathered_position[v],
			batch->gathered_position[v + 1],
			batch->gathered_position[v + 2],
			batch->gathered_normal[v]);
		memcpy(batch->gathered_normal[v + 1], batch->gathered_normal[v],
			sizeof(float[3]));
		memcpy(batch->gathered_normal[v + 2], batch->gathered_normal[v],
			sizeof(float[3]));
	}
}

void batch_gather(struct drawable *drawable)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		struct batch *batch = &drawable->batch[i];

		if (!batch->source) {
			continue;
		}
		for (int v = 0; v < batch->vertex_count; v++) {
			uint32_t from = batch->source[v];

			memcpy(batch->gathered_position[v],
				drawable->position[from], sizeof(float[3]));
			if (drawable->normal) {
				memcpy(batch->gathered_normal[v],
					drawable->normal[from],
					sizeof(float[3]));
			}
		}
		if (!drawable->normal) {
			gather_flat_normals(batch);
		}
	}
}
