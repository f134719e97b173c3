/*
 * 16.16 fixed point, the number type of the OpenGL ES 1.1 Common-Lite profile.
 */
#ifndef PLATFORM_BASE_FIXED_H
#define PLATFORM_BASE_FIXED_H

#include <stdint.h>

typedef int32_t fx16_t; /* Q16.16: 65536 is 1.0 */

#define FX16_ONE ((fx16_t)65536)

/*
 * Rounds to the nearest 16.16 value. Values beyond +-32768 saturate, NaN gives
 * 0. The resolution is 1.5e-5.
 */
static inline fx16_t fx16_from_float(float value)
{
	float scaled = value * 65536.0f;

	if (scaled >= 2147483648.0f) {
		return INT32_MAX;
	}
	if (scaled <= -2147483648.0f) {
		return INT32_MIN;
	}
	if (scaled != scaled) {
		return 0;
	}
	return (fx16_t)(scaled < 0 ? scaled - 0.5f : scaled + 0.5f);
}

static inline float fx16_to_float(fx16_t value)
{
	return (float)value * (1.0f / 65536.0f);
}

#endif
