/* image.h: images of every kind become RGBA; broken ones are an error. */
#include "app/model/image/image.h"
#include "tests/support/jpeg_size.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>
#include <png.h>

struct bytes {
	uint8_t data[4096];
	size_t size;
};

struct kind {
	int type, depth;
	bool interlaced;
	double gamma; /* 0 means no gAMA chunk */
	bool keyed;   /* whether there is a tRNS chunk */
};

static void append(png_structp png, png_bytep data, size_t count)
{
	struct bytes *bytes = png_get_io_ptr(png);

	assert_true(bytes->size + count <= sizeof(bytes->data));
	memcpy(bytes->data + bytes->size, data, count);
	bytes->size += count;
}

static void flush(png_structp png)
{
	(void)png;
}

static void write_header(png_structp png, png_infop info, int width, int height,
	const struct kind *kind)
{
	png_color palette[2] = {{10, 20, 30}, {40, 50, 60}};
	png_byte alpha[1] = {77};
	png_color_16 key = {.gray = 1, .red = 10, .green = 20, .blue = 30};

	png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height,
		kind->depth, kind->type,
		kind->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
		PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	if (kind->type == PNG_COLOR_TYPE_PALETTE) {
		png_set_PLTE(png, info, palette, 2);
	}
	if (kind->keyed) {
		png_set_tRNS(png, info, alpha, 1, &key);
	}
	if (kind->gamma > 0) {
		png_set_gAMA(png, info, kind->gamma);
	}
	png_write_info(png, info);
}

/* rows holds the packed bytes of all rows. */
static struct bytes make_png(int width, int height, const struct kind *kind,
	const uint8_t *rows, size_t row_bytes)
{
	struct bytes bytes = {.size = 0};
	png_structp png = png_create_write_struct(
		PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
	png_infop info = png_create_info_struct(png);
	png_bytep row[16];
	int y;

	assert_true(height <= 16);
	for (y = 0; y < height; y++) {
		row[y] = (png_bytep)rows + (size_t)y * row_bytes;
	}
	png_set_write_fn(png, &bytes, append, flush);
	write_header(png, info, width, height, kind);
	png_write_image(png, row);
	png_write_end(png, NULL);
	png_destroy_write_struct(&png, &info);
	return bytes;
}

static struct bytes make_jpeg(int width, int height, bool gray, int level)
{
	struct jpeg_compress_struct jpeg;
	struct jpeg_error_mgr errors;
	struct bytes bytes = {.size = 0};
	unsigned char *data = NULL;
	unsigned long size = 0;
	JSAMPLE row[64 * 3];
	JSAMPROW rows[1] = {row};

	assert_true(width <= 64);
	memset(row, level, sizeof(row));
	jpeg.err = jpeg_std_error(&errors);
	jpeg_create_compress(&jpeg);
	jpeg_mem_dest(&jpeg, &data, &size);
	jpeg.image_width = (JDIMENSION)width;
	jpeg.image_height = (JDIMENSION)height;
	jpeg.input_components = gray ? 1 : 3;
	jpeg.in_color_space = gray ? JCS_GRAYSCALE : JCS_RGB;
	jpeg_set_defaults(&jpeg);
	jpeg_start_compress(&jpeg, TRUE);
	while (jpeg.next_scanline < jpeg.image_height) {
		jpeg_write_scanlines(&jpeg, rows, 1);
	}
	jpeg_finish_compress(&jpeg);
	jpeg_destroy_compress(&jpeg);
	assert_true(size <= sizeof(bytes.data));
	memcpy(bytes.data, data, size);
	bytes.size = size;
	free(data);
	return bytes;
}

static int decode(const struct bytes *bytes, struct log_capture *logged,
	struct arena *arena, struct model_image *out)
{
	struct log log = log_capture_begin(logged);

	*arena = arena_empty();
	*out = (struct model_image){.name = "kept"};
	return image_decode(bytes->data, bytes->size, "HERE", &log, arena, out);
}

static void expect_pixels(const struct bytes *bytes, int width, int height,
	const uint8_t *rgba, bool opaque)
{
	struct log_capture logged;
	struct model_image image;
	struct arena arena;

	assert_int_equal(decode(bytes, &logged, &arena, &image), 0);
	assert_int_equal(logged.count, 0);
	assert_int_equal(image.width, width);
	assert_int_equal(image.height, height);
	assert_memory_equal(
		image.rgba, rgba, (size_t)width * (size_t)height * 4);
	assert_int_equal(image.opaque, opaque);
	assert_string_equal(image.name, "kept");
	arena_release(&arena);
}

static void expect_refusal(const struct bytes *bytes, int code, const char *part)
{
	struct log_capture logged;
	struct model_image image;
	struct arena arena;

	assert_int_equal(decode(bytes, &logged, &arena, &image), code);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
	assert_contains(logged.sentence[0], "HERE: ");
	assert_contains(logged.sentence[0], part);
	arena_release(&arena);
}

static void test_reads_rgba(void **state)
{
	static const uint8_t rows[8] = {1, 2, 3, 255, 5, 6, 7, 8};
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
	struct bytes bytes = make_png(1, 2, &kind, rows, 4);

	(void)state;
	expect_pixels(&bytes, 1, 2, rows, false);
}

static void test_gives_rgb_an_alpha_of_255(void **state)
{
	static const uint8_t rows[6] = {1, 2, 3, 4, 5, 6};
	static const uint8_t rgba[8] = {1, 2, 3, 255, 4, 5, 6, 255};
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 8};
	struct bytes bytes = make_png(2, 1, &kind, rows, 6);

	(void)state;
	expect_pixels(&bytes, 2, 1, rgba, true);
}

static void test_expands_gray_of_1_to_4_bits(void **state)
{
	static const uint8_t rows[1] = {0x80};
	static const uint8_t rgba[8] = {255, 255, 255, 255, 0, 0, 0, 255};
	const struct kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 1};
	struct bytes bytes = make_png(2, 1, &kind, rows, 1);

	(void)state;
	expect_pixels(&bytes, 2, 1, rgba, true);
}

static void test_expands_gray_with_alpha(void **state)
{
	static const uint8_t rows[4] = {9, 100, 200, 255};
	static const uint8_t rgba[8] = {9, 9, 9, 100, 200, 200, 200, 255};
	const struct kind kind = {.type = PNG_COLOR_TYPE_GRAY_ALPHA, .depth = 8};
	struct bytes bytes = make_png(2, 1, &kind, rows, 4);

	(void)state;
	expect_pixels(&bytes, 2, 1, rgba, false);
}

static void test_expands_a_palette_with_transparency(void **state)
{
	static const uint8_t rows[1] = {0x40};
	static const uint8_t rgba[8] = {10, 20, 30, 77, 40, 50, 60, 255};
	const struct kind kind = {
		.type = PNG_COLOR_TYPE_PALETTE, .depth = 1, .keyed = true};
	struct bytes bytes = make_png(2, 1, &kind, rows, 1);

	(void)state;
	expect_pixels(&bytes, 2, 1, rgba, false);
}

static void test_makes_a_key_colour_transparent(void **state)
{
	static const uint8_t rows[6] = {10, 20, 30, 10, 20, 31};
	static const uint8_t rgba[8] = {10, 20, 30, 0, 10, 20, 31, 255};
	const struct kind kind = {
		.type = PNG_COLOR_TYPE_RGB, .depth = 8, .keyed = true};
	struct bytes bytes = make_png(2, 1, &kind, rows, 6);

	(void)state;
	expect_pixels(&bytes, 2, 1, rgba, false);
}

static void test_rounds_16_bits_to_8(void **state)
{
	static const uint8_t rows[6] = {0xff, 0xff, 0x80, 0x80, 0x01, 0xff};
	static const uint8_t rgba[4] = {255, 128, 2, 255};
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 16};
	struct bytes bytes = make_png(1, 1, &kind, rows, 6);

	(void)state;
	expect_pixels(&bytes, 1, 1, rgba, true);
}

/* glTF 2.0, 3.9.2: colour space information in images is ignored. */
static void test_ignores_a_gamma_chunk(void **state)
{
	static const uint8_t rows[3] = {50, 100, 150};
	static const uint8_t rgba[4] = {50, 100, 150, 255};
	const struct kind kind = {
		.type = PNG_COLOR_TYPE_RGB, .depth = 8, .gamma = 1.0};
	struct bytes bytes = make_png(1, 1, &kind, rows, 3);

	(void)state;
	expect_pixels(&bytes, 1, 1, rgba, true);
}

static void test_reads_interlaced_pictures(void **state)
{
	uint8_t rows[9 * 9 * 4];
	const struct kind kind = {
		.type = PNG_COLOR_TYPE_RGB_ALPHA,
		.depth = 8,
		.interlaced = true,
	};
	struct bytes bytes;
	size_t i;

	(void)state;
	for (i = 0; i < sizeof(rows); i++) {
		rows[i] = (uint8_t)(i * 7);
	}
	bytes = make_png(9, 9, &kind, rows, 36);
	expect_pixels(&bytes, 9, 9, rows, false);
}

static void test_reads_jpeg_in_colour_and_gray(void **state)
{
	uint8_t rgba[16 * 3 * 4];
	struct bytes bytes;
	int i;

	(void)state;
	for (i = 0; i < 16 * 3; i++) {
		memset(rgba + i * 4, 128, 3);
		rgba[i * 4 + 3] = 255;
	}
	bytes = make_jpeg(16, 3, false, 128);
	expect_pixels(&bytes, 16, 3, rgba, true);
	bytes = make_jpeg(16, 3, true, 128);
	expect_pixels(&bytes, 16, 3, rgba, true);
}

static void test_refuses_other_formats(void **state)
{
	struct bytes gif = {.data = "GIF89a............", .size = 18};
	struct bytes nothing = {.size = 0};

	(void)state;
	expect_refusal(&gif, -ENOTSUP, "neither PNG nor JPEG");
	expect_refusal(&nothing, -ENOTSUP, "neither PNG nor JPEG");
}

static void test_refuses_a_png_truncated_at_any_length(void **state)
{
	static const uint8_t rows[4] = {1, 2, 3, 4};
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
	struct bytes whole = make_png(1, 1, &kind, rows, 4);
	size_t size;

	(void)state;
	for (size = 9; size < whole.size; size++) {
		struct bytes cut = whole;

		cut.size = size;
		expect_refusal(&cut, -EINVAL,
			"PNG image is broken: the file is truncated");
	}
}

static void test_refuses_a_png_with_a_wrong_checksum(void **state)
{
	static const uint8_t rows[4] = {1, 2, 3, 4};
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
	struct bytes bytes = make_png(1, 1, &kind, rows, 4);

	(void)state;
	bytes.data[8 + 8 + 13]++;
	expect_refusal(&bytes, -EINVAL, "PNG image is broken: IHDR: CRC error");
}

static void test_refuses_a_broken_jpeg_header(void **state)
{
	struct bytes bytes = make_jpeg(8, 8, false, 10);

	(void)state;
	bytes.size = 20;
	expect_refusal(&bytes, -EINVAL, "the JPEG image is broken");
}

static void test_decodes_a_damaged_jpeg_with_a_warning(void **state)
{
	struct bytes bytes = make_jpeg(64, 64, false, 200);
	struct log_capture logged;
	struct model_image image;
	struct arena arena;

	(void)state;
	bytes.size -= 30;
	assert_int_equal(decode(&bytes, &logged, &arena, &image), 0);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 0);
	assert_true(log_capture_has(
		&logged, LOG_WARNING, "HERE: the JPEG image is damaged"));
	assert_int_equal(image.rgba[0], 200);
	arena_release(&arena);
}

static void test_refuses_sizes_above_the_limit(void **state)
{
	static const uint8_t rows[4097 * 3];
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 8};
	struct bytes png = make_png(4097, 1, &kind, rows, sizeof(rows));
	struct bytes jpeg = make_jpeg(8, 8, false, 10);

	(void)state;
	expect_refusal(&png, -EFBIG,
		"has 4097x1 pixels; limber reads up to 4096 in width and height: save it smaller, as limber shows up to 1024");
	jpeg_size_set(jpeg.data, jpeg.size, 8, 65500);
	expect_refusal(&jpeg, -EFBIG, "has 8x65500 pixels");
}

static void test_refuses_a_png_without_pixels(void **state)
{
	struct bytes bytes = {.size = 0};
	static const uint8_t rows[3];
	const struct kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 8};

	(void)state;
	bytes = make_png(1, 1, &kind, rows, 3);
	bytes.data[8 + 8 + 3] = 0;
	expect_refusal(&bytes, -EINVAL, "the PNG image is broken");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_rgba),
		cmocka_unit_test(test_gives_rgb_an_alpha_of_255),
		cmocka_unit_test(test_expands_gray_of_1_to_4_bits),
		cmocka_unit_test(test_expands_gray_with_alpha),
		cmocka_unit_test(test_expands_a_palette_with_transparency),
		cmocka_unit_test(test_makes_a_key_colour_transparent),
		cmocka_unit_test(test_rounds_16_bits_to_8),
		cmocka_unit_test(test_ignores_a_gamma_chunk),
		cmocka_unit_test(test_reads_interlaced_pictures),
		cmocka_unit_test(test_reads_jpeg_in_colour_and_gray),
		cmocka_unit_test(test_refuses_other_formats),
		cmocka_unit_test(test_refuses_a_png_truncated_at_any_length),
		cmocka_unit_test(test_refuses_a_png_with_a_wrong_checksum),
		cmocka_unit_test(test_refuses_a_broken_jpeg_header),
		cmocka_unit_test(test_decodes_a_damaged_jpeg_with_a_warning),
		cmocka_unit_test(test_refuses_sizes_above_the_limit),
		cmocka_unit_test(test_refuses_a_png_without_pixels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
