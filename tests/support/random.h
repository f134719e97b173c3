/* Pseudo-random integers, the same in every run that begins with a seed. */
#ifndef TESTS_SUPPORT_RANDOM_H
#define TESTS_SUPPORT_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

/* The next number of 24 bits (a linear congruential generator). */
static inline uint32_t next_random(uint32_t *seed)
{
	*seed = *seed * 1664525u + 1013904223u;
	return *seed >> 8;
}

/* The next number of 32 bits. */
static inline uint32_t any_word(uint32_t *seed)
{
	uint32_t upper = next_random(seed);

	return upper << 16 ^ next_random(seed);
}

/* The next number of low..high, both included. */
static inline int random_between(uint32_t *seed, int low, int high)
{
	return low + (int)(next_random(seed) % (uint32_t)(high - low + 1));
}

/* The next number of -most..most. */
static inline int32_t random_within(uint32_t *seed, int32_t most)
{
	return (int32_t)(any_word(seed) % (2 * (uint32_t)most + 1)) - most;
}

/* True once in so many times. */
static inline bool random_one_in(uint32_t *seed, int times)
{
	return random_between(seed, 1, times) == 1;
}

#endif
