/* Where pictures lie on a screen, their memory, and gray screens. */
#include "platform/display/packing.h"
#include "platform/display/placement.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void test_a_picture_without_a_size_fills_the_screen(void **state)
{
	const struct log log = log_to_nowhere();
	const struct display_options options = {
		.width = 10, .height = 10, .log = &log};
	struct placement place = placement_choose(&options, 33, 21);

	(void)state;
	assert_int_equal(place.left, 0);
	assert_int_equal(place.top, 0);
	assert_int_equal(place.width, 33);
	assert_int_equal(place.height, 21);
}

static void test_a_picture_of_a_given_size_is_centred(void **state)
{
	static const struct {
		int width, height;
		struct placement place;
		bool warns;
	} cases[] = {
		{10, 10, {11, 5, 10, 10}, false},
		{33, 21, {0, 0, 33, 21}, false},
		{32, 20, {0, 0, 32, 20}, false},
		{1, 1, {16, 10, 1, 1}, false},
		{34, 10, {0, 5, 33, 10}, true},
		{10, 22, {11, 0, 10, 21}, true},
		{8192, 8192, {0, 0, 33, 21}, true},
	};

	(void)state;
	for (int i = 0; i < 7; i++) {
		struct log_capture heard;
		const struct log log = log_capture_begin(&heard);
		const struct display_options options = {.width = cases[i].width,
			.height = cases[i].height,
			.size_given = true,
			.log = &log};
		struct placement place = placement_choose(&options, 33, 21);

		assert_int_equal(place.left, cases[i].place.left);
		assert_int_equal(place.top, cases[i].place.top);
		assert_int_equal(place.width, cases[i].place.width);
		assert_int_equal(place.height, cases[i].place.height);
		assert_int_equal(heard.count, cases[i].warns);
		if (cases[i].warns) {
			assert_contains(heard.sentence[0],
				"the screen has only 33x21 pixels");
		}
	}
}

static void test_pictures_have_limits(void **state)
{
	static const int refused[][2] = {{0, 1}, {1, 0}, {-1, 1},
		{PIXELS_SIZE_MAX + 1, 1}, {1, PIXELS_SIZE_MAX + 1}};
	struct log_capture heard;
	const struct log log = log_capture_begin(&heard);
	struct pixels picture;

	(void)state;
	for (int i = 0; i < 5; i++) {
		assert_int_equal(pixels_alloc(&picture, refused[i][0],
					 refused[i][1], PIXELS_RGB565, &log),
			-EINVAL);
		assert_int_equal(heard.count, i + 1);
	}
	for (int i = 0; i < 4; i++) {
		int side = i < 2 ? 3 : PIXELS_SIZE_MAX;
		enum pixel_format format =
			i % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888;

		assert_int_equal(
			pixels_alloc(&picture, side, 1, format, &log), 0);
		assert_int_equal(picture.width, side);
		assert_int_equal(picture.height, 1);
		assert_int_equal(picture.format, format);
		assert_int_equal(picture.stride_bytes, side * (i % 2 ? 2 : 4));
		assert_int_equal(picture.data[picture.stride_bytes - 1], 0);
		free(picture.data);
	}
}

static void test_only_the_picture_is_copied(void **state)
{
	uint8_t from[3 * 6], to[3 * 8];
	const struct pixels source = {.data = from,
		.width = 2,
		.height = 3,
		.stride_bytes = 6,
		.format = PIXELS_RGB565};
	const struct pixels target = {.data = to,
		.width = 2,
		.height = 3,
		.stride_bytes = 8,
		.format = PIXELS_RGB565};

	(void)state;
	for (int i = 0; i < 18; i++) {
		from[i] = (uint8_t)(i + 1);
	}
	memset(to, 0xee, sizeof(to));
	pixels_copy(&target, &source);
	for (int i = 0; i < 24; i++) {
		assert_int_equal(
			to[i], i % 8 < 4 ? i / 8 * 6 + i % 8 + 1 : 0xee);
	}
}

static uint32_t gray_of(const struct packing *packing, int r, int g, int b)
{
	return packing->red[r] + packing->green[g] + packing->blue[b];
}

static void test_gray_is_the_luma_of_the_colour(void **state)
{
	const struct pixel_layout gray = {.bits = 16,
		.red = {4, 8},
		.green = {4, 8},
		.blue = {4, 8},
		.alpha = {15, 1},
		.gray = true};
	struct packing packing;

	(void)state;
	assert_true(pixel_layout_is_valid(&gray));
	packing_init(&packing, PIXELS_RGBA8888, &gray);
	assert_false(packing.same);
	assert_int_equal(gray_of(&packing, 0, 0, 0), 0x8000);
	assert_int_equal(gray_of(&packing, 255, 255, 255), 0x8ff0);
	for (int i = 0; i < 255; i++) {
		assert_int_equal(gray_of(&packing, i, 0, 0),
			0x8000 + (i * 77 / 256 << 4));
		assert_int_equal(gray_of(&packing, 0, i, 0),
			0x8000 + (i * 150 / 256 << 4));
		assert_int_equal(gray_of(&packing, 0, 0, i),
			0x8000 + (i * 29 / 256 << 4));
	}
	packing_init(&packing, PIXELS_RGB565, &gray);
	assert_int_equal(gray_of(&packing, 0, 0, 0), 0x8000);
	assert_int_equal(gray_of(&packing, 31, 63, 31), 0x8ff0);
	for (int i = 0; i < 31; i++) {
		assert_int_equal(gray_of(&packing, i, 0, 0),
			0x8000 + (i * 255 * 77 / 31 / 256 << 4));
		assert_int_equal(gray_of(&packing, 0, 2 * i, 0),
			0x8000 + (2 * i * 255 * 150 / 63 / 256 << 4));
	}
}

/* Layouts that differ from a format's own in one thing are converted. */
static void test_only_a_formats_own_layout_is_copied(void **state)
{
	struct pixel_layout layout[6];
	struct packing packing;

	(void)state;
	for (int i = 0; i < 6; i++) {
		layout[i] = pixel_layout_of(PIXELS_RGB565);
	}
	layout[1].bits = 24;
	layout[2].red.length = 4;
	layout[3].green.length = 5;
	layout[4].blue.length = 4;
	layout[5].gray = true;
	for (int i = 0; i < 6; i++) {
		packing_init(&packing, PIXELS_RGB565, &layout[i]);
		assert_int_equal(packing.same, i == 0);
		assert_int_equal(packing.bytes, i == 1 ? 3 : 2);
		packing_init(&packing, PIXELS_RGBA8888, &layout[i]);
		assert_false(packing.same);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_picture_without_a_size_fills_the_screen),
		cmocka_unit_test(test_a_picture_of_a_given_size_is_centred),
		cmocka_unit_test(test_pictures_have_limits),
		cmocka_unit_test(test_only_the_picture_is_copied),
		cmocka_unit_test(test_gray_is_the_luma_of_the_colour),
		cmocka_unit_test(test_only_a_formats_own_layout_is_copied),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
