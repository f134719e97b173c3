/*
 * Sums and products of counts that come from a file.
 *
 * Each count of a file may be valid while a sum or product of two of them does
 * not fit its type. Code that computes a size from such counts uses these
 * functions: they return false, and leave *out as it is, when the result does
 * not fit.
 */
#ifndef PLATFORM_BASE_COUNT_H
#define PLATFORM_BASE_COUNT_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* a + b; neither is negative. */
static inline bool count_add(int a, int b, int *out)
{
	if (b > INT_MAX - a) {
		return false;
	}
	*out = a + b;
	return true;
}

/* a * b; neither is negative. */
static inline bool count_multiply(int a, int b, int *out)
{
	if (b > 0 && a > INT_MAX / b) {
		return false;
	}
	*out = a * b;
	return true;
}

/* a + b in bytes. */
static inline bool size_add(size_t a, size_t b, size_t *out)
{
	if (b > SIZE_MAX - a) {
		return false;
	}
	*out = a + b;
	return true;
}

/* a * b in bytes. */
static inline bool size_multiply(size_t a, size_t b, size_t *out)
{
	if (b > 0 && a > SIZE_MAX / b) {
		return false;
	}
	*out = a * b;
	return true;
}

#endif
