#include "app/anim/kernel/layout/fixed_keys.h"

#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/layout/fixed_attribute.h"
#include "app/anim/kernel/layout/fixed_key.h"
#include "app/model/model_deltas.h"
#include "platform/base/count.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	KEY_MAX = 16383
};

const struct fixed_placement fixed_keys_directions = {
	1.0f / KEY_MAX, {0.0f, 0.0f, 0.0f}};

/* Computes a vertex of key 0, or of a target at its full weight. */
static void vertex_of(const struct model_primitive *primitive,
	enum fixed_attribute attribute, int key, int vertex, float out[3])
{
	const float *base =
		fixed_attribute_of(primitive, attribute, (uint32_t)vertex);
	float delta[3] = {0.0f, 0.0f, 0.0f};

	if (key > 0) {
		model_deltas_get(fixed_attribute_deltas(
					 &primitive->target[key - 1], attribute),
			vertex, delta);
	}
	for (int k = 0; k < 3; k++) {
		out[k] = base[k] + delta[k];
	}
}

static int choose_placement(
	struct fixed_keys *keys, const struct model_primitive *primitive)
{
	struct fixed_range range = fixed_range_empty();

	for (int key = 0; key <= keys->target_count; key++) {
		for (int v = 0; v < keys->vertex_count; v++) {
			float at[1][3];

			vertex_of(primitive, FIXED_POSITION, key, v, at[0]);
			fixed_range_add(&range, 1, (const float(*)[3])at);
		}
	}
	return fixed_range_placement(&range, &keys->placement);
}

static int16_t number(float value)
{
	return (int16_t)(-2 *
		fixed_round(scalar_clamp(value, -KEY_MAX, KEY_MAX)));
}

void fixed_keys_convert(int count, const float (*vector)[3],
	const struct fixed_placement *placement, struct fixed_key *out)
{
	const float *from = placement->offset;
	float scale = 1.0f / placement->scale;

	for (int i = 0; i < count; i++) {
		out[i].x = number((vector[i][0] - from[0]) * scale);
		out[i].y = number((vector[i][1] - from[1]) * scale);
		out[i].z = number((vector[i][2] - from[2]) * scale);
	}
}

/*
 * Shortens a direction to length 1. A sum of base and delta is often a little
 * longer, and fixed_keys_convert() would clamp each axis on its own.
 */
static void make_short(float v[3])
{
	float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

	if (square > 1.0f) {
		float scale = 1.0f / scalar_sqrt(square);

		for (int k = 0; k < 3; k++) {
			v[k] *= scale;
		}
	}
}

static int write_keys(struct fixed_keys *keys,
	const struct model_primitive *primitive, enum fixed_attribute attribute,
	struct arena *arena)
{
	const struct fixed_placement *placement = attribute == FIXED_POSITION
		? &keys->placement
		: &fixed_keys_directions;
	struct fixed_key *first;
	size_t count;

	if (!size_multiply((size_t)keys->stride, 1 + (size_t)keys->target_count,
		    &count)) {
		return -ENOMEM;
	}
	first = ARENA_ARRAY(arena, struct fixed_key, count);
	keys->key[attribute] = first;
	if (!first) {
		return -ENOMEM;
	}
	for (int key = 0; key <= keys->target_count; key++) {
		struct fixed_key *out =
			first + (size_t)key * (size_t)keys->stride;

		for (int v = 0; v < keys->vertex_count; v++) {
			float at[1][3];

			vertex_of(primitive, attribute, key, v, at[0]);
			if (attribute != FIXED_POSITION) {
				make_short(at[0]);
			}
			fixed_keys_convert(
				1, (const float(*)[3])at, placement, &out[v]);
		}
	}
	return 0;
}

/* Uses the model's key frames. Returns false if a wanted array is missing. */
static bool take_keys(struct fixed_keys *keys, const struct model_keys *from,
	unsigned streams)
{
	const unsigned wanted[FIXED_ATTRIBUTES] = {
		[FIXED_NORMAL] = FIXED_NORMALS,
		[FIXED_TANGENT] = FIXED_TANGENTS,
	};

	keys->placement = (struct fixed_placement){from->scale,
		{from->offset[0], from->offset[1], from->offset[2]}};
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (a == FIXED_POSITION || (streams & wanted[a])) {
			keys->key[a] = (const struct fixed_key *)from->key[a];
			if (!keys->key[a]) {
				return false;
			}
		}
	}
	return true;
}

int fixed_keys_init(struct fixed_keys *keys,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena)
{
	int error;

	*keys = (struct fixed_keys){
		.vertex_count = primitive->vertex_count,
		.stride = primitive->vertex_count + primitive->vertex_count % 2,
		.target_count = target_count,
	};
	if (primitive->keys && take_keys(keys, primitive->keys, streams)) {
		return 0;
	}
	error = choose_placement(keys, primitive);
	if (!error) {
		error = write_keys(keys, primitive, FIXED_POSITION, arena);
	}
	if (!error && (streams & FIXED_NORMALS)) {
		error = write_keys(keys, primitive, FIXED_NORMAL, arena);
	}
	if (!error && (streams & FIXED_TANGENTS)) {
		error = write_keys(keys, primitive, FIXED_TANGENT, arena);
	}
	return error;
}

size_t fixed_keys_bytes(const struct fixed_keys *keys)
{
	size_t bytes = 0;

	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		bytes += keys->key[a] ? (1 + (size_t)keys->target_count) *
				(size_t)keys->stride * sizeof(struct fixed_key)
				      : 0;
	}
	return bytes;
}
