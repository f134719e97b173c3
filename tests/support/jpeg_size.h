/* The size that a JPEG image claims to have. */
#ifndef TESTS_SUPPORT_JPEG_SIZE_H
#define TESTS_SUPPORT_JPEG_SIZE_H

#include "tests/support/test.h"

/* Sets the size in the frame header (SOF0 or SOF2), which follows the tables. */
static inline void jpeg_size_set(
	uint8_t *data, size_t size, int width, int height)
{
	size_t i = 2;

	while (data[i + 1] != 0xc0 && data[i + 1] != 0xc2) {
		i += 2 + (size_t)(data[i + 2] << 8 | data[i + 3]);
		assert_true(i < size);
	}
	data[i + 5] = (uint8_t)(height >> 8);
	data[i + 6] = (uint8_t)height;
	data[i + 7] = (uint8_t)(width >> 8);
	data[i + 8] = (uint8_t)width;
}

#endif
