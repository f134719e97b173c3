#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"
#include "platform/base/count.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>

enum {
	KEY_MAX = 16383,
	ATTRIBUTES = 3, /* positions, normals, tangents */
	BYTE_ONE = 127,
	KEY_OF_BYTE = KEY_MAX / BYTE_ONE
};

/* How the file's numbers become those of keys: (number - center) * factor. */
struct key_format {
	float one;       /* the number that stands for 1 in the file */
	float center[3]; /* the file's number that becomes 0 in keys */
	int factor;
};

struct store {
	struct model_primitive *primitive;
	int target_count, stride;
	bool tangents; /* whether to store them */
	bool rounded;  /* whether keys may differ from the file's numbers */
	struct key_format format[ATTRIBUTES];
	int16_t (*key[ATTRIBUTES])[3];
};

static struct model_deltas *deltas_of(
	const struct store *store, int target, int attribute)
{
	struct model_target *of = &store->primitive->target[target];

	return attribute == 0    ? &of->position
		: attribute == 1 ? &of->normal
				 : &of->tangent;
}

static bool has_attribute(const struct store *store, int attribute)
{
	const struct model_primitive *primitive = store->primitive;

	return attribute == 0 || (attribute == 1 && primitive->normal) ||
		(attribute == 2 && store->tangents);
}

static const float *base_of(const struct store *store, int attribute, int vertex)
{
	const struct model_primitive *primitive = store->primitive;

	return attribute == 0    ? primitive->position[vertex]
		: attribute == 1 ? primitive->normal[vertex]
				 : primitive->tangent[vertex];
}

/*
 * Whether all displacements are integers with the same unit. Sets *one to this
 * unit, or to 0 if there are no displacements.
 */
static bool are_integers(const struct store *store, int attribute, float *one)
{
	*one = 0.0f;
	for (int t = 0; t < store->target_count; t++) {
		const struct model_deltas *deltas =
			deltas_of(store, t, attribute);

		if (deltas->vertex_count == 0) {
			continue;
		}
		if (deltas->number == MODEL_FLOAT || deltas->base ||
			(*one > 0.0f && deltas->unit != *one)) {
			return false;
		}
		*one = deltas->unit;
	}
	return true;
}

/*
 * Shortens a direction to length 1: a sum of base and displacement may be a
 * little longer, which keys cannot hold.
 */
static void make_short(float v[3])
{
	float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

	for (int k = 0; k < 3 && square > 1.0f; k++) {
		v[k] /= scalar_sqrt(square);
	}
}

/*
 * Adds a target's displacement to the numbers of key 0, so that the sum is the
 * displaced vertex, rounded. one converts to the numbers of keys.
 */
static void round_vertex(const struct store *store, int attribute, int target,
	int vertex, float one, float number[3])
{
	const float *base = base_of(store, attribute, vertex);
	float at[3];

	model_deltas_get(deltas_of(store, target, attribute), vertex, at);
	for (int k = 0; k < 3; k++) {
		at[k] += base[k];
	}
	if (attribute > 0) {
		make_short(at);
	}
	for (int k = 0; k < 3; k++) {
		number[k] += rintf(at[k] * one) - rintf(base[k] * one);
	}
}

/* Adds a target's displacement to the numbers of key 0. */
static void add_displacement(const struct store *store, int attribute,
	int target, int vertex, const struct key_format *format, float number[3])
{
	int moved[3];

	if (store->rounded) {
		round_vertex(
			store, attribute, target, vertex, format->one, number);
		return;
	}
	model_deltas_numbers(deltas_of(store, target, attribute), vertex, moved);
	for (int k = 0; k < 3; k++) {
		number[k] += (float)format->factor * (float)moved[k];
	}
}

/* Extends the box low..high by the positions of all key frames, times one. */
static void find_box(
	const struct store *store, float one, float low[3], float high[3])
{
	int count = store->primitive->vertex_count * (1 + store->target_count);

	for (int i = 0; i < count; i++) {
		int v = i / (1 + store->target_count);
		int key = i % (1 + store->target_count);
		float at[3];

		for (int k = 0; k < 3; k++) {
			at[k] = store->primitive->position[v][k] * one;
		}
		if (key > 0) {
			float moved[3];

			model_deltas_get(deltas_of(store, key - 1, 0), v, moved);
			for (int k = 0; k < 3; k++) {
				at[k] += moved[k] * one;
			}
		}
		for (int k = 0; k < 3; k++) {
			low[k] = fminf(low[k], at[k]);
			high[k] = fmaxf(high[k], at[k]);
		}
	}
}

/*
 * Returns the unit with which the box around all key frames fills 15 bits, or 0
 * if the box is too large.
 */
static float unit_of_floats(const struct store *store)
{
	float low[3] = {1e9f, 1e9f, 1e9f}, high[3] = {-1e9f, -1e9f, -1e9f};
	float half = 1e-12f;

	find_box(store, 1.0f, low, high);
	for (int k = 0; k < 3; k++) {
		half = fmaxf(half, 0.5f * (high[k] - low[k]));
	}
	return half < 1e9f ? (KEY_MAX - 1) / half : 0.0f;
}

/*
 * Chooses the format of positions. Returns false if they do not fit. The factor
 * is a power of two, so that displacements that are read from keys equal those
 * of the file to the bit.
 */
static bool choose_position_format(struct store *store)
{
	struct key_format *format = &store->format[0];
	float low[3] = {1e9f, 1e9f, 1e9f}, high[3] = {-1e9f, -1e9f, -1e9f};
	float half = 0.0f;

	if (store->rounded) {
		format->one = unit_of_floats(store);
	} else if (!are_integers(store, 0, &format->one)) {
		return false;
	}
	if (format->one == 0.0f) {
		return false;
	}
	find_box(store, format->one, low, high);
	for (int k = 0; k < 3; k++) {
		float center = rintf(0.5f * low[k] + 0.5f * high[k]);

		format->center[k] = center;
		half = fmaxf(half, fmaxf(high[k] - center, center - low[k]));
	}
	if (!(half <= KEY_MAX) ||
		!(scalar_abs(format->center[0]) < 1e6f &&
			scalar_abs(format->center[1]) < 1e6f &&
			scalar_abs(format->center[2]) < 1e6f)) {
		return false;
	}
	format->factor = 1;
	while (!store->rounded && format->factor < 8192 &&
		(half + 0.5f) * (float)format->factor * 2.0f <= KEY_MAX) {
		format->factor *= 2;
	}
	return true;
}

static bool choose_direction_format(struct store *store, int attribute)
{
	struct key_format *format = &store->format[attribute];
	float one;

	if (store->rounded) {
		*format = (struct key_format){.one = KEY_MAX, .factor = 1};
		return true;
	}
	*format = (struct key_format){.one = BYTE_ONE, .factor = KEY_OF_BYTE};
	return are_integers(store, attribute, &one) &&
		(one == 0.0f || one == (float)BYTE_ONE);
}

/*
 * Computes the numbers of a vertex in a key. Returns false if they do not fit.
 * Writes them, times -2, if the keys are allocated.
 */
static bool make_vertex(
	const struct store *store, int attribute, int key, int vertex)
{
	const struct key_format *format = &store->format[attribute];
	const float *base = base_of(store, attribute, vertex);
	float factor = (float)format->factor, number[3];
	int16_t *out = store->key[attribute]
		? store->key[attribute][(size_t)key * (size_t)store->stride +
			  (size_t)vertex]
		: NULL;

	for (int k = 0; k < 3; k++) {
		number[k] = rintf(
			(base[k] * format->one - format->center[k]) * factor);
	}
	if (key > 0) {
		add_displacement(
			store, attribute, key - 1, vertex, format, number);
	}
	for (int k = 0; k < 3; k++) {
		if (!(scalar_abs(number[k]) <= KEY_MAX)) {
			return false;
		}
		if (out) {
			out[k] = (int16_t)(-2.0f * number[k]);
		}
	}
	return true;
}

static bool make_key(const struct store *store, int attribute, int key)
{
	for (int v = 0; v < store->primitive->vertex_count; v++) {
		if (!make_vertex(store, attribute, key, v)) {
			return false;
		}
	}
	return true;
}

/* Checks whether all keys fit and, once they are allocated, writes them. */
static bool make_keys(const struct store *store)
{
	for (int a = 0; a < ATTRIBUTES; a++) {
		for (int key = 0;
			has_attribute(store, a) && key <= store->target_count;
			key++) {
			if (!make_key(store, a, key)) {
				return false;
			}
		}
	}
	return true;
}

static int allocate(struct store *store, struct arena *arena)
{
	size_t count;

	if (!size_multiply((size_t)store->stride,
		    1 + (size_t)store->target_count, &count)) {
		return -ENOMEM;
	}
	for (int a = 0; a < ATTRIBUTES; a++) {
		if (!has_attribute(store, a)) {
			continue;
		}
		store->key[a] =
			arena_alloc(arena, count, sizeof(*store->key[a]));
		if (!store->key[a]) {
			return -ENOMEM;
		}
	}
	return 0;
}

/* Changes the targets' deltas so that they read displacements from the keys. */
static void refer(const struct store *store)
{
	for (int i = 0; i < store->target_count * ATTRIBUTES; i++) {
		int t = i / ATTRIBUTES, a = i % ATTRIBUTES;
		const struct key_format *format = &store->format[a];
		struct model_deltas *deltas = deltas_of(store, t, a);
		const int16_t(*key)[3] = (const int16_t(*)[3])store->key[a];

		if (deltas->vertex_count > 0 && key) {
			*deltas = (struct model_deltas){
				.vertex_count = deltas->vertex_count,
				.number = MODEL_INT16,
				.unit = -2.0f * (float)format->factor *
					format->one,
				.value = key +
					(size_t)(t + 1) * (size_t)store->stride,
				.base = key,
			};
		}
	}
}

static bool choose_formats(struct store *store)
{
	return choose_position_format(store) &&
		choose_direction_format(store, 1) &&
		(!store->tangents || choose_direction_format(store, 2)) &&
		make_keys(store);
}

int model_keys_store(struct model_primitive *primitive, int target_count,
	bool tangents, bool rounded, struct arena *arena)
{
	struct store store = {
		.rounded = rounded,
		.primitive = primitive,
		.target_count = target_count,
		.stride = primitive->vertex_count + primitive->vertex_count % 2,
		.tangents = tangents && primitive->tangent,
	};
	const struct key_format *format = &store.format[0];
	struct model_keys *keys;

	if (!choose_formats(&store)) {
		return 0;
	}
	keys = ARENA_NEW(arena, struct model_keys);
	if (!keys || allocate(&store, arena) != 0) {
		return -ENOMEM;
	}
	make_keys(&store);
	*keys = (struct model_keys){
		.stride = store.stride,
		.scale = 1.0f / ((float)format->factor * format->one),
	};
	for (int k = 0; k < 3; k++) {
		keys->offset[k] = format->center[k] / format->one;
		keys->key[k] = (const int16_t(*)[3])store.key[k];
	}
	refer(&store);
	primitive->keys = keys;
	return 0;
}

size_t model_keys_bytes(const struct model_keys *keys, int target_count)
{
	size_t bytes = 0;

	for (int a = 0; a < ATTRIBUTES; a++) {
		bytes += keys->key[a] ? (1 + (size_t)target_count) *
				(size_t)keys->stride * sizeof(int16_t[3])
				      : 0;
	}
	return bytes;
}
