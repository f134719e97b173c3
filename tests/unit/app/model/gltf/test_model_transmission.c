/* KHR_materials_transmission: glass that one can look through. */
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdio.h>

/* Pictures of one red pixel: with an alpha of 0, and without alpha. */
static const char clear_png[] =
	"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP4"
	"z8DAAAAEAQEAmFjYzgAAAABJRU5ErkJggg==";
static const char red_png[] =
	"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4"
	"z8AAAAMBAQD3A0FDAAAAAElFTkSuQmCC";

/* Reads a material with these members, and the extension with its own. */
static struct model_material read(const char *members, const char *transmission)
{
	struct log_capture logged;
	struct model *model;
	struct model_material material;
	char text[1024];

	snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},"
		"'extensionsUsed':['KHR_materials_transmission'],"
		"'images':[{'uri':'data:image/png;base64,%s'},"
		"{'uri':'data:image/png;base64,%s'}],"
		"'textures':[{'source':0},{'source':1}],"
		"'materials':[{%s'extensions':{"
		"'KHR_materials_transmission':{%s}}}]}",
		clear_png, red_png, members, transmission);
	assert_int_equal(model_from_text(text, &logged, &model), 0);
	assert_int_equal(log_capture_count(&logged, LOG_WARNING), 0);
	material = model->material[0];
	model_destroy(model);
	return material;
}

static void expect(const char *members, const char *transmission,
	enum model_alpha alpha, float opacity)
{
	struct model_material material = read(members, transmission);

	assert_int_equal(material.alpha, alpha);
	assert_all_near(&material.base_color[3], &opacity, 1, 1e-6f);
}

static void test_glass_is_blended_with_what_is_behind(void **state)
{
	(void)state;
	expect("", "'transmissionFactor':1", MODEL_BLEND, 0.25f);
	expect("", "'transmissionFactor':0.5", MODEL_BLEND, 0.625f);
	expect("'alphaMode':'BLEND','pbrMetallicRoughness':"
	       "{'baseColorFactor':[1,1,1,0.5]},",
		"'transmissionFactor':1", MODEL_BLEND, 0.125f);
}

/* The alpha of an opaque material has no effect. */
static void test_glass_that_is_opaque_counts_as_whole(void **state)
{
	(void)state;
	expect("'pbrMetallicRoughness':{'baseColorFactor':[1,1,1,0]},",
		"'transmissionFactor':1", MODEL_BLEND, 0.25f);
}

static void test_what_lets_no_light_through_stays_opaque(void **state)
{
	(void)state;
	expect("", "", MODEL_OPAQUE, 1);
	expect("", "'transmissionFactor':0", MODEL_OPAQUE, 1);
	expect("'alphaMode':'MASK',", "'transmissionFactor':1", MODEL_MASK, 1);
	/* The texture says where the surface is glass. */
	expect("", "'transmissionFactor':1,'transmissionTexture':{'index':0}",
		MODEL_OPAQUE, 1);
}

/* Blended, a texture would hide what it does not hide as an opaque one. */
static void test_glass_does_not_take_the_alpha_of_an_opaque_texture(void **state)
{
	(void)state;
	expect("'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},",
		"'transmissionFactor':1", MODEL_OPAQUE, 1);
	expect("'pbrMetallicRoughness':{'baseColorTexture':{'index':1}},",
		"'transmissionFactor':1", MODEL_BLEND, 0.25f);
	expect("'alphaMode':'BLEND',"
	       "'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},",
		"'transmissionFactor':1", MODEL_BLEND, 0.25f);
}

static void test_refuses_a_transmission_that_is_no_number(void **state)
{
	struct log_capture logged;
	struct model *model = NULL;

	(void)state;
	assert_int_not_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'materials':[{'extensions':"
			"{'KHR_materials_transmission':"
			"{'transmissionFactor':'all'}}}]}",
			&logged, &model),
		0);
	assert_contains(logged.sentence[0], "transmissionFactor");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_glass_is_blended_with_what_is_behind),
		cmocka_unit_test(test_glass_that_is_opaque_counts_as_whole),
		cmocka_unit_test(test_what_lets_no_light_through_stays_opaque),
		cmocka_unit_test(
			test_glass_does_not_take_the_alpha_of_an_opaque_texture),
		cmocka_unit_test(test_refuses_a_transmission_that_is_no_number),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
