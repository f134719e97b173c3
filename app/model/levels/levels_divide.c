#include "app/model/levels/levels_divide.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

/* Copies an array of the whole primitive; NULL if it has none, or no memory. */
static void *divide_array(const struct model_primitive *whole,
	const void *array, size_t each, struct arena *arena)
{
	size_t count = (size_t)whole->index_count;
	uint8_t *out = array ? arena_alloc(arena, count, each) : NULL;

	for (size_t i = 0; out && i < count; i++) {
		memcpy(out + i * each,
			(const uint8_t *)array + whole->index[i] * each, each);
	}
	return out;
}

/* A triangle without an area gets 0. */
static void find_plane(const float corner[3][3], float out[3])
{
	const float *a = corner[0], *b = corner[1], *c = corner[2];
	float square = 0.0f, length;

	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		out[i] = (b[j] - a[j]) * (c[k] - a[k]) -
			(b[k] - a[k]) * (c[j] - a[j]);
		square += out[i] * out[i];
	}
	length = scalar_sqrt(square);
	for (int i = 0; i < 3; i++) {
		out[i] = length > 0.0f ? out[i] / length : 0.0f;
	}
}

static void find_normals(struct model_primitive *primitive)
{
	for (int i = 0; i < primitive->index_count; i += 3) {
		float *n = primitive->normal[i];

		find_plane((const float(*)[3]) & primitive->position[i], n);
		memcpy(primitive->normal[i + 1], n, sizeof(float[3]));
		memcpy(primitive->normal[i + 2], n, sizeof(float[3]));
	}
}

static bool is_whole(const struct model_primitive *whole,
	const struct levels_divided *divided)
{
	const struct model_primitive *own = &divided->primitive;

	return divided->source && divided->shared && own->position &&
		own->normal && own->index &&
		(own->texcoord || !whole->texcoord) &&
		(own->color || !whole->color) &&
		(whole->influences == 0 || (own->joint && own->weight));
}

int levels_divide(const struct model_primitive *whole, const bool *shared,
	struct arena *arena, struct levels_divided *out)
{
	size_t count = (size_t)whole->index_count;
	size_t influences = (size_t)whole->influences;
	uint32_t *own = ARENA_ARRAY(arena, uint32_t, count);

	*out = (struct levels_divided){
		.source = whole->index,
		.shared = divide_array(whole, shared, sizeof(*shared), arena),
		.primitive =
			{
				.vertex_count = whole->index_count,
				.influences = whole->influences,
				.index_count = whole->index_count,
				.index = own,
				.position = divide_array(whole, whole->position,
					sizeof(*whole->position), arena),
				.normal = arena_alloc(
					arena, count, sizeof(float[3])),
				.texcoord = divide_array(whole, whole->texcoord,
					sizeof(*whole->texcoord), arena),
				.color = divide_array(whole, whole->color,
					sizeof(*whole->color), arena),
				.joint = divide_array(whole, whole->joint,
					influences * sizeof(*whole->joint),
					arena),
				.weight = divide_array(whole, whole->weight,
					influences * sizeof(*whole->weight),
					arena),
			},
	};
	if (!is_whole(whole, out)) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < count; i++) {
		own[i] = (uint32_t)i;
	}
	find_normals(&out->primitive);
	return 0;
}

int levels_join(const struct levels_divided *divided, struct model_lod *lod,
	struct arena *arena)
{
	size_t count = (size_t)lod->index_count;

	lod->corner = ARENA_ARRAY(arena, uint32_t, count);
	if (!lod->corner) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < count; i++) {
		lod->corner[i] = lod->index[i];
		lod->index[i] = divided->source[lod->corner[i]];
	}
	return 0;
}
