#include "app/model/levels/simplify_error.h"
#include "app/model/levels/simplify_vector.h"

#include "platform/base/scalar.h"

/* The weight of a border's planes. */
static const float border_weight = 10.0f;

static void add(struct simplify_quadric *to, const struct simplify_quadric *q)
{
	to->xx += q->xx;
	to->yy += q->yy;
	to->zz += q->zz;
	to->xy += q->xy;
	to->xz += q->xz;
	to->yz += q->yz;
	to->x += q->x;
	to->y += q->y;
	to->z += q->z;
	to->constant += q->constant;
	to->weight += q->weight;
}

/* Adds the plane with unit normal n through a point. */
static void add_plane(struct simplify_quadric *to, const float n[3],
	const float point[3], float weight)
{
	float d = -simplify_dot(n, point);
	const struct simplify_quadric plane = {
		n[0] * n[0] * weight,
		n[1] * n[1] * weight,
		n[2] * n[2] * weight,
		n[0] * n[1] * weight,
		n[0] * n[2] * weight,
		n[1] * n[2] * weight,
		n[0] * d * weight,
		n[1] * d * weight,
		n[2] * d * weight,
		d * d * weight,
		weight,
	};

	add(to, &plane);
}

static bool has_unit_length(float v[3])
{
	float length = scalar_sqrt(simplify_dot(v, v));

	if (!(length > 0.0f)) {
		return false;
	}
	for (int i = 0; i < 3; i++) {
		v[i] /= length;
	}
	return true;
}

/*
 * Adds a plane through a border edge, upright on its triangle, so that the
 * border keeps its line.
 */
static void add_border(struct simplify *simplify, uint32_t a, uint32_t b,
	const float normal[3])
{
	const float *from = simplify->position[a];
	float along[3], upright[3], weight;

	simplify_subtract(simplify->position[b], from, along);
	weight = simplify_dot(along, along) * border_weight;
	simplify_cross(along, normal, upright);
	if (has_unit_length(upright)) {
		add_plane(&simplify->quadric[simplify->leader[a]], upright,
			from, weight);
		add_plane(&simplify->quadric[simplify->leader[b]], upright,
			from, weight);
	}
}

/*
 * Whether a triangle has the edge from leader b to leader a. If both leaders
 * have many triangles, neither collapses, and the answer does not matter.
 */
static bool has_opposite(const struct simplify *simplify, uint32_t a, uint32_t b)
{
	bool at_a = simplify_mesh_valence(simplify, a) <
		simplify_mesh_valence(simplify, b);
	uint32_t own = at_a ? a : b, other = at_a ? b : a;
	uint32_t first = simplify->first_triangle[own];
	uint32_t end = simplify->first_triangle[own + 1];

	if (end - first > SIMPLIFY_VALENCE_MAX) {
		return true;
	}
	for (uint32_t i = first; i < end; i++) {
		const uint32_t *at = simplify->index + simplify->triangle[i];
		int corner = simplify_mesh_corner(
			simplify, simplify->triangle[i], own);

		/*
		 * The triangle has b before a: at a it is the previous corner,
		 * at b the next one is a.
		 */
		if (simplify->leader[at[(corner + (at_a ? 2 : 1)) % 3]] ==
			other) {
			return true;
		}
	}
	return false;
}

void simplify_error_begin(struct simplify *simplify)
{
	for (int t = 0; t < simplify->index_count; t += 3) {
		const uint32_t *at = simplify->index + t;
		const float *p = simplify->position[at[0]];
		float normal[3], area;

		simplify_normal(p, simplify->position[at[1]],
			simplify->position[at[2]], normal);
		area = scalar_sqrt(simplify_dot(normal, normal));
		if (!has_unit_length(normal)) {
			continue;
		}
		for (int i = 0; i < 3; i++) {
			uint32_t a = at[i], b = at[(i + 1) % 3];

			add_plane(&simplify->quadric[simplify->leader[a]],
				normal, p, area);
			if (!has_opposite(simplify, simplify->leader[a],
				    simplify->leader[b])) {
				add_border(simplify, a, b, normal);
			}
		}
	}
}

float simplify_error_of_shape(
	const struct simplify *simplify, uint32_t from, uint32_t to)
{
	const struct simplify_quadric *q = &simplify->quadric[from];
	const float *p = simplify->position[to];
	float sum = q->constant + p[0] * p[0] * q->xx + p[1] * p[1] * q->yy +
		p[2] * p[2] * q->zz +
		2.0f *
			(p[0] * p[1] * q->xy + p[0] * p[2] * q->xz +
				p[1] * p[2] * q->yz + p[0] * q->x +
				p[1] * q->y + p[2] * q->z);

	return q->weight > 0.0f ? scalar_sqrt(scalar_abs(sum) / q->weight)
				: 0.0f;
}

void simplify_error_collapse(
	struct simplify *simplify, uint32_t from, uint32_t to)
{
	add(&simplify->quadric[to], &simplify->quadric[from]);
}
