#include "app/scene/instance/batch/facets.h"

#include "app/anim/math/vec.h"
#include "app/scene/instance/batch/index_order.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES_MAX = 65536,
	NOT_YET = UINT16_MAX + 1
};

/* Facets under construction. */
struct making {
	int vertex_count;
	uint32_t *source; /* room for one more copy for each triangle */
	/* NOT_YET: no triangle has used this vertex so far */
	uint32_t *inverse_order;
	uint16_t *index;
	/* [vertex]: 1 if a triangle has this vertex as its last corner */
	uint8_t *ends;
};

static uint32_t add_vertex(struct making *making, uint32_t from)
{
	making->source[making->vertex_count] = from;
	return (uint32_t)making->vertex_count++;
}

static uint32_t find_vertex(struct making *making, uint32_t from)
{
	if (making->inverse_order[from] == NOT_YET) {
		making->inverse_order[from] = add_vertex(making, from);
	}
	return making->inverse_order[from];
}

/* Rotates a triangle's corners so that its last one ends no other triangle. */
static void add_triangle(
	struct making *making, const uint16_t from[3], uint16_t out[3])
{
	uint32_t corner[3];
	int last = 2;

	for (int i = 0; i < 3; i++) {
		corner[i] = find_vertex(making, from[i]);
	}
	for (int i = 2; i >= 0 && making->ends[corner[last]]; i--) {
		last = i;
	}
	if (making->ends[corner[last]]) {
		corner[last] = add_vertex(making, from[last]);
	}
	making->ends[corner[last]] = 1;
	for (int i = 0; i < 3; i++) {
		out[i] = (uint16_t)corner[(last + 1 + i) % 3];
	}
}

/* list is the primitive's index, improved by index_order_improve(). */
static void make(struct making *making, const struct model_primitive *primitive,
	const uint16_t *list)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		making->inverse_order[v] = NOT_YET;
	}
	for (int i = 0; i + 2 < primitive->index_count; i += 3) {
		add_triangle(making, list + i, making->index + i);
	}
	/* Lists for shadows may use vertices that no triangle here uses. */
	for (int v = 0; v < primitive->vertex_count; v++) {
		find_vertex(making, (uint32_t)v);
	}
}

int facets_make(const struct model_primitive *primitive, struct arena *arena,
	struct facets *out)
{
	size_t count = (size_t)primitive->index_count;
	size_t most = (size_t)primitive->vertex_count + count / 3;
	struct making making;
	uint16_t *list;
	int error = -ENOMEM;

	if (primitive->vertex_count > VERTICES_MAX) {
		return -ERANGE;
	}
	making = (struct making){
		.source = ARENA_ARRAY(arena, uint32_t, most),
		.inverse_order = ARENA_ARRAY(
			arena, uint32_t, (size_t)primitive->vertex_count),
		.index = ARENA_ARRAY(arena, uint16_t, count),
		.ends = calloc(most + 1, 1),
	};
	list = malloc(count * sizeof(*list) + 1);
	if (making.source && making.inverse_order && making.index &&
		making.ends && list) {
		for (size_t i = 0; i < count; i++) {
			list[i] = (uint16_t)primitive->index[i];
		}
		index_order_improve(list, primitive->index_count);
		make(&making, primitive, list);
		error = making.vertex_count <= VERTICES_MAX ? 0 : -ERANGE;
	}
	*out = (struct facets){making.vertex_count, making.source,
		making.inverse_order, making.index};
	free(list);
	free(making.ends);
	return error;
}

static void find_normal(
	const float a[3], const float b[3], const float c[3], float out[3])
{
	float u[3], v[3], length;

	vec_subtract(b, a, u);
	vec_subtract(c, a, v);
	vec_cross(u, v, out);
	length = vec_length(out);
	for (int i = 0; i < 3; i++) {
		out[i] = length > 0.0f ? out[i] / length : 0.0f;
	}
}

void facets_find_normals(const uint16_t *index, int count,
	const float (*position)[3], float (*normal)[3])
{
	for (int i = 0; i + 2 < count; i += 3) {
		int a = index ? index[i] : i, b = index ? index[i + 1] : i + 1;
		int c = index ? index[i + 2] : i + 2;

		find_normal(position[a], position[b], position[c], normal[c]);
		if (!index) {
			memcpy(normal[a], normal[c], sizeof(float[3]));
			memcpy(normal[b], normal[c], sizeof(float[3]));
		}
	}
}

/* Returns the magnitudes' bits, ORed; that of a negative number is one less. */
static ALWAYS_INLINE uint32_t bits_of(int32_t a, int32_t b, int32_t c)
{
	return (uint32_t)((a ^ a >> 31) | (b ^ b >> 31) | (c ^ c >> 31));
}

/* Scales components below 2^31 so that the largest one has 15 bits. */
static ALWAYS_INLINE struct fixed_vector to_shorts(
	int32_t x, int32_t y, int32_t z)
{
	int zeros = LEADING_ZEROS_32(bits_of(x, y, z) | 1);
	int up = zeros > 17 ? zeros - 17 : 0, down = zeros < 17 ? 17 - zeros : 0;

	return (struct fixed_vector){
		.x = (int16_t)((x >> down) * (1 << up)),
		.y = (int16_t)((y >> down) * (1 << up)),
		.z = (int16_t)((z >> down) * (1 << up)),
	};
}

/* Sides of more than 15 bits are divided by 4, so that products fit 32 bits. */
static ALWAYS_INLINE struct fixed_vector find_fixed_normal(
	const struct fixed_vector *a, const struct fixed_vector *b,
	const struct fixed_vector *c)
{
	int32_t ux = b->x - a->x, uy = b->y - a->y, uz = b->z - a->z;
	int32_t vx = c->x - a->x, vy = c->y - a->y, vz = c->z - a->z;
	uint32_t bits = bits_of(ux, uy, uz) | bits_of(vx, vy, vz);

	if (bits >> 15) {
		ux >>= 2, uy >>= 2, uz >>= 2;
		vx >>= 2, vy >>= 2, vz >>= 2;
	}
	return to_shorts(
		uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
}

void facets_find_fixed_normals(const uint16_t *index, int count,
	const struct fixed_vector *position, struct fixed_vector *normal)
{
	for (int i = 0; index && i + 2 < count; i += 3) {
		normal[index[i + 2]] = find_fixed_normal(&position[index[i]],
			&position[index[i + 1]], &position[index[i + 2]]);
	}
	for (int i = 0; !index && i + 2 < count; i += 3) {
		normal[i] = find_fixed_normal(
			&position[i], &position[i + 1], &position[i + 2]);
		normal[i + 1] = normal[i];
		normal[i + 2] = normal[i];
	}
}

/* Sets at to where the corners of the triangle of corner i are stored. */
static ALWAYS_INLINE void find_corners(
	const struct facets_corners *corners, int i, uint32_t at[3])
{
	const uint32_t *from = corners->index + corners->corner[i] / 3 * 3;

	for (int k = 0; k < 3; k++) {
		at[k] = corners->inverse_order ? corners->inverse_order[from[k]]
					       : from[k];
	}
}

void facets_find_normals_at(const struct facets_corners *corners,
	const float (*position)[3], float (*normal)[3])
{
	for (int i = 0; i < corners->count; i++) {
		uint32_t at[3];

		find_corners(corners, i, at);
		find_normal(position[at[0]], position[at[1]], position[at[2]],
			normal[i]);
	}
}

void facets_find_fixed_normals_at(const struct facets_corners *corners,
	const struct fixed_vector *position, struct fixed_vector *normal)
{
	for (int i = 0; i < corners->count; i++) {
		uint32_t at[3];

		find_corners(corners, i, at);
		normal[i] = find_fixed_normal(
			&position[at[0]], &position[at[1]], &position[at[2]]);
	}
}

void facets_turn_normals(int count, float (*normal)[3])
{
	for (int v = 0; v < count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			normal[v][axis] = -normal[v][axis];
		}
	}
}

void facets_turn_fixed_normals(int count, struct fixed_vector *normal)
{
	for (int v = 0; v < count; v++) {
		normal[v].x = (int16_t)-normal[v].x;
		normal[v].y = (int16_t)-normal[v].y;
		normal[v].z = (int16_t)-normal[v].z;
	}
}
