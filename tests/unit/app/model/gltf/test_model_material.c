/* glTF materials: colours, textures, images from three sources. */
#include "app/model/model.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>

#define ONE_PIXEL                                                        \
	"'images':[{'uri':'data:image/png;base64,"                       \
	"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNgZG" \
	"IGAAAOAAfpkjfUAAAAAElFTkSuQmCC'}],"

static void test_reads_factors_and_flags(void **state)
{
	static const float color[4] = {0.25f, 0.5f, 0.75f, 0.5f};
	struct model *model = model_fixture("gltf/material/kinds.gltf", NULL);
	const struct model_material *glass = &model->material[0];

	(void)state;
	assert_string_equal(glass->name, "glass");
	assert_all_near(glass->base_color, color, 4, 0);
	assert_near(glass->roughness, 0.125, 0);
	assert_int_equal(glass->alpha, MODEL_BLEND);
	assert_true(glass->double_sided);
	assert_false(glass->unlit);
	model_destroy(model);
}

static void test_reads_alpha_masks_and_unlit(void **state)
{
	struct model *model = model_fixture("gltf/material/kinds.gltf", NULL);

	(void)state;
	assert_int_equal(model->material[1].alpha, MODEL_MASK);
	assert_near(model->material[1].alpha_cutoff, 0.25, 0);
	assert_true(model->material[1].unlit);
	model_destroy(model);
}

static void test_reads_diffuse_colours_and_glossiness(void **state)
{
	static const float color[4] = {0.25f, 0.5f, 0.75f, 1};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'extensionsRequired':["
			"'KHR_materials_pbrSpecularGlossiness'],'materials':[{"
			"'pbrMetallicRoughness':{'roughnessFactor':0.5},"
			"'extensions':{'KHR_materials_pbrSpecularGlossiness':{"
			"'diffuseFactor':[0.25,0.5,0.75,1],"
			"'glossinessFactor':0.25}}}]}",
			&logged, &model),
		0);
	assert_all_near(model->material[0].base_color, color, 4, 0);
	assert_near(model->material[0].roughness, 0.75, 0);
	model_destroy(model);
}

/* A document with these members, two textures of 1x1 and this material. */
#define SHINING(members, material)                                 \
	"{'asset':{'version':'2.0'}," members "'images':[{'uri':"  \
	"'data:image/png;base64,"                                  \
	"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4" \
	"2mNgZGIGAAAOAAfpkjfUAAAAAElFTkSuQmCC'}],"                 \
	"'textures':[{'source':0},{'source':0}],'materials':[{" material "}]}"

static void test_reads_the_light_that_a_material_emits(void **state)
{
	static const float light[3] = {0.25f, 0.5f, 1};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text(SHINING("",
						 "'emissiveFactor':[0.25,0.5,1],"
						 "'emissiveTexture':{'index':1,"
						 "'texCoord':2}"),
				 &logged, &model),
		0);
	assert_all_near(model->material[0].emissive, light, 3, 0);
	assert_true(model_material_emits(&model->material[0]));
	/* It is the only texture, so it chooses the coordinates. */
	assert_int_equal(model->material[0].emissive_texture, 0);
	assert_int_equal(model->texture_count, 1);
	assert_int_equal(log_capture_count(&logged, LOG_WARNING), 0);
	model_destroy(model);
}

/* KHR_materials_emissive_strength; white is the brightest that GL draws. */
static void test_strong_light_is_at_most_white(void **state)
{
	static const float light[3] = {0.5f, 1, 0};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			SHINING("'extensionsRequired':["
				"'KHR_materials_emissive_strength'],",
				"'emissiveFactor':[0.125,0.5,0],'extensions':{"
				"'KHR_materials_emissive_strength':{"
				"'emissiveStrength':4}}"),
			&logged, &model),
		0);
	assert_all_near(model->material[0].emissive, light, 3, 0);
	assert_int_equal(model->material[0].emissive_texture, -1);
	model_destroy(model);
}

/* glTF 2.0: without a factor, the texture is multiplied by 0. */
static void test_a_texture_without_a_factor_does_not_shine(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(SHINING("", "'emissiveTexture':{'index':0}"),
			&logged, &model),
		0);
	assert_false(model_material_emits(&model->material[0]));
	assert_int_equal(model->image_count, 0);
	model_destroy(model);
}

static void test_ignores_light_whose_coordinates_differ(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(SHINING("",
					"'emissiveFactor':[1,1,1],"
					"'emissiveTexture':{'index':0,"
					"'texCoord':1},'pbrMetallicRoughness':{"
					"'baseColorTexture':{'index':1}}"),
			&logged, &model),
		0);
	assert_false(model_material_emits(&model->material[0]));
	assert_int_equal(model->material[0].emissive_texture, -1);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/materials/0: limber ignores emissiveTexture"));
	model_destroy(model);
}

static void test_refuses_light_that_is_no_number(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text(SHINING("", "'emissiveFactor':[1,1]"),
				 &logged, &model),
		-EINVAL);
	assert_int_equal(
		model_from_text(SHINING("",
					"'emissiveFactor':[1,1,1],"
					"'emissiveTexture':{'index':7}"),
			&logged, &model),
		-EINVAL);
}

static void expect_plain(const struct model_material *material)
{
	static const float white[4] = {1, 1, 1, 1};

	assert_string_equal(material->name, "");
	assert_all_near(material->base_color, white, 4, 0);
	assert_int_equal(material->texture, -1);
	assert_int_equal(material->normal_texture, -1);
	assert_false(model_material_emits(material));
	assert_int_equal(material->emissive_texture, -1);
	assert_near(material->roughness, 1, 0);
	assert_int_equal(material->alpha, MODEL_OPAQUE);
	assert_near(material->alpha_cutoff, 0.5, 0);
	assert_false(material->double_sided);
	assert_false(material->unlit);
}

static void test_uses_the_defaults_of_a_material(void **state)
{
	struct model *model = model_fixture("gltf/material/kinds.gltf", NULL);

	(void)state;
	expect_plain(&model->material[2]);
	model_destroy(model);
}

static void test_adds_one_default_material(void **state)
{
	struct model *model = model_fixture("gltf/material/kinds.gltf", NULL);
	const struct model_primitive *primitive = model->mesh[0].primitive;

	(void)state;
	assert_int_equal(model->material_count, 4);
	assert_int_equal(primitive[0].material, 1);
	assert_int_equal(primitive[1].material, 3);
	assert_int_equal(primitive[2].material, 0);
	assert_int_equal(primitive[3].material, 3);
	expect_plain(&model->material[3]);
	model_destroy(model);
}

static void test_adds_no_default_material_without_need(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text("{'asset':{'version':'2.0'},"
					 "'materials':[{}]}",
				 &logged, &model),
		0);
	assert_int_equal(model->material_count, 1);
	model_destroy(model);
}

static const struct model_image *image_of(
	const struct model *model, int material)
{
	int texture = model->material[material].texture;

	assert_true(texture >= 0 && texture < model->texture_count);
	return &model->image[model->texture[texture].image];
}

static void test_reads_a_png_beside_the_file(void **state)
{
	static const uint8_t expected[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0,
		0, 255, 255, 255, 255, 255, 128};
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	const struct model_image *image = image_of(model, 0);

	(void)state;
	assert_string_equal(image->name, "beside");
	assert_int_equal(image->width, 2);
	assert_int_equal(image->height, 2);
	assert_memory_equal(image->rgba, expected, sizeof(expected));
	assert_false(image->opaque);
	model_destroy(model);
}

static void test_reads_a_png_from_a_buffer_view(void **state)
{
	static const uint8_t expected[4] = {1, 2, 3, 255};
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	const struct model_image *image = image_of(model, 1);

	(void)state;
	assert_string_equal(image->name, "inside");
	assert_memory_equal(image->rgba, expected, sizeof(expected));
	assert_true(image->opaque);
	model_destroy(model);
}

/* The left half is red, the right half blue, up to rounding in JPEG. */
static void test_reads_a_jpeg_from_a_data_uri(void **state)
{
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	const struct model_image *image = image_of(model, 2);
	const uint8_t *left, *right;

	(void)state;
	assert_int_equal(image->width, 16);
	assert_int_equal(image->height, 8);
	left = image->rgba;
	right = image->rgba + (7 * 16 + 15) * 4;
	assert_true(left[0] >= 252 && left[1] <= 3 && left[2] <= 3);
	assert_true(right[0] <= 3 && right[1] <= 3 && right[2] >= 252);
	assert_int_equal(right[3], 255);
	model_destroy(model);
}

static void test_reads_only_images_that_materials_use(void **state)
{
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	int i;

	(void)state;
	assert_int_equal(model->image_count, 3);
	assert_int_equal(model->texture_count, 3);
	for (i = 0; i < model->image_count; i++) {
		assert_string_not_equal(model->image[i].name, "unused");
	}
	model_destroy(model);
}

static void test_reads_wrap_modes_and_filters(void **state)
{
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	const struct model_texture *first =
		&model->texture[model->material[0].texture];
	const struct model_texture *second =
		&model->texture[model->material[1].texture];
	const struct model_texture *third =
		&model->texture[model->material[2].texture];

	(void)state;
	assert_int_equal(first->wrap_s, MODEL_CLAMP);
	assert_int_equal(first->wrap_t, MODEL_MIRROR);
	assert_true(first->nearest);
	assert_false(first->mipmap);
	assert_int_equal(second->wrap_s, MODEL_REPEAT);
	assert_false(second->nearest);
	assert_true(second->mipmap);
	assert_int_equal(third->wrap_t, MODEL_REPEAT);
	assert_true(third->mipmap);
	model_destroy(model);
}

static void test_reads_the_texture_coordinates_of_the_texture(void **state)
{
	static const float first[3][2] = {{0, 0}, {1, 0}, {0, 1}};
	static const float second[3][2] = {
		{0.5f, 0.5f}, {0.25f, 0.5f}, {0.5f, 0.25f}};
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);

	(void)state;
	assert_all_near(model->mesh[0].primitive[0].texcoord, first, 6, 0);
	assert_all_near(model->mesh[1].primitive[0].texcoord, second, 6, 0);
	model_destroy(model);
}

/*
 * Scale (2, 4), then a quarter turn counter-clockwise in the image, which is
 * (u, v) -> (v, -u), then offset (0.5, 0.25).
 */
static void test_applies_a_texture_transform(void **state)
{
	static const float expected[3][2] = {
		{0.5f, 0.25f}, {0.5f, -1.75f}, {4.5f, 0.25f}};
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);

	(void)state;
	assert_all_near(model->mesh[2].primitive[0].texcoord, expected, 6, 1e-6);
	model_destroy(model);
}

/* Scale (2, 4), a turn whose cosine and sine are 0.8 and 0.6, offset (0.5, 0.25). */
static void test_turns_scaled_texture_coordinates_by_any_angle(void **state)
{
	static const float expected[3][2] = {
		{2.1f, -0.95f}, {2.9f, 3.45f}, {4.5f, 2.25f}};
	struct log_capture logged;
	struct model *model;

	(void)state;
	/* The coordinates are (1, 0), (0, 1) and (1, 1), in bytes. */
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'buffers':[{'byteLength':12,"
			"'uri':'data:application/octet-stream;base64,"
			"/wAAAAD/AAD//wAA'}],'bufferViews':[{'buffer':0,"
			"'byteLength':12,'byteStride':4}],'accessors':[{"
			"'componentType':5126,'count':3,'type':'VEC3'},{"
			"'bufferView':0,'componentType':5121,'count':3,"
			"'normalized':true,'type':'VEC2'}]," ONE_PIXEL
			"'textures':[{'source':0}],'materials':[{"
			"'pbrMetallicRoughness':{'baseColorTexture':{'index':0,"
			"'extensions':{'KHR_texture_transform':{'scale':[2,4],"
			"'rotation':0.6435011,'offset':[0.5,0.25]}}}}}],"
			"'meshes':[{'primitives':[{'material':0,'attributes':{"
			"'POSITION':0,'TEXCOORD_0':1}}]}],'nodes':[{'mesh':0}],"
			"'scenes':[{'nodes':[0]}]}",
			&logged, &model),
		0);
	assert_all_near(model->mesh[0].primitive[0].texcoord, expected, 6, 1e-6);
	model_destroy(model);
}

static void test_keeps_a_normal_map_with_the_same_coordinates(void **state)
{
	struct log_capture logged;
	struct model *model =
		model_fixture("gltf/material/textures.gltf", &logged);

	(void)state;
	assert_true(model->material[1].normal_texture >= 0);
	assert_int_equal(model->material[2].normal_texture, -1);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/materials/2: limber ignores normalTexture"));
	model_destroy(model);
}

/* A transform without effect gives the same coordinates as none. */
static void test_keeps_textures_with_a_transform_without_effect(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'}," ONE_PIXEL
			"'textures':[{'source':0}],'materials':[{"
			"'emissiveFactor':[1,1,1],'emissiveTexture':{'index':0},"
			"'normalTexture':{'index':0,'extensions':{"
			"'KHR_texture_transform':{'offset':[0,0]}}},"
			"'pbrMetallicRoughness':{'baseColorTexture':{"
			"'index':0}}}]}",
			&logged, &model),
		0);
	assert_int_equal(model->material[0].normal_texture, 0);
	assert_int_equal(model->material[0].emissive_texture, 0);
	assert_int_equal(log_capture_count(&logged, LOG_WARNING), 0);
	model_destroy(model);
}

static void test_ignores_a_texture_of_an_extension(void **state)
{
	struct log_capture logged;
	struct model *model =
		model_fixture("gltf/material/textures.gltf", &logged);

	(void)state;
	assert_int_equal(model->material[3].texture, -1);
	assert_true(log_capture_has(
		&logged, LOG_WARNING, "/textures/4: has no source"));
	model_destroy(model);
}

/* Two textures use one 1x1 image; one of them is only a normal map. */
static void test_decodes_a_shared_image_once(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'}," ONE_PIXEL
			"'textures':[{'source':0},{'source':0}],'materials':[{"
			"'normalTexture':{'index':1,'texCoord':3}},{"
			"'pbrMetallicRoughness':{'baseColorTexture':{'index':"
			"0}}}]}",
			&logged, &model),
		0);
	assert_int_equal(model->image_count, 1);
	assert_int_equal(model->texture_count, 2);
	assert_int_equal(model->material[0].texture, -1);
	assert_int_equal(model->material[0].normal_texture, 0);
	assert_int_equal(model->material[1].texture, 1);
	assert_int_equal(model->texture[0].image, 0);
	assert_int_equal(model->texture[1].image, 0);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_factors_and_flags),
		cmocka_unit_test(test_reads_alpha_masks_and_unlit),
		cmocka_unit_test(test_reads_diffuse_colours_and_glossiness),
		cmocka_unit_test(test_reads_the_light_that_a_material_emits),
		cmocka_unit_test(test_strong_light_is_at_most_white),
		cmocka_unit_test(test_a_texture_without_a_factor_does_not_shine),
		cmocka_unit_test(test_ignores_light_whose_coordinates_differ),
		cmocka_unit_test(test_refuses_light_that_is_no_number),
		cmocka_unit_test(test_uses_the_defaults_of_a_material),
		cmocka_unit_test(test_adds_one_default_material),
		cmocka_unit_test(test_adds_no_default_material_without_need),
		cmocka_unit_test(test_reads_a_png_beside_the_file),
		cmocka_unit_test(test_reads_a_png_from_a_buffer_view),
		cmocka_unit_test(test_reads_a_jpeg_from_a_data_uri),
		cmocka_unit_test(test_reads_only_images_that_materials_use),
		cmocka_unit_test(test_reads_wrap_modes_and_filters),
		cmocka_unit_test(
			test_reads_the_texture_coordinates_of_the_texture),
		cmocka_unit_test(test_applies_a_texture_transform),
		cmocka_unit_test(
			test_turns_scaled_texture_coordinates_by_any_angle),
		cmocka_unit_test(
			test_keeps_a_normal_map_with_the_same_coordinates),
		cmocka_unit_test(
			test_keeps_textures_with_a_transform_without_effect),
		cmocka_unit_test(test_ignores_a_texture_of_an_extension),
		cmocka_unit_test(test_decodes_a_shared_image_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
