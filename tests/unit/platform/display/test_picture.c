#include "tests/support/files.h"
#include "tests/support/gl/picture.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	WIDTH = 100,
	HEIGHT = 60
};

static const struct picture_tolerance TOLERANCE = {
	.step = 8,
	.far_percent = 0.5,
	.mean = 0.5,
	.block_mean = 12,
	.block_strays = 8,
};

static struct picture gray(int width, int height, int value)
{
	struct picture picture = picture_new(width, height);

	assert_non_null(picture.rgb);
	memset(picture.rgb, value, (size_t)width * (size_t)height * 3);
	return picture;
}

static void fill_area(struct picture *picture, int left, int top, int width,
	int height, int value)
{
	for (int y = top; y < top + height; y++) {
		memset(picture->rgb + 3 * (y * picture->width + left), value,
			3 * (size_t)width);
	}
}

static void fill(struct picture *picture, int left, int top, int size, int value)
{
	fill_area(picture, left, top, size, size, value);
}

/* Releases both. */
static bool is_near(struct picture a, struct picture b)
{
	struct picture_difference difference =
		picture_compare(&a, &b, TOLERANCE.step);

	picture_release(&a);
	picture_release(&b);
	return picture_is_near(&difference, &TOLERANCE);
}

static void test_a_picture_equals_itself(void **state)
{
	(void)state;
	assert_true(is_near(gray(WIDTH, HEIGHT, 90), gray(WIDTH, HEIGHT, 90)));
}

static void test_other_sizes_are_never_near(void **state)
{
	(void)state;
	assert_false(is_near(gray(WIDTH, HEIGHT, 90), gray(HEIGHT, WIDTH, 90)));
	assert_false(is_near(gray(1, 1, 90), gray(1, 2, 90)));
}

static void test_a_small_shift_everywhere_is_too_far(void **state)
{
	(void)state;
	assert_false(is_near(gray(WIDTH, HEIGHT, 90), gray(WIDTH, HEIGHT, 92)));
}

static void test_single_pixels_are_forgiven(void **state)
{
	struct picture picture = gray(WIDTH, HEIGHT, 90);

	(void)state;
	for (int i = 0; i < 10; i++) {
		fill(&picture, 9 * i, 5 * i, 1, 200);
	}
	assert_true(is_near(gray(WIDTH, HEIGHT, 90), picture));
}

static void test_too_many_far_pixels_are_too_far(void **state)
{
	struct picture picture = gray(WIDTH, HEIGHT, 90);

	(void)state;
	for (int i = 0; i < 40; i++) {
		fill(&picture, 2 * i, i, 1, 100);
	}
	assert_false(is_near(gray(WIDTH, HEIGHT, 90), picture));
}

static void test_a_missing_small_part_is_too_far(void **state)
{
	struct picture large = gray(480, 640, 90);

	(void)state;
	/* 0.08 % of the pixels, a mean difference of 0.07 */
	fill(&large, 320, 160, 16, 180);
	assert_false(is_near(gray(480, 640, 90), large));
}

static void test_a_seam_one_pixel_wide_is_too_far(void **state)
{
	struct picture upright = gray(480, 640, 90);
	struct picture flat = gray(480, 640, 90);

	(void)state;
	fill_area(&upright, 100, 200, 1, 30, 110);
	assert_false(is_near(gray(480, 640, 90), upright));
	fill_area(&flat, 100, 200, 30, 1, 110);
	assert_false(is_near(flat, gray(480, 640, 90)));
}

static void test_a_wrong_patch_is_too_far(void **state)
{
	(void)state;
	for (int at = 0; at < 16; at++) {
		struct picture picture = gray(480, 640, 90);

		fill(&picture, 100 + at, 200 + at, 8, 110);
		assert_false(is_near(gray(480, 640, 90), picture));
	}
}

static void test_an_edge_may_be_off_by_a_pixel(void **state)
{
	struct picture a = gray(480, 640, 90);
	struct picture b = gray(480, 640, 90);

	(void)state;
	fill_area(&a, 0, 0, 300, 100, 130);
	fill_area(&b, 0, 0, 301, 100, 130);
	assert_true(is_near(a, b));
}

static void test_the_measures_are_exact(void **state)
{
	struct picture a = gray(32, 32, 100);
	struct picture b = gray(32, 32, 100);
	struct picture_difference difference;

	(void)state;
	fill(&b, 16, 0, 8, 132);
	difference = picture_compare(&a, &b, 8);
	assert_true(difference.same_size);
	assert_int_equal(difference.worst, 32);
	assert_near(difference.far_percent, 6.25, 1e-9);
	assert_near(difference.mean, 2, 1e-9);
	assert_near(difference.block_mean, 8, 1e-9);
	assert_int_equal(difference.block_x, 16);
	assert_int_equal(difference.block_y, 0);
	assert_int_equal(difference.block_strays, 64);
	assert_int_equal(difference.stray_x, 8);
	assert_int_equal(difference.stray_y, 0);
	picture_release(&a);
	picture_release(&b);
}

static void test_the_difference_is_shown_beside_both(void **state)
{
	struct picture a = gray(2, 1, 100);
	struct picture b = gray(2, 1, 110);
	struct picture shown = picture_show_difference(&a, &b);

	(void)state;
	assert_int_equal(shown.width, 6);
	assert_int_equal(shown.height, 1);
	assert_int_equal(shown.rgb[0], 100);
	assert_int_equal(shown.rgb[3 * 2], 110);
	assert_int_equal(shown.rgb[3 * 4], 80);
	picture_release(&a);
	picture_release(&b);
	picture_release(&shown);
}

static void test_png_files_keep_every_pixel(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "a.png");
	struct picture a = gray(5, 3, 0);
	struct picture b;

	(void)state;
	for (int i = 0; i < 45; i++) {
		a.rgb[i] = (uint8_t)(5 * i);
	}
	assert_int_equal(picture_write(file.text, &a), 0);
	assert_int_equal(picture_read(file.text, &b), 0);
	assert_int_equal(b.width, 5);
	assert_int_equal(b.height, 3);
	assert_memory_equal(a.rgb, b.rgb, 45);
	picture_release(&a);
	picture_release(&b);
	file_write(file.text, "no", 2);
	assert_int_equal(picture_read(file.text, &b), -1);
	assert_null(b.rgb);
	temp_dir_remove(&folder);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_picture_equals_itself),
		cmocka_unit_test(test_other_sizes_are_never_near),
		cmocka_unit_test(test_a_small_shift_everywhere_is_too_far),
		cmocka_unit_test(test_single_pixels_are_forgiven),
		cmocka_unit_test(test_too_many_far_pixels_are_too_far),
		cmocka_unit_test(test_a_missing_small_part_is_too_far),
		cmocka_unit_test(test_a_seam_one_pixel_wide_is_too_far),
		cmocka_unit_test(test_a_wrong_patch_is_too_far),
		cmocka_unit_test(test_an_edge_may_be_off_by_a_pixel),
		cmocka_unit_test(test_the_measures_are_exact),
		cmocka_unit_test(test_the_difference_is_shown_beside_both),
		cmocka_unit_test(test_png_files_keep_every_pixel),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
