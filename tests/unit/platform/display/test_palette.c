#include "platform/display/image/palette.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>

enum {
	WIDTH = 64,
	HEIGHT = 64
};

static uint8_t data[HEIGHT][WIDTH][4];
static const struct pixels picture = {
	&data[0][0][0], WIDTH, HEIGHT, WIDTH * 4, PIXELS_RGBA8888};

static void paint(int x, int y, int red, int green, int blue)
{
	data[y][x][0] = (uint8_t)red;
	data[y][x][1] = (uint8_t)green;
	data[y][x][2] = (uint8_t)blue;
	data[y][x][3] = (uint8_t)(x * y);
}

static void test_a_picture_of_few_colours_keeps_them(void **state)
{
	struct palette_maker *maker = palette_maker_create();

	(void)state;
	assert_non_null(maker);
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			int band = y / 8;

			paint(x, y, band * 36, 255 - band * 36, band * 5);
		}
	}
	/* A single pixel counts, too. */
	paint(0, 0, 1, 2, 255);
	palette_choose(maker, &picture, 255);
	assert_int_equal(palette_current(maker)->count, 9);
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			const uint8_t *pixel = data[y][x];
			int index = palette_nearest(
				maker, pixel[0], pixel[1], pixel[2]);

			assert_memory_equal(
				palette_current(maker)->rgb[index], pixel, 3);
		}
	}
	palette_maker_destroy(maker);
}

/* The mean of all three is the second. */
static void test_a_colour_at_the_mean_joins_the_darker_ones(void **state)
{
	struct palette_maker *maker = palette_maker_create();
	const struct pixels three = {
		&data[0][0][0], 3, 1, WIDTH * 4, PIXELS_RGBA8888};
	const struct palette *palette;
	int dark, light;

	(void)state;
	assert_non_null(maker);
	for (int x = 0; x < 3; x++) {
		paint(x, 0, 100 * x, 100 * x, 100 * x);
	}
	palette_choose(maker, &three, 2);
	palette = palette_current(maker);
	assert_int_equal(palette->count, 2);
	dark = palette->rgb[0][0] < palette->rgb[1][0] ? 0 : 1;
	light = 1 - dark;
	for (int i = 0; i < 3; i++) {
		assert_int_equal(palette->rgb[dark][i], 50);
		assert_int_equal(palette->rgb[light][i], 200);
	}
	palette_maker_destroy(maker);
}

/* A picture of more colours than any palette. */
static void paint_plane(void)
{
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			paint(x, y, 4 * x, 4 * y, 255 - 2 * (x + y));
		}
	}
}

static void test_a_full_picture_is_near_its_palette(void **state)
{
	struct palette_maker *maker = palette_maker_create();

	(void)state;
	assert_non_null(maker);
	paint_plane();
	palette_choose(maker, &picture, 255);
	assert_int_equal(palette_current(maker)->count, 255);
	/*
	 * 255 colours for a plane of 256 x 256: steps of 16 with a mean square
	 * error of 16^2 / 12 in red (weight 2) and green (4), less in blue.
	 */
	assert_in_range((int)palette_error(maker, &picture), 1, 220);
	palette_maker_destroy(maker);
}

/* Of four values, the one in the middle decides: the third. */
static void test_the_nearest_of_two_colours_changes_half_way(void **state)
{
	struct palette_maker *maker = palette_maker_create();

	(void)state;
	assert_non_null(maker);
	for (int i = 0; i < 6; i++) {
		/* Half way are 5.5 and 6.5; the cell of 4 to 7 has 6. */
		int other = i < 3 ? 11 : 13, channel = i % 3, index[4];
		int color[3] = {0, 0, 0};

		for (int p = 0; p < WIDTH * HEIGHT; p++) {
			int value = p % 2 ? other : 0;

			paint(p % WIDTH, p / WIDTH, channel == 0 ? value : 0,
				channel == 1 ? value : 0,
				channel == 2 ? value : 0);
		}
		palette_choose(maker, &picture, 255);
		assert_int_equal(palette_current(maker)->count, 2);
		for (int k = 0; k < 4; k++) {
			static const int values[4] = {3, 4, 7, 8};

			color[channel] = values[k];
			index[k] = palette_current(maker)->rgb[palette_nearest(
				maker, color[0], color[1], color[2])][channel];
		}
		assert_int_equal(index[0], 0);
		assert_int_equal(index[1], i < 3 ? other : 0);
		assert_int_equal(index[2], i < 3 ? other : 0);
		assert_int_equal(index[3], other);
	}
	palette_maker_destroy(maker);
}

static void test_the_limit_is_reached_and_holds(void **state)
{
	struct palette_maker *maker = palette_maker_create();

	(void)state;
	assert_non_null(maker);
	paint_plane();
	for (int limit = 1; limit <= PALETTE_COLORS_MAX; limit += 51) {
		palette_choose(maker, &picture, limit);
		assert_int_equal(palette_current(maker)->count, limit);
		for (int i = 0; i < 256; i += 15) {
			assert_in_range(palette_nearest(maker, i, 255 - i, i),
				0, limit - 1);
		}
	}
	palette_maker_destroy(maker);
}

/* Colours weigh as much as the square root of their pixels, and are rounded. */
static void test_a_palettes_colours_are_weighted_means(void **state)
{
	static const int parts[] = {1, 4, 9, 16, 25};
	struct palette_maker *maker = palette_maker_create();

	(void)state;
	assert_non_null(maker);
	for (int i = 0; i < 5; i++) {
		/* Of the 26 pixels of each row. */
		double few = sqrt(parts[i] * HEIGHT),
		       many = sqrt((26 - parts[i]) * HEIGHT);
		struct pixels row = picture;
		const uint8_t *got;

		row.width = 26;
		for (int p = 0; p < WIDTH * HEIGHT; p++) {
			bool first = p % WIDTH < parts[i];

			paint(p % WIDTH, p / WIDTH, first ? 255 : 3,
				first ? 41 : 254, first ? 2 : 121);
		}
		palette_choose(maker, &row, 1);
		assert_int_equal(palette_current(maker)->count, 1);
		got = palette_current(maker)->rgb[0];
		assert_near(got[0], (255 * few + 3 * many) / (few + many), 0.51);
		assert_near(
			got[1], (41 * few + 254 * many) / (few + many), 0.51);
		assert_near(got[2], (2 * few + 121 * many) / (few + many), 0.51);
	}
	palette_maker_destroy(maker);
}

static void test_another_picture_has_a_larger_error(void **state)
{
	struct palette_maker *maker = palette_maker_create();
	float before;

	(void)state;
	assert_non_null(maker);
	paint_plane();
	palette_choose(maker, &picture, 255);
	before = palette_error(maker, &picture);
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			paint(x, y, 255, 0, 255);
		}
	}
	assert_true(palette_error(maker, &picture) > 10 * before);
	palette_maker_destroy(maker);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_picture_of_few_colours_keeps_them),
		cmocka_unit_test(test_a_colour_at_the_mean_joins_the_darker_ones),
		cmocka_unit_test(test_a_full_picture_is_near_its_palette),
		cmocka_unit_test(
			test_the_nearest_of_two_colours_changes_half_way),
		cmocka_unit_test(test_the_limit_is_reached_and_holds),
		cmocka_unit_test(test_a_palettes_colours_are_weighted_means),
		cmocka_unit_test(test_another_picture_has_a_larger_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
