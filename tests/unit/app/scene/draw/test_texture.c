/* The texels that a GL gets of a model's images: sides, interpolation, levels. */
#include "app/scene/draw/texture.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/texture_sent.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void test_sides_become_the_nearest_power_of_two(void **state)
{
	static const int sides[][2] = {{1, 1}, {2, 2}, {4, 4}, {8, 8}, {16, 16},
		{32, 32}, {64, 64}, {65, 64}, {95, 64}, {96, 128}, {100, 128},
		{300, 256}, {383, 256}, {384, 512}, {400, 512}, {767, 512},
		{768, 1024}, {1000, 1024}, {1024, 1024}, {1025, 1024},
		{1600, 1024}, {4096, 1024}};
	const struct model_texture plain = {.wrap_s = MODEL_REPEAT};
	const struct model_texture mirrored = {.wrap_t = MODEL_MIRROR};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		struct model_image image =
			texture_sent_image(sides[i][0], 1, true);
		struct gl gl = texture_sent_begin();

		assert_int_equal(
			texture_upload(&gl, &image, &plain, PIXELS_RGBA8888),
			70);
		assert_int_equal(texture_sent.level_count, 1);
		assert_int_equal(texture_sent.level[0].width, sides[i][1]);
		assert_int_equal(texture_sent.level[0].height, 1);
		image.width = 1;
		image.height = sides[i][0];
		texture_upload(&gl, &image, &mirrored, PIXELS_RGBA8888);
		assert_int_equal(texture_sent.level[0].width, 1);
		/* Twice as long, but no longer than a GL has to accept. */
		assert_int_equal(texture_sent.level[0].height,
			sides[i][1] < 1024 ? 2 * sides[i][1] : 1024);
		free(image.rgba);
	}
}

/* Each texel of a small image keeps its colour in its middle. */
static void test_small_sides_become_several_times_as_long(void **state)
{
	static const int sides[][2] = {{3, 16}, {5, 32}, {7, 32}, {9, 64},
		{17, 128}, {33, 128}, {63, 128}};
	const struct model_texture plain = {.wrap_s = MODEL_REPEAT};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		int side = sides[i][0], to = sides[i][1];
		struct model_image image = texture_sent_image(side, 1, false);
		struct gl gl = texture_sent_begin();

		texture_upload(&gl, &image, &plain, PIXELS_RGBA8888);
		assert_int_equal(texture_sent.level[0].width, to);
		for (int k = 0; k < side; k++) {
			int middle = (2 * k + 1) * to / (2 * side);
			const uint8_t *from = image.rgba + 4 * k;
			const uint8_t *got =
				texture_sent.level[0].data + 4 * middle;

			/* A quarter of a texel away where there are 4, 1/4 of 255. */
			assert_in_range(abs(from[0] - got[0]), 0, 66);
		}
		free(image.rgba);
	}
}

/* A model that asks for the nearest texel gets none in between. */
static void test_nearest_texels_are_not_interpolated(void **state)
{
	const struct model_texture sampling = {
		.wrap_s = MODEL_MIRROR, .nearest = true};
	struct model_image image = texture_sent_image(3, 5, false);
	struct gl gl = texture_sent_begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(texture_sent.level[0].width, 32);
	assert_int_equal(texture_sent.level[0].height, 32);
	for (int i = 0; i < 32 * 32; i++) {
		int x = i % 32 < 16 ? i % 32 : 31 - i % 32, y = i / 32;
		int from = (2 * y + 1) * 5 / 64 * 3 + (2 * x + 1) * 3 / 32;

		assert_memory_equal(texture_sent.level[0].data + 4 * i,
			image.rgba + (size_t)from * 4, 4);
	}
	free(image.rgba);
}

/* At each width, and where a centre is close to the edge of two columns. */
static void test_the_column_of_a_texels_centre_is_the_nearest(void **state)
{
	const struct model_texture sampling = {.nearest = true};
	struct gl gl = texture_sent_begin();

	(void)state;
	for (int width = 3; width < 1024; width += 17) {
		struct model_image image = texture_sent_image(width, 1, false);
		int side;

		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
		side = texture_sent.level[0].width;
		for (int x = 0; x < side; x++) {
			size_t from = (size_t)((2 * x + 1) * width / 2 / side);

			assert_memory_equal(texture_sent.level[0].data + 4 * x,
				image.rgba + 4 * from, 4);
		}
		free(image.rgba);
	}
}

/* The image at a texel's centre, interpolated linearly; edges go on. */
static double interpolated(
	const struct model_image *image, double x, double y, int channel)
{
	double sum = 0.0;

	x = fmin(fmax(x, 0.0), image->width - 1);
	y = fmin(fmax(y, 0.0), image->height - 1);
	for (int row = 0; row < image->height; row++) {
		for (int column = 0; column < image->width; column++) {
			sum += fmax(1.0 - fabs(column - x), 0.0) *
				fmax(1.0 - fabs(row - y), 0.0) *
				image->rgba[4 * (row * image->width + column) +
					channel];
		}
	}
	return sum;
}

/* Where a texel's centre is in the image, in whole 256ths of its texels. */
static double place_of(int texel, int side, int to_side)
{
	return floor((texel + 0.5) * side / to_side * 256.0) / 256.0 - 0.5;
}

static void expect_resampled(int width, int height, int to_width, int to_height,
	enum model_wrap wrap_s, enum model_wrap wrap_t)
{
	const struct model_texture sampling = {
		.wrap_s = wrap_s, .wrap_t = wrap_t};
	struct model_image image = texture_sent_image(width, height, false);
	struct gl gl = texture_sent_begin();
	const struct texture_sent_level *level = &texture_sent.level[0];

	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(level->width, to_width << (wrap_s == MODEL_MIRROR));
	assert_int_equal(level->height, to_height << (wrap_t == MODEL_MIRROR));
	for (int i = 0; i < 4 * level->width * level->height; i++) {
		int x = i / 4 % level->width, y = i / 4 / level->width;

		x = x < to_width ? x : 2 * to_width - 1 - x;
		y = y < to_height ? y : 2 * to_height - 1 - y;
		assert_near(level->data[i],
			interpolated(&image, place_of(x, width, to_width),
				place_of(y, height, to_height), i % 4),
			0.501);
	}
	free(image.rgba);
}

static void test_other_sides_are_interpolated(void **state)
{
	(void)state;
	expect_resampled(3, 5, 16, 32, MODEL_REPEAT, MODEL_CLAMP);
	expect_resampled(5, 3, 32, 16, MODEL_CLAMP, MODEL_REPEAT);
	expect_resampled(80, 4, 64, 4, MODEL_REPEAT, MODEL_REPEAT);
	expect_resampled(2, 100, 2, 128, MODEL_REPEAT, MODEL_REPEAT);
	expect_resampled(8, 4, 8, 4, MODEL_REPEAT, MODEL_REPEAT);
	expect_resampled(8, 3, 8, 16, MODEL_REPEAT, MODEL_REPEAT);
}

static void test_a_mirrored_image_is_stored_twice(void **state)
{
	(void)state;
	expect_resampled(3, 5, 16, 32, MODEL_MIRROR, MODEL_CLAMP);
	expect_resampled(3, 5, 16, 32, MODEL_REPEAT, MODEL_MIRROR);
	expect_resampled(4, 2, 4, 2, MODEL_MIRROR, MODEL_MIRROR);
	expect_resampled(1, 1, 1, 1, MODEL_MIRROR, MODEL_MIRROR);
}

static void test_each_level_has_the_means_of_the_one_before(void **state)
{
	static const int sides[][2] = {{8, 8}, {4, 4}, {8, 2}, {1, 4}, {16, 1}};
	const struct model_texture sampling = {.mipmap = true};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		struct model_image image =
			texture_sent_image(sides[i][0], sides[i][1], false);
		struct gl gl = texture_sent_begin();
		int longest =
			sides[i][0] > sides[i][1] ? sides[i][0] : sides[i][1];

		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
		assert_int_equal(1 << (texture_sent.level_count - 1), longest);
		for (int l = 1; l < texture_sent.level_count; l++) {
			const struct texture_sent_level *from =
				&texture_sent.level[l - 1];
			const struct texture_sent_level *to =
				&texture_sent.level[l];

			assert_int_equal(to->width,
				from->width > 1 ? from->width / 2 : 1);
			assert_int_equal(to->height,
				from->height > 1 ? from->height / 2 : 1);
			for (int t = 0; t < 4 * to->width * to->height; t++) {
				int x = t / 4 % to->width;
				int y = t / 4 / to->width;
				double sum = 0.0;

				for (int k = 0; k < 4; k++) {
					int fx = from->width > 1 ? 2 * x + k % 2
								 : 0;
					int fy = from->height > 1 ? 2 * y + k / 2
								  : 0;

					sum += from->data[4 *
							(fy * from->width + fx) +
						t % 4];
				}
				assert_near(to->data[t], sum / 4.0, 0.5);
			}
		}
		free(image.rgba);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_sides_become_the_nearest_power_of_two),
		cmocka_unit_test(test_small_sides_become_several_times_as_long),
		cmocka_unit_test(test_nearest_texels_are_not_interpolated),
		cmocka_unit_test(
			test_the_column_of_a_texels_centre_is_the_nearest),
		cmocka_unit_test(test_other_sides_are_interpolated),
		cmocka_unit_test(test_a_mirrored_image_is_stored_twice),
		cmocka_unit_test(test_each_level_has_the_means_of_the_one_before),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
