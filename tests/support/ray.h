/* Rays and triangles. */
#ifndef TESTS_SUPPORT_RAY_H
#define TESTS_SUPPORT_RAY_H

#include "app/anim/math/vec.h"

#include <stdint.h>

/*
 * Where from + t * way meets a triangle whose corners are given by their
 * numbers: returns t, or -1 where it is not above 0 or the ray passes by.
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
