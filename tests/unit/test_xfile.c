#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define HEADER "xof 0303txt 0032\n"

/* A frame turned by +30 degrees about Y as Direct3D does it: rows, left. */
#define TURNED                                                                 \
	"FrameTransformMatrix { 0.866025,0,-0.5,0, 0,1,0,0, 0.5,0,0.866025,0," \
	" 1,2,3,1;; }\n"

#define QUAD "Mesh Quad { 4; 0;0;0;, 1;0;0;, 1;1;0;, 0;1;0;; 1; 4;0,3,2,1;;\n"

static struct model *load(const char *text, struct log_capture *said)
{
	struct log log = log_capture_begin(said);
	struct model *model = NULL;

	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	return model;
}

static const float *vertex(const struct model *model, int index)
{
	return model->mesh[0].primitive[0].position[index];
}

static void test_vertices_go_from_left_to_right_handed(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER "Mesh T { 3; 1;2;3;, 4;5;6;, "
					  "7;8;10;; 1; 3;0,1,2;; }",
		&said);
	const struct model_primitive *primitive = model->mesh[0].primitive;
	const float expected[3] = {1, 2, -3};
	int first = -1;

	(void)state;
	assert_int_equal(primitive->index_count, 3);
	for (int i = 0; i < 3; i++) {
		if (primitive->position[primitive->index[i]][0] == 1) {
			first = i;
		}
	}
	assert_all_near(
		primitive->position[primitive->index[first]], expected, 3, 0);
	/* Mirroring turns the winding, so the order is turned back. */
	assert_near(primitive->position[primitive->index[(first + 1) % 3]][0],
		7, 0);
	model_destroy(model);
}

static void test_a_frame_turns_as_it_did_in_direct3d(void **state)
{
	struct log_capture said;
	struct model *model =
		load(HEADER "Frame Root {\n" TURNED QUAD "} }", &said);
	int node = model_find_node(model, "Root");
	const struct transform *rest = &model->node[node].rest;
	const float moved[3] = {1, 2, -3};

	(void)state;
	/* Left-handed +30 about Y is right-handed -30: q = (0 -s 0 c). */
	assert_all_near(rest->translation, moved, 3, 1e-6);
	assert_near(rest->rotation[1] / rest->rotation[3], -0.267949, 1e-5);
	assert_near(rest->rotation[0], 0, 1e-6);
	assert_near(rest->scale[0], 1, 1e-5);
	model_destroy(model);
}

static void test_polygons_become_fans(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER QUAD "}", &said);

	(void)state;
	assert_int_equal(model->mesh[0].primitive[0].index_count, 6);
	assert_int_equal(model->mesh[0].primitive[0].vertex_count, 4);
	assert_near(vertex(model, 0)[2], 0, 0);
	model_destroy(model);
}

#define KEYS                                                             \
	"Frame Bone { FrameTransformMatrix { 1,0,0,0,0,1,0,0,0,0,1,0,"   \
	"0,0,0,1;; } }\n"                                                \
	"AnimationSet Move { Animation { { Bone } AnimationKey { 2; 2; " \
	"0;3;0,0,0;;, 48;3;1,2,3;;; } } }"

static void test_pitfall_19_the_tick_rate_is_4800_unless_given(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER KEYS, &said);

	(void)state;
	assert_near(model->clip[0].duration_s, 0.01, 1e-7);
	model_destroy(model);
	model = load(HEADER "AnimTicksPerSecond { 24; }\n" KEYS, &said);
	assert_near(model->clip[0].duration_s, 2.0, 1e-6);
	model_destroy(model);
}

static void test_position_keys_are_converted(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER KEYS, &said);
	const struct model_channel *channel = &model->clip[0].channel[0];
	const float last[3] = {1, 2, -3};

	(void)state;
	assert_int_equal(channel->path, MODEL_TRANSLATION);
	assert_int_equal(channel->key_count, 2);
	assert_all_near(channel->value + 3, last, 3, 0);
	model_destroy(model);
}

static const struct model_channel *find_channel(
	const struct model *model, enum model_path path)
{
	const struct model_clip *clip = &model->clip[0];

	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path == path) {
			return &clip->channel[i];
		}
	}
	return NULL;
}

static void test_matrix_keys_are_taken_apart(void **state)
{
	struct log_capture said;
	/* Twice as large and moved. */
	struct model *model = load(HEADER
		"Frame Bone { FrameTransformMatrix { 1,0,0,0,0,1,0,0,"
		"0,0,1,0,0,0,0,1;; } }\nAnimationSet Move { Animation { "
		"{ Bone } AnimationKey { 4; 1; 0;16;2,0,0,0,0,2,0,0,"
		"0,0,2,0,1,2,3,1;;; } } }",
		&said);
	const struct model_channel *moved =
		find_channel(model, MODEL_TRANSLATION);
	const struct model_channel *scaled = find_channel(model, MODEL_SCALE);
	const float place[3] = {1, 2, -3}, size[3] = {2, 2, 2};

	(void)state;
	assert_non_null(moved);
	assert_non_null(scaled);
	assert_all_near(moved->value, place, 3, 1e-6);
	assert_all_near(scaled->value, size, 3, 1e-6);
	model_destroy(model);
}

static void test_influences_come_from_skin_weights(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER
		"Frame Bone { FrameTransformMatrix { 1,0,0,0,0,1,0,0,0,0,1,0,"
		"0,0,0,1;; }\n" QUAD "XSkinMeshHeader { 1; 1; 1; } "
		"SkinWeights { \"Bone\"; 2; 0,1; 0.5,1.0; "
		"1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1;; } } }",
		&said);
	const struct model_skin *skin = &model->skin[0];
	const float offset[3] = {1, 2, -3};

	(void)state;
	assert_int_equal(model->skin_count, 1);
	assert_string_equal(model->node[skin->joint[0]].name, "Bone");
	assert_all_near(skin->inverse_bind[0][3], offset, 3, 1e-6);
	assert_int_equal(model->mesh[0].primitive[0].influences, 4);
	/* A lone influence counts fully, whatever its weight. */
	assert_near(model->mesh[0].primitive[0].weight[0], 1, 1e-6);
	model_destroy(model);
}

static void test_a_missing_texture_costs_a_warning_only(void **state)
{
	struct log_capture said;
	struct model *model = load(HEADER QUAD
		"MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;; 1; 0;0;0;; "
		"0;0;0;; TextureFilename { \"nowhere.bmp\"; } } } }",
		&said);

	(void)state;
	assert_int_equal(log_capture_count(&said, LOG_WARNING), 1);
	assert_true(log_capture_has(&said, LOG_WARNING, "texture"));
	assert_near(model->material[model->mesh[0].primitive[0].material]
			    .base_color[1],
		0, 0);
	model_destroy(model);
}

static void test_malformed_files_get_one_sentence_with_the_line(void **state)
{
	static const char *const broken[] = {
		HEADER "Mesh T {",
		HEADER "Mesh T { 3; 1;2;",
		HEADER "Mesh T { 3; 1;2;3;, 4;5;6;, 7;8;9;; 1; 3;0,1,3;; }",
		HEADER "Mesh T { 3; 1;2;3;, 4;5;6;, 7;8;9;; 1; 3;0,1,-1;; }",
		HEADER "Mesh T { 4000000000; 1;2;3;; }",
		HEADER "Mesh T { 99999999; 1;2;3;; }",
		HEADER "Frame { Frame { Frame {",
		HEADER QUAD "XSkinMeshHeader { 1;1;1; } SkinWeights { \"B\"; "
			    "1; 9; 1.0; 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1;; } }",
		HEADER "\"unterminated",
		"xof 0303txt 0016\n",
		"xof 0909txt 0032\n",
		"xof 0303bzip0032",
		"xof 0303bin 0032\x01",
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(broken); i++) {
		struct log_capture said;
		struct log log = log_capture_begin(&said);
		struct model *model = NULL;

		assert_true(model_load_memory(broken[i], strlen(broken[i]),
				    "test.x", &log, &model) < 0);
		assert_int_equal(log_capture_count(&said, LOG_ERROR), 1);
		assert_true(log_capture_has(&said, LOG_ERROR, "test.x: "));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vertices_go_from_left_to_right_handed),
		cmocka_unit_test(test_a_frame_turns_as_it_did_in_direct3d),
		cmocka_unit_test(test_polygons_become_fans),
		cmocka_unit_test(
			test_pitfall_19_the_tick_rate_is_4800_unless_given),
		cmocka_unit_test(test_position_keys_are_converted),
		cmocka_unit_test(test_matrix_keys_are_taken_apart),
		cmocka_unit_test(test_influences_come_from_skin_weights),
		cmocka_unit_test(test_a_missing_texture_costs_a_warning_only),
		cmocka_unit_test(
			test_malformed_files_get_one_sentence_with_the_line),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
