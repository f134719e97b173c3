/* Where the planes of pictures lie, which part is shown, where motion is seen. */
#include "platform/base/compiler.h"
#include "platform/camera/convert.h"
#include "platform/camera/motion.h"
#include "tests/support/test.h"

#include <string.h>

static void test_planes_follow_each_other_in_every_format(void **state)
{
	static const struct {
		enum camera_format format;
		int width, height, least;
		int stride[3], offset[3], size;
	} cases[] = {
		{CAMERA_RGB565, 5, 3, 0, {10}, {0}, 30},
		{CAMERA_RGB565, 5, 3, 16, {16}, {0}, 48},
		{CAMERA_UYVY, 5, 3, 0, {12}, {0}, 36},
		{CAMERA_YUYV, 4, 3, 0, {8}, {0}, 24},
		{CAMERA_RGB24, 5, 3, 0, {15}, {0}, 45},
		{CAMERA_BGR24, 5, 3, 20, {20}, {0}, 60},
		{CAMERA_NV12, 5, 3, 0, {5, 6}, {0, 15}, 27},
		{CAMERA_NV12, 6, 4, 8, {8, 8}, {0, 32}, 48},
		{CAMERA_YUV420, 5, 3, 0, {5, 3, 3}, {0, 15, 21}, 27},
		{CAMERA_YUV420, 6, 4, 8, {8, 4, 4}, {0, 32, 40}, 48},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct camera_layout layout = camera_layout_of(cases[i].format,
			cases[i].width, cases[i].height, cases[i].least);
		uint8_t data[64];
		struct camera_image image = camera_image_at(cases[i].format,
			cases[i].width, cases[i].height, &layout, data);

		assert_int_equal(layout.size, cases[i].size);
		for (int k = 0; k < CAMERA_PLANES; k++) {
			assert_int_equal(
				layout.stride_bytes[k], cases[i].stride[k]);
			assert_int_equal(layout.offset[k], cases[i].offset[k]);
			assert_ptr_equal(
				image.plane[k], data + cases[i].offset[k]);
			assert_int_equal(
				image.stride_bytes[k], cases[i].stride[k]);
		}
		assert_int_equal(image.width, cases[i].width);
		assert_int_equal(image.height, cases[i].height);
		assert_int_equal(image.format, cases[i].format);
	}
}

static void test_formats_are_found_by_their_names(void **state)
{
	static const char *const names[] = {
		"rgb565", "uyvy", "yuyv", "nv12", "yuv420", "rgb24", "bgr24"};
	static const enum camera_format formats[] = {CAMERA_RGB565, CAMERA_UYVY,
		CAMERA_YUYV, CAMERA_NV12, CAMERA_YUV420, CAMERA_RGB24,
		CAMERA_BGR24};

	(void)state;
	for (int i = 0; i < 7; i++) {
		assert_int_equal(camera_format_find(names[i]), formats[i]);
	}
	assert_int_equal(camera_format_find("RGB565"), CAMERA_FORMATS);
}

static void test_the_largest_part_of_an_aspect_is_centred(void **state)
{
	static const struct {
		int width, height, aspect_width, aspect_height;
		struct camera_part part;
	} cases[] = {
		{320, 240, 4, 3, {0, 0, 320, 240}},
		{320, 240, 1, 1, {40, 0, 240, 240}},
		{240, 320, 1, 1, {0, 40, 240, 240}},
		/* The corner is even, as pixels share their chroma in pairs. */
		{323, 240, 1, 1, {40, 0, 240, 240}},
		{326, 240, 1, 1, {42, 0, 240, 240}},
		{240, 326, 1, 1, {0, 42, 240, 240}},
		{320, 240, 100000, 1, {0, 118, 320, 1}},
		{320, 240, 1, 100000, {158, 0, 1, 240}},
		{2048, 2048, 2000000000, 1999999999, {0, 0, 2048, 2047}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct camera_part part =
			camera_part_cut(cases[i].width, cases[i].height,
				cases[i].aspect_width, cases[i].aspect_height);

		assert_int_equal(part.x, cases[i].part.x);
		assert_int_equal(part.y, cases[i].part.y);
		assert_int_equal(part.width, cases[i].part.width);
		assert_int_equal(part.height, cases[i].part.height);
	}
}

enum {
	WIDTH = 320,
	HEIGHT = 240,
	CELLS = CAMERA_MOTION_COLUMNS * CAMERA_MOTION_ROWS
};

/* What is seen after one pixel of a black picture becomes this bright. */
static int see_pixel(int x, int y, uint8_t luma)
{
	static uint8_t data[WIDTH * HEIGHT * 3 / 2];
	const struct camera_layout layout =
		camera_layout_of(CAMERA_NV12, WIDTH, HEIGHT, 0);
	const struct camera_image image =
		camera_image_at(CAMERA_NV12, WIDTH, HEIGHT, &layout, data);
	struct camera_motion motion = {.seen = false};

	memset(data, 0, sizeof(data));
	(void)camera_motion_feed(&motion, &image);
	data[y * WIDTH + x] = luma;
	return camera_motion_feed(&motion, &image);
}

static void test_four_pixels_of_a_cell_are_looked_at(void **state)
{
	static const int corners[][2] = {{0, 0}, {31, 0}, {0, 23}, {17, 11}};

	(void)state;
	for (int i = 0; i < 4; i++) {
		int seen = 0;

		for (int k = 0; k < 100; k++) {
			int x = 10 * corners[i][0] + k % 10;
			int y = 10 * corners[i][1] + k / 10;
			int motion = see_pixel(x, y, 240);
			bool looked_at = (k % 10 == 2 || k % 10 == 7) &&
				(k / 10 == 2 || k / 10 == 7);

			assert_int_equal(
				motion, looked_at ? 240 * 64 / CELLS : 0);
			seen += motion > 0;
		}
		assert_int_equal(seen, 4);
	}
}

static void test_a_change_of_more_than_noise_counts(void **state)
{
	(void)state;
	assert_int_equal(see_pixel(12, 12, 24), 0);
	assert_int_equal(see_pixel(12, 12, 25), 25 * 64 / CELLS);
}

/* Red and blue change from black to white, and do not count. */
static void test_green_stands_for_the_luma_of_24_bits(void **state)
{
	static const enum camera_format formats[] = {CAMERA_RGB24, CAMERA_BGR24};
	static uint8_t data[64 * 48 * 3];

	(void)state;
	for (int f = 0; f < 2; f++) {
		const struct camera_layout layout =
			camera_layout_of(formats[f], 64, 48, 0);
		const struct camera_image image =
			camera_image_at(formats[f], 64, 48, &layout, data);
		struct camera_motion motion = {.seen = false};

		memset(data, 0, sizeof(data));
		(void)camera_motion_feed(&motion, &image);
		memset(data, 255, sizeof(data));
		for (size_t i = 1; i < sizeof(data); i += 3) {
			data[i] = 100;
		}
		assert_int_equal(camera_motion_feed(&motion, &image), 100 * 256);
	}
}

static void test_green_stands_for_the_luma_of_rgb565(void **state)
{
	static uint8_t data[64 * 48 * 2];
	const struct camera_layout layout =
		camera_layout_of(CAMERA_RGB565, 64, 48, 0);
	const struct camera_image image =
		camera_image_at(CAMERA_RGB565, 64, 48, &layout, data);

	(void)state;
	for (unsigned green = 2; green < 64; green++) {
		struct camera_motion motion = {.seen = false};

		memset(data, 0, sizeof(data));
		(void)camera_motion_feed(&motion, &image);
		for (size_t i = 0; i < sizeof(data); i += 2) {
			/* Red and blue are full, and do not count. */
			unsigned pixel = 0xf81fu | green << 5;

			data[i] = (uint8_t)pixel;
			data[i + 1] = (uint8_t)(pixel >> 8);
		}
		assert_int_equal(camera_motion_feed(&motion, &image),
			green * 255 / 63 * 256);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_planes_follow_each_other_in_every_format),
		cmocka_unit_test(test_formats_are_found_by_their_names),
		cmocka_unit_test(test_the_largest_part_of_an_aspect_is_centred),
		cmocka_unit_test(test_four_pixels_of_a_cell_are_looked_at),
		cmocka_unit_test(test_a_change_of_more_than_noise_counts),
		cmocka_unit_test(test_green_stands_for_the_luma_of_24_bits),
		cmocka_unit_test(test_green_stands_for_the_luma_of_rgb565),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
