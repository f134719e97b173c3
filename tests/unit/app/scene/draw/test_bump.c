#include "app/scene/draw/bump.h"
#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/small_model.h"

#include <stdlib.h>
#include <string.h>

/* Left half tilted towards -X, right half towards +X, by 45 degrees. */
static const uint8_t ridge_map[2][4] = {
	{37, 128, 218, 255}, {218, 128, 218, 255}};

static void light_from(struct instance *instance, float x, float y, float z)
{
	instance->towards_light[0] = x;
	instance->towards_light[1] = y;
	instance->towards_light[2] = z;
	instance_update(instance);
}

static void assert_texel(const uint8_t actual[4], int r, int g, int b)
{
	assert_int_equal(actual[0], r);
	assert_int_equal(actual[1], g);
	assert_int_equal(actual[2], b);
	assert_int_equal(actual[3], 255);
}

static void test_encodes_the_light_in_the_vertexs_frame(void **state)
{
	static const float x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
	static const float minus_x[3] = {-1, 0, 0};
	static const float slanted[3] = {0.6f, 0, 0.8f};
	uint8_t out[4];

	(void)state;
	bump_encode(z, x, y, z, out);
	assert_texel(out, 128, 128, 255);
	bump_encode(x, x, y, z, out);
	assert_texel(out, 255, 128, 128);
	bump_encode(minus_x, x, y, z, out);
	assert_texel(out, 0, 128, 128);
	/* 127.5 + 127.5 * 0.6 = 204, 127.5 + 127.5 * 0.8 = 229.5 */
	bump_encode(slanted, x, y, z, out);
	assert_texel(out, 204, 128, 230);
	/* Tangent y, bitangent z, normal x. */
	bump_encode(slanted, y, z, x, out);
	assert_texel(out, 128, 230, 204);
}

static void test_fades_the_light_on_the_side_away_from_it(void **state)
{
	static const float x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
	static const float below[3] = {0.99f, 0, -0.1428572f};
	static const float half_way[3] = {0.99745f, 0, -0.0714286f};
	uint8_t out[4];

	(void)state;
	bump_encode(below, x, y, z, out);
	assert_texel(out, 128, 128, 128);
	/* 128 + 127.5 * 0.5 * 0.99745 = 191.6, 128 - 127.5 / 28 = 123.4 */
	bump_encode(half_way, x, y, z, out);
	assert_texel(out, 191, 128, 123);
}

static void test_rigid_meshes_are_lit_as_their_node_stands(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct transform *local;
	struct instance *instance;
	const uint8_t(*light)[4];

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	instance = small_model_instance(model);
	local = &instance->pose.local[0];
	light = (const uint8_t(*)[4])instance->drawable[0].light;
	light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 204, 128, 230);
	light_from(instance, -0.6f, 0, 0.8f);
	assert_texel(light[0], 51, 128, 230);
	/* Turned to face +X: what shines along +X now shines on it. */
	local->rotation[1] = local->rotation[3] = 0.70710678f;
	light_from(instance, 1, 0, 0);
	assert_texel(light[3], 128, 128, 255);
	/* Mirrored, its tangent runs along -X. */
	local->rotation[1] = 0;
	local->rotation[3] = 1;
	local->scale[0] = -1;
	light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 51, 128, 230);
	local->scale[0] = local->scale[1] = local->scale[2] = 1e-4f;
	light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 204, 128, 230);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_the_attributes_sign_turns_the_bitangent(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance;
	const uint8_t(*light)[4];

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	model->mesh[0].primitive[0].tangent[1][3] = -1;
	instance = small_model_instance(model);
	light = (const uint8_t(*)[4])instance->drawable[0].light;
	light_from(instance, 0, 0.6f, 0.8f);
	assert_texel(light[0], 128, 204, 230);
	assert_texel(light[1], 128, 51, 230);
	instance_destroy(instance);
	model_destroy(model);
}

/* Of an instance whose model has one thing changed. */
static bool has_relief(void (*change)(struct model *model))
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance;
	bool has;

	small_model_add_normal_map(model, 1, small_model_flat_map);
	change(model);
	instance = small_model_instance(model);
	has = instance->drawable[0].tangent;
	instance_destroy(instance);
	model_destroy(model);
	return has;
}

static void change_nothing(struct model *model)
{
	(void)model;
}

static void drop_map(struct model *model)
{
	model->material[0].normal_texture = -1;
}

static void blend(struct model *model)
{
	model->material[0].alpha = MODEL_BLEND;
}

static void unlight(struct model *model)
{
	model->material[0].unlit = true;
}

static void drop_texcoords(struct model *model)
{
	model->mesh[0].primitive[0].texcoord = NULL;
}

static void drop_tangents(struct model *model)
{
	model->mesh[0].primitive[0].tangent = NULL;
}

static void drop_normals(struct model *model)
{
	model->mesh[0].primitive[0].normal = NULL;
}

static void test_only_what_can_show_relief_has_it(void **state)
{
	(void)state;
	assert_true(has_relief(change_nothing));
	assert_false(has_relief(drop_map));
	assert_false(has_relief(blend));
	assert_false(has_relief(unlight));
	assert_false(has_relief(drop_texcoords));
	assert_false(has_relief(drop_tangents));
	assert_false(has_relief(drop_normals));
}

static void test_gathered_batches_are_lit_plainly(void **state)
{
	/* 300 x 300 quads: 90,601 vertices, too many for 16-bit indices. */
	struct model *model = small_model_grid(300, 300, 1.0f, true);
	struct instance *instance;

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	instance = small_model_instance(model);
	assert_null(instance->drawable[0].tangent);
	instance_destroy(instance);
	model_destroy(model);
}

/* GL without combiner; GL's calls carry no context. */
static GLenum pending_error;
static GLint environment_mode;

static GLenum tell_error(void)
{
	GLenum error = pending_error;

	pending_error = GL_NO_ERROR;
	return error;
}

static void refuse_combiner(GLenum target, GLenum name, GLfixed value)
{
	(void)target;
	if (name != GL_TEXTURE_ENV_MODE || value == GL_COMBINE) {
		pending_error = GL_INVALID_ENUM;
	} else {
		environment_mode = value;
	}
}

static void accept_combiner(GLenum target, GLenum name, GLfixed value)
{
	(void)target;
	if (name == GL_TEXTURE_ENV_MODE) {
		environment_mode = value;
	}
}

static int draws_of(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, enum draw_pass pass)
{
	gl_recorder_clear();
	draw_instance(gl, instance, textures, pass);
	return gl_recorder_result()->draw_count;
}

static void test_a_driver_without_combiner_gets_one_sentence(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct texture_set textures;
	struct instance *instance;

	(void)state;
	gl.GetError = tell_error;
	gl.TexEnvx = refuse_combiner;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	instance = small_model_instance(model);
	pending_error = GL_NO_ERROR;
	assert_int_equal(
		texture_set_create(&textures, model, &gl, PIXELS_RGBA8888, &log),
		0);
	assert_false(textures.normal_mapping);
	assert_int_equal(pending_error, GL_NO_ERROR);
	assert_int_equal(environment_mode, GL_MODULATE);
	for (int frame = 0; frame < 3; frame++) {
		assert_int_equal(
			draws_of(&gl, instance, &textures, DRAW_SHADED), 1);
	}
	assert_int_equal(pending_error, GL_NO_ERROR);
	assert_int_equal(capture.count, 1);
	assert_true(log_capture_has(&capture, LOG_WARNING, "DOT3"));
	texture_set_destroy(&textures, &gl);
	instance_destroy(instance);
	model_destroy(model);
}

/* Whether relief is possible with that GL, which is found out without a word. */
static bool is_possible(const struct model *model,
	void (*combiner)(GLenum target, GLenum name, GLfixed value),
	GLenum older_error)
{
	struct gl gl = gl_recorder_begin();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	bool possible;

	gl.GetError = tell_error;
	gl.TexEnvx = combiner;
	pending_error = older_error;
	possible = bump_is_supported(model, &gl, &log);
	assert_int_equal(capture.count, 0);
	return possible;
}

static void test_an_older_error_does_not_hide_the_combiner(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	assert_true(is_possible(model, accept_combiner, GL_INVALID_VALUE));
	assert_int_equal(environment_mode, GL_MODULATE);
	model_destroy(model);
}

static void test_models_without_relief_need_no_combiner(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	(void)state;
	assert_false(is_possible(model, refuse_combiner, GL_NO_ERROR));
	model_destroy(model);
}

static void test_relief_takes_three_passes_and_can_be_off(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct texture_set textures = {.model = model};
	GLuint name = 1;
	struct instance *instance;

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	textures.name = &name;
	textures.normal_mapping = true;
	instance = small_model_instance(model);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 3);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADOW), 1);
	instance->normal_mapping = false;
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 1);
	instance->normal_mapping = true;
	/* The inner side is drawn on its own, lit plainly. */
	model->material[0].double_sided = true;
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 4);
	instance_destroy(instance);
	model_destroy(model);
}

/* A grid over all of the picture, as it comes out of OSMesa. */
struct shown {
	struct stage stage;
	struct model *model;
	struct instance *instance;
	struct texture_set textures;
};

static void set_up(struct shown *shown, int texels, const uint8_t (*map)[4])
{
	static const uint8_t color[4][4] = {{255, 200, 100, 255},
		{255, 255, 255, 255}, {90, 180, 255, 255}, {40, 30, 20, 255}};
	struct log nowhere = log_to_nowhere();
	struct transform *local;

	shown->stage = stage_open("osmesa", PIXELS_RGBA8888);
	shown->model = small_model_grid(1, 1, 1.0f, true);
	small_model_add_normal_map(shown->model, texels, map);
	shown->model->mesh[0].primitive[0].color =
		arena_alloc(&shown->model->arena, 4, 4);
	assert_non_null(shown->model->mesh[0].primitive[0].color);
	memcpy(shown->model->mesh[0].primitive[0].color, color, sizeof(color));
	shown->instance = small_model_instance(shown->model);
	local = &shown->instance->pose.local[0];
	for (int axis = 0; axis < 2; axis++) {
		local->translation[axis] = -1;
		local->scale[axis] = 2;
	}
	local->scale[2] = 2;
	instance_update(shown->instance);
	assert_int_equal(texture_set_create(&shown->textures, shown->model,
				 shown->stage.gl, PIXELS_RGBA8888, &nowhere),
		0);
	assert_true(shown->textures.normal_mapping);
	shown->stage.gl->Enable(GL_DEPTH_TEST);
	light_apply(shown->stage.gl);
}

static void tear_down(struct shown *shown)
{
	texture_set_destroy(&shown->textures, shown->stage.gl);
	instance_destroy(shown->instance);
	model_destroy(shown->model);
	stage_close(&shown->stage);
}

/* RGBA of the picture, top row first. */
static void show(struct shown *shown, uint8_t (*out)[4])
{
	struct stage *stage = &shown->stage;

	stage->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	draw_instance(stage->gl, shown->instance, &shown->textures, DRAW_SHADED);
	stage_end_frame(stage);
	for (int y = 0; y < STAGE_HEIGHT; y++) {
		memcpy(out[(size_t)y * STAGE_WIDTH],
			stage->pixels.data + y * stage->pixels.stride_bytes,
			(size_t)STAGE_WIDTH * 4);
	}
	assert_int_equal(stage->context->driver->begin_frame(
				 stage->context, &stage->pixels),
		0);
}

/* Red, green and blue of a half of the picture together. */
static long brightness(const uint8_t (*picture)[4], bool right)
{
	long sum = 0;

	for (int y = 0; y < STAGE_HEIGHT; y++) {
		for (int x = 0; x < STAGE_WIDTH / 2; x++) {
			const uint8_t *texel = picture[y * STAGE_WIDTH + x +
				(right ? STAGE_WIDTH / 2 : 0)];

			sum += texel[0] + texel[1] + texel[2];
		}
	}
	return sum;
}

static void test_a_ridge_is_bright_on_the_side_of_the_light(void **state)
{
	static uint8_t left[STAGE_WIDTH * STAGE_HEIGHT][4];
	static uint8_t right[STAGE_WIDTH * STAGE_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 2, ridge_map);
	light_from(shown.instance, -0.6f, 0, 0.8f);
	show(&shown, left);
	light_from(shown.instance, 0.6f, 0, 0.8f);
	show(&shown, right);
	/* Key light on the slopes: 0.99 against 0.14 (0.2 more without). */
	assert_true(brightness(left, false) * 2 > brightness(right, false) * 3);
	assert_true(brightness(right, true) * 2 > brightness(left, true) * 3);
	tear_down(&shown);
}

static void test_a_flat_map_looks_like_plain_light(void **state)
{
	static uint8_t plain[STAGE_WIDTH * STAGE_HEIGHT][4];
	static uint8_t relief[STAGE_WIDTH * STAGE_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 1, small_model_flat_map);
	show(&shown, relief);
	shown.instance->normal_mapping = false;
	show(&shown, plain);
	for (int i = 0; i < STAGE_WIDTH * STAGE_HEIGHT; i++) {
		for (int channel = 0; channel < 3; channel++) {
			/* The picture is not empty, and three passes round
			   three times. */
			assert_true(plain[i][channel] > 10);
			assert_near(relief[i][channel], plain[i][channel], 3.0);
		}
	}
	tear_down(&shown);
}

static void test_the_state_is_plain_again_afterwards(void **state)
{
	static uint8_t before[STAGE_WIDTH * STAGE_HEIGHT][4];
	static uint8_t after[STAGE_WIDTH * STAGE_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 2, ridge_map);
	shown.instance->normal_mapping = false;
	show(&shown, before);
	shown.instance->normal_mapping = true;
	show(&shown, after);
	assert_memory_not_equal(before, after, sizeof(after));
	shown.instance->normal_mapping = false;
	show(&shown, after);
	assert_memory_equal(before, after, sizeof(after));
	tear_down(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_encodes_the_light_in_the_vertexs_frame),
		cmocka_unit_test(test_fades_the_light_on_the_side_away_from_it),
		cmocka_unit_test(test_rigid_meshes_are_lit_as_their_node_stands),
		cmocka_unit_test(test_the_attributes_sign_turns_the_bitangent),
		cmocka_unit_test(test_only_what_can_show_relief_has_it),
		cmocka_unit_test(test_gathered_batches_are_lit_plainly),
		cmocka_unit_test(
			test_a_driver_without_combiner_gets_one_sentence),
		cmocka_unit_test(test_an_older_error_does_not_hide_the_combiner),
		cmocka_unit_test(test_models_without_relief_need_no_combiner),
		cmocka_unit_test(test_relief_takes_three_passes_and_can_be_off),
		cmocka_unit_test(test_a_ridge_is_bright_on_the_side_of_the_light),
		cmocka_unit_test(test_a_flat_map_looks_like_plain_light),
		cmocka_unit_test(test_the_state_is_plain_again_afterwards),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
