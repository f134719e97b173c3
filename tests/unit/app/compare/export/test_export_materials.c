/* Materials, textures, attributes and indices of exported files. */
#include "app/compare/export/export_bake.h"
#include "tests/support/model/written_glb.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

static struct written_glb write_materials(const struct model *model)
{
	struct glb glb;

	glb_begin_memory(&glb);
	export_materials(&glb, model);
	return written_glb_take(&glb);
}

static void test_materials_keep_what_they_are(void **state)
{
	struct model_material material[3] = {model_plain_material,
		model_plain_material, model_plain_material};
	const struct model model = {.material_count = 3, .material = material};
	struct written_glb written;

	(void)state;
	material[0].name = "masked";
	material[0].texture = 0;
	material[0].base_color[1] = 0.25f;
	material[0].roughness = 0.5f;
	material[0].alpha = MODEL_MASK;
	material[0].alpha_cutoff = 0.75f;
	material[1].name = "glass";
	material[1].alpha = MODEL_BLEND;
	material[1].double_sided = true;
	material[1].unlit = true;
	material[2].name = "lamp";
	material[2].emissive[0] = 0.5f;
	material[2].emissive[2] = 0.125f;
	material[2].emissive_texture = 0;
	written = write_materials(&model);
	written_glb_expect(&written, "materials",
		"[{'alphaCutoff':0.75,'alphaMode':'MASK','doubleSided':false,"
		"'name':'masked','pbrMetallicRoughness':{"
		"'baseColorFactor':[1.0,0.25,1.0,1.0],"
		"'baseColorTexture':{'index':0},'metallicFactor':0.0,"
		"'roughnessFactor':0.5}},"
		"{'alphaMode':'BLEND','doubleSided':true,"
		"'extensions':{'KHR_materials_unlit':{}},'name':'glass',"
		"'pbrMetallicRoughness':{"
		"'baseColorFactor':[1.0,1.0,1.0,1.0],'metallicFactor':0.0,"
		"'roughnessFactor':1.0}},"
		"{'alphaMode':'OPAQUE','doubleSided':false,"
		"'emissiveFactor':[0.5,0.0,0.125],"
		"'emissiveTexture':{'index':0},'name':'lamp',"
		"'pbrMetallicRoughness':{"
		"'baseColorFactor':[1.0,1.0,1.0,1.0],'metallicFactor':0.0,"
		"'roughnessFactor':1.0}}]");
	written_glb_expect(
		&written, "extensionsUsed", "['KHR_materials_unlit']");
	written_glb_expect(&written, "textures", "");
	written_glb_release(&written);
}

static void test_an_emission_without_light_or_texture_is_left_out(void **state)
{
	struct model_material material[2] = {
		model_plain_material, model_plain_material};
	const struct model model = {.material_count = 2, .material = material};
	struct written_glb written;
	json_t *array;

	(void)state;
	material[0].emissive_texture = 3;
	material[1].emissive[1] = 1.0f;
	written = write_materials(&model);
	array = json_object_get(written.root, "materials");
	for (size_t i = 0; i < 2; i++) {
		json_t *one = json_array_get(array, i);

		assert_int_equal(
			json_object_get(one, "emissiveFactor") != NULL, i == 1);
		assert_null(json_object_get(one, "emissiveTexture"));
		assert_null(json_object_get(one, "extensions"));
	}
	written_glb_expect(&written, "extensionsUsed", "");
	written_glb_release(&written);
}

/* Images become PNG, which the test reads again. */
static void test_textures_keep_their_samplers_and_pixels(void **state)
{
	struct model_texture texture[3] = {
		{.image = 1, .wrap_s = MODEL_CLAMP, .nearest = true},
		{.image = 0, .wrap_t = MODEL_MIRROR, .mipmap = true},
		{.image = 1, .wrap_s = MODEL_MIRROR, .wrap_t = MODEL_CLAMP}};
	uint8_t pixels[2][24];
	struct model_image image[2] = {
		{.width = 3, .height = 2, .rgba = pixels[0]},
		{.width = 1, .height = 2, .rgba = pixels[1]}};
	const struct model model = {.texture_count = 3,
		.texture = texture,
		.image_count = 2,
		.image = image};
	struct written_glb written;

	(void)state;
	for (int i = 0; i < 48; i++) {
		pixels[i / 24][i % 24] = (uint8_t)(5 * i + 3);
	}
	written = write_materials(&model);
	written_glb_expect(&written, "textures",
		"[{'sampler':0,'source':1},{'sampler':1,'source':0},"
		"{'sampler':2,'source':1}]");
	/* OpenGL's NEAREST, LINEAR, LINEAR_MIPMAP_LINEAR and edges. */
	written_glb_expect(&written, "samplers",
		"[{'magFilter':9728,'minFilter':9729,'wrapS':33071,"
		"'wrapT':10497},"
		"{'magFilter':9729,'minFilter':9987,'wrapS':10497,"
		"'wrapT':33648},"
		"{'magFilter':9729,'minFilter':9729,'wrapS':33648,"
		"'wrapT':33071}]");
	written_glb_expect(&written, "images",
		"[{'bufferView':0,'mimeType':'image/png'},"
		"{'bufferView':1,'mimeType':'image/png'}]");
	for (size_t i = 0; i < 2; i++) {
		json_t *view = json_array_get(
			json_object_get(written.root, "bufferViews"), i);
		png_image png = {.version = PNG_IMAGE_VERSION};
		uint8_t read[24];

		assert_true(png_image_begin_read_from_memory(&png,
			written.binary +
				json_integer_value(
					json_object_get(view, "byteOffset")),
			(size_t)json_integer_value(
				json_object_get(view, "byteLength"))));
		assert_int_equal(png.width, image[i].width);
		assert_int_equal(png.height, image[i].height);
		png.format = PNG_FORMAT_RGBA;
		assert_true(png_image_finish_read(&png, NULL, read, 0, NULL));
		assert_memory_equal(read, pixels[i], i == 0 ? 24 : 8);
	}
	written_glb_release(&written);
}

/* A transparent pixel each, named by its number; one texture shows the last. */
static void test_images_that_are_shared_have_numbers_alone(void **state)
{
	static const uint8_t transparent[4] = {0, 0, 0, 0};
	struct model_texture texture = {.image = 11};
	struct model_image image[12] = {{.width = 3}};
	const struct model model = {.texture_count = 1,
		.texture = &texture,
		.image_count = 12,
		.image = image};
	struct written_glb written;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	glb.shares_images = true;
	export_materials(&glb, &model);
	written = written_glb_take(&glb);
	written_glb_expect(&written, "textures", "[{'sampler':0,'source':11}]");
	for (size_t i = 0; i < 12; i++) {
		json_t *json = json_array_get(
			json_object_get(written.root, "images"), i);
		json_t *view = json_array_get(
			json_object_get(written.root, "bufferViews"), i);
		png_image png = {.version = PNG_IMAGE_VERSION};
		uint8_t read[4];

		assert_int_equal(
			atoi(json_string_value(json_object_get(json, "name"))),
			i);
		assert_int_equal(
			json_integer_value(json_object_get(json, "bufferView")),
			i);
		assert_true(png_image_begin_read_from_memory(&png,
			written.binary +
				json_integer_value(
					json_object_get(view, "byteOffset")),
			(size_t)json_integer_value(
				json_object_get(view, "byteLength"))));
		assert_int_equal(png.width, 1);
		assert_int_equal(png.height, 1);
		png.format = PNG_FORMAT_RGBA;
		assert_true(png_image_finish_read(&png, NULL, read, 0, NULL));
		assert_memory_equal(read, transparent, 4);
	}
	written_glb_release(&written);
}

static void test_attributes_follow_their_sources(void **state)
{
	static const int source[4] = {2, 0, 1, 2};
	float texcoord[3][2] = {{0, 1}, {2, 3}, {4, 5}};
	uint8_t color[3][4] = {
		{0, 5, 11, 51}, {100, 200, 255, 0}, {7, 8, 9, 255}};
	const struct model_primitive primitive = {
		.vertex_count = 3, .texcoord = texcoord, .color = color};

	(void)state;
	for (int with = 0; with < 2; with++) {
		int count = with ? 4 : 3;
		json_t *attributes = json_object();
		struct written_glb written;
		const float *numbers;
		struct glb glb;

		glb_begin_memory(&glb);
		export_attributes(&glb, attributes, &primitive, count,
			with ? source : NULL);
		assert_int_equal(json_integer_value(json_object_get(
					 attributes, "TEXCOORD_0")),
			0);
		assert_int_equal(json_integer_value(
					 json_object_get(attributes, "COLOR_0")),
			1);
		written = written_glb_take(&glb);
		numbers = (const float *)(const void *)written.binary;
		for (int v = 0; v < count; v++) {
			int from = with ? source[v] : v;

			assert_near(numbers[2 * v], texcoord[from][0], 0);
			assert_near(numbers[2 * v + 1], texcoord[from][1], 0);
		}
		numbers += 2 * count;
		for (int i = 0; i < 4 * count; i++) {
			int from = with ? source[i / 4] : i / 4;
			double shown = color[from][i % 4] / 255.0;
			/* IEC 61966-2-1 */
			double linear = shown <= 0.04045
				? shown / 12.92
				: pow((shown + 0.055) / 1.055, 2.4);

			assert_near(
				numbers[i], i % 4 < 3 ? linear : shown, 1e-6);
		}
		written_glb_release(&written);
		json_decref(attributes);
	}
}

/* 65535 restarts a strip. */
static void test_indices_are_short_up_to_65534(void **state)
{
	static const uint32_t small[3] = {65534, 0, 7}, large[3] = {1, 65535, 7};
	static const uint16_t stored[3] = {65534, 0, 7};
	struct written_glb written;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(export_indices(&glb, small, 3), 0);
	assert_int_equal(export_indices(&glb, large, 3), 1);
	written = written_glb_take(&glb);
	written_glb_expect(&written, "accessors",
		"[{'bufferView':0,'componentType':5123,'count':3,"
		"'type':'SCALAR'},"
		"{'bufferView':1,'componentType':5125,'count':3,"
		"'type':'SCALAR'}]");
	assert_memory_equal(written.binary, stored, 6);
	assert_memory_equal(written.binary + 8, large, 12);
	written_glb_release(&written);
}

/* glTF has no accessors without elements. */
static void test_no_triangles_become_one_of_one_vertex(void **state)
{
	static const uint16_t stored[3] = {0, 0, 0};
	struct written_glb written;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	assert_int_equal(export_indices(&glb, NULL, 0), 0);
	written = written_glb_take(&glb);
	written_glb_expect(&written, "accessors",
		"[{'bufferView':0,'componentType':5123,'count':3,"
		"'type':'SCALAR'}]");
	assert_memory_equal(written.binary, stored, 6);
	written_glb_release(&written);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_materials_keep_what_they_are),
		cmocka_unit_test(
			test_an_emission_without_light_or_texture_is_left_out),
		cmocka_unit_test(test_textures_keep_their_samplers_and_pixels),
		cmocka_unit_test(test_images_that_are_shared_have_numbers_alone),
		cmocka_unit_test(test_attributes_follow_their_sources),
		cmocka_unit_test(test_indices_are_short_up_to_65534),
		cmocka_unit_test(test_no_triangles_become_one_of_one_vertex),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
