/*
 * 16.16 fixed point, the number type of the OpenGL ES 1.1 Common-Lite profile.
 */
#ifndef PLATFORM_BASE_FIXED_H
#define PLATFORM_BASE_FIXED_H

#include <stdint.h>
#include <string.h>

typedef int32_t fx16_t; /* Q16.16: 65536 is 1.0 */

#define FX16_ONE ((fx16_t)65536)

/*
 * Rounds to the nearest 16.16 value. Values beyond +-32768 saturate, NaN gives
 * 0. The resolution is 1.5e-5.
 */
static inline fx16_t fx16_from_float(float value)
{
	uint32_t bits, half_bits;
	float half;

	/* |value| < 2^15: 0x8E000000 is the bits of 2^15, shifted likewise. */
	memcpy(&bits, &value, sizeof(bits));
	if (bits << 1 < 0x8E000000) {
		half_bits = (bits & 0x80000000) | 0x3F000000;
		memcpy(&half, &half_bits, sizeof(half));
		return (fx16_t)(value * 65536.0f + half);
	}
	return value != value ? 0 : value > 0.0f ? INT32_MAX : INT32_MIN;
}

static inline float fx16_to_float(fx16_t value)
{
	return (float)value * (1.0f / 65536.0f);
}

#endif
