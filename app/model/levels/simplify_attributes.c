#include "app/model/levels/simplify_attributes.h"
#include "app/model/levels/simplify_vector.h"

#include "platform/base/scalar.h"

#include <string.h>

/*
 * Factors that convert a difference of 1 in an attribute to the distance that
 * looks as bad, in fractions of the longest side. For weights it is what
 * bending a limb moves a vertex by.
 */
static const float normal_distance = 0.009f;
static const float color_distance = 0.05f; /* from black to white */
static const float weight_distance = 0.05f;
static const float texture_factor = 1.0f;

/* How far bending a joint by 60 degrees moves a point at a distance of 1. */
static const float bend_distance = 1.0f;

/* A point on a triangle, in barycentric coordinates. */
struct place {
	const uint32_t *vertex;
	float share[3];
	float square; /* square of the distance from the given point */
};

/*
 * Finds the point of a triangle that is nearest to the given point; outside an
 * obtuse corner only approximately.
 */
static void find_place(const struct simplify *simplify, const float point[3],
	struct place *place)
{
	const float *a = simplify->position[place->vertex[0]];
	float u[3], v[3], d[3], sum = 0.0f, away[3];
	float uu, uv, vv, du, dv, area;

	simplify_subtract(simplify->position[place->vertex[1]], a, u);
	simplify_subtract(simplify->position[place->vertex[2]], a, v);
	simplify_subtract(point, a, d);
	uu = simplify_dot(u, u);
	uv = simplify_dot(u, v);
	vv = simplify_dot(v, v);
	du = simplify_dot(d, u);
	dv = simplify_dot(d, v);
	area = uu * vv - uv * uv;
	area = area > 0.0f ? 1.0f / area : 0.0f;
	place->share[1] = (vv * du - uv * dv) * area;
	place->share[2] = (uu * dv - uv * du) * area;
	place->share[0] = 1.0f - place->share[1] - place->share[2];
	for (int i = 0; i < 3; i++) {
		place->share[i] = scalar_max(place->share[i], 0.0f);
		sum += place->share[i];
	}
	for (int i = 0; i < 3; i++) {
		place->share[i] /= sum;
		away[i] = d[i];
	}
	for (int i = 0; i < 3; i++) {
		away[i] -= place->share[1] * u[i] + place->share[2] * v[i];
	}
	place->square = simplify_dot(away, away);
}

static float difference(const float *value, const float (*corner)[3], int width,
	const struct place *place)
{
	float square = 0.0f;

	for (int i = 0; i < width; i++) {
		float d = value[i] - place->share[0] * corner[0][i] -
			place->share[1] * corner[1][i] -
			place->share[2] * corner[2][i];

		square += d * d;
	}
	return square;
}

static float normal_square(const struct model_primitive *primitive,
	uint32_t vertex, const struct place *place)
{
	float corner[3][3];

	for (int i = 0; i < 3; i++) {
		memcpy(corner[i], primitive->normal[place->vertex[i]],
			sizeof(corner[i]));
	}
	return difference(primitive->normal[vertex], (const float(*)[3])corner,
		       3, place) *
		normal_distance * normal_distance;
}

static float color_square(const struct model_primitive *primitive,
	uint32_t vertex, const struct place *place)
{
	const float scale = color_distance / 255.0f;
	float corner[3][3], value[3];

	for (int i = 0; i < 3; i++) {
		value[i] = primitive->color[vertex][i];
		for (int j = 0; j < 3; j++) {
			corner[j][i] = primitive->color[place->vertex[j]][i];
		}
	}
	return difference(value, (const float(*)[3])corner, 3, place) * scale *
		scale;
}

static float texture_square(const struct simplify *simplify, uint32_t vertex,
	const struct place *place)
{
	const struct model_primitive *primitive = simplify->primitive;
	const float scale = simplify->texture_scale * texture_factor;
	float corner[3][3];

	for (int i = 0; i < 3; i++) {
		memcpy(corner[i], primitive->texcoord[place->vertex[i]],
			sizeof(primitive->texcoord[0]));
	}
	return difference(primitive->texcoord[vertex],
		       (const float(*)[3])corner, 2, place) *
		scale * scale;
}

static float weight_of(const struct model_primitive *primitive, uint32_t vertex,
	uint16_t joint)
{
	size_t count = (size_t)primitive->influences, at = vertex * count;
	float weight = 0.0f;

	for (size_t i = at; i < at + count; i++) {
		if (primitive->joint[i] == joint) {
			weight += primitive->weight[i];
		}
	}
	return weight;
}

/*
 * Sums only the weights that are too small: since weights sum to 1, others are
 * too large by as much.
 */
static float weight_square(const struct model_primitive *primitive,
	uint32_t vertex, const struct place *place)
{
	size_t count = (size_t)primitive->influences, at = vertex * count;
	float lack = 0.0f;

	for (size_t i = at; i < at + count; i++) {
		float left = primitive->weight[i];

		for (int j = 0; j < 3 && left > 0.0f; j++) {
			left -= place->share[j] *
				weight_of(primitive, place->vertex[j],
					primitive->joint[i]);
		}
		lack += scalar_max(left, 0.0f);
	}
	return lack * lack * weight_distance * weight_distance;
}

/* Returns a joint's weight at the place, and its weights at the corners. */
static float shared_weight(const struct simplify *simplify,
	const struct place *place, uint16_t joint, float weight[3])
{
	float sum = 0.0f;

	for (int k = 0; k < 3; k++) {
		weight[k] =
			weight_of(simplify->primitive, place->vertex[k], joint);
		sum += place->share[k] * weight[k];
	}
	return sum;
}

/* Whether influence i has weight and is the first one, from `at`, of its joint. */
static bool is_first(
	const struct model_primitive *primitive, size_t at, size_t i)
{
	while (at < i &&
		(primitive->joint[at] != primitive->joint[i] ||
			primitive->weight[at] <= 0.0f)) {
		at++;
	}
	return at == i && primitive->weight[i] > 0.0f;
}

/*
 * Returns the length of the covariance of weight and position over the corners,
 * for the joint of influence i of a corner; 0 if an earlier influence or corner
 * has the joint, too.
 */
static float covariance(const struct simplify *simplify,
	const struct place *place, int corner, size_t i)
{
	const struct model_primitive *primitive = simplify->primitive;
	size_t at = place->vertex[corner] * (size_t)primitive->influences;
	float weight[3], along[3] = {0.0f, 0.0f, 0.0f}, mean;

	if (!is_first(primitive, at, at + i)) {
		return 0.0f;
	}
	mean = shared_weight(simplify, place, primitive->joint[at + i], weight);
	if ((corner > 0 && weight[0] > 0.0f) ||
		(corner > 1 && weight[1] > 0.0f)) {
		return 0.0f;
	}
	for (int k = 0; k < 3; k++) {
		const float *p = simplify->position[place->vertex[k]];
		float factor = place->share[k] * (weight[k] - mean);

		for (int axis = 0; axis < 3; axis++) {
			along[axis] += factor * p[axis];
		}
	}
	return scalar_sqrt(simplify_dot(along, along));
}

/*
 * The error of a bent limb. A skin moves a point by products of weights and
 * position. If both change along a triangle, a straight edge cuts off the curve
 * of a bent limb, for each joint by the covariance of weight and position over
 * the corners, times the bend. Each joint counts half, because the weight that
 * one joint loses another one gains.
 */
static float bend_square(
	const struct simplify *simplify, const struct place *place)
{
	size_t count = (size_t)simplify->primitive->influences;
	float sum = 0.0f;

	for (int corner = 0; corner < 3; corner++) {
		for (size_t i = 0; i < count; i++) {
			sum += covariance(simplify, place, corner, i);
		}
	}
	sum *= 0.5f * bend_distance;
	return sum * sum;
}

static float delta_square(const struct simplify *simplify,
	const float (*delta)[3], uint32_t vertex, const struct place *place,
	float scale)
{
	const uint32_t *source = simplify->source;
	float corner[3][3];

	if (!delta) {
		return 0.0f;
	}
	for (int i = 0; i < 3; i++) {
		uint32_t at = place->vertex[i];

		memcpy(corner[i], delta[source ? source[at] : at],
			sizeof(corner[i]));
	}
	vertex = source ? source[vertex] : vertex;
	return difference(delta[vertex], (const float(*)[3])corner, 3, place) *
		scale * scale;
}

/* The error of the target that changes most, at its weight of 1. */
static float target_square(const struct simplify *simplify, uint32_t vertex,
	const struct place *place)
{
	float most = 0.0f;

	for (int t = 0; t < simplify->target_count; t++) {
		const struct simplify_target *target = &simplify->target[t];
		float square = delta_square(simplify, target->position, vertex,
			place, 1.0f / simplify->extent);

		if (!simplify->shape_only) {
			square += delta_square(simplify, target->normal, vertex,
				place, normal_distance);
		}
		most = scalar_max(square, most);
	}
	return most;
}

static float square_at(const struct simplify *simplify, uint32_t vertex,
	const struct place *place)
{
	const struct model_primitive *primitive = simplify->primitive;
	float square = target_square(simplify, vertex, place);

	if (primitive->influences > 0) {
		square += weight_square(primitive, vertex, place) +
			bend_square(simplify, place);
	}
	if (simplify->shape_only) {
		return square;
	}
	square += normal_square(primitive, vertex, place);
	if (primitive->color) {
		square += color_square(primitive, vertex, place);
	}
	if (primitive->texcoord) {
		square += texture_square(simplify, vertex, place);
	}
	return square;
}

/* Returns a vertex's squared error; 0 if no triangle has the vertex. */
static float vertex_square(const struct simplify *simplify, uint32_t from,
	uint32_t to, uint32_t vertex)
{
	struct place best = {.vertex = NULL};
	uint32_t corners[2][3];
	int turn = 0;

	for (uint32_t i = simplify->first_triangle[from];
		i < simplify->first_triangle[from + 1]; i++) {
		uint32_t t = simplify->triangle[i];
		int corner = simplify_mesh_corner(simplify, t, from);
		struct place place = {.vertex = corners[turn]};

		memcpy(corners[turn], simplify->index + t, sizeof(corners[0]));
		if (corners[turn][corner] != vertex ||
			simplify_mesh_has(simplify, t, to)) {
			continue;
		}
		corners[turn][corner] = simplify->to[vertex];
		find_place(simplify, simplify->position[vertex], &place);
		if (!best.vertex || place.square < best.square) {
			best = place;
			turn = !turn;
		}
	}
	return best.vertex ? square_at(simplify, vertex, &best) : 0.0f;
}

float simplify_error_of_attributes(
	const struct simplify *simplify, uint32_t from, uint32_t to)
{
	float most = 0.0f;
	uint32_t vertex = from;

	do {
		float square = vertex_square(simplify, from, to, vertex);

		most = scalar_max(square, most);
		vertex = simplify->next[vertex];
	} while (vertex != from);
	return scalar_sqrt(most);
}

float simplify_square_of_merge(
	const struct simplify *simplify, uint32_t from, uint32_t to)
{
	const uint32_t corner[3] = {to, to, to};
	const struct place place = {.vertex = corner, .share = {1.0f}};

	return square_at(simplify, from, &place);
}
