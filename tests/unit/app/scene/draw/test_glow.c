/* Which triangles are drawn with a texture that emits, and which without. */
#include "app/scene/draw/draw.h"
#include "app/scene/draw/glow.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/small_model.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	QUADS = 8,
	SIDE = 64, /* texels; each quad shows 8 of them */
	CORNERS = 6 * QUADS
};

/* A row of quads on which a texture emits: where[i] of 255 at texel i. */
static struct model *make_row(const uint8_t where[SIDE])
{
	struct model *model = small_model_grid(QUADS, 1, 1.0f, true);
	struct model_material *material = &model->material[0];
	uint8_t rgba[SIDE][4] = {{0}};

	for (int i = 0; i < SIDE; i++) {
		rgba[i][i % 3] = where[i];
	}
	small_model_add_normal_map(model, SIDE, (const uint8_t(*)[4])rgba);
	material->normal_texture = -1;
	material->emissive_texture = 0;
	material->emissive[0] = material->emissive[1] = material->emissive[2] =
		1.0f;
	return model;
}

/* The list is what it was, but with shining triangles behind the others. */
static int sorted_from(const struct model *model)
{
	struct instance *instance = small_model_instance(model);
	const struct batch *batch = instance->drawable[0].batch;
	const uint32_t *index = model->mesh[0].primitive[0].index;
	int from = batch->glow_from;
	int dark = 0, shining = from;

	assert_int_equal(batch->index_count, CORNERS);
	for (int i = 0; i < CORNERS; i += 3) {
		int *at = dark < from && batch->index[dark] == index[i] &&
				batch->index[dark + 1] == index[i + 1] &&
				batch->index[dark + 2] == index[i + 2]
			? &dark
			: &shining;

		for (int k = 0; k < 3; k++) {
			assert_int_equal(batch->index[*at + k], index[i + k]);
		}
		*at += 3;
	}
	assert_int_equal(dark, from);
	instance_destroy(instance);
	return from;
}

/* As many corners as emit nothing where one texel has this value. */
static int dark_with(int texel, uint8_t value)
{
	uint8_t where[SIDE] = {0};
	struct model *model;
	int from;

	where[texel] = value;
	model = make_row(where);
	from = sorted_from(model);
	model_destroy(model);
	return from;
}

/* Filters read up to two texels beside a triangle's own. */
static void test_triangles_near_a_texel_that_shines_come_last(void **state)
{
	(void)state;
	assert_int_equal(dark_with(28, 255), CORNERS - 6);
	assert_int_equal(dark_with(27, 255), CORNERS - 6);
	assert_int_equal(dark_with(26, 255), CORNERS - 12);
	assert_int_equal(dark_with(29, 255), CORNERS - 6);
	assert_int_equal(dark_with(30, 255), CORNERS - 12);
	assert_int_equal(dark_with(0, 255), CORNERS - 6);
	assert_int_equal(dark_with(SIDE - 1, 255), CORNERS - 6);
}

/* A step of RGB565 is 8 of 255. */
static void test_what_a_panel_cannot_show_is_dark(void **state)
{
	(void)state;
	for (int channel = 0; channel < 3; channel++) {
		assert_int_equal(dark_with(27 + channel, 7), CORNERS);
		assert_true(dark_with(27 + channel, 8) < CORNERS);
	}
}

static void test_few_dark_triangles_stay_in_their_places(void **state)
{
	uint8_t where[SIDE] = {0};
	struct model *model;

	(void)state;
	memset(where, 255, 46); /* all but two quads: a quarter is dark */
	model = make_row(where);
	assert_int_equal(sorted_from(model), CORNERS / 4);
	model_destroy(model);
	where[46] = 255;
	model = make_row(where);
	assert_int_equal(sorted_from(model), 0);
	model_destroy(model);
}

/* Glass needs its order; a texture that the base shares needs no unit. */
static void test_only_textures_of_their_own_on_what_is_not_glass_count(
	void **state)
{
	static const uint8_t nowhere[SIDE] = {0};
	struct model *model = make_row(nowhere);
	struct model_material *material = &model->material[0];

	(void)state;
	assert_int_equal(sorted_from(model), CORNERS);
	material->alpha = MODEL_MASK;
	assert_int_equal(sorted_from(model), CORNERS);
	material->alpha = MODEL_BLEND;
	material->base_color[3] = 0.5f;
	assert_int_equal(sorted_from(model), 0);
	material->alpha = MODEL_OPAQUE;
	material->texture = 0;
	assert_int_equal(sorted_from(model), 0);
	material->texture = material->emissive_texture = -1;
	assert_int_equal(sorted_from(model), 0);
	model_destroy(model);
}

static void test_coordinates_beside_the_texture_may_shine(void **state)
{
	uint8_t where[SIDE] = {[28] = 255};
	struct model *model = make_row(where);
	float(*texcoord)[2] = model->mesh[0].primitive[0].texcoord;

	(void)state;
	texcoord[QUADS][0] = 1.01f; /* of both triangles of the last quad */
	assert_int_equal(sorted_from(model), CORNERS - 12);
	texcoord[QUADS][0] = 1.0f;
	texcoord[0][1] = -0.01f; /* of one triangle of the first quad */
	assert_int_equal(sorted_from(model), CORNERS - 9);
	model_destroy(model);
}

static void test_coarser_lists_are_sorted_too(void **state)
{
	uint8_t where[SIDE] = {[4] = 255};
	struct model *model = make_row(where);
	struct model_primitive *primitive = model->mesh[0].primitive;
	struct model_lod lod = {
		.error_m = 0.1f, .index_count = 12, .index = primitive->index};
	struct instance *instance;
	const struct batch_lod *list;

	(void)state;
	primitive->lod = &lod;
	primitive->lod_count = 1;
	instance = small_model_instance(model);
	list = instance->drawable[0].batch[0].lod;
	assert_int_equal(list->glow_from, 6);
	for (int i = 0; i < 12; i++) {
		assert_int_equal(list->index[i], primitive->index[(i + 6) % 12]);
	}
	instance_destroy(instance);
	model_destroy(model);
}

/* One map serves textures of any size, one after the other. */
static void test_maps_are_of_the_last_texture(void **state)
{
	uint32_t seed = 7;

	(void)state;
	for (int turn = 0; turn < 40; turn++) {
		int width = random_between(&seed, 1, 700);
		int height = random_between(&seed, 1, 300);
		size_t bytes = (size_t)width * (size_t)height * 4;
		int lit_x = random_between(&seed, 0, width - 1);
		int lit_y = random_between(&seed, 0, height - 1);
		static const uint8_t nowhere[SIDE] = {0};
		struct model *model = make_row(nowhere);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct model_image *image = model->image;
		bool near;

		image->width = width;
		image->height = height;
		image->rgba = arena_alloc(&model->arena, bytes, 1);
		memset(image->rgba, 0, bytes);
		image->rgba[((size_t)lit_y * (size_t)width + (size_t)lit_x) * 4] =
			255;
		/* All quads show one place, at or far from the texel. */
		near = random_one_in(&seed, 2);
		for (int v = 0; v < primitive->vertex_count; v++) {
			float x = ((float)lit_x + 0.5f) / (float)width;
			float y = ((float)lit_y + 0.5f) / (float)height;

			primitive->texcoord[v][0] = near ? x
				: x < 0.5f               ? x + 0.5f
							 : x - 0.5f;
			primitive->texcoord[v][1] = y;
		}
		if (near || width > 50) {
			assert_int_equal(sorted_from(model), near ? 0 : CORNERS);
		}
		model_destroy(model);
	}
}

/* Whether a texel shines in the box of a triangle and two texels around it. */
static bool box_shines(const struct model_image *image,
	const struct model_primitive *primitive, const uint32_t *corner)
{
	int low[2] = {9999, 9999}, high[2] = {-1, -1};
	const int side[2] = {image->width, image->height};

	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < 2; i++) {
			int at = (int)(primitive->texcoord[corner[k]][i] *
				(float)side[i]);

			low[i] = at - 2 < low[i] ? at - 2 : low[i];
			high[i] = at + 2 > high[i] ? at + 2 : high[i];
		}
	}
	for (int y = 0; y < side[1]; y++) {
		for (int x = 0; x < side[0]; x++) {
			if (image->rgba[(y * side[0] + x) * 4] > 0 &&
				x >= low[0] && x <= high[0] && y >= low[1] &&
				y <= high[1]) {
				return true;
			}
		}
	}
	return false;
}

/* Pictures of at most 128 texels a side, each of which counts. */
static void test_triangles_of_any_place_are_sorted_by_their_texels(void **state)
{
	uint32_t seed = 11;
	int dark_in_all = 0;

	(void)state;
	for (int turn = 0; turn < 60; turn++) {
		static const uint8_t nowhere[SIDE] = {0};
		struct model *model = make_row(nowhere);
		struct model_primitive *primitive = model->mesh[0].primitive;
		struct model_image *image = model->image;
		size_t bytes;
		int dark = 0;

		image->width = random_between(&seed, 20, 128);
		image->height = random_between(&seed, 20, 128);
		bytes = (size_t)image->width * (size_t)image->height * 4;
		image->rgba = arena_alloc(&model->arena, bytes, 1);
		memset(image->rgba, 0, bytes);
		for (int i = 0; i < 3; i++) {
			int x = random_between(&seed, 0, image->width - 1);
			int y = random_between(&seed, 0, image->height - 1);

			image->rgba[(y * image->width + x) * 4] = 255;
		}
		/* Neighbouring corners are near to each other. */
		for (int v = 0; v < primitive->vertex_count; v++) {
			for (int i = 0; i < 2; i++) {
				primitive->texcoord[v][i] =
					(float)random_between(&seed, 0, 40) /
						100 +
					0.6f * (float)(turn >> i & 1);
			}
		}
		for (int i = 0; i < CORNERS; i += 3) {
			dark += !box_shines(
				image, primitive, primitive->index + i);
		}
		/* A quarter is the least that is sorted. */
		assert_int_equal(sorted_from(model),
			3 * dark < CORNERS / 4 ? 0 : 3 * dark);
		dark_in_all += dark;
		model_destroy(model);
	}
	assert_in_range(dark_in_all, 100, 60 * CORNERS / 3 - 100);
}

/* GL's calls carry no context argument. */
static struct {
	int unit;
	bool second_texture;
	int without, with; /* corners */
} drawn;

static void active_texture(GLenum unit)
{
	drawn.unit = (int)(unit - GL_TEXTURE0);
}

static void enable(GLenum capability)
{
	if (capability == GL_TEXTURE_2D && drawn.unit == 1) {
		drawn.second_texture = true;
	}
}

static void disable(GLenum capability)
{
	if (capability == GL_TEXTURE_2D && drawn.unit == 1) {
		drawn.second_texture = false;
	}
}

static void draw_elements(
	GLenum mode, GLsizei count, GLenum type, const void *index)
{
	(void)mode;
	(void)type;
	(void)index;
	*(drawn.second_texture ? &drawn.with : &drawn.without) += count;
}

static void test_only_triangles_that_may_shine_take_a_second_texture(
	void **state)
{
	uint8_t where[SIDE] = {[28] = 255};
	struct model *model = make_row(where);
	struct model_texture two[2] = {model->texture[0], model->texture[0]};
	GLuint names[2] = {1, 2};
	struct texture_set textures = {
		.model = model, .count = 2, .name = names, .two_units = true};

	(void)state;
	model->texture = two;
	model->texture_count = 2;
	model->material[0].texture = 1;
	for (int sides = 1; sides <= 2; sides++) {
		struct gl gl = gl_recorder_begin();
		struct instance *instance = small_model_instance(model);

		gl.ActiveTexture = active_texture;
		gl.Enable = enable;
		gl.Disable = disable;
		gl.DrawElements = draw_elements;
		memset(&drawn, 0, sizeof(drawn));
		draw_instance(&gl, instance, &textures, DRAW_SHADED);
		assert_int_equal(drawn.with, sides * 6);
		assert_int_equal(drawn.without, sides * (CORNERS - 6));
		instance_destroy(instance);
		model->material[0].double_sided = true;
	}
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_triangles_near_a_texel_that_shines_come_last),
		cmocka_unit_test(test_what_a_panel_cannot_show_is_dark),
		cmocka_unit_test(test_few_dark_triangles_stay_in_their_places),
		cmocka_unit_test(
			test_only_textures_of_their_own_on_what_is_not_glass_count),
		cmocka_unit_test(test_coordinates_beside_the_texture_may_shine),
		cmocka_unit_test(test_coarser_lists_are_sorted_too),
		cmocka_unit_test(test_maps_are_of_the_last_texture),
		cmocka_unit_test(
			test_only_triangles_that_may_shine_take_a_second_texture),
		cmocka_unit_test(
			test_triangles_of_any_place_are_sorted_by_their_texels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
