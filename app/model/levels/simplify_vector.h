/* Vectors of a simplification. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_VECTOR_H
#define APP_MODEL_LEVELS_SIMPLIFY_VECTOR_H

static inline float simplify_dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void simplify_subtract(
	const float a[3], const float b[3], float out[3])
{
	out[0] = a[0] - b[0];
	out[1] = a[1] - b[1];
	out[2] = a[2] - b[2];
}

static inline void simplify_cross(
	const float a[3], const float b[3], float out[3])
{
	out[0] = a[1] * b[2] - a[2] * b[1];
	out[1] = a[2] * b[0] - a[0] * b[2];
	out[2] = a[0] * b[1] - a[1] * b[0];
}

/* The normal of a triangle, twice as long as its area is large. */
static inline void simplify_normal(
	const float a[3], const float b[3], const float c[3], float out[3])
{
	float ab[3], ac[3];

	simplify_subtract(b, a, ab);
	simplify_subtract(c, a, ac);
	simplify_cross(ab, ac, out);
}

#endif
