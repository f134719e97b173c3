#include "app/model/image/image_codec.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CHUNKS_MAX = 256,
	CHUNK_BYTES_MAX = 4 * 1024 * 1024, /* of ancillary chunks, unpacked */
};

struct reading {
	const struct image_input *input;
	size_t at;
	png_structp png;
	png_infop info;
	png_bytep *rows;
	char problem[128];
};

static void keep_error(png_structp png, png_const_charp message)
{
	struct reading *reading = png_get_error_ptr(png);

	snprintf(reading->problem, sizeof(reading->problem), "%s", message);
	png_longjmp(png, 1);
}

static void drop_warning(png_structp png, png_const_charp message)
{
	(void)png;
	(void)message;
}

static void read_bytes(png_structp png, png_bytep out, size_t count)
{
	struct reading *reading = png_get_io_ptr(png);

	if (count > reading->input->size - reading->at) {
		png_error(png, "the file is cut short");
	}
	memcpy(out, reading->input->data + reading->at, count);
	reading->at += count;
}

static int begin(struct reading *reading, const struct image_input *input)
{
	*reading = (struct reading){.input = input};
	reading->png = png_create_read_struct(
		PNG_LIBPNG_VER_STRING, reading, keep_error, drop_warning);
	if (reading->png) {
		reading->info = png_create_info_struct(reading->png);
	}
	if (!reading->info) {
		png_destroy_read_struct(&reading->png, &reading->info, NULL);
		log_error(input->log, "%s: not enough memory", input->where);
		return -ENOMEM;
	}
	return 0;
}

static int end(struct reading *reading, bool fine)
{
	const struct image_input *input = reading->input;

	png_destroy_read_struct(&reading->png, &reading->info, NULL);
	free(reading->rows);
	if (!fine) {
		log_error(input->log, "%s: is a broken PNG: %s", input->where,
			reading->problem);
		return -EINVAL;
	}
	return 0;
}

/*
 * The limits of size are image.c's; libpng's own, which is lower, would only
 * give a worse sentence.
 */
static bool read_header(struct reading *reading)
{
	if (setjmp(png_jmpbuf(reading->png))) {
		return false;
	}
	png_set_user_limits(reading->png, 0x7fffffff, 0x7fffffff);
	png_set_chunk_cache_max(reading->png, CHUNKS_MAX);
	png_set_chunk_malloc_max(reading->png, CHUNK_BYTES_MAX);
	png_set_read_fn(reading->png, reading, read_bytes);
	png_read_info(reading->png, reading->info);
	return true;
}

/* All kinds become 8-bit RGBA; gamma and profiles do not count. */
static bool read_pixels(struct reading *reading)
{
	if (setjmp(png_jmpbuf(reading->png))) {
		return false;
	}
	png_set_expand(reading->png);
	png_set_scale_16(reading->png);
	png_set_gray_to_rgb(reading->png);
	png_set_add_alpha(reading->png, 255, PNG_FILLER_AFTER);
	png_set_interlace_handling(reading->png);
	png_read_update_info(reading->png, reading->info);
	png_read_image(reading->png, reading->rows);
	png_read_end(reading->png, NULL);
	return true;
}

static int measure(const struct image_input *input, int *width, int *height)
{
	struct reading reading;
	bool fine;
	int error = begin(&reading, input);

	if (error) {
		return error;
	}
	fine = read_header(&reading);
	if (fine) {
		*width = (int)png_get_image_width(reading.png, reading.info);
		*height = (int)png_get_image_height(reading.png, reading.info);
	}
	return end(&reading, fine);
}

static int decode(
	const struct image_input *input, int width, int height, uint8_t *rgba)
{
	struct reading reading;
	bool fine;
	int error = begin(&reading, input);
	int y;

	if (error) {
		return error;
	}
	fine = read_header(&reading);
	reading.rows = malloc((size_t)height * sizeof(*reading.rows));
	if (!reading.rows) {
		snprintf(reading.problem, sizeof(reading.problem),
			"not enough memory");
		return end(&reading, false);
	}
	for (y = 0; y < height; y++) {
		reading.rows[y] = rgba + (size_t)y * (size_t)width * 4;
	}
	fine = fine && read_pixels(&reading);
	return end(&reading, fine);
}

const struct image_codec image_codec_png = {
	.magic = "\x89PNG\r\n\x1a\n",
	.magic_bytes = 8,
	.measure = measure,
	.decode = decode,
};
