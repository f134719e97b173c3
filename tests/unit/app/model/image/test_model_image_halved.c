/* image.h: images larger than textures are halved while they are decoded. */
#include "app/model/image/image.h"
#include "platform/base/compiler.h"
#include "platform/base/memory_budget.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>
#include <png.h>

enum {
	CHECKED_EVERY = 7 /* pixels: a prime, so that all columns are checked */
};

struct size {
	int width, height, halvings;
	int interlace;
	bool gray; /* the picture's red alone */
};

struct bytes {
	uint8_t *data;
	size_t size, room;
};

/* Smooth, as JPEG wants it. */
static uint8_t red_of(int x, int y)
{
	return (uint8_t)((x + y) * 255 / (2 * IMAGE_SIDE_MAX));
}

/* The other channels jump from pixel to pixel. */
static void draw_pixel(int x, int y, uint8_t rgba[4])
{
	unsigned int noise =
		(unsigned int)x * 2654435761u ^ (unsigned int)y * 2246822519u;

	rgba[0] = red_of(x, y);
	rgba[1] = (uint8_t)(noise >> 24);
	rgba[2] = (uint8_t)(noise >> 16);
	rgba[3] = (uint8_t)(noise >> 8);
}

static size_t row_bytes(const struct size *size)
{
	return (size_t)size->width * (size->gray ? 1 : 4);
}

static void draw_row(const struct size *size, int y, uint8_t *out)
{
	for (int x = 0; x < size->width; x++) {
		if (size->gray) {
			out[x] = red_of(x, y);
		} else {
			draw_pixel(x, y, out + 4 * (size_t)x);
		}
	}
}

static uint8_t *draw_picture(const struct size *size)
{
	uint8_t *out = malloc(row_bytes(size) * (size_t)size->height);

	assert_non_null(out);
	for (int y = 0; y < size->height; y++) {
		draw_row(size, y, out + (size_t)y * row_bytes(size));
	}
	return out;
}

static void append(png_structp png, png_bytep data, size_t count)
{
	struct bytes *bytes = png_get_io_ptr(png);

	if (bytes->size + count > bytes->room) {
		bytes->room = 2 * (bytes->size + count);
		bytes->data = realloc(bytes->data, bytes->room);
		assert_non_null(bytes->data);
	}
	memcpy(bytes->data + bytes->size, data, count);
	bytes->size += count;
}

static void flush(png_structp png)
{
	(void)png;
}

/* Nothing is compressed, as that would take most of the test's time. */
static struct bytes make_png(const struct size *size)
{
	struct bytes bytes = {NULL, 0, 0};
	png_structp png = png_create_write_struct(
		PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
	png_infop info = png_create_info_struct(png);
	uint8_t *picture = draw_picture(size);
	int passes;

	png_set_write_fn(png, &bytes, append, flush);
	png_set_compression_level(png, 0);
	png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
	png_set_IHDR(png, info, (png_uint_32)size->width,
		(png_uint_32)size->height, 8,
		size->gray ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB_ALPHA,
		size->interlace, PNG_COMPRESSION_TYPE_DEFAULT,
		PNG_FILTER_TYPE_DEFAULT);
	png_write_info(png, info);
	passes = png_set_interlace_handling(png);
	for (int i = 0; i < passes * size->height; i++) {
		png_write_row(png,
			picture + (size_t)(i % size->height) * row_bytes(size));
	}
	png_write_end(png, NULL);
	png_destroy_write_struct(&png, &info);
	free(picture);
	return bytes;
}

/* The size's pictures are gray. */
static struct bytes make_jpeg(const struct size *size)
{
	struct jpeg_compress_struct jpeg;
	struct jpeg_error_mgr errors;
	struct bytes bytes = {NULL, 0, 0};
	unsigned long count = 0;
	JSAMPLE row[IMAGE_SIDE_MAX];
	JSAMPROW rows[1] = {row};

	jpeg.err = jpeg_std_error(&errors);
	jpeg_create_compress(&jpeg);
	jpeg_mem_dest(&jpeg, &bytes.data, &count);
	jpeg.image_width = (JDIMENSION)size->width;
	jpeg.image_height = (JDIMENSION)size->height;
	jpeg.input_components = 1;
	jpeg.in_color_space = JCS_GRAYSCALE;
	jpeg_set_defaults(&jpeg);
	jpeg_set_quality(&jpeg, 100, TRUE);
	jpeg_start_compress(&jpeg, TRUE);
	for (int y = 0; y < size->height; y++) {
		draw_row(size, y, row);
		jpeg_write_scanlines(&jpeg, rows, 1);
	}
	jpeg_finish_compress(&jpeg);
	jpeg_destroy_compress(&jpeg);
	bytes.size = (size_t)count;
	return bytes;
}

/* Decodes an image; the arena has the budget. */
static int decode(const struct bytes *bytes, struct arena *arena,
	struct log_capture *logged, struct model_image *out)
{
	struct log log = log_capture_begin(logged);

	*out = (struct model_image){.name = "kept"};
	return image_decode(bytes->data, bytes->size, "HERE", &log, arena, out);
}

static struct model_image expect_size(
	const struct bytes *bytes, const struct size *size, struct arena *arena)
{
	struct log_capture logged;
	struct model_image image;
	int step = 1 << size->halvings;

	*arena = arena_empty();
	assert_int_equal(decode(bytes, arena, &logged, &image), 0);
	assert_int_equal(logged.count, 0);
	assert_int_equal(image.file_width, size->width);
	assert_int_equal(image.file_height, size->height);
	assert_int_equal(image.width, (size->width + step - 1) / step);
	assert_int_equal(image.height, (size->height + step - 1) / step);
	return image;
}

static int lesser(int a, int b)
{
	return a < b ? a : b;
}

/* The rounded mean of the pixels for which one of the image stands. */
static void find_mean(
	const struct size *size, int left, int top, uint8_t mean[4])
{
	int step = 1 << size->halvings, sum[4] = {0, 0, 0, 0};

	for (int i = 0; i < step * step; i++) {
		uint8_t rgba[4];

		draw_pixel(lesser(left * step + i % step, size->width - 1),
			lesser(top * step + i / step, size->height - 1), rgba);
		for (int k = 0; k < 4; k++) {
			sum[k] += rgba[k];
		}
	}
	for (int k = 0; k < 4; k++) {
		mean[k] = (uint8_t)((sum[k] + step * step / 2) / (step * step));
	}
	if (size->gray) {
		mean[1] = mean[2] = mean[0];
		mean[3] = 255;
	}
}

/* Returns the largest difference of a channel from the mean. */
static int farthest_from_mean(
	const struct size *size, const struct model_image *image)
{
	int most = 0;

	for (int i = 0; i < image->width * image->height; i += CHECKED_EVERY) {
		uint8_t mean[4];

		find_mean(size, i % image->width, i / image->width, mean);
		for (int k = 0; k < 4; k++) {
			int away = abs(image->rgba[(size_t)i * 4 + (size_t)k] -
				mean[k]);

			most = away > most ? away : most;
		}
	}
	return most;
}

static void test_a_pixel_of_a_halved_png_is_the_mean_of_its_own(void **state)
{
	static const struct size sizes[] = {
		{2049, 2051, 1, PNG_INTERLACE_ADAM7, false},
		{2049, 2048, 1, PNG_INTERLACE_NONE, false},
		{4096, 4095, 1, PNG_INTERLACE_NONE, true},
		{4096, 4096, 2, PNG_INTERLACE_NONE, true},
		{4096, 4096, 2, PNG_INTERLACE_ADAM7, true},
		{2048, 2047, 0, PNG_INTERLACE_NONE, true},
		{2047, 2049, 0, PNG_INTERLACE_ADAM7, true},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		struct bytes bytes = make_png(&sizes[i]);
		struct arena arena;
		struct model_image image =
			expect_size(&bytes, &sizes[i], &arena);

		/* Each halving rounds. */
		assert_in_range(farthest_from_mean(&sizes[i], &image), 0,
			sizes[i].halvings > 1);
		arena_release(&arena);
		free(bytes.data);
	}
}

static void test_a_pixel_of_a_halved_jpeg_is_near_the_mean_of_its_own(
	void **state)
{
	static const struct size sizes[] = {
		{2049, 2051, 1, 0, true},
		{4095, 4096, 1, 0, true},
		{4096, 4096, 2, 0, true},
		{2047, 2048, 0, 0, true},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		struct bytes bytes = make_jpeg(&sizes[i]);
		struct arena arena;
		struct model_image image =
			expect_size(&bytes, &sizes[i], &arena);

		assert_true(image.opaque);
		assert_in_range(farthest_from_mean(&sizes[i], &image), 0, 3);
		arena_release(&arena);
		free(bytes.data);
	}
}

static int decode_within(const struct bytes *bytes, size_t budget_bytes,
	struct log_capture *logged)
{
	struct memory_budget budget = {.limit_bytes = budget_bytes};
	struct arena arena = arena_within(&budget);
	struct model_image image;
	int error = decode(bytes, &arena, logged, &image);

	arena_release(&arena);
	if (!error) {
		/* As a model does that is loaded. */
		memory_budget_give_back(&budget, image_held_bytes(&image));
	}
	assert_int_equal(budget.used_bytes, 0);
	return error;
}

static void test_a_large_image_takes_the_memory_of_its_half(void **state)
{
	const struct size size = {2048, 2048, 1, PNG_INTERLACE_NONE, true};
	struct bytes bytes[] = {make_png(&size), make_jpeg(&size)};
	struct log_capture logged;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bytes); i++) {
		assert_int_equal(decode_within(&bytes[i], 5u << 20, &logged), 0);
		free(bytes[i].data);
	}
}

static void test_an_interlaced_image_asks_for_the_memory_of_all_rows(
	void **state)
{
	const struct size size = {2048, 2048, 1, PNG_INTERLACE_ADAM7, true};
	struct bytes bytes = make_png(&size);
	struct log_capture logged;

	(void)state;
	assert_int_equal(decode_within(&bytes, 21u << 20, &logged), 0);
	assert_int_equal(decode_within(&bytes, 19u << 20, &logged), -ENOMEM);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
	assert_contains(logged.sentence[0], "HERE");
	free(bytes.data);
}

/* Otherwise small files could ask for hours of decoding. */
static void test_the_budget_bounds_the_pixels_that_are_decoded(void **state)
{
	const struct size size = {4096, 4096, 2, PNG_INTERLACE_NONE, true};
	struct bytes bytes[] = {make_png(&size), make_jpeg(&size)};
	struct log_capture logged;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bytes); i++) {
		assert_int_equal(
			decode_within(&bytes[i], 15u << 20, &logged), -ENOMEM);
		assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
		assert_contains(logged.sentence[0], "HERE");
		assert_int_equal(
			decode_within(&bytes[i], 17u << 20, &logged), 0);
		free(bytes[i].data);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_pixel_of_a_halved_png_is_the_mean_of_its_own),
		cmocka_unit_test(
			test_a_pixel_of_a_halved_jpeg_is_near_the_mean_of_its_own),
		cmocka_unit_test(test_a_large_image_takes_the_memory_of_its_half),
		cmocka_unit_test(
			test_an_interlaced_image_asks_for_the_memory_of_all_rows),
		cmocka_unit_test(
			test_the_budget_bounds_the_pixels_that_are_decoded),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
