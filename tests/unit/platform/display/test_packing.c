#include "platform/display/packing.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* The channel's value as a fraction of 1, in floating point. */
static uint32_t expected(int value, int max, struct pixel_field field)
{
	double full = (double)((1ull << field.length) - 1);

	return (uint32_t)floor((double)value / max * full + 0.5) << field.offset;
}

static uint32_t packed(const struct packing *packing, const uint8_t *pixel,
	enum pixel_format format)
{
	uint8_t data[4];
	struct pixels picture = {
		.data = (uint8_t *)(uintptr_t)pixel,
		.width = 1,
		.height = 1,
		.stride_bytes = 4,
		.format = format,
	};
	uint32_t result = 0;

	memcpy(data, &result, 4);
	packing_copy(packing, &picture, data, 4);
	memcpy(&result, data, 4);
	return result;
}

static const struct pixel_layout layouts[] = {
	{8, {5, 3}, {2, 3}, {0, 2}, {0, 0}, false},
	{16, {11, 5}, {5, 6}, {0, 5}, {0, 0}, false},
	{16, {10, 5}, {5, 5}, {0, 5}, {15, 1}, false},
	{16, {8, 4}, {4, 4}, {0, 4}, {12, 4}, false},
	{24, {16, 8}, {8, 8}, {0, 8}, {0, 0}, false},
	{18, {12, 6}, {6, 6}, {0, 6}, {0, 0}, false},
	{32, {16, 8}, {8, 8}, {0, 8}, {24, 8}, false},
	{32, {0, 8}, {8, 8}, {16, 8}, {24, 8}, false},
	{32, {22, 10}, {11, 11}, {0, 11}, {0, 0}, false},
	{32, {0, 16}, {16, 1}, {17, 15}, {0, 0}, false},
	{32, {16, 8}, {8, 8}, {0, 8}, {0, 0}, false},
	{32, {16, 8}, {8, 8}, {0, 8}, {28, 4}, false},
	{32, {0, 8}, {8, 8}, {16, 8}, {28, 4}, false},
};

static void test_every_value_of_a_channel_is_rounded_to_nearest(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
		const struct pixel_layout *layout = &layouts[i];
		struct packing packing;
		uint32_t opaque =
			layout->alpha.length ? expected(1, 1, layout->alpha) : 0;

		assert_true(pixel_layout_is_valid(layout));
		packing_init(&packing, PIXELS_RGBA8888, layout);
		for (int value = 0; value < 256; value++) {
			uint8_t pixel[4] = {(uint8_t)value,
				(uint8_t)(255 - value), (uint8_t)(value ^ 0x55),
				0};

			assert_int_equal(
				packed(&packing, pixel, PIXELS_RGBA8888),
				opaque + expected(value, 255, layout->red) +
					expected(255 - value, 255,
						layout->green) +
					expected(value ^ 0x55, 255,
						layout->blue));
		}
	}
}

/* Blending leaves any alpha in pictures, which must not make them transparent. */
static void test_the_alpha_of_a_picture_changes_nothing(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
		struct packing packing;

		packing_init(&packing, PIXELS_RGBA8888, &layouts[i]);
		for (int alpha = 0; alpha < 256; alpha++) {
			uint8_t pixel[4] = {0x12, 0x9A, 0xE7, (uint8_t)alpha};
			uint8_t opaque[4] = {0x12, 0x9A, 0xE7, 0xFF};

			assert_int_equal(
				packed(&packing, pixel, PIXELS_RGBA8888),
				packed(&packing, opaque, PIXELS_RGBA8888));
		}
	}
}

/* A row of any width, and nothing behind it. */
static void test_black_is_opaque_and_as_wide_as_it_should_be(void **state)
{
	enum {
		WIDTH = 300
	};

	(void)state;
	for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
		int bytes = pixel_layout_bytes(&layouts[i]);
		uint32_t black = pixel_layout_mask(layouts[i].alpha);
		uint8_t out[WIDTH * 4];
		struct packing packing;

		packing_init(&packing, PIXELS_RGBA8888, &layouts[i]);
		for (int width = 0; width < WIDTH - 1; width += 7) {
			memset(out, 0xEE, sizeof(out));
			packing_blacken(&packing, out, width);
			for (int k = 0; k < width * bytes; k++) {
				assert_int_equal(
					out[k], black >> 8 * (k % bytes) & 255);
			}
			assert_int_equal(out[width * bytes], 0xEE);
		}
	}
}

static void test_565_fills_wider_channels(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
		const struct pixel_layout *layout = &layouts[i];
		struct packing packing;

		packing_init(&packing, PIXELS_RGB565, layout);
		for (int value = 0; value < 64; value++) {
			uint16_t pixel = (uint16_t)((value & 31) << 11 |
				value << 5 | (31 - (value & 31)));
			uint32_t opaque = layout->alpha.length
				? expected(1, 1, layout->alpha)
				: 0;

			assert_int_equal(packed(&packing, (uint8_t *)&pixel,
						 PIXELS_RGB565),
				opaque + expected(value & 31, 31, layout->red) +
					expected(value, 63, layout->green) +
					expected(31 - (value & 31), 31,
						layout->blue));
		}
	}
}

static void test_a_format_without_alpha_is_its_own_layout(void **state)
{
	static const enum pixel_format formats[] = {
		PIXELS_RGB565, PIXELS_RGBA8888};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct pixel_layout layout = pixel_layout_of(formats[i]);
		struct packing packing;

		layout.alpha = (struct pixel_field){0, 0};
		packing_init(&packing, formats[i], &layout);
		assert_true(packing.same);
		packing_init(&packing, formats[!i], &layout);
		assert_false(packing.same);
	}
}

static void test_converting_565_back_and_forth_changes_nothing(void **state)
{
	struct pixel_layout wide = pixel_layout_of(PIXELS_RGBA8888);
	struct pixel_layout narrow = pixel_layout_of(PIXELS_RGB565);
	struct packing there, back;

	(void)state;
	packing_init(&there, PIXELS_RGB565, &wide);
	packing_init(&back, PIXELS_RGBA8888, &narrow);
	for (int i = 0; i < 65536; i++) {
		uint16_t pixel = (uint16_t)i;
		uint32_t rgba =
			packed(&there, (const uint8_t *)&pixel, PIXELS_RGB565);

		assert_int_equal(
			packed(&back, (const uint8_t *)&rgba, PIXELS_RGBA8888) &
				0xFFFF,
			i);
	}
}

/* Of any size: what follows a row stays as it is. */
static void test_only_the_pixels_of_a_row_are_written(void **state)
{
	enum {
		WIDTH = 5,
		ROWS = 3,
		STRIDE = WIDTH * 4 + 8
	};

	(void)state;
	for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
		int bytes = pixel_layout_bytes(&layouts[i]);
		uint8_t in[ROWS][WIDTH + 2][4], out[ROWS][STRIDE];
		const struct pixels picture = {&in[0][0][0], WIDTH, ROWS,
			(WIDTH + 2) * 4, PIXELS_RGBA8888};
		struct packing packing;

		for (size_t k = 0; k < sizeof(in); k++) {
			(&in[0][0][0])[k] = (uint8_t)(37 * k);
		}
		memset(out, 0xEE, sizeof(out));
		packing_init(&packing, PIXELS_RGBA8888, &layouts[i]);
		packing_copy(&packing, &picture, &out[0][0], STRIDE);
		for (int y = 0; y < ROWS; y++) {
			for (int x = 0; x < WIDTH; x++) {
				uint32_t pixel = packed(
					&packing, in[y][x], PIXELS_RGBA8888);

				for (int k = 0; k < bytes; k++) {
					assert_int_equal(out[y][x * bytes + k],
						pixel >> 8 * k & 255);
				}
			}
			for (int k = WIDTH * bytes; k < STRIDE; k++) {
				assert_int_equal(out[y][k], 0xEE);
			}
		}
	}
}

static void test_invalid_layouts_are_recognized(void **state)
{
	static const struct pixel_layout unsound[] = {
		{0, {0, 1}, {1, 1}, {2, 1}, {0, 0}, false},
		{33, {0, 8}, {8, 8}, {16, 8}, {0, 0}, false},
		{16, {12, 5}, {5, 6}, {0, 5}, {0, 0}, false},
		{16, {11, 5}, {4, 6}, {0, 5}, {0, 0}, false},
		{16, {11, 5}, {5, 6}, {0, 0}, {0, 0}, false},
		{16, {11, 5}, {5, 6}, {0, 5}, {15, 1}, false},
		{16, {-1, 5}, {5, 6}, {0, 5}, {0, 0}, false},
		{16, {11, -5}, {5, 6}, {0, 5}, {0, 0}, false},
		{8, {0, 8}, {0, 8}, {0, 8}, {0, 0}, false},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(unsound) / sizeof(unsound[0]); i++) {
		if (pixel_layout_is_valid(&unsound[i])) {
			fail_msg("layout %d is taken for sound", (int)i);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_every_value_of_a_channel_is_rounded_to_nearest),
		cmocka_unit_test(test_the_alpha_of_a_picture_changes_nothing),
		cmocka_unit_test(
			test_black_is_opaque_and_as_wide_as_it_should_be),
		cmocka_unit_test(test_565_fills_wider_channels),
		cmocka_unit_test(test_a_format_without_alpha_is_its_own_layout),
		cmocka_unit_test(
			test_converting_565_back_and_forth_changes_nothing),
		cmocka_unit_test(test_only_the_pixels_of_a_row_are_written),
		cmocka_unit_test(test_invalid_layouts_are_recognized),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
