#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <cglm/quat.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HEADER "xof 0303txt 0032\n"

/* A frame rotated by +30 degrees about Y: left-handed, row vectors. */
#define TURNED                                                                 \
	"FrameTransformMatrix { 0.866025,0,-0.5,0, 0,1,0,0, 0.5,0,0.866025,0," \
	" 1,2,3,1;; }\n"

#define QUAD "Mesh Quad { 4; 0;0;0;, 1;0;0;, 1;1;0;, 0;1;0;; 1; 4;0,3,2,1;;\n"

static struct model *load(const char *text, struct log_capture *logged)
{
	struct log log = log_capture_begin(logged);
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

static void test_vertices_become_right_handed(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER "Mesh T { 3; 1;2;3;, 4;5;6;, "
					  "7;8;10;; 1; 3;0,1,2;; }",
		&logged);
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
	/* Negating z reverses the winding, so the loader reverses the order. */
	assert_near(primitive->position[primitive->index[(first + 1) % 3]][0],
		7, 0);
	model_destroy(model);
}

static void test_a_frame_rotates_as_in_direct3d(void **state)
{
	struct log_capture logged;
	struct model *model =
		load(HEADER "Frame Root {\n" TURNED QUAD "} }", &logged);
	int node = model_find_node(model, "Root");
	const struct transform *rest = &model->node[node].rest;
	const float moved[3] = {1, 2, -3};

	(void)state;
	/* +30 degrees about Y become -30: q = (0, -sin 15, 0, cos 15). */
	assert_all_near(rest->translation, moved, 3, 1e-6);
	assert_near(rest->rotation[1] / rest->rotation[3], -0.267949, 1e-5);
	assert_near(rest->rotation[0], 0, 1e-6);
	assert_near(rest->scale[0], 1, 1e-5);
	model_destroy(model);
}

static void test_polygons_become_triangles(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER QUAD "}", &logged);

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

static void test_the_tick_rate_is_4800_unless_given(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER KEYS, &logged);

	(void)state;
	assert_near(model->clip[0].duration_s, 0.01, 1e-7);
	model_destroy(model);
	/* It looks as if frames were counted. */
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"the longest animation takes 0.01 s, as a second has 4800 ticks in a file without AnimTicksPerSecond"));
	model = load(HEADER "AnimTicksPerSecond { 4800; }\n" KEYS, &logged);
	assert_int_equal(logged.count, 0);
	model_destroy(model);
	model = load(HEADER "AnimTicksPerSecond { 24; }\n" KEYS, &logged);
	assert_near(model->clip[0].duration_s, 2.0, 1e-6);
	model_destroy(model);
}

static void test_position_keys_are_converted(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER KEYS, &logged);
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

static void test_matrix_keys_are_decomposed(void **state)
{
	struct log_capture logged;
	/* A scale of 2 and a translation. */
	struct model *model = load(HEADER
		"Frame Bone { FrameTransformMatrix { 1,0,0,0,0,1,0,0,"
		"0,0,1,0,0,0,0,1;; } }\nAnimationSet Move { Animation { "
		"{ Bone } AnimationKey { 4; 1; 0;16;2,0,0,0,0,2,0,0,"
		"0,0,2,0,1,2,3,1;;; } } }",
		&logged);
	const struct model_channel *moved =
		find_channel(model, MODEL_TRANSLATION);
	const struct model_channel *scaled = find_channel(model, MODEL_SCALE);
	const float offset[3] = {1, 2, -3}, size[3] = {2, 2, 2};

	(void)state;
	assert_non_null(moved);
	assert_non_null(scaled);
	assert_all_near(moved->value, offset, 3, 1e-6);
	assert_all_near(scaled->value, size, 3, 1e-6);
	model_destroy(model);
}

static void test_influences_come_from_skin_weights(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame Bone { FrameTransformMatrix { 1,0,0,0,0,1,0,0,0,0,1,0,"
		"0,0,0,1;; }\n" QUAD "XSkinMeshHeader { 1; 1; 1; } "
		"SkinWeights { \"Bone\"; 2; 0,1; 0.5,1.0; "
		"1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1;; } } }",
		&logged);
	const struct model_skin *skin = &model->skin[0];
	const float offset[3] = {1, 2, -3};

	(void)state;
	assert_int_equal(model->skin_count, 1);
	assert_string_equal(model->node[skin->joint[0]].name, "Bone");
	assert_all_near(skin->inverse_bind[0][3], offset, 3, 1e-6);
	assert_int_equal(model->mesh[0].primitive[0].influences, 4);
	/* A single influence becomes 1, whatever its weight. */
	assert_near(model->mesh[0].primitive[0].weight[0], 1, 1e-6);
	model_destroy(model);
}

static void test_reads_the_light_that_a_material_emits(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER QUAD
		"MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;; 1; 0;0;0;; "
		"0.5;1;0;; } } }",
		&logged);
	const struct model_material *lamp =
		&model->material[model->mesh[0].primitive[0].material];

	(void)state;
	/* sRGB 0.5 in linear light. */
	assert_near(lamp->emissive[0], 0.2140411, 1e-5);
	assert_near(lamp->emissive[1], 1, 0);
	assert_near(lamp->emissive[2], 0, 0);
	/* Direct3D multiplies it by the surface's texture; there is none. */
	assert_int_equal(lamp->emissive_texture, lamp->texture);
	model_destroy(model);
}

static void test_a_missing_texture_only_causes_a_warning(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER QUAD
		"MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;; 1; 0;0;0;; "
		"0;0;0;; TextureFilename { \"nowhere.bmp\"; } } } }",
		&logged);

	(void)state;
	assert_int_equal(log_capture_count(&logged, LOG_WARNING), 1);
	assert_true(log_capture_has(&logged, LOG_WARNING, "texture"));
	assert_near(model->material[model->mesh[0].primitive[0].material]
			    .base_color[1],
		0, 0);
	model_destroy(model);
}

static void test_malformed_files_cause_one_error(void **state)
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
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = NULL;

		assert_true(model_load_memory(broken[i], strlen(broken[i]),
				    "test.x", &log, &model) < 0);
		assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
		assert_true(log_capture_has(&logged, LOG_ERROR, "test.x: "));
	}
}

#define UNIT "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;; "
#define FACE "3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,1,2;; "

/* D3DXMatrixRotationY(+30 degrees) takes (1 0 0) to (cos 30, 0, -sin 30). */
static void test_a_rotation_key_rotates_as_in_direct3d(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame Bone { }\nAnimationSet Turn { Animation { { Bone } "
		"AnimationKey { 0; 1; 0;4;0.9659258,0,-0.2588190,0;;; } } }",
		&logged);
	const float expected[3] = {0.8660254f, 0, 0.5f};
	vec3 point = {1, 0, 0};
	versor turn;

	(void)state;
	memcpy(turn, model->clip[0].channel[0].value, sizeof(turn));
	glm_quat_rotatev(turn, point, point);
	assert_all_near(point, expected, 3, 1e-6);
	model_destroy(model);
}

static void test_vertices_are_split_where_normals_differ(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Mesh T { 4; 0;0;0;, 1;0;0;, 1;1;0;, 0;1;0;; "
		"2; 3;0,1,2;, 3;0,2,3;; "
		"MeshNormals { 2; 0;0;-1;, 0;1;0;; 2; 3;0,0,0;, 3;1,0,0;; } }",
		&logged);
	const struct model_primitive *primitive = model->mesh[0].primitive;

	(void)state;
	assert_int_equal(primitive->vertex_count, 5);
	assert_near(primitive->normal[primitive->index[0]][2], 1, 0);
	assert_near(primitive->normal[primitive->index[3]][1], 1, 0);
	model_destroy(model);
}

static void test_the_eight_largest_of_ten_weights_are_kept(void **state)
{
	char text[4096] = HEADER "Frame B { } Mesh T { " FACE;
	struct log_capture logged;
	struct model *model;
	const struct model_primitive *primitive;

	(void)state;
	for (int i = 1; i <= 10; i++) {
		size_t used = strlen(text);

		snprintf(text + used, sizeof(text) - used,
			"SkinWeights { \"B\"; 1; 0; %d; " UNIT "}\n", i);
	}
	strcat(text, "}");
	model = load(text, &logged);
	primitive = model->mesh[0].primitive;
	assert_int_equal(primitive->influences, 8);
	assert_int_equal(primitive->joint[0], 9);
	assert_near(primitive->weight[0], 10.0 / 52, 1e-6);
	assert_int_equal(primitive->joint[7], 2);
	assert_near(primitive->weight[7], 3.0 / 52, 1e-6);
	model_destroy(model);
}

static void test_a_bone_without_a_frame_only_causes_a_warning(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame F { Mesh T { " FACE
		"SkinWeights { \"Gone\"; 3; 0,1,2; 1,1,1; " UNIT "} } }",
		&logged);

	(void)state;
	assert_true(log_capture_has(&logged, LOG_WARNING, "\"Gone\""));
	assert_int_equal(model->skin[0].joint[0], model_find_node(model, "F"));
	model_destroy(model);
}

/* The node that draws the mesh of that name. */
static int find_drawing_node(const struct model *model, const char *mesh)
{
	for (int i = 0; i < model->node_count; i++) {
		int drawn = model->node[i].mesh;

		if (drawn >= 0 && strcmp(model->mesh[drawn].name, mesh) == 0) {
			return i;
		}
	}
	return -1;
}

/* One mesh is drawn by the frame's own node, the others by nodes below it. */
static void test_meshes_may_share_a_frame_or_have_none(void **state)
{
	static const char *const below[] = {"A", "B", "C"};
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame F { Mesh A { " FACE "} Mesh B { " FACE
		"} { C } { Nobody } }\nMesh C { " FACE "}\nMesh D { " FACE "}",
		&logged);
	int frame = model_find_node(model, "F");
	int drawn = 0;

	(void)state;
	for (int i = 0; i < model->node_count; i++) {
		drawn += model->node[i].mesh >= 0;
		assert_true(model->node[i].parent < i);
	}
	assert_int_equal(drawn, 4);
	assert_int_equal(model->node_count, 4);
	assert_true(frame >= 0);
	for (int i = 0; i < 3; i++) {
		int node = find_drawing_node(model, below[i]);

		assert_true(node >= 0);
		assert_true(node == frame || model->node[node].parent == frame);
	}
	assert_true(find_drawing_node(model, "D") >= 0);
	assert_int_equal(model->node[find_drawing_node(model, "D")].parent, -1);
	assert_true(log_capture_has(&logged, LOG_WARNING, "\"Nobody\""));
	model_destroy(model);
}

static void test_a_sheared_frame_keeps_its_matrix(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame F { FrameTransformMatrix { 1,0,0,0, 1,1,0,0, 0,0,1,0, "
		"0,0,0,1;; } }",
		&logged);

	(void)state;
	assert_non_null(model->node[0].matrix);
	assert_near(model->node[0].matrix[1][0], 1, 0);
	model_destroy(model);
}

#define TEXTURED(name)                                                   \
	HEADER "Mesh T { " FACE "MeshMaterialList { 1; 1; 0; Material {" \
	       "1;1;1;1;; 0; 0;0;0;; 0;0;0;; TextureFilename { \"" name  \
	       "\"; } } } }"

/* Of a path that leads outside the folder, only the file name counts. */
static void test_textures_come_from_the_models_folder_only(void **state)
{
	static const char inside[] = TEXTURED("C:\\\\old\\\\two by two.png");
	static const char outside[] = TEXTURED("..\\\\secret.png");
	struct test_path folder = temp_dir_make();
	struct test_path model_path = path_join(&folder, "sub-model.x");
	struct test_path beside = path_join(&folder, "two by two.png");
	struct test_path picture =
		fixture_path("gltf/material/parts/two by two.png");
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;
	size_t size;
	char *data = file_read(picture.text, &size);

	(void)state;
	file_write(beside.text, data, size);
	free(data);
	file_write(model_path.text, inside, sizeof(inside) - 1);
	assert_int_equal(model_load(model_path.text, &log, &model), 0);
	assert_int_equal(model->texture_count, 1);
	assert_int_equal(model->image[0].width, 2);
	model_destroy(model);
	file_write(model_path.text, outside, sizeof(outside) - 1);
	assert_int_equal(model_load(model_path.text, &log, &model), 0);
	assert_int_equal(model->texture_count, 0);
	assert_int_equal(log_capture_count(&logged, LOG_WARNING), 1);
	model_destroy(model);
	temp_dir_remove(&folder);
}

static void test_frames_nested_too_deep_are_an_error(void **state)
{
	enum {
		DEEP = 5000
	};
	static char text[20 + 6 * DEEP] = HEADER;
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;
	size_t used = strlen(text);

	(void)state;
	for (int i = 0; i < DEEP; i++) {
		memcpy(text + used, "Frame{", 6);
		used += 6;
	}
	assert_int_equal(
		model_load_memory(text, used, "deep.x", &log, &model), -EINVAL);
	assert_true(log_capture_has(&logged, LOG_ERROR, "deep.x: line 2"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vertices_become_right_handed),
		cmocka_unit_test(test_a_frame_rotates_as_in_direct3d),
		cmocka_unit_test(test_polygons_become_triangles),
		cmocka_unit_test(test_the_tick_rate_is_4800_unless_given),
		cmocka_unit_test(test_position_keys_are_converted),
		cmocka_unit_test(test_matrix_keys_are_decomposed),
		cmocka_unit_test(test_influences_come_from_skin_weights),
		cmocka_unit_test(test_reads_the_light_that_a_material_emits),
		cmocka_unit_test(test_a_missing_texture_only_causes_a_warning),
		cmocka_unit_test(test_malformed_files_cause_one_error),
		cmocka_unit_test(test_a_rotation_key_rotates_as_in_direct3d),
		cmocka_unit_test(test_vertices_are_split_where_normals_differ),
		cmocka_unit_test(test_the_eight_largest_of_ten_weights_are_kept),
		cmocka_unit_test(
			test_a_bone_without_a_frame_only_causes_a_warning),
		cmocka_unit_test(test_meshes_may_share_a_frame_or_have_none),
		cmocka_unit_test(test_a_sheared_frame_keeps_its_matrix),
		cmocka_unit_test(test_textures_come_from_the_models_folder_only),
		cmocka_unit_test(test_frames_nested_too_deep_are_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
