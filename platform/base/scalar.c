#include "platform/base/scalar.h"

#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static const float HALF_PI = 1.57079632679f;
static const float LARGEST_ANGLE = 1073741824.0f; /* 2^30 */

/*
 * Subtracts a multiple of pi/2, so that the remainder lies in -pi/4..pi/4, and
 * returns that multiple modulo 4. In double the error of the reduction is below
 * 1e-12 for angles up to 8192.
 */
static unsigned reduce(float angle_rad, float *remainder)
{
	const double half_pi = 1.57079632679489661923;
	double turns = angle_rad * (1.0 / half_pi);
	int32_t quadrant;

	if (!(scalar_abs(angle_rad) < LARGEST_ANGLE)) {
		*remainder = 0;
		return 0;
	}
	quadrant = (int32_t)(turns < 0 ? turns - 0.5 : turns + 0.5);
	*remainder = (float)(angle_rad - quadrant * half_pi);
	return (unsigned)quadrant & 3;
}

/* Minimax polynomial for -pi/4..pi/4; its error is 2e-9 before rounding. */
static float sin_core(float r)
{
	float z = r * r;

	return r +
		r * z *
		(-0.1666665019f + z * (0.0083319516f + z * -0.0001949221f));
}

static float cos_core(float r)
{
	float z = r * r;

	return 1 +
		z *
		(-0.5f +
			z *
				(0.041666646269f +
					z *
						(-0.0013887337083f +
							z * 0.000024434846036f)));
}

static float sin_of_quadrant(unsigned quadrant, float r)
{
	float value = quadrant & 1 ? cos_core(r) : sin_core(r);

	return quadrant & 2 ? -value : value;
}

float scalar_sin(float angle_rad)
{
	float r;
	unsigned quadrant = reduce(angle_rad, &r);

	return sin_of_quadrant(quadrant, r);
}

float scalar_cos(float angle_rad)
{
	float r;
	unsigned quadrant = reduce(angle_rad, &r);

	return sin_of_quadrant(quadrant + 1, r);
}

/*
 * acos(x) / sqrt(1 - x) is smooth on 0..1, so a minimax polynomial of it is
 * multiplied by the root; its error is 9e-8.
 */
static float acos_positive(float x)
{
	float p = 0.00261172f;

	p = p * x - 0.0120033934f;
	p = p * x + 0.0277629118f;
	p = p * x - 0.0491974362f;
	p = p * x + 0.0888358856f;
	p = p * x - 0.2145910887f;
	p = p * x + 1.5707962389f;
	return p * scalar_sqrt(1 - x);
}

float scalar_acos(float cosine)
{
	if (!(cosine < 1)) {
		return 0;
	}
	if (cosine >= 0) {
		return acos_positive(cosine);
	}
	return SCALAR_PI - acos_positive(cosine > -1 ? -cosine : 1);
}

/* Minimax polynomial for 0..1; its error is 5e-8. */
static float atan_core(float x)
{
	float z = x * x;
	float p = -0.0043554029f;

	p = p * z + 0.0230401253f;
	p = p * z - 0.0577735746f;
	p = p * z + 0.0979423347f;
	p = p * z - 0.1397658172f;
	p = p * z + 0.1996270391f;
	p = p * z - 0.3333165903f;
	return x + x * z * p;
}

float scalar_atan2(float y, float x)
{
	float ax = scalar_abs(x);
	float ay = scalar_abs(y);
	float angle;

	if (!(ax <= FLT_MAX && ay <= FLT_MAX) || (ax == 0 && ay == 0)) {
		return 0;
	}
	angle = ay <= ax ? atan_core(ay / ax) : HALF_PI - atan_core(ax / ay);
	if (x < 0) {
		angle = SCALAR_PI - angle;
	}
	return y < 0 ? -angle : angle;
}

float scalar_floor(float value)
{
	float whole;

	/* From 2^23 on floats have no fraction. */
	if (!(scalar_abs(value) < 8388608.0f)) {
		return value;
	}
	whole = (float)(int32_t)value;
	return whole > value ? whole - 1 : whole;
}

float scalar_exp(float value)
{
	const float ln2_high =
		0.693359375f; /* has 10 bits, so n * ln2_high is exact */
	const float ln2_low = -2.12194440e-4f;
	float p = 1.0f / 720.0f;
	float r;
	float power;
	int32_t n;
	uint32_t bits;

	if (!(value > -87)) {
		return 0;
	}
	if (value > 88) {
		return FLT_MAX;
	}
	n = (int32_t)scalar_floor(value * 1.44269504f + 0.5f);
	r = (value - (float)n * ln2_high) - (float)n * ln2_low;
	p = p * r + 1.0f / 120.0f;
	p = p * r + 1.0f / 24.0f;
	p = p * r + 1.0f / 6.0f;
	p = p * r + 0.5f;
	p = p * r + 1;
	p = p * r + 1;
	/* After the tests above -126 <= n <= 127, so 2^n is a normal float. */
	bits = (uint32_t)(n + 127) << 23;
	memcpy(&power, &bits, sizeof(power));
	return p * power;
}
