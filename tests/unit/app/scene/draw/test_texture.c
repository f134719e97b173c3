/* What a GL gets of a model's images: sides, texels, levels, formats. */
#include "app/scene/draw/texture.h"
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	LEVELS_MAX = 12,
	BYTES_MAX = 4096
};

struct level {
	int width, height;
	GLenum format, type;
	uint8_t data[BYTES_MAX];
};

/* GL's calls carry no context argument. */
static struct {
	int level_count;
	struct level level[LEVELS_MAX];
	GLfixed magnify, minify, wrap_s, wrap_t;
	GLenum error;
	int deleted, named;
	GLuint bound;
	GLfixed scale[2];
} sent;

static size_t texel_bytes(GLenum format, GLenum type)
{
	return type != GL_UNSIGNED_BYTE ? 2 : format == GL_LUMINANCE ? 1 : 4;
}

static void tex_image(GLenum target, GLint number, GLint internal,
	GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
	const void *data)
{
	struct level *level = &sent.level[number];
	size_t bytes =
		(size_t)width * (size_t)height * texel_bytes(format, type);

	assert_int_equal(target, GL_TEXTURE_2D);
	assert_int_equal(number, sent.level_count);
	assert_int_equal(internal, format);
	assert_int_equal(border, 0);
	sent.level_count++;
	level->width = width;
	level->height = height;
	level->format = format;
	level->type = type;
	memcpy(level->data, data, bytes < BYTES_MAX ? bytes : BYTES_MAX);
}

static void tex_parameter(GLenum target, GLenum name, GLfixed value)
{
	(void)target;
	*(name == GL_TEXTURE_MAG_FILTER                 ? &sent.magnify
			: name == GL_TEXTURE_MIN_FILTER ? &sent.minify
			: name == GL_TEXTURE_WRAP_S     ? &sent.wrap_s
							: &sent.wrap_t) = value;
}

static void gen_textures(GLsizei count, GLuint *textures)
{
	for (int i = 0; i < count; i++) {
		textures[i] = (GLuint)(70 + sent.named++);
	}
	sent.level_count = 0;
}

static void delete_textures(GLsizei count, const GLuint *textures)
{
	(void)textures;
	sent.deleted += count;
}

static void bind_texture(GLenum target, GLuint texture)
{
	assert_int_equal(target, GL_TEXTURE_2D);
	sent.bound = texture;
}

static void scale(GLfixed x, GLfixed y, GLfixed z)
{
	assert_int_equal(z, FX16_ONE);
	sent.scale[0] = x;
	sent.scale[1] = y;
}

static GLenum get_error(void)
{
	GLenum error = sent.error;

	sent.error = GL_NO_ERROR;
	return error;
}

static struct gl begin(void)
{
	struct gl gl = gl_recorder_begin();

	memset(&sent, 0, sizeof(sent));
	gl.TexImage2D = tex_image;
	gl.TexParameterx = tex_parameter;
	gl.GenTextures = gen_textures;
	gl.DeleteTextures = delete_textures;
	gl.BindTexture = bind_texture;
	gl.Scalex = scale;
	gl.GetError = get_error;
	return gl;
}

/* An image of arbitrary texels, which the caller frees. */
static struct model_image make_image(int width, int height, bool opaque)
{
	struct model_image image = {.name = "image",
		.width = width,
		.height = height,
		.opaque = opaque,
		.rgba = malloc((size_t)width * (size_t)height * 4)};
	uint32_t chance = 12345;

	assert_non_null(image.rgba);
	for (int i = 0; i < 4 * width * height; i++) {
		chance = chance * 1664525u + 1013904223u;
		image.rgba[i] =
			opaque && i % 4 == 3 ? 255 : (uint8_t)(chance >> 24);
	}
	return image;
}

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
		struct model_image image = make_image(sides[i][0], 1, true);
		struct gl gl = begin();

		assert_int_equal(
			texture_upload(&gl, &image, &plain, PIXELS_RGBA8888),
			70);
		assert_int_equal(sent.level_count, 1);
		assert_int_equal(sent.level[0].width, sides[i][1]);
		assert_int_equal(sent.level[0].height, 1);
		image.width = 1;
		image.height = sides[i][0];
		texture_upload(&gl, &image, &mirrored, PIXELS_RGBA8888);
		assert_int_equal(sent.level[0].width, 1);
		assert_int_equal(sent.level[0].height, 2 * sides[i][1]);
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
		struct model_image image = make_image(side, 1, false);
		struct gl gl = begin();

		texture_upload(&gl, &image, &plain, PIXELS_RGBA8888);
		assert_int_equal(sent.level[0].width, to);
		for (int k = 0; k < side; k++) {
			int middle = (2 * k + 1) * to / (2 * side);
			const uint8_t *from = image.rgba + 4 * k;
			const uint8_t *got = sent.level[0].data + 4 * middle;

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
	struct model_image image = make_image(3, 5, false);
	struct gl gl = begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(sent.level[0].width, 32);
	assert_int_equal(sent.level[0].height, 32);
	for (int i = 0; i < 32 * 32; i++) {
		int x = i % 32 < 16 ? i % 32 : 31 - i % 32, y = i / 32;
		int from = (2 * y + 1) * 5 / 64 * 3 + (2 * x + 1) * 3 / 32;

		assert_memory_equal(sent.level[0].data + 4 * i,
			image.rgba + (size_t)from * 4, 4);
	}
	free(image.rgba);
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
	struct model_image image = make_image(width, height, false);
	struct gl gl = begin();
	const struct level *level = &sent.level[0];

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
			make_image(sides[i][0], sides[i][1], false);
		struct gl gl = begin();
		int longest =
			sides[i][0] > sides[i][1] ? sides[i][0] : sides[i][1];

		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
		assert_int_equal(1 << (sent.level_count - 1), longest);
		for (int l = 1; l < sent.level_count; l++) {
			const struct level *from = &sent.level[l - 1];
			const struct level *to = &sent.level[l];

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

/* A texel of 16 bits. */
static unsigned int short_at(int texel)
{
	uint16_t value;

	memcpy(&value, sent.level[0].data + 2 * texel, sizeof(value));
	return value;
}

static void test_formats_suit_the_image_and_the_target(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	uint8_t rgba[2][4] = {
		{0xff, 0x82, 0x18, 0xff}, {0x08, 0x04, 0xf8, 0xff}};
	struct model_image image = {
		.width = 2, .height = 1, .opaque = true, .rgba = rgba[0]};
	struct gl gl = begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(sent.level[0].format, GL_RGB);
	assert_int_equal(sent.level[0].type, GL_UNSIGNED_SHORT_5_6_5);
	assert_int_equal(short_at(0), 31 << 11 | 32 << 5 | 3);
	assert_int_equal(short_at(1), 1 << 11 | 1 << 5 | 31);
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(sent.level[0].format, GL_RGBA);
	assert_int_equal(sent.level[0].type, GL_UNSIGNED_BYTE);
	assert_memory_equal(sent.level[0].data, rgba, sizeof(rgba));
	image.opaque = false;
	rgba[1][3] = 0x7f;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(sent.level[0].format, GL_RGBA);
	assert_int_equal(sent.level[0].type, GL_UNSIGNED_SHORT_4_4_4_4);
	assert_int_equal(short_at(0), 0xf81f);
	assert_int_equal(short_at(1), 0x00f7);
}

static void test_opaque_grays_take_a_byte(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	uint8_t rgba[2][4] = {{9, 9, 9, 255}, {200, 200, 200, 255}};
	struct model_image image = {
		.width = 2, .height = 1, .opaque = true, .rgba = rgba[0]};
	struct gl gl = begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(sent.level[0].format, GL_LUMINANCE);
	assert_int_equal(sent.level[0].data[0], 9);
	assert_int_equal(sent.level[0].data[1], 200);
	image.opaque = false;
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(sent.level[0].format, GL_RGBA);
	image.opaque = true;
	for (int i = 0; i < 3; i++) {
		rgba[1][i] = 201;
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
		assert_int_equal(sent.level[0].format, GL_RGBA);
		rgba[1][i] = 200;
	}
}

static void test_filters_and_wrap_modes_are_the_models(void **state)
{
	struct model_image image = make_image(2, 2, true);
	struct gl gl = begin();

	(void)state;
	texture_upload(&gl, &image,
		&(struct model_texture){.wrap_s = MODEL_CLAMP, .nearest = true},
		PIXELS_RGBA8888);
	assert_int_equal(sent.magnify, GL_NEAREST);
	assert_int_equal(sent.minify, GL_NEAREST);
	assert_int_equal(sent.wrap_s, GL_CLAMP_TO_EDGE);
	assert_int_equal(sent.wrap_t, GL_REPEAT);
	texture_upload(&gl, &image,
		&(struct model_texture){.wrap_s = MODEL_MIRROR,
			.wrap_t = MODEL_CLAMP,
			.mipmap = true},
		PIXELS_RGBA8888);
	assert_int_equal(sent.magnify, GL_LINEAR);
	assert_int_equal(sent.minify, GL_LINEAR_MIPMAP_NEAREST);
	assert_int_equal(sent.wrap_s, GL_REPEAT);
	assert_int_equal(sent.wrap_t, GL_CLAMP_TO_EDGE);
	free(image.rgba);
}

static void test_a_gl_without_memory_is_noticed(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	struct model_image image = make_image(2, 2, true);
	struct gl gl = begin();

	(void)state;
	sent.error = GL_OUT_OF_MEMORY;
	assert_int_equal(
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888), 0);
	assert_int_equal(sent.deleted, 1);
	sent.error = GL_INVALID_VALUE;
	assert_int_equal(
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888), 71);
	assert_int_equal(sent.deleted, 1);
	free(image.rgba);
}

/* Twice the texels' bytes, and a third more for levels. */
static void test_textures_take_their_bytes_from_the_budget(void **state)
{
	struct model_image image = make_image(16, 4, true);
	const struct model_texture textures[] = {{.wrap_s = MODEL_REPEAT},
		{.wrap_t = MODEL_MIRROR, .mipmap = true}};
	struct memory_budget budget = {.limit_bytes = 100000};
	const struct model model = {.path = "m",
		.image_count = 1,
		.image = &image,
		.texture_count = 2,
		.texture = (struct model_texture *)textures,
		.budget = &budget};
	const size_t bytes = 16 * 4 * 4 + 16 * 8 * 4 + 16 * 8 * 4 / 3;
	const size_t wide = 16 * 4 * 8 + 16 * 8 * 8 + 16 * 8 * 8 / 3;
	struct gl gl = begin();
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct texture_set set;

	(void)state;
	assert_int_equal(
		texture_set_create(&set, &model, &gl, PIXELS_RGB565, &log), 0);
	assert_int_equal(set.count, 2);
	assert_int_equal(set.name[1], 71);
	assert_int_equal(set.taken_bytes, bytes);
	texture_bind(&set, &gl, 1);
	assert_int_equal(sent.bound, 71);
	assert_int_equal(sent.scale[0], FX16_ONE);
	assert_int_equal(sent.scale[1], FX16_ONE / 2);
	texture_set_destroy(&set, &gl);
	assert_int_equal(sent.deleted, 2);
	assert_int_equal(budget.used_bytes, 0);
	assert_int_equal(
		texture_set_create(&set, &model, &gl, PIXELS_RGBA8888, &log), 0);
	assert_int_equal(set.taken_bytes, wide);
	texture_set_destroy(&set, &gl);
	budget.limit_bytes = wide - 1;
	assert_int_equal(
		texture_set_create(&set, &model, &gl, PIXELS_RGBA8888, &log),
		-ENOMEM);
	assert_int_equal(logged.count, 1);
	assert_int_equal(budget.used_bytes, 0);
	free(image.rgba);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_sides_become_the_nearest_power_of_two),
		cmocka_unit_test(test_small_sides_become_several_times_as_long),
		cmocka_unit_test(test_nearest_texels_are_not_interpolated),
		cmocka_unit_test(test_other_sides_are_interpolated),
		cmocka_unit_test(test_a_mirrored_image_is_stored_twice),
		cmocka_unit_test(test_each_level_has_the_means_of_the_one_before),
		cmocka_unit_test(test_formats_suit_the_image_and_the_target),
		cmocka_unit_test(test_opaque_grays_take_a_byte),
		cmocka_unit_test(test_filters_and_wrap_modes_are_the_models),
		cmocka_unit_test(test_a_gl_without_memory_is_noticed),
		cmocka_unit_test(test_textures_take_their_bytes_from_the_budget),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
