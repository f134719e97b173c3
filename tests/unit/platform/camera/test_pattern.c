/* The test picture, pixel by pixel, in each format. */
#include "platform/base/compiler.h"
#include "platform/camera/camera.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

extern const struct camera_driver camera_driver_pattern;

static const int sizes[][2] = {{16, 16}, {64, 48}, {50, 70}, {200, 20}};

static struct camera_source *open_pattern(
	int width, int height, const char *format)
{
	struct log log = log_to_nowhere();
	const struct camera_options options = {
		.width = width, .height = height, .format = format, .log = &log};
	struct camera_source *source = NULL;

	assert_int_equal(camera_driver_pattern.create(&options, &source), 0);
	return source;
}

static struct camera_image take(struct camera_source *source, int64_t now_ms)
{
	struct camera_image image;

	assert_int_equal(
		camera_driver_pattern.take(source, now_ms, &image), CAMERA_NEW);
	camera_driver_pattern.give_back(source);
	return image;
}

/* There and back again, from 0 to span. */
static int there_and_back(int distance, int span)
{
	int at = 0, step = 1;

	for (int i = 0; i < distance; i++) {
		step = at == span ? -1 : at == 0 ? 1 : step;
		at += span ? step : 0;
	}
	return at;
}

/* Bars above a ramp, a mark in the corner, and the ball of picture number. */
static void expected_color(
	int x, int y, int width, int height, int number, uint8_t rgb[3])
{
	static const uint8_t bars[8][3] = {{235, 235, 235}, {228, 196, 40},
		{44, 188, 200}, {56, 184, 76}, {196, 64, 180}, {208, 56, 48},
		{44, 72, 196}, {24, 24, 28}};
	static const uint8_t yellow[3] = {255, 255, 0};
	static const uint8_t rim[3] = {20, 20, 24}, ball[3] = {250, 120, 30};
	int radius = height / 7;
	int ball_x = radius +
		there_and_back(number * width / 60, width - 2 * radius - 1);
	int ball_y = radius +
		there_and_back(number * height / 44, height - 2 * radius - 1);
	int away = (x - ball_x) * (x - ball_x) + (y - ball_y) * (y - ball_y);
	uint8_t gray = (uint8_t)(255 * x / width);

	memset(rgb, gray, 3);
	if (away <= radius * radius) {
		memcpy(rgb, away <= radius * radius * 3 / 4 ? ball : rim, 3);
	} else if (x + y < height / 6) {
		memcpy(rgb, yellow, 3);
	} else if (y < height * 3 / 4) {
		memcpy(rgb, bars[8 * x / width], 3);
	}
}

static void test_the_picture_is_the_cards_with_a_ball(void **state)
{
	static const int numbers[] = {0, 1, 7, 20, 44, 45, 60, 87, 300};

	(void)state;
	for (size_t s = 0; s < ARRAY_COUNT(sizes); s++) {
		int width = sizes[s][0], height = sizes[s][1];
		struct camera_source *source =
			open_pattern(width, height, "rgb24");

		for (size_t n = 0; n < ARRAY_COUNT(numbers); n++) {
			struct camera_image image =
				take(source, numbers[n] * 40);

			assert_int_equal(image.format, CAMERA_RGB24);
			assert_int_equal(image.width, width);
			assert_int_equal(image.height, height);
			for (int i = 0; i < width * height; i++) {
				uint8_t rgb[3];

				expected_color(i % width, i / width, width,
					height, numbers[n], rgb);
				assert_memory_equal(image.plane[0] +
						i / width *
							image.stride_bytes[0] +
						i % width * 3,
					rgb, 3);
			}
		}
		camera_driver_pattern.destroy(source);
	}
}

/* ITU-R BT.601-7, limited range; row 0 is luma, the others chroma. */
static double channel_of(const uint8_t *rgb, int row)
{
	static const double factors[3][3] = {{65.481, 128.553, 24.966},
		{-37.797, -74.203, 112.0}, {112.0, -93.786, -18.214}};
	double sum = row ? 128.0 : 16.0;

	for (int i = 0; i < 3; i++) {
		sum += factors[row][i] * rgb[i] / 255.0;
	}
	return sum;
}

/* Where a format keeps luma, Cb and Cr of a pixel. */
static const uint8_t *place_of(
	const struct camera_image *image, int x, int y, int channel)
{
	const uint8_t *row = image->plane[0] + y * image->stride_bytes[0];
	int plane;

	switch (image->format) {
	case CAMERA_UYVY:
		return row + (channel ? x / 2 * 4 + 2 * channel - 2 : 2 * x + 1);
	case CAMERA_YUYV:
		return row + (channel ? x / 2 * 4 + 2 * channel - 1 : 2 * x);
	case CAMERA_NV12:
		return channel
			? image->plane[1] + y / 2 * image->stride_bytes[1] +
				x / 2 * 2 + channel - 1
			: row + x;
	default:
		plane = channel;
		return channel ? image->plane[plane] +
				y / 2 * image->stride_bytes[plane] + x / 2
			       : row + x;
	}
}

static const uint8_t *rgb_at(const struct camera_image *image, int x, int y)
{
	return image->plane[0] + y * image->stride_bytes[0] + x * 3;
}

/* Whether the pixels that may share a chroma sample have one colour. */
static bool is_even(const struct camera_image *rgb, int x, int y)
{
	const uint8_t *first = rgb_at(rgb, x / 2 * 2, y / 2 * 2);

	for (int i = 1; i < 4; i++) {
		if (memcmp(rgb_at(rgb, x / 2 * 2 + i % 2, y / 2 * 2 + i / 2),
			    first, 3) != 0) {
			return false;
		}
	}
	return true;
}

static void expect_same_colors(
	const struct camera_image *image, const struct camera_image *rgb)
{
	for (int i = 0; i < rgb->width * rgb->height; i++) {
		int x = i % rgb->width, y = i / rgb->width;
		const uint8_t *color = rgb_at(rgb, x, y);

		assert_near(
			*place_of(image, x, y, 0), channel_of(color, 0), 0.82);
		if (is_even(rgb, x, y)) {
			assert_near(*place_of(image, x, y, 1),
				channel_of(color, 1), 0.82);
			assert_near(*place_of(image, x, y, 2),
				channel_of(color, 2), 0.82);
		}
	}
}

static void test_video_formats_have_the_same_colours(void **state)
{
	static const char *const formats[] = {"uyvy", "yuyv", "nv12", "yuv420"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(formats) * ARRAY_COUNT(sizes); i++) {
		const int *size = sizes[i / ARRAY_COUNT(formats)];
		struct camera_source *source = open_pattern(
			size[0], size[1], formats[i % ARRAY_COUNT(formats)]);
		struct camera_source *colors =
			open_pattern(size[0], size[1], "rgb24");

		for (int now_ms = 0; now_ms < 4000; now_ms += 400) {
			struct camera_image image = take(source, now_ms);
			struct camera_image rgb = take(colors, now_ms);

			expect_same_colors(&image, &rgb);
		}
		camera_driver_pattern.destroy(source);
		camera_driver_pattern.destroy(colors);
	}
}

static void test_colour_formats_have_the_same_colours(void **state)
{
	struct camera_source *source[] = {open_pattern(64, 48, "rgb24"),
		open_pattern(64, 48, "bgr24"), open_pattern(64, 48, "rgb565")};
	struct camera_image image[3];

	(void)state;
	for (int i = 0; i < 3; i++) {
		image[i] = take(source[i], 1000);
	}
	for (int i = 0; i < 64 * 48; i++) {
		int x = i % 64, y = i / 64;
		const uint8_t *rgb = rgb_at(&image[0], x, y);
		const uint8_t *bgr = rgb_at(&image[1], x, y);
		const uint8_t *pair = image[2].plane[0] +
			y * image[2].stride_bytes[0] + 2 * x;

		for (int c = 0; c < 3; c++) {
			assert_int_equal(bgr[2 - c], rgb[c]);
		}
		assert_int_equal(pair[0] | pair[1] << 8,
			rgb[0] / 8 * 2048 + rgb[1] / 4 * 32 + rgb[2] / 8);
	}
	for (int i = 0; i < 3; i++) {
		camera_driver_pattern.destroy(source[i]);
	}
}

/* 25 pictures a second, and uyvy unless another format is asked for. */
static void test_a_picture_lasts_40_ms(void **state)
{
	struct camera_source *source = open_pattern(16, 16, NULL);
	struct camera_image image;

	(void)state;
	assert_int_equal(take(source, -5).format, CAMERA_UYVY);
	for (int now_ms = 0; now_ms < 2000; now_ms += 5) {
		assert_int_equal(
			camera_driver_pattern.take(source, now_ms, &image),
			now_ms % 40 == 0 && now_ms > 0 ? CAMERA_NEW
						       : CAMERA_SAME);
	}
	camera_driver_pattern.destroy(source);
}

static void test_no_source_can_be_destroyed(void **state)
{
	(void)state;
	camera_driver_pattern.destroy(NULL);
}

static void test_pictures_have_at_least_16_pixels_a_side(void **state)
{
	static const int wrong[][2] = {{15, 16}, {16, 15}, {0, 16}, {16, -1}};
	struct log log = log_to_nowhere();
	struct camera_source *source;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		const struct camera_options options = {.width = wrong[i][0],
			.height = wrong[i][1],
			.log = &log};

		assert_int_equal(camera_driver_pattern.create(&options, &source),
			-EINVAL);
	}
}

static bool is_ball(const uint8_t rgb[3])
{
	return rgb[0] == 250 && rgb[1] == 120 && rgb[2] == 30;
}

/*
 * No pixel beyond the picture may be written, and rows must not run over into
 * the next one: the ball is symmetric in a picture whose width it fills.
 */
static void test_the_ball_fits_into_a_narrow_picture(void **state)
{
	static const int narrow[][2] = {{16, 2048}, {17, 300}, {20, 100}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(narrow); i++) {
		int width = narrow[i][0], height = narrow[i][1];
		struct camera_source *source =
			open_pattern(width, height, "rgb24");
		int side = (width - 1) / 2 * 2 + 1, pixels = 0;

		for (int now_ms = 0; now_ms < 4000; now_ms += 400) {
			struct camera_image image = take(source, now_ms);

			pixels = 0;
			for (int p = 0; p < width * height; p++) {
				pixels += is_ball(
					rgb_at(&image, p % width, p / width));
			}
			assert_in_range(pixels, side * side / 3, side * side);
		}
		camera_driver_pattern.destroy(source);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_picture_is_the_cards_with_a_ball),
		cmocka_unit_test(test_video_formats_have_the_same_colours),
		cmocka_unit_test(test_colour_formats_have_the_same_colours),
		cmocka_unit_test(test_a_picture_lasts_40_ms),
		cmocka_unit_test(test_no_source_can_be_destroyed),
		cmocka_unit_test(test_pictures_have_at_least_16_pixels_a_side),
		cmocka_unit_test(test_the_ball_fits_into_a_narrow_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
