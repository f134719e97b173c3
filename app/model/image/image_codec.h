/*
 * The interface of an image decoder. Only image.c uses it.
 *
 * libpng and libjpeg report errors by longjmp(). Variables that must keep their
 * values then are in a struct of the caller, not in locals of the function that
 * calls setjmp().
 */
#ifndef APP_MODEL_IMAGE_IMAGE_CODEC_H
#define APP_MODEL_IMAGE_IMAGE_CODEC_H

#include "platform/base/log.h"
#include "platform/base/memory_budget.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct image_input {
	const uint8_t *data;
	size_t size;
	const char *where; /* start of messages: the file and the place in it */
	const struct log *log;
	struct memory_budget *budget; /* for the decoder's own memory, or NULL */
};

struct image_codec {
	const char *magic; /* the first bytes of a file */
	size_t magic_bytes;

	/*
	 * Reads the size from the header, without checking it. Returns 0, or
	 * -errno after an error.
	 */
	int (*measure)(const struct image_input *input, int *width, int *height);

	/*
	 * Fills rgba[height][width][4], the size that measure() returned. Each
	 * halving rounds both sides up: a pixel is the mean of those it stands for.
	 */
	int (*decode)(const struct image_input *input, int width, int height,
		int halvings, uint8_t *rgba);
};

extern const struct image_codec image_codec_png;
extern const struct image_codec image_codec_jpeg;

#endif
