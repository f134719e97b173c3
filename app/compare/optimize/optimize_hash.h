/* FNV-1a, a hash of bytes. */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_HASH_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_HASH_H

#include <stddef.h>
#include <stdint.h>

/* The hash of no bytes. */
static const uint64_t optimize_hash_empty = 0xcbf29ce484222325u;

/* Returns the hash of the bytes before, whose hash is given, and of these. */
static inline uint64_t optimize_hash(
	uint64_t before, const void *bytes, size_t size)
{
	for (size_t i = 0; i < size; i++) {
		before = (before ^ ((const uint8_t *)bytes)[i]) * 0x100000001b3u;
	}
	return before;
}

#endif
