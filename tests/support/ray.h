/* Rays and triangles. */
#ifndef TESTS_SUPPORT_RAY_H
#define TESTS_SUPPORT_RAY_H

#include "app/anim/math/vec.h"

#include <stdint.h>

/*
 * Intersects the ray from + t * way with a triangle, whose corners are indices
 * into position (the algorithm of Moeller and Trumbore). Returns t, which is
 * above 0, or -1 if the ray misses the triangle.
 */
static inline float ray_meet(const float from[3], const float way[3],
	const float (*position)[3], const uint16_t corner[3])
{
	const float *a = position[corner[0]];
	float edge[2][3], offset[3], across[3], along[3], size, u, v, t;

	vec_subtract(position[corner[1]], a, edge[0]);
	vec_subtract(position[corner[2]], a, edge[1]);
	vec_subtract(from, a, offset);
	vec_cross(way, edge[1], across);
	vec_cross(offset, edge[0], along);
	size = vec_dot(edge[0], across);
	u = vec_dot(offset, across) / size;
	v = vec_dot(way, along) / size;
	t = vec_dot(edge[1], along) / size;
	return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f ? t : -1.0f;
}

#endif
