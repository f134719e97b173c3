/*
 * Surfaces that emit light, as both drivers draw them. A square fills the
 * picture; its textures have one texel on the left and one on the right.
 */
#include "app/scene/draw/draw.h"
#include "app/scene/draw/emission.h"
#include "tests/support/gl/gl_expect.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	NONE = -1,
	BASE,  /* black and white */
	SHINE, /* green and black */
	TEXTURES
};

/* Half of what black mirrors, 0.22. */
#define DARK 0.11

/* What is drawn over gray 51, in light that reflects half of the surface. */
struct surface {
	const char *name;
	float base[4]; /* linear, with 0 or 1 for what is reflected */
	int texture;
	float emissive[3];
	int emissive_texture;
	enum model_alpha alpha;
	bool unlit, double_sided;
	bool transparent; /* where one unit shows no base texture under another */
	double left[3], right[3]; /* expected */
};

static const struct surface surfaces[] = {
	{"a lamp", {0, 0, 0, 1}, NONE, {1, 0.2140411f, 0}, NONE, MODEL_OPAQUE,
		.left = {1, 0.5, 0}, .right = {1, 0.5, 0}},
	{"a lamp of two sides", {0, 0, 0, 1}, NONE, {1, 0.2140411f, 0}, NONE,
		MODEL_OPAQUE, .double_sided = true, .left = {1, 0.5, 0},
		.right = {1, 0.5, 0}},
	{"a texture that does not shine", {1, 1, 1, 1}, BASE, {0, 0, 0}, SHINE,
		MODEL_OPAQUE, .left = {DARK, DARK, DARK},
		.right = {0.5, 0.5, 0.5}},
	{"light over a texture", {1, 1, 1, 1}, BASE, {0.2140411f, 0, 0}, NONE,
		MODEL_OPAQUE, .left = {0.5 + DARK, DARK, DARK},
		.right = {1, 0.5, 0.5}},
	{"a screen", {0, 0, 0, 1}, NONE, {1, 1, 1}, SHINE, MODEL_OPAQUE,
		.left = {DARK, 1, DARK}, .right = {DARK, DARK, DARK}},
	{"a screen over a texture", {1, 1, 1, 1}, BASE, {1, 1, 1}, SHINE,
		MODEL_OPAQUE, .left = {DARK, 1, DARK}, .right = {0.5, 0.5, 0.5}},
	{"a screen of two sides", {1, 1, 1, 1}, BASE, {1, 1, 1}, SHINE,
		MODEL_OPAQUE, .double_sided = true, .left = {DARK, 1, DARK},
		.right = {0.5, 0.5, 0.5}},
	{"a texture that shines itself", {0, 0, 0, 1}, BASE, {1, 0, 1}, BASE,
		MODEL_OPAQUE, .left = {0, 0, 0}, .right = {1, 0, 1}},
	{"cut out", {1, 1, 1, 1}, BASE, {1, 1, 1}, SHINE, MODEL_MASK,
		.left = {0.2, 0.2, 0.2}, .right = {0.5, 0.5, 0.5}},
	{"glass", {0, 0, 0, 0.5f}, NONE, {1, 1, 1}, SHINE, MODEL_BLEND,
		.left = {0.1 + DARK / 2, 0.613, 0.1 + DARK / 2},
		.right = {0.1 + DARK / 2, 0.1 + DARK / 2, 0.1 + DARK / 2}},
	{"unlit", {0, 0, 0, 1}, NONE, {1, 1, 1}, SHINE, MODEL_OPAQUE,
		.unlit = true, .left = {0, 0, 0}, .right = {0, 0, 0}},
	{"light over a texture of two sides", {1, 1, 1, 1}, BASE,
		{0.2140411f, 0, 0}, NONE, MODEL_OPAQUE, .double_sided = true,
		.left = {0.5 + DARK, DARK, DARK}, .right = {1, 0.5, 0.5}},
	{"light over a texture that is cut out", {1, 1, 1, 1}, BASE,
		{0.2140411f, 0, 0}, NONE, MODEL_MASK, .left = {0.2, 0.2, 0.2},
		.right = {1, 0.5, 0.5}},
	{"light over glass with a texture", {1, 1, 1, 0.5f}, BASE,
		{0.2140411f, 0, 0}, NONE, MODEL_BLEND, .left = {0.2, 0.2, 0.2},
		.right = {0.6, 0.35, 0.35}},
	{"a screen over glass with a texture", {1, 1, 1, 0.5f}, BASE, {1, 1, 1},
		SHINE, MODEL_BLEND, .left = {0.2, 0.2, 0.2},
		.right = {0.35, 0.35, 0.35}, .transparent = true},
	{"a dim screen over a texture", {1, 1, 1, 1}, BASE,
		{0.2140411f, 0.2140411f, 0.2140411f}, SHINE, MODEL_OPAQUE,
		.left = {DARK, 0.5 + DARK, DARK}, .right = {0.5, 0.5, 0.5}},
};

/* The left texel of the base is transparent, which only masks notice. */
static void add_textures(struct model *model)
{
	static uint8_t texels[TEXTURES][2][4] = {
		[BASE] = {{0, 0, 0, 0}, {255, 255, 255, 255}},
		[SHINE] = {{0, 255, 0, 255}, {0, 0, 0, 255}},
	};
	static struct model_image image[TEXTURES];
	static struct model_texture texture[TEXTURES];

	for (int i = 0; i < TEXTURES; i++) {
		image[i] = (struct model_image){
			.width = 2, .height = 1, .rgba = texels[i][0]};
		texture[i] = (struct model_texture){.image = i,
			.wrap_s = MODEL_CLAMP,
			.wrap_t = MODEL_CLAMP,
			.nearest = true};
	}
	model->image = image;
	model->texture = texture;
	model->image_count = model->texture_count = TEXTURES;
}

static struct model *make_model(const struct surface *surface)
{
	static const uint8_t flat[1][4] = {{128, 128, 255, 255}};
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_material *material = &model->material[0];

	small_model_add_normal_map(model, 1, flat); /* for its coordinates */
	add_textures(model);
	*material = model_plain_material;
	for (int i = 0; i < 3; i++) {
		material->emissive[i] = surface->emissive[i];
		material->base_color[i] = surface->base[i];
	}
	material->base_color[3] = surface->base[3];
	material->texture = surface->texture;
	material->emissive_texture = surface->emissive_texture;
	material->alpha = surface->alpha;
	material->unlit = surface->unlit;
	material->double_sided = surface->double_sided;
	return model;
}

static void draw_square(
	struct gl_canvas *canvas, const struct model *model, bool one_unit)
{
	static const GLfixed half[4] = {32768, 32768, 32768, 65536};
	struct instance *instance = small_model_instance(model);
	struct log nowhere = log_to_nowhere();
	struct texture_set textures;
	struct gl *gl = canvas->gl;

	small_model_fill_picture(instance);
	assert_int_equal(texture_set_create(&textures, model, gl,
				 PIXELS_RGBA8888, &nowhere),
		0);
	assert_true(textures.two_units);
	textures.two_units = !one_unit;
	gl->ClearColorx(65536 / 5, 65536 / 5, 65536 / 5, 65536);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->Enable(GL_DEPTH_TEST);
	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, half);
	draw_instance(gl, instance, &textures, DRAW_SHADED);
	texture_set_destroy(&textures, gl);
	instance_destroy(instance);
}

static void check_surface(
	const char *driver, const struct surface *surface, bool one_unit)
{
	struct gl_canvas canvas = gl_canvas_open(driver, PIXELS_RGBA8888);
	struct model *model = make_model(surface);

	draw_square(&canvas, model, one_unit);
	gl_expect_color(&canvas, surface->name, 2, 2, surface->left);
	gl_expect_color(
		&canvas, surface->name, GL_CANVAS_WIDTH - 3, 2, surface->right);
	model_destroy(model);
	gl_canvas_end_and_close(&canvas);
}

static void test_light_is_added_to_what_a_surface_reflects(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(surfaces); i++) {
		for (int one_unit = 0; one_unit <= 1; one_unit++) {
			if (!one_unit || !surfaces[i].transparent) {
				check_surface("soft", &surfaces[i], one_unit);
				check_surface("osmesa", &surfaces[i], one_unit);
			}
		}
	}
}

/*
 * A lamp without a texture, or with the base colour's, is drawn at once; others
 * are by two units.
 */
static void test_only_dim_textures_and_one_unit_take_a_second_pass(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(surfaces); i++) {
		const struct surface *surface = &surfaces[i];
		struct model *model = make_model(surface);
		bool shines = !surface->unlit && surface->emissive[0] > 0;
		enum emission expected = !shines ? EMISSION_NONE
			: surface->texture == surface->emissive_texture
			? EMISSION_WITH_LIGHT
			: surface->emissive_texture == NONE
			? EMISSION_OVER_TEXTURE
			: surface->texture != NONE && surface->emissive[0] == 1
			? EMISSION_BY_TEXTURE
			: EMISSION_ADDED;

		assert_int_equal(
			emission_of(model, model->mesh[0].primitive, true),
			expected);
		assert_int_equal(
			emission_of(model, model->mesh[0].primitive, false),
			expected >= EMISSION_OVER_TEXTURE ? EMISSION_ADDED
							  : expected);
		model_destroy(model);
	}
}

static void test_nothing_shines_without_the_texture_that_limits_it(void **state)
{
	struct surface screen = surfaces[4];
	struct model *model = make_model(&screen);

	(void)state;
	model->mesh[0].primitive->texcoord = NULL;
	assert_int_equal(emission_of(model, model->mesh[0].primitive, true),
		EMISSION_NONE);
	model->material[0].emissive_texture = NONE;
	model->material[0].texture = BASE;
	assert_int_equal(emission_of(model, model->mesh[0].primitive, true),
		EMISSION_WITH_LIGHT);
	model_destroy(model);
}

/* Linear 0.2 of the surface, 1, 0.6 and 0.1 of the lamp. */
static void test_the_colour_of_a_lamp_is_kept(void **state)
{
	struct surface lamp = {.base = {0.2f, 0.2f, 0.2f, 1},
		.texture = NONE,
		.emissive = {1, 0.6f, 0.1f},
		.emissive_texture = NONE};
	struct model *model = make_model(&lamp);
	const float reflected = 0.4845f; /* sRGB-encoded */
	float added[3];

	(void)state;
	emission_color(model, model->mesh[0].primitive, added);
	/* Never less than the lamp emits, in the stage's least light. */
	assert_true(added[0] + 0.38f * reflected > 0.99f);
	assert_true(added[1] + 0.38f * reflected > 0.79f);
	assert_true(added[2] + 0.38f * reflected > 0.34f);
	/* In medium light, about the sum of linear light. */
	assert_near(added[2] + 0.6f * reflected, 0.43, 0.03);
	model_destroy(model);
}

/* IEC 61966-2-1 */
static double encoded(double linear)
{
	return linear <= 0.0031308 ? 12.92 * linear
				   : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/*
 * In light that is 0.6 encoded the sum is right, and in light of 0.38 it is no
 * less than what is emitted.
 */
static void test_the_sum_is_right_in_medium_light(void **state)
{
	static const float bases[] = {0.0f, 0.05f, 0.2f, 0.5f, 1.0f};
	static const float lights[] = {0.02f, 0.05f, 0.1f, 0.4f};
	const double medium_light = pow((0.6 + 0.055) / 1.055, 2.4);
	const struct surface lamp = {.texture = NONE, .emissive_texture = NONE};
	struct model *model = make_model(&lamp);
	struct model_material *material = &model->material[0];
	int medium_counts = 0, least_counts = 0;

	(void)state;
	for (int i = 0; i < 20; i++) {
		double base = (double)bases[i / 4],
		       light = (double)lights[i % 4];
		double medium = encoded(base * medium_light + light) -
			encoded(base) * 0.6;
		double least = encoded(light) - encoded(base) * 0.38;
		double wanted = medium > least ? medium : least;
		float found[3];

		for (int k = 0; k < 3; k++) {
			material->base_color[k] = bases[i / 4];
			material->emissive[k] = lights[i % 4];
		}
		emission_color(model, model->mesh[0].primitive, found);
		for (int k = 0; k < 3; k++) {
			assert_near(found[k], wanted > 0 ? wanted : 0, 1e-4);
		}
		medium_counts += medium > least && medium > 0;
		least_counts += least > medium && least > 0;
	}
	assert_true(medium_counts >= 5 && least_counts >= 5);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_light_is_added_to_what_a_surface_reflects),
		cmocka_unit_test(
			test_only_dim_textures_and_one_unit_take_a_second_pass),
		cmocka_unit_test(
			test_nothing_shines_without_the_texture_that_limits_it),
		cmocka_unit_test(test_the_colour_of_a_lamp_is_kept),
		cmocka_unit_test(test_the_sum_is_right_in_medium_light),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
