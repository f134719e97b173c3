#include "app/model/image/image_codec.h"
#include "app/model/image/image_halve.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CHUNKS_MAX = 256,
	CHUNK_BYTES_MAX =
		4 * 1024 * 1024, /* limit of a decompressed ancillary chunk */
};

/* How rows of the file become rows of the image. */
struct reduction {
	int width, height; /* the file's */
	int halvings;
	uint8_t (*row)[4]; /* of an image that is halved: the rows of the file
			      for one row of it, or all if it is interlaced;
			      else NULL */
	size_t bytes;      /* of row */
};

struct decoder {
	const struct image_input *input;
	size_t at;
	png_structp png;
	png_infop info;
	bool no_memory; /* an allocation has failed */
	char problem[128];
};

static void keep_error(png_structp png, png_const_charp message)
{
	struct decoder *decoder = png_get_error_ptr(png);

	snprintf(decoder->problem, sizeof(decoder->problem), "%s", message);
	png_longjmp(png, 1);
}

static void drop_warning(png_structp png, png_const_charp message)
{
	(void)png;
	(void)message;
}

static png_voidp allocate(png_structp png, png_alloc_size_t bytes)
{
	struct decoder *decoder = png_get_mem_ptr(png);
	void *memory = malloc(bytes);

	decoder->no_memory = decoder->no_memory || !memory;
	return memory;
}

static void read_bytes(png_structp png, png_bytep out, size_t count)
{
	struct decoder *decoder = png_get_io_ptr(png);

	if (count > decoder->input->size - decoder->at) {
		png_error(png, "the file is truncated");
	}
	memcpy(out, decoder->input->data + decoder->at, count);
	decoder->at += count;
}

static int fail_memory(const struct image_input *input)
{
	log_error(input->log, "%s: there is not enough memory", input->where);
	return -ENOMEM;
}

static int begin(struct decoder *decoder, const struct image_input *input)
{
	*decoder = (struct decoder){.input = input};
	decoder->png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, decoder,
		keep_error, drop_warning, decoder, allocate, NULL);
	if (decoder->png) {
		decoder->info = png_create_info_struct(decoder->png);
	}
	if (!decoder->info) {
		png_destroy_read_struct(&decoder->png, &decoder->info, NULL);
		return fail_memory(input);
	}
	return 0;
}

static int end(struct decoder *decoder, bool fine)
{
	const struct image_input *input = decoder->input;

	png_destroy_read_struct(&decoder->png, &decoder->info, NULL);
	if (!fine && interrupt_pending()) {
		return -EINTR;
	}
	if (!fine && decoder->no_memory) {
		return fail_memory(input);
	}
	if (!fine) {
		log_error(input->log, "%s: the PNG image is broken: %s",
			input->where, decoder->problem);
		return -EINVAL;
	}
	return 0;
}

/* Lifts libpng's limit of an image's size: image.c has one of its own. */
static bool read_header(struct decoder *decoder)
{
	if (setjmp(png_jmpbuf(decoder->png))) {
		return false;
	}
	png_set_user_limits(decoder->png, 0x7fffffff, 0x7fffffff);
	png_set_chunk_cache_max(decoder->png, CHUNKS_MAX);
	png_set_chunk_malloc_max(decoder->png, CHUNK_BYTES_MAX);
	png_set_read_fn(decoder->png, decoder, read_bytes);
	png_read_info(decoder->png, decoder->info);
	return true;
}

/* Halves count rows as often as asked, in place, into one row. */
static void reduce_rows(const struct reduction *reduction, uint8_t (*row)[4],
	int count, uint8_t (*out)[4])
{
	int width = reduction->width;

	for (int left = reduction->halvings; left > 0; left--) {
		int half = (width + 1) / 2;

		for (int y = 0; y < count; y += 2) {
			int below = y + 1 < count ? y + 1 : y;

			image_halve_rows((const uint8_t(*)[4])row + y * width,
				(const uint8_t(*)[4])row + below * width, width,
				left > 1 ? row + y / 2 * half : out);
		}
		count = (count + 1) / 2;
		width = half;
	}
}

/* Reads all rows and reduces each few of them once they are complete. */
static void read_rows(png_structp png, const struct reduction *reduction,
	int passes, uint8_t (*rgba)[4])
{
	int width = reduction->width, height = reduction->height;
	int step = 1 << reduction->halvings;
	int out_width = (width + step - 1) / step;

	for (int i = 0; i < passes * height; i++) {
		int y = i % height, part = y % step;
		uint8_t(*to)[4] = reduction->row
			? reduction->row + (passes > 1 ? y : part) * width
			: rgba + y * width;

		if (interrupt_pending()) {
			png_error(png, "limber was asked to end");
		}
		png_read_row(png, (png_bytep)to, NULL);
		if (reduction->row && i >= (passes - 1) * height &&
			(part == step - 1 || y == height - 1)) {
			reduce_rows(reduction, to - part * width, part + 1,
				rgba + y / step * out_width);
		}
	}
}

/* Takes the memory of rows that are to be halved. Returns 0 or -ENOMEM. */
static int reserve_rows(struct decoder *decoder, struct reduction *reduction)
{
	const struct image_input *input = decoder->input;
	bool all = png_get_interlace_type(decoder->png, decoder->info) !=
		PNG_INTERLACE_NONE;
	size_t rows = all ? (size_t)reduction->height
			  : (size_t)1 << reduction->halvings;

	reduction->bytes = rows * (size_t)reduction->width * 4;
	if (!memory_budget_take(input->budget, reduction->bytes)) {
		reduction->bytes = 0;
		return memory_budget_fail(
			input->budget, input->where, input->log);
	}
	reduction->row = malloc(reduction->bytes);
	return reduction->row ? 0 : fail_memory(input);
}

/* Converts any PNG to 8-bit RGBA; ignores gamma and colour profiles. */
static bool read_pixels(struct decoder *decoder,
	const struct reduction *reduction, uint8_t *rgba)
{
	int passes;

	if (setjmp(png_jmpbuf(decoder->png))) {
		return false;
	}
	png_set_expand(decoder->png);
	png_set_scale_16(decoder->png);
	png_set_gray_to_rgb(decoder->png);
	png_set_add_alpha(decoder->png, 255, PNG_FILLER_AFTER);
	passes = png_set_interlace_handling(decoder->png);
	png_read_update_info(decoder->png, decoder->info);
	read_rows(decoder->png, reduction, passes, (uint8_t(*)[4])rgba);
	png_read_end(decoder->png, NULL);
	return true;
}

static int measure(const struct image_input *input, int *width, int *height)
{
	struct decoder decoder;
	bool fine;
	int error = begin(&decoder, input);

	if (error) {
		return error;
	}
	fine = read_header(&decoder);
	if (fine) {
		*width = (int)png_get_image_width(decoder.png, decoder.info);
		*height = (int)png_get_image_height(decoder.png, decoder.info);
	}
	return end(&decoder, fine);
}

static int decode(const struct image_input *input, int width, int height,
	int halvings, uint8_t *rgba)
{
	struct reduction reduction = {width, height, halvings, NULL, 0};
	struct decoder decoder;
	bool fine;
	int error = begin(&decoder, input);

	if (error) {
		return error;
	}
	fine = read_header(&decoder);
	error = fine && halvings > 0 ? reserve_rows(&decoder, &reduction) : 0;
	if (error) {
		png_destroy_read_struct(&decoder.png, &decoder.info, NULL);
	} else {
		fine = fine && read_pixels(&decoder, &reduction, rgba);
		error = end(&decoder, fine);
	}
	free(reduction.row);
	memory_budget_give_back(input->budget, reduction.bytes);
	return error;
}

const struct image_codec image_codec_png = {
	.magic = "\x89PNG\r\n\x1a\n",
	.magic_bytes = 8,
	.measure = measure,
	.decode = decode,
};
