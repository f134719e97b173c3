/*
 * A picture format, for image.c alone.
 *
 * The libraries leave by longjmp() on errors. Whatever has to survive that
 * lives in a struct of the caller, never in a local of the function that
 * calls setjmp().
 */
#ifndef APP_MODEL_IMAGE_IMAGE_CODEC_H
#define APP_MODEL_IMAGE_IMAGE_CODEC_H

#include "platform/base/log.h"

#include <stddef.h>
#include <stdint.h>

struct image_input {
	const uint8_t *data;
	size_t size;
	const char *where; /* begins sentences */
	const struct log *log;
};

struct image_codec {
	const char *magic; /* the first bytes of a file */
	size_t magic_bytes;

	/* What the header says, unchecked. 0, or -errno after a sentence. */
	int (*measure)(const struct image_input *input, int *width, int *height);

	/* Fills [height][width][4], of the size that measure() gave. */
	int (*decode)(const struct image_input *input, int width, int height,
		uint8_t *rgba);
};

extern const struct image_codec image_codec_png;
extern const struct image_codec image_codec_jpeg;

#endif
