/* Which of many floats is the largest; arm/largest_float.S is faster. */
#include "platform/gl/soft/vertex/draw.h"

#include <string.h>

/* Of the sizes of floats, as bits without their sign. */
static ALWAYS_INLINE uint32_t larger(uint32_t most, const uint8_t *at)
{
	uint32_t bits;

	memcpy(&bits, at, sizeof(bits));
	return bits << 1 > most ? bits << 1 : most;
}

uint32_t soft_largest_float(const uint8_t *at, int stride_bytes, uint32_t count)
{
	uint32_t most = 0;

	for (; count > 0; count--, at += stride_bytes) {
		most = larger(most, at);
		most = larger(most, at + 4);
		most = larger(most, at + 8);
	}
	return most;
}
