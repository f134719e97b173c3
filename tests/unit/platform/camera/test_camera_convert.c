#include "platform/camera/convert.h"

#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
	int width, height, least_stride_bytes;
} sizes[] = {
	{16, 4, 0},
	{17, 5, 0},
	{1, 1, 0},
	{2, 3, 64},
	{31, 9, 96},
};

/* Returns a picture of noise; the caller frees data. */
struct noise {
	struct camera_image image;
	uint8_t *data;
};

static struct noise make_noise(enum camera_format format, int width, int height,
	int least_stride_bytes)
{
	struct camera_layout layout =
		camera_layout_of(format, width, height, least_stride_bytes);
	struct noise noise = {.data = malloc((size_t)layout.size)};
	uint32_t seed = 12345;

	assert_non_null(noise.data);
	for (int i = 0; i < layout.size; i++) {
		seed = seed * 1664525u + 1013904223u;
		noise.data[i] = (uint8_t)(seed >> 24);
	}
	noise.image =
		camera_image_at(format, width, height, &layout, noise.data);
	return noise;
}

static double clamp(double value)
{
	return value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
}

/* Reads a pixel's luma and chroma as its format defines them. */
static void read_ycc(const struct camera_image *image, int x, int y, int ycc[3])
{
	const uint8_t *luma =
		image->plane[0] + (size_t)y * (size_t)image->stride_bytes[0];
	const uint8_t *plane[3] = {luma};

	for (int i = 1; i < 3; i++) {
		plane[i] = image->plane[i] +
			(size_t)(y / 2) * (size_t)image->stride_bytes[i];
	}
	switch (image->format) {
	case CAMERA_UYVY:
		ycc[0] = luma[2 * x + 1];
		ycc[1] = luma[x / 2 * 4];
		ycc[2] = luma[x / 2 * 4 + 2];
		break;
	case CAMERA_YUYV:
		ycc[0] = luma[2 * x];
		ycc[1] = luma[x / 2 * 4 + 1];
		ycc[2] = luma[x / 2 * 4 + 3];
		break;
	case CAMERA_NV12:
		ycc[0] = luma[x];
		ycc[1] = plane[1][x / 2 * 2];
		ycc[2] = plane[1][x / 2 * 2 + 1];
		break;
	default:
		ycc[0] = luma[x];
		ycc[1] = plane[1][x / 2];
		ycc[2] = plane[2][x / 2];
		break;
	}
}

/* ITU-R BT.601-7: E'Y = (Y - 16) / 219, E'Cb = (Cb - 128) / 224, and the
 * inverse of its luma equation with the weights 0.299, 0.587 and 0.114. */
static void ycc_to_rgb(const int ycc[3], double rgb[3])
{
	double y = (ycc[0] - 16) / 219.0;
	double cb = (ycc[1] - 128) / 224.0, cr = (ycc[2] - 128) / 224.0;
	double red = y + 2.0 * (1.0 - 0.299) * cr;
	double blue = y + 2.0 * (1.0 - 0.114) * cb;

	rgb[0] = clamp(red);
	rgb[1] = clamp((y - 0.299 * red - 0.114 * blue) / 0.587);
	rgb[2] = clamp(blue);
}

static void reference(
	const struct camera_image *image, int x, int y, double rgb[3])
{
	const uint8_t *row =
		image->plane[0] + (size_t)y * (size_t)image->stride_bytes[0];
	int ycc[3];

	switch (image->format) {
	case CAMERA_RGB565:
		rgb[0] = (row[2 * x + 1] >> 3) / 31.0;
		rgb[1] = ((row[2 * x + 1] & 7) * 8 + (row[2 * x] >> 5)) / 63.0;
		rgb[2] = (row[2 * x] & 31) / 31.0;
		break;
	case CAMERA_RGB24:
	case CAMERA_BGR24:
		for (int i = 0; i < 3; i++) {
			int at = image->format == CAMERA_RGB24 ? i : 2 - i;

			rgb[i] = row[3 * x + at] / 255.0;
		}
		break;
	default:
		read_ycc(image, x, y, ycc);
		ycc_to_rgb(ycc, rgb);
		break;
	}
}

/* Rounding costs half a step, the constants in Q16 the rest. */
static void assert_color(uint16_t color, const double rgb[3])
{
	assert_near(color >> 11, rgb[0] * 31.0, 0.51);
	assert_near(color >> 5 & 63, rgb[1] * 63.0, 0.51);
	assert_near(color & 31, rgb[2] * 31.0, 0.51);
}

static void check_rows(enum camera_format format, int width, int height,
	int least_stride_bytes)
{
	struct noise noise =
		make_noise(format, width, height, least_stride_bytes);
	uint16_t *row = calloc((size_t)width + 1, sizeof(*row));

	assert_non_null(row);
	for (int y = 0; y < height; y++) {
		for (int from = 0; from < width && from < 4; from += 2) {
			row[width - from] = 0xbeef;
			camera_convert_row(
				&noise.image, from, y, width - from, row);
			assert_int_equal(row[width - from], 0xbeef);
			for (int x = from; x < width; x++) {
				double rgb[3];

				reference(&noise.image, x, y, rgb);
				assert_color(row[x - from], rgb);
			}
		}
	}
	free(row);
	free(noise.data);
}

static void test_rows_match_the_formula_of_the_standard(void **state)
{
	(void)state;
	for (int format = 0; format < CAMERA_FORMATS; format++) {
		for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
			check_rows((enum camera_format)format, sizes[i].width,
				sizes[i].height, sizes[i].least_stride_bytes);
		}
	}
}

/* All of luma with extreme chroma, where clamping happens. */
static void test_every_luma_and_extreme_chroma_match_the_formula(void **state)
{
	static const uint8_t chroma[] = {
		0, 16, 64, 127, 128, 129, 200, 240, 255};

	(void)state;
	for (int y = 0; y < 256; y++) {
		for (size_t i = 0; i < 81; i++) {
			uint8_t data[4] = {chroma[i / 9], (uint8_t)y,
				chroma[i % 9], (uint8_t)(255 - y)};
			struct camera_layout layout =
				camera_layout_of(CAMERA_UYVY, 2, 1, 0);
			struct camera_image image = camera_image_at(
				CAMERA_UYVY, 2, 1, &layout, data);
			uint16_t row[2];

			camera_convert_row(&image, 0, 0, 2, row);
			for (int x = 0; x < 2; x++) {
				double rgb[3];

				reference(&image, x, 0, rgb);
				assert_color(row[x], rgb);
			}
		}
	}
}

static void test_black_and_white_are_exact(void **state)
{
	static const uint8_t data[4] = {128, 16, 128, 235};
	struct camera_layout layout = camera_layout_of(CAMERA_UYVY, 2, 1, 0);
	struct camera_image image =
		camera_image_at(CAMERA_UYVY, 2, 1, &layout, data);
	uint16_t row[2];

	(void)state;
	camera_convert_row(&image, 0, 0, 2, row);
	assert_int_equal(row[0], 0x0000);
	assert_int_equal(row[1], 0xffff);
}

static void test_planes_follow_each_other(void **state)
{
	struct camera_layout layout = camera_layout_of(CAMERA_YUV420, 5, 3, 0);

	(void)state;
	assert_int_equal(layout.offset[1], 15);
	assert_int_equal(layout.offset[2], 21);
	assert_int_equal(layout.size, 27);
	layout = camera_layout_of(CAMERA_NV12, 6, 4, 8);
	assert_int_equal(layout.offset[1], 32);
	assert_int_equal(layout.stride_bytes[1], 8);
	assert_int_equal(layout.size, 48);
}

/* Returns a picture of RGB565 whose pixels count up. */
static struct noise make_count(int width, int height)
{
	struct noise count = make_noise(CAMERA_RGB565, width, height, 0);

	for (int i = 0; i < width * height; i++) {
		count.data[2 * i] = (uint8_t)i;
		count.data[2 * i + 1] = (uint8_t)(i >> 8);
	}
	return count;
}

static void test_a_part_of_its_own_size_is_copied(void **state)
{
	struct camera_scaler *scaler = malloc(sizeof(*scaler));
	struct noise count = make_count(20, 10);
	const struct camera_part part = {4, 2, 3, 2};
	uint16_t out[2][5] = {{0}};

	(void)state;
	assert_non_null(scaler);
	camera_convert(scaler, &count.image, &part, 3, 2, out[0], 5);
	assert_int_equal(out[0][0], 44);
	assert_int_equal(out[0][2], 46);
	assert_int_equal(out[0][3], 0);
	assert_int_equal(out[1][0], 64);
	free(count.data);
	free(scaler);
}

static void test_a_larger_picture_takes_the_nearest(void **state)
{
	struct camera_scaler *scaler = malloc(sizeof(*scaler));
	struct noise count = make_count(4, 2);
	const struct camera_part part = {0, 0, 4, 2};
	uint16_t out[5][9];

	(void)state;
	assert_non_null(scaler);
	/* A centre between two pixels takes the first. */
	camera_convert(scaler, &count.image, &part, 9, 5, out[0], 9);
	for (int y = 0; y < 5; y++) {
		for (int x = 0; x < 9; x++) {
			int near_x = (int)floor((x + 0.5) * 4.0 / 9.0 - 1e-3);
			int near_y = (int)floor((y + 0.5) * 2.0 / 5.0 - 1e-3);

			assert_int_equal(out[y][x], near_y * 4 + near_x);
		}
	}
	free(count.data);
	free(scaler);
}

static void test_a_somewhat_smaller_picture_takes_the_nearest(void **state)
{
	struct camera_scaler *scaler = malloc(sizeof(*scaler));
	struct noise count = make_count(5, 5);
	const struct camera_part part = {0, 0, 5, 5};
	uint16_t out[3][3];

	(void)state;
	assert_non_null(scaler);
	camera_convert(scaler, &count.image, &part, 3, 3, out[0], 3);
	for (int i = 0; i < 9; i++) {
		/* The first, the third and the last of each. */
		assert_int_equal(out[i / 3][i % 3], i / 3 * 10 + i % 3 * 2);
	}
	free(count.data);
	free(scaler);
}

/* Each channel is the rounded mean of four pixels, computed in float. */
static void test_half_the_size_is_the_mean_of_squares(void **state)
{
	enum {
		WIDTH = 26,
		HEIGHT = 10
	};
	struct camera_scaler *scaler = malloc(sizeof(*scaler));
	struct noise noise = make_noise(CAMERA_RGB565, WIDTH, HEIGHT, 0);
	const struct camera_part part = {0, 0, WIDTH, HEIGHT};
	uint16_t out[HEIGHT / 2][WIDTH / 2];

	(void)state;
	assert_non_null(scaler);
	camera_convert(scaler, &noise.image, &part, WIDTH / 2, HEIGHT / 2,
		out[0], WIDTH / 2);
	for (int i = 0; i < WIDTH / 2 * (HEIGHT / 2); i++) {
		int x = i % (WIDTH / 2), y = i / (WIDTH / 2);
		double mean[3] = {0.0}, rgb[3];

		for (int k = 0; k < 4; k++) {
			reference(&noise.image, 2 * x + k % 2, 2 * y + k / 2,
				rgb);
			for (int c = 0; c < 3; c++) {
				mean[c] += rgb[c] / 4.0;
			}
		}
		assert_color(out[y][x], mean);
	}
	free(noise.data);
	free(scaler);
}

static void test_the_centre_is_cropped(void **state)
{
	struct camera_part part = camera_part_cut(320, 240, 480, 640);

	(void)state;
	assert_int_equal(part.width, 180);
	assert_int_equal(part.height, 240);
	assert_int_equal(part.x, 70);
	assert_int_equal(part.y, 0);
	part = camera_part_cut(320, 240, 4, 3);
	assert_int_equal(part.width, 320);
	assert_int_equal(part.height, 240);
	part = camera_part_cut(100, 100, 8192, 1);
	assert_int_equal(part.width, 100);
	assert_int_equal(part.height, 1);
	part = camera_part_cut(3, 3, 1, 8192);
	assert_int_equal(part.width, 1);
	assert_int_equal(part.x % 2, 0);
	assert_true(part.x + part.width <= 3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_rows_match_the_formula_of_the_standard),
		cmocka_unit_test(
			test_every_luma_and_extreme_chroma_match_the_formula),
		cmocka_unit_test(test_black_and_white_are_exact),
		cmocka_unit_test(test_planes_follow_each_other),
		cmocka_unit_test(test_a_part_of_its_own_size_is_copied),
		cmocka_unit_test(test_a_larger_picture_takes_the_nearest),
		cmocka_unit_test(
			test_a_somewhat_smaller_picture_takes_the_nearest),
		cmocka_unit_test(test_half_the_size_is_the_mean_of_squares),
		cmocka_unit_test(test_the_centre_is_cropped),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
