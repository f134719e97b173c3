/* How a GL keeps a model's images: formats, filters, wrap modes, memory. */
#include "app/scene/draw/texture.h"
#include "platform/base/fixed.h"
#include "tests/support/gl/texture_sent.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* A texel of 16 bits. */
static unsigned int short_at(int texel)
{
	uint16_t value;

	memcpy(&value, texture_sent.level[0].data + 2 * texel, sizeof(value));
	return value;
}

static void test_formats_suit_the_image_and_the_target(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	uint8_t rgba[2][4] = {
		{0xff, 0x82, 0x18, 0xff}, {0x08, 0x04, 0xf8, 0xff}};
	struct model_image image = {
		.width = 2, .height = 1, .opaque = true, .rgba = rgba[0]};
	struct gl gl = texture_sent_begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(texture_sent.level[0].format, GL_RGB);
	assert_int_equal(texture_sent.level[0].type, GL_UNSIGNED_SHORT_5_6_5);
	assert_int_equal(short_at(0), 31 << 11 | 32 << 5 | 3);
	assert_int_equal(short_at(1), 1 << 11 | 1 << 5 | 31);
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(texture_sent.level[0].format, GL_RGBA);
	assert_int_equal(texture_sent.level[0].type, GL_UNSIGNED_BYTE);
	assert_memory_equal(texture_sent.level[0].data, rgba, sizeof(rgba));
	image.opaque = false;
	rgba[1][3] = 0x7f;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(texture_sent.level[0].format, GL_RGBA);
	assert_int_equal(texture_sent.level[0].type, GL_UNSIGNED_SHORT_4_4_4_4);
	assert_int_equal(short_at(0), 0xf81f);
	assert_int_equal(short_at(1), 0x00f7);
}

static void test_opaque_grays_take_a_byte(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	uint8_t rgba[2][4] = {{9, 9, 9, 255}, {200, 200, 200, 255}};
	struct model_image image = {
		.width = 2, .height = 1, .opaque = true, .rgba = rgba[0]};
	struct gl gl = texture_sent_begin();

	(void)state;
	texture_upload(&gl, &image, &sampling, PIXELS_RGB565);
	assert_int_equal(texture_sent.level[0].format, GL_LUMINANCE);
	assert_int_equal(texture_sent.level[0].data[0], 9);
	assert_int_equal(texture_sent.level[0].data[1], 200);
	image.opaque = false;
	texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
	assert_int_equal(texture_sent.level[0].format, GL_RGBA);
	image.opaque = true;
	for (int i = 0; i < 3; i++) {
		rgba[1][i] = 201;
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888);
		assert_int_equal(texture_sent.level[0].format, GL_RGBA);
		rgba[1][i] = 200;
	}
}

static void test_filters_and_wrap_modes_are_the_models(void **state)
{
	struct model_image image = texture_sent_image(2, 2, true);
	struct gl gl = texture_sent_begin();

	(void)state;
	texture_upload(&gl, &image,
		&(struct model_texture){.wrap_s = MODEL_CLAMP, .nearest = true},
		PIXELS_RGBA8888);
	assert_int_equal(texture_sent.magnify, GL_NEAREST);
	assert_int_equal(texture_sent.minify, GL_NEAREST);
	assert_int_equal(texture_sent.wrap_s, GL_CLAMP_TO_EDGE);
	assert_int_equal(texture_sent.wrap_t, GL_REPEAT);
	texture_upload(&gl, &image,
		&(struct model_texture){.wrap_s = MODEL_MIRROR,
			.wrap_t = MODEL_CLAMP,
			.mipmap = true},
		PIXELS_RGBA8888);
	assert_int_equal(texture_sent.magnify, GL_LINEAR);
	assert_int_equal(texture_sent.minify, GL_LINEAR_MIPMAP_NEAREST);
	assert_int_equal(texture_sent.wrap_s, GL_REPEAT);
	assert_int_equal(texture_sent.wrap_t, GL_CLAMP_TO_EDGE);
	free(image.rgba);
}

static void test_a_gl_without_memory_is_noticed(void **state)
{
	const struct model_texture sampling = {.wrap_s = MODEL_REPEAT};
	struct model_image image = texture_sent_image(2, 2, true);
	struct gl gl = texture_sent_begin();

	(void)state;
	texture_sent.error = GL_OUT_OF_MEMORY;
	assert_int_equal(
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888), 0);
	assert_int_equal(texture_sent.deleted, 1);
	texture_sent.error = GL_INVALID_VALUE;
	assert_int_equal(
		texture_upload(&gl, &image, &sampling, PIXELS_RGBA8888), 71);
	assert_int_equal(texture_sent.deleted, 1);
	free(image.rgba);
}

/* Twice the texels' bytes, and a third more for levels. */
static void test_textures_take_their_bytes_from_the_budget(void **state)
{
	struct model_image image = texture_sent_image(16, 4, true);
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
	struct gl gl = texture_sent_begin();
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
	assert_int_equal(texture_sent.bound, 71);
	assert_int_equal(texture_sent.scale[0], FX16_ONE);
	assert_int_equal(texture_sent.scale[1], FX16_ONE / 2);
	texture_set_destroy(&set, &gl);
	assert_int_equal(texture_sent.deleted, 2);
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

/* Of two black texels, what GL gets of the texture for the material's use. */
static int sent_of_black(const struct model_material *material, int count)
{
	uint8_t rgba[2][4] = {{0, 0, 0, 255}, {0, 0, 0, 255}};
	struct model_image image = {
		.width = 2, .height = 1, .opaque = true, .rgba = rgba[0]};
	struct model_texture texture = {.wrap_s = MODEL_REPEAT};
	const struct model model = {.path = "m",
		.image_count = 1,
		.image = &image,
		.texture_count = 1,
		.texture = &texture,
		.material_count = count,
		.material = (struct model_material *)material};
	struct gl gl = texture_sent_begin();
	struct log log = log_to_nowhere();
	struct texture_set set;

	assert_int_equal(
		texture_set_create(&set, &model, &gl, PIXELS_RGB565, &log), 0);
	texture_set_destroy(&set, &gl);
	assert_int_equal(texture_sent.level[0].format, GL_LUMINANCE);
	return texture_sent.level[0].data[1];
}

static void test_textures_mirror_where_all_that_show_them_are_lit(void **state)
{
	struct model_material m[2];

	(void)state;
	m[0] = m[1] = model_plain_material;
	assert_int_equal(sent_of_black(m, 1), 0);
	m[0].texture = m[1].texture = 0;
	assert_int_equal(sent_of_black(m, 2), 56);
	m[1].unlit = true;
	assert_int_equal(sent_of_black(m, 2), 0);
	m[1] = model_plain_material;
	m[1].emissive_texture = 0;
	assert_int_equal(sent_of_black(m, 2), 0);
	m[1] = model_plain_material;
	m[1].normal_texture = 0;
	assert_int_equal(sent_of_black(m, 2), 0);
	m[1].normal_texture = -1;
	assert_int_equal(sent_of_black(m, 2), 56);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_formats_suit_the_image_and_the_target),
		cmocka_unit_test(test_opaque_grays_take_a_byte),
		cmocka_unit_test(test_filters_and_wrap_modes_are_the_models),
		cmocka_unit_test(test_a_gl_without_memory_is_noticed),
		cmocka_unit_test(
			test_textures_mirror_where_all_that_show_them_are_lit),
		cmocka_unit_test(test_textures_take_their_bytes_from_the_budget),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
