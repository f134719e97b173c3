#include "app/scene/draw/bump.h"
#include "app/scene/draw/draw.h"
#include "app/scene/instance/lod.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

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
	small_model_light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 204, 128, 230);
	small_model_light_from(instance, -0.6f, 0, 0.8f);
	assert_texel(light[0], 51, 128, 230);
	/* The mesh faces +X, so light from +X is perpendicular to it. */
	local->rotation[1] = local->rotation[3] = 0.70710678f;
	small_model_light_from(instance, 1, 0, 0);
	assert_texel(light[3], 128, 128, 255);
	/* Mirrored, the tangent points along -X. */
	local->rotation[1] = 0;
	local->rotation[3] = 1;
	local->scale[0] = -1;
	small_model_light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 51, 128, 230);
	local->scale[0] = local->scale[1] = local->scale[2] = 1e-4f;
	small_model_light_from(instance, 0.6f, 0, 0.8f);
	assert_texel(light[0], 204, 128, 230);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_the_tangents_w_flips_the_bitangent(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance;
	const uint8_t(*light)[4];

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	model->mesh[0].primitive[0].tangent[1][3] = -1;
	instance = small_model_instance(model);
	light = (const uint8_t(*)[4])instance->drawable[0].light;
	small_model_light_from(instance, 0, 0.6f, 0.8f);
	assert_texel(light[0], 128, 204, 230);
	assert_texel(light[1], 128, 51, 230);
	instance_destroy(instance);
	model_destroy(model);
}

/* Directions without length are lit as by light along the surface. */
static void test_what_has_no_direction_is_lit_evenly(void **state)
{
	static const char *const kernels[] = {"float", "fixed"};
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	memset(primitive->normal[1], 0, sizeof(float[3]));
	memset(primitive->tangent[1], 0, sizeof(float[3]));
	for (int k = 0; k < 2; k++) {
		struct instance *instance;
		const uint8_t(*light)[4];

		assert_int_equal(instance_create(model, kernel_find(kernels[k]),
					 NULL, &instance),
			0);
		instance->normal_mapping = true;
		light = (const uint8_t(*)[4])instance->drawable[0].light;
		small_model_light_from(instance, 0.6f, 0, 0.8f);
		assert_texel(light[0], 204, 128, 230);
		assert_texel(light[1], 128, 128, 128);
		small_model_light_from(instance, 0, 0, 0);
		assert_texel(light[0], 128, 128, 128);
		/* A flat node's vertices move along one axis at most. */
		instance->pose.local[0].scale[0] = 0;
		small_model_light_from(instance, 0.6f, 0, 0.8f);
		assert_texel(light[0], 255, 128, 128);
		memset(instance->pose.local[0].scale, 0, sizeof(float[3]));
		small_model_light_from(instance, 0.6f, 0, 0.8f);
		assert_texel(light[0], 128, 128, 128);
		instance_destroy(instance);
	}
	model_destroy(model);
}

/* Changes after which a primitive is not bump-mapped. */
enum change {
	CHANGE_NOTHING,
	DROP_MAP,
	BLEND,
	UNLIGHT,
	DROP_TEXCOORDS,
	DROP_TANGENTS,
	DROP_NORMALS,
	CHANGES,
};

static void apply(enum change change, struct model *model)
{
	struct model_primitive *primitive = &model->mesh[0].primitive[0];

	switch (change) {
	case DROP_MAP:
		model->material[0].normal_texture = -1;
		break;
	case BLEND:
		model->material[0].alpha = MODEL_BLEND;
		model->material[0].base_color[3] = 0.5f;
		break;
	case UNLIGHT:
		model->material[0].unlit = true;
		break;
	case DROP_TEXCOORDS:
		primitive->texcoord = NULL;
		break;
	case DROP_TANGENTS:
		primitive->tangent = NULL;
		break;
	case DROP_NORMALS:
		primitive->normal = NULL;
		break;
	default:
		break;
	}
}

static void test_only_suitable_primitives_are_bump_mapped(void **state)
{
	(void)state;
	for (int change = 0; change < CHANGES; change++) {
		struct model *model = small_model_grid(1, 1, 1.0f, true);
		struct instance *instance;

		small_model_add_normal_map(model, 1, small_model_flat_map);
		apply((enum change)change, model);
		instance = small_model_instance(model);
		assert_int_equal(instance->drawable[0].tangent != NULL,
			change == CHANGE_NOTHING);
		instance_destroy(instance);
		model_destroy(model);
	}
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

/* The state of a GL without combiner; GL's functions have no context. */
static GLenum pending_error;
static GLint environment_mode;

static GLenum get_error(void)
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

static void test_a_driver_without_combiner_gets_one_warning(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct texture_set textures;
	struct instance *instance;

	(void)state;
	gl.GetError = get_error;
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

/* Asks whether a GL supports bump mapping and expects no warning. */
static bool is_supported(const struct model *model,
	void (*combiner)(GLenum target, GLenum name, GLfixed value),
	GLenum older_error)
{
	struct gl gl = gl_recorder_begin();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	bool supported;

	gl.GetError = get_error;
	gl.TexEnvx = combiner;
	pending_error = older_error;
	supported = bump_is_supported(model, &gl, &log);
	assert_int_equal(capture.count, 0);
	return supported;
}

static void test_an_older_error_does_not_hide_the_combiner(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	assert_true(is_supported(model, accept_combiner, GL_INVALID_VALUE));
	assert_int_equal(environment_mode, GL_MODULATE);
	model_destroy(model);
}

static int asked;

/* As a context that the driver has lost. */
static GLenum fail_for_ever(void)
{
	assert_true(++asked < 100);
	return GL_OUT_OF_MEMORY;
}

static void test_a_gl_whose_errors_never_end_is_not_waited_for(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	gl.GetError = fail_for_ever;
	gl.TexEnvx = accept_combiner;
	asked = 0;
	assert_false(bump_is_supported(model, &gl, &log));
	assert_true(asked > 1);
	assert_int_equal(capture.count, 1);
	model_destroy(model);
}

static void test_models_without_normal_maps_need_no_combiner(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	(void)state;
	assert_false(is_supported(model, refuse_combiner, GL_NO_ERROR));
	model_destroy(model);
}

static void test_bump_mapping_takes_three_passes_and_can_be_off(void **state)
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
	/* Back faces are drawn in a pass of their own without bumps. */
	model->material[0].double_sided = true;
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 4);
	/* The light of an emissive texture is added on both sides. */
	model->material[0].emissive[0] = 1.0f;
	model->material[0].emissive_texture = 0;
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 5);
	instance_destroy(instance);
	model_destroy(model);
}

/* After how many draws GL_EMISSION was set last, and how often not to black. */
static int emission_after, times_lit;
static bool emission_lit;

static void watch_emission(GLenum face, GLenum name, const GLfixed *value)
{
	(void)face;
	if (name == GL_EMISSION) {
		emission_after = gl_recorder_result()->draw_count;
		emission_lit = value[0] > 0;
		times_lit += emission_lit;
		/* It is black in the two passes of the bumps. */
		assert_int_equal(emission_after, emission_lit ? 2 : 3);
	}
}

static void test_bumps_do_not_shade_light_that_is_emitted(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct texture_set textures = {.model = model, .normal_mapping = true};
	GLuint name = 1;
	struct instance *instance;

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	model->material[0].emissive[0] = 1.0f;
	textures.name = &name;
	instance = small_model_instance(model);
	gl.Materialxv = watch_emission;
	emission_after = times_lit = 0;
	draw_instance(&gl, instance, &textures, DRAW_SHADED);
	assert_int_equal(times_lit, 1);
	assert_int_equal(emission_after, 3);
	assert_false(emission_lit);
	instance_destroy(instance);
	model_destroy(model);
}

/* 4 texels on a square of 0.5 x 0.5, whichever way that faces. */
static void test_texels_are_counted_along_the_surface(void **state)
{
	static const uint8_t map[4][4] = {{128, 128, 255, 255}};
	struct model *model = small_model_grid(3, 2, 0.5f, true);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	struct instance *instance;

	(void)state;
	small_model_add_normal_map(model, 4, map);
	for (int v = 0; v < primitive->vertex_count; v++) {
		primitive->position[v][2] = 0.8f * primitive->position[v][0];
		primitive->position[v][0] *= 0.6f;
	}
	instance = small_model_instance(model);
	assert_near(instance->drawable[0].bump_texels, 4, 1e-4);
	instance_destroy(instance);
	memset(primitive->position, 0, 12 * sizeof(float[3]));
	instance = small_model_instance(model);
	assert_near(instance->drawable[0].bump_texels, 0, 0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_bumps_smaller_than_pixels_are_left_out(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct gl gl = gl_recorder_begin();
	struct texture_set textures = {.model = model, .normal_mapping = true};
	const struct lod fine = {.kind = LOD_AUTO}, all = {.kind = LOD_ALL};
	GLuint name = 1;
	struct instance *instance;
	float texels;

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	textures.name = &name;
	instance = small_model_instance(model);
	/* The single texel covers the unit square of the grid. */
	texels = instance->drawable[0].bump_texels;
	assert_true(texels > 0.99f && texels < 1.01f);
	lod_choose(instance, &fine, 0.3f / LOD_BUMP_TEXELS);
	instance_update(instance);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 1);
	/* What comes into sight is drawn when it is posed. */
	lod_choose(instance, &fine, 3.0f / LOD_BUMP_TEXELS);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 1);
	instance_update(instance);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 3);
	lod_choose(instance, &all, 0.3f / LOD_BUMP_TEXELS);
	instance_update(instance);
	assert_int_equal(draws_of(&gl, instance, &textures, DRAW_SHADED), 3);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_encodes_the_light_in_the_vertexs_frame),
		cmocka_unit_test(test_fades_the_light_on_the_side_away_from_it),
		cmocka_unit_test(test_rigid_meshes_are_lit_as_their_node_stands),
		cmocka_unit_test(test_the_tangents_w_flips_the_bitangent),
		cmocka_unit_test(test_what_has_no_direction_is_lit_evenly),
		cmocka_unit_test(test_only_suitable_primitives_are_bump_mapped),
		cmocka_unit_test(test_gathered_batches_are_lit_plainly),
		cmocka_unit_test(test_a_driver_without_combiner_gets_one_warning),
		cmocka_unit_test(test_an_older_error_does_not_hide_the_combiner),
		cmocka_unit_test(
			test_a_gl_whose_errors_never_end_is_not_waited_for),
		cmocka_unit_test(
			test_models_without_normal_maps_need_no_combiner),
		cmocka_unit_test(
			test_bump_mapping_takes_three_passes_and_can_be_off),
		cmocka_unit_test(test_bumps_do_not_shade_light_that_is_emitted),
		cmocka_unit_test(test_texels_are_counted_along_the_surface),
		cmocka_unit_test(test_bumps_smaller_than_pixels_are_left_out),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
