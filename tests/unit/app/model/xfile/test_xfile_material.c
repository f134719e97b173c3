/* What materials and skins of .x files become in glTF's terms. */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HEADER  "xof 0303txt 0032\n"
#define CORNERS "4; 0;0;0;, 1;0;0;, 0;1;0;, 1;1;0;; "
#define FACE    CORNERS "2; 3;0,1,2;, 3;1,2,3;; "
#define UNIT    "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;; "
#define MOVED   "1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1;; "

static struct model *load(const char *text, struct log_capture *logged)
{
	struct log log = log_capture_begin(logged);
	struct model *model = NULL;

	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	return model;
}

/* The fourth root of 2 / (power + 2), if any colour shines. */
static void test_the_power_of_a_highlight_becomes_roughness(void **state)
{
	static const struct {
		const char *power, *shine;
		double roughness;
	} cases[] = {
		{"30", "1;0;0", 0.5},
		{"30", "0;0.1;0", 0.5},
		{"30", "0;0;1", 0.5},
		{"30", "0;0;0", 1},
		{"160", "1;1;1", 1.0 / 3},
		{"0", "1;1;1", 1},
		{"-1", "1;1;1", 1},
		{"0.5", "1;1;1", 0.945742},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct model *model;
		char text[200];

		snprintf(text, sizeof(text),
			HEADER "Material { 1;1;1;1;; %s; %s;; 0;0;0;; }",
			cases[i].power, cases[i].shine);
		model = load(text, &logged);
		assert_near(
			model->material[0].roughness, cases[i].roughness, 1e-5);
		model_destroy(model);
	}
}

/* What a file cannot say is as in glTF. */
static void test_other_members_of_materials_are_plain(void **state)
{
	static const float colour[] = {1, 0, 0.2140411f};
	struct log_capture logged;
	struct model *model =
		load(HEADER "Material Paint { 1;0;0.5;1;; 0; 0;0;0;; 0;0;0;; }",
			&logged);
	const struct model_material *material = &model->material[0];

	(void)state;
	assert_int_equal(model->material_count, 1);
	assert_string_equal(material->name, "Paint");
	assert_all_near(material->base_color, colour, 3, 1e-6);
	assert_int_equal(material->texture, -1);
	assert_int_equal(material->normal_texture, -1);
	assert_int_equal(material->emissive_texture, -1);
	assert_near(material->alpha_cutoff, 0.5, 0);
	assert_int_equal(material->alpha, MODEL_OPAQUE);
	model_destroy(model);
}

static void test_alpha_below_one_blends(void **state)
{
	static const struct {
		const char *alpha;
		float value;
		enum model_alpha kind;
	} cases[] = {{"2", 1, MODEL_OPAQUE}, {"1", 1, MODEL_OPAQUE},
		{"0.75", 0.75f, MODEL_BLEND}, {"0", 0, MODEL_BLEND},
		{"-2", 0, MODEL_BLEND}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct model *model;
		char text[200];

		snprintf(text, sizeof(text),
			HEADER "Material { 1;1;1;%s;; 0; 0;0;0;; 0;0;0;; }",
			cases[i].alpha);
		model = load(text, &logged);
		assert_near(model->material[0].base_color[3], cases[i].value, 0);
		assert_int_equal(model->material[0].alpha, cases[i].kind);
		model_destroy(model);
	}
}

#define PAINTED                                                          \
	HEADER "Material { 1;1;1;1;; 0; 0;0;0;; 0;0;0;; TextureFilename" \
	       " { \"%s\"; } }"

/* Paths stay below the model's folder, or the name alone counts. */
static void test_paths_of_textures_are_cleaned(void **state)
{
	static const struct {
		const char *written, *cleaned;
	} cases[] = {
		{"a.png", " a.png"},
		{"sub/a.png", " sub/a.png"},
		{"sub\\a.png", " sub/a.png"},
		{"sub\\\\deep\\\\a.png", " sub/deep/a.png"},
		{"sub//a.png", " sub/a.png"},
		{"/home/a.png", " a.png"},
		{"C:\\\\old\\\\a.png", " a.png"},
		{"..\\a.png", " a.png"},
		{"sub/../../a.png", " a.png"},
	};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "m.x");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model;
		char text[300];

		snprintf(text, sizeof(text), PAINTED, cases[i].written);
		file_write(path.text, text, strlen(text));
		assert_int_equal(model_load(path.text, &log, &model), 0);
		assert_int_equal(logged.count, 1);
		assert_int_equal(logged.level[0], LOG_WARNING);
		assert_contains(logged.sentence[0], cases[i].cleaned);
		assert_int_equal(model->texture_count, 0);
		assert_int_equal(model->material[0].texture, -1);
		model_destroy(model);
	}
	temp_dir_remove(&folder);
}

/* The picture has a pixel of alpha 128. */
static void test_a_texture_with_alpha_masks(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "m.x");
	struct test_path picture =
		fixture_path("gltf/material/parts/two by two.png");
	struct log log = log_to_stderr(LOG_WARNING);
	struct model *model;
	size_t size;
	char *data = file_read(picture.text, &size);
	char text[300];

	(void)state;
	file_write(path_join(&folder, "a.png").text, data, size);
	free(data);
	snprintf(text, sizeof(text), PAINTED, "a.png");
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &log, &model), 0);
	assert_int_equal(model->material[0].texture, 0);
	assert_int_equal(model->material[0].emissive_texture, 0);
	assert_int_equal(model->material[0].alpha, MODEL_MASK);
	assert_string_equal(model->image[0].name, "a.png");
	assert_true(model->texture[0].mipmap);
	model_destroy(model);
	temp_dir_remove(&folder);
}

/* Vertex 3 has no weight: it moves with the mesh, an added joint at rest. */
static void test_vertices_without_a_bone_follow_the_mesh(void **state)
{
	static const struct {
		const char *weights;
		int joints;
	} cases[] = {{"4; 0,1,2,3; 1,1,1,1; ", 1}, {"3; 0,1,2; 1,1,1; ", 2},
		{"4; 0,1,2,3; 1,1,1,0; ", 2}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		const struct model_primitive *primitive;
		const struct model_skin *skin;
		struct model *model;
		char text[500];

		snprintf(text, sizeof(text),
			HEADER "Frame A { } Frame B { Mesh M { " FACE
			       "SkinWeights { \"A\"; %s" MOVED "} } }",
			cases[i].weights);
		model = load(text, &logged);
		assert_int_equal(logged.count, 0);
		assert_int_equal(model->skin_count, 1);
		skin = &model->skin[0];
		assert_string_equal(skin->name, "M");
		assert_int_equal(skin->joint_count, cases[i].joints);
		assert_int_equal(skin->joint[0], 0);
		assert_near(skin->inverse_bind[0][3][0], 5, 0);
		assert_near(skin->inverse_bind[0][3][2], -7, 0);
		if (cases[i].joints == 2) {
			assert_int_equal(skin->joint[1], 1);
			for (int n = 0; n < 16; n++) {
				assert_near(skin->inverse_bind[1][n / 4][n % 4],
					n % 5 == 0, 0);
			}
		}
		primitive = &model->mesh[0].primitive[0];
		assert_int_equal(primitive->influences, 4);
		for (int v = 0; v < 4; v++) {
			const float *at = primitive->position[v];
			bool last = at[0] + at[1] == 2;

			assert_int_equal(primitive->joint[4 * v],
				last ? cases[i].joints - 1 : 0);
			assert_near(primitive->weight[4 * v], 1, 0);
		}
		model_destroy(model);
	}
}

/* Of equal weights, the first eight count. */
static void test_the_first_of_equal_weights_count(void **state)
{
	struct log_capture logged;
	char text[6000] = HEADER;
	struct model *model;

	(void)state;
	for (int b = 0; b < 10; b++) {
		snprintf(text + strlen(text), 100, "Frame B%d { } ", b);
	}
	strcat(text, "Mesh M { " FACE);
	for (int b = 0; b < 10; b++) {
		snprintf(text + strlen(text), 300,
			"SkinWeights { \"B%d\"; 4; 0,1,2,3; 0.1,0.1,0.1,0.1; %s} ",
			b, UNIT);
	}
	strcat(text, "}");
	model = load(text, &logged);
	assert_int_equal(model->mesh[0].primitive[0].influences, 8);
	assert_int_equal(model->skin[0].joint_count, 10);
	for (int i = 0; i < 32; i++) {
		assert_int_equal(model->mesh[0].primitive[0].joint[i], i % 8);
		assert_near(model->mesh[0].primitive[0].weight[i], 0.125, 1e-6);
	}
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0],
		"more than 8 bones; limber drops the 8 smallest weights");
	model_destroy(model);
}

/* Five bones already take eight influences. */
static void test_five_bones_take_eight_influences(void **state)
{
	(void)state;
	for (int bones = 4; bones <= 5; bones++) {
		struct log_capture logged;
		char text[3000] = HEADER;
		struct model *model;

		for (int b = 0; b < bones; b++) {
			snprintf(text + strlen(text), 100, "Frame B%d { } ", b);
		}
		strcat(text, "Mesh M { " FACE);
		for (int b = 0; b < bones; b++) {
			snprintf(text + strlen(text), 300,
				"SkinWeights { \"B%d\"; 4; 0,1,2,3; %d,0,0,0; %s} ",
				b, b + 1, UNIT);
		}
		strcat(text, "}");
		model = load(text, &logged);
		assert_int_equal(model->mesh[0].primitive[0].influences,
			bones == 5 ? 8 : 4);
		/* The largest weight comes first. */
		assert_int_equal(
			model->mesh[0].primitive[0].joint[0], bones - 1);
		assert_near(model->mesh[0].primitive[0].weight[0],
			bones == 5 ? 5 / 15.0 : 4 / 10.0, 1e-6);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_power_of_a_highlight_becomes_roughness),
		cmocka_unit_test(test_other_members_of_materials_are_plain),
		cmocka_unit_test(test_alpha_below_one_blends),
		cmocka_unit_test(test_paths_of_textures_are_cleaned),
		cmocka_unit_test(test_a_texture_with_alpha_masks),
		cmocka_unit_test(test_vertices_without_a_bone_follow_the_mesh),
		cmocka_unit_test(test_the_first_of_equal_weights_count),
		cmocka_unit_test(test_five_bones_take_eight_influences),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
