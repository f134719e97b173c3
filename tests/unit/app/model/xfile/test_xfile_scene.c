/* Which nodes, meshes and clips the objects of an .x file become. */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

#define HEADER  "xof 0303txt 0032\n"
#define CORNERS "4; 0;0;0;, 1;0;0;, 0;1;0;, 1;1;0;; "
#define FACE    CORNERS "1; 3;0,1,2;; "
#define UNIT    "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;; "
#define SKIN    "SkinWeights { \"A\"; 3; 0,1,2; 1,1,1; " UNIT "} "

static struct model *load(const char *text, struct log_capture *logged)
{
	struct log log = log_capture_begin(logged);
	struct model *model = NULL;

	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	return model;
}

static void expect_refused(const char *text, size_t size, const char *reason)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	assert_true(model_load_memory(text, size, "test.x", &log, &model) < 0);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0], reason);
}

/* A frame draws its first mesh itself; other meshes get nodes that rest. */
static void test_meshes_that_share_a_frame_get_nodes_at_rest(void **state)
{
	static const float none[3] = {0, 0, 0}, turn[4] = {0, 0, 0, 1};
	static const float ones[3] = {1, 1, 1};
	static const char *const names[] = {"A", "N", "L"};
	static const int parents[] = {-1, 0, -1};
	struct log_capture logged;
	struct model *model =
		load(HEADER "Frame A { Mesh M { " FACE "} Mesh N { " FACE SKIN
			    "} } Mesh L { " FACE "} ",
			&logged);

	(void)state;
	assert_int_equal(model->node_count, 3);
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		assert_string_equal(node->name, names[i]);
		assert_int_equal(node->parent, parents[i]);
		assert_int_equal(node->mesh, i);
		assert_int_equal(node->skin, i == 1 ? 0 : -1);
		assert_int_equal(node->camera, -1);
		assert_true(node->in_scene);
		assert_null(node->matrix);
		assert_all_near(node->rest.translation, none, 3, 0);
		assert_all_near(node->rest.rotation, turn, 4, 0);
		assert_all_near(node->rest.scale, ones, 3, 0);
	}
	model_destroy(model);
}

/* It is read once, even if the first of its frames is node 0. */
static void test_frames_that_refer_to_a_mesh_share_it(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Mesh M { " FACE SKIN "} Frame A { { M } } Frame B { { M } }"
		"Frame C { { M } }",
		&logged);

	(void)state;
	assert_int_equal(logged.count, 0);
	assert_int_equal(model->mesh_count, 1);
	assert_int_equal(model->skin_count, 1);
	assert_int_equal(model->node_count, 3);
	for (int i = 0; i < model->node_count; i++) {
		assert_int_equal(model->node[i].mesh, 0);
		assert_int_equal(model->node[i].skin, 0);
	}
	model_destroy(model);
}

/* The frame in which it stands draws it, too, even if this is node 0. */
static void test_a_mesh_of_a_frame_may_be_drawn_by_another(void **state)
{
	struct log_capture logged;
	struct model *model =
		load(HEADER "Frame A { Mesh M { " FACE "} } Frame B { { M } }",
			&logged);

	(void)state;
	assert_int_equal(model->mesh_count, 1);
	assert_int_equal(model->node_count, 2);
	assert_int_equal(model->node[0].mesh, 0);
	assert_int_equal(model->node[1].mesh, 0);
	model_destroy(model);
}

#define PAINT "Material { 1;1;1;1;; 1; 0;0;0;; 0;0;0;; } "

/* Each corner belongs to the primitive of its face's material. */
static void test_materials_divide_a_mesh(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Mesh M { " CORNERS "4; 3;0,1,2;, 3;3,2,1;, 3;0,1,3;, "
		"3;0,3,2;; MeshMaterialList { 3; 4; 2, 0, 1, 2; " PAINT PAINT PAINT
		"} }",
		&logged);
	const struct model_mesh *mesh = &model->mesh[0];

	(void)state;
	assert_int_equal(mesh->primitive_count, 3);
	for (int p = 0; p < 3; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		assert_int_equal(primitive->file_index, p);
		assert_int_equal(primitive->material, p);
		assert_int_equal(primitive->vertex_count, p == 2 ? 4 : 3);
		assert_int_equal(primitive->index_count, p == 2 ? 6 : 3);
	}
	model_destroy(model);
}

/* Objects without a name have an empty one, whatever was read before. */
static void test_objects_without_a_name_have_an_empty_one(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER "Frame Bone { Frame { Mesh { " FACE
					  "} } Frame Long { Mesh Last { " FACE
					  "} } Frame { } }",
		&logged);

	(void)state;
	assert_int_equal(model->node_count, 4);
	assert_string_equal(model->node[1].name, "");
	assert_string_equal(model->node[2].name, "Long");
	assert_string_equal(model->node[3].name, "");
	assert_string_equal(model->mesh[0].name, "");
	assert_string_equal(model->mesh[1].name, "Last");
	model_destroy(model);
}

static void test_an_error_describes_what_stands_there_instead(void **state)
{
	static const struct {
		const char *found, *told;
	} cases[] = {
		{"word", "but there is \"word\""},
		{"\"two words\"", "but there is \"two words\""},
		{"\"\"", "but there is \"\""},
		/* Neither control characters nor other bytes get out. */
		{"\"\x1f ~\x7f\xc3\x1b\"", "but there is \"? ~???\""},
		/* At most 32 bytes of it. */
		{"\"abcdefghijklmnopqrstuvwxyz012345\"",
			"but there is \"abcdefghijklmnopqrstuvwxyz012345\""},
		{"\"abcdefghijklmnopqrstuvwxyz0123456\"",
			"but there is \"abcdefghijklmnopqrstuvwxyz012345\""},
		{"<123>", "but there is a GUID"},
		{"{", "but there is an opening brace"},
		{"}", "but there is a closing brace"},
		{"[", "but there is a punctuation mark"},
		{"", "but the file ends"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[200];

		snprintf(text, sizeof(text),
			HEADER "Frame F { FrameTransformMatrix {\n1, %s",
			cases[i].found);
		expect_refused(text, strlen(text), cases[i].told);
	}
	expect_refused(HEADER "-1.5", sizeof(HEADER) + 3, "but there is -1.5");
}

/* Half turns about x, y and z; the last one goes the other way round. */
static void test_rotation_keys_keep_their_order(void **state)
{
	static const float turns[3][4] = {
		{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}};
	struct log_capture logged;
	struct model *model = load(HEADER
		"AnimTicksPerSecond { 1; } Frame A { } AnimationSet S { "
		"Animation { { A } AnimationKey { 0; 3; 0;4;0,1,0,0;;, "
		"1;4;0,0,1,0;;, 2;4;0,0,0,1;;; } } }",
		&logged);
	const struct model_channel *channel = &model->clip[0].channel[0];

	(void)state;
	assert_int_equal(channel->path, MODEL_ROTATION);
	assert_int_equal(channel->width, 4);
	for (int k = 0; k < 3; k++) {
		assert_all_near(channel->value + 4 * k, turns[k], 4, 1e-6);
	}
	model_destroy(model);
}

static void test_numbers_are_1e9_at_most(void **state)
{
	static const char *const numbers[] = {
		"1e9", "-1e9", "1000000001", "-1000000001"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(numbers); i++) {
		struct log_capture logged;
		struct model *model;
		char text[200];

		snprintf(text, sizeof(text),
			HEADER "Mesh M { 3; 0;0;0;, %s;0;0;, 0;1;0;; 1; "
			       "3;0,1,2;; }",
			numbers[i]);
		if (i < 2) {
			model = load(text, &logged);
			assert_int_equal(model->mesh_count, 1);
			model_destroy(model);
		} else {
			expect_refused(text, strlen(text), "is larger than 1e9");
		}
	}
}

static void test_scale_keys_keep_their_values(void **state)
{
	static const float scales[2][3] = {{2, 3, 4}, {5, 6, 7}};
	struct log_capture logged;
	struct model *model = load(HEADER
		"AnimTicksPerSecond { 1; } Frame A { } AnimationSet S { "
		"Animation { { A } AnimationKey { 1; 2; 0;3;2,3,4;;, "
		"1;3;5,6,7;;; } } }",
		&logged);
	const struct model_channel *channel = &model->clip[0].channel[0];

	(void)state;
	assert_int_equal(channel->path, MODEL_SCALE);
	assert_int_equal(channel->width, 3);
	assert_int_equal(channel->key_count, 2);
	for (int k = 0; k < 2; k++) {
		assert_all_near(channel->value + 3 * k, scales[k], 3, 0);
	}
	model_destroy(model);
}

#define MOVE(time)                                      \
	HEADER "AnimTicksPerSecond { 1; } Frame A { } " \
	       "AnimationSet S { Animation { { A } "    \
	       "AnimationKey { 2; 1; " time ";3;1,2,3;;; } } }"

/* Floats are 64 apart behind 1e9. */
static void test_keys_lie_at_1e9_seconds_at_most(void **state)
{
	static const char late[] = MOVE("1000000064");
	struct log_capture logged;
	struct model *model = load(MOVE("1000000000"), &logged);

	(void)state;
	assert_near(model->clip[0].duration_s, 1e9, 0);
	model_destroy(model);
	expect_refused(late, sizeof(late) - 1,
		"the time of an animation key is beyond 1e9 s");
}

static void test_an_animation_without_a_frame_moves_nothing(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame A { } AnimationSet S { Animation { AnimationKey { 2; 1; "
		"4800;3;1,2,3;;; } } Animation { { B } AnimationKey { 2; 1; "
		"4800;3;1,2,3;;; } } }",
		&logged);

	(void)state;
	assert_int_equal(model->clip_count, 0);
	assert_int_equal(logged.count, 3);
	assert_contains(logged.sentence[0], "does not name a frame");
	assert_contains(logged.sentence[1], "\"B\", which does not exist");
	assert_contains(logged.sentence[2], "moves no frame");
	model_destroy(model);
}

/* The numbers of matrices: how they end, and how many digits count. */
static void test_numbers_end_where_another_token_begins(void **state)
{
	static const char *const ends[] = {"{", "}", "<", ">", "[", "]", "(",
		")", "\"", " ", ";", ",", "\t", "\n", "\r", "//\n", "#\n", "\1"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(ends); i++) {
		char text[200];
		bool comment = ends[i][1] == '/', hash = ends[i][0] == '#';

		snprintf(text, sizeof(text),
			HEADER "Frame F { FrameTransformMatrix { 1%s x",
			ends[i]);
		if (hash) {
			/* A word goes on with it. */
			expect_refused(
				text, strlen(text), "but there is \"1#\"");
		} else if (comment || ends[i][0] <= ' ' ||
			strchr(";,", ends[i][0])) {
			expect_refused(text, strlen(text), "but there is \"x\"");
		} else if (strchr("<\"", ends[i][0])) {
			expect_refused(text, strlen(text),
				"the file ends before the closing ");
		} else {
			expect_refused(text, strlen(text),
				strchr("{", ends[i][0])
					? "but there is an opening brace"
					: strchr("}", ends[i][0])
					? "but there is a closing brace"
					: "but there is a punctuation mark");
		}
	}
}

/* A few more elements than the shortest that would fit. */
static void test_counts_that_do_not_fit_into_the_file_are_refused(void **state)
{
	static const struct {
		const char *before, *element;
	} cases[] = {
		{HEADER "Mesh T{" CORNERS "93;", "0;"},
		{HEADER "Mesh T{" CORNERS "1;93;", "0;"},
		{HEADER "Mesh T{93;", "0;0;0;"},
		{HEADER "Mesh T{" FACE "MeshNormals{93;", "0;0;0;"},
		{HEADER "Mesh T{" FACE "MeshTextureCoords{93;", "0;0;"},
		{HEADER "Mesh T{" FACE "MeshVertexColors{93;", "0;0;0;0;0;"},
		{HEADER "Mesh T{" FACE "SkinWeights{\"A\";93;", "0;0;"},
		{HEADER "Frame A{}AnimationSet S{Animation{{A}AnimationKey{2;"
			"93;",
			"0;3;0;0;0;"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[2000];

		strcpy(text, cases[i].before);
		for (int n = 0; n < 90; n++) {
			strcat(text, cases[i].element);
		}
		expect_refused(text, strlen(text),
			"is 93, which is more than the rest of the file can hold");
	}
}

/* A binary mesh of no vertices whose faces have no corners. */
static size_t write_faces(uint8_t *at, int written, int told)
{
	static const uint8_t head[] = "xof 0303bin 0032\1\0\4\0\0\0Mesh\12\0\6";
	uint8_t *begin = at;

	memcpy(at, head, sizeof(head));
	at += sizeof(head);
	memset(at, 0, 12 + 4 * (size_t)written);
	at[0] = (uint8_t)(written + 2);
	at[8] = (uint8_t)told;
	at += 12 + 4 * written;
	*at++ = 11;
	*at++ = 0;
	return (size_t)(at - begin);
}

static void test_the_numbers_of_a_binary_file_take_four_bytes(void **state)
{
	uint8_t text[600];
	size_t size = write_faces(text, 90, 90);
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	(void)state;
	if (model_load_memory(text, size, "test.x", &log, &model) != 0) {
		fail_msg("%s", logged.sentence[0]);
	}
	model_destroy(model);
	for (int more = 1; more < 30; more++) {
		size = write_faces(text, 90, 90 + more);
		expect_refused((char *)text, size,
			", which is more than the rest of the file can hold");
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_meshes_that_share_a_frame_get_nodes_at_rest),
		cmocka_unit_test(test_frames_that_refer_to_a_mesh_share_it),
		cmocka_unit_test(test_a_mesh_of_a_frame_may_be_drawn_by_another),
		cmocka_unit_test(test_rotation_keys_keep_their_order),
		cmocka_unit_test(test_numbers_are_1e9_at_most),
		cmocka_unit_test(test_materials_divide_a_mesh),
		cmocka_unit_test(test_objects_without_a_name_have_an_empty_one),
		cmocka_unit_test(
			test_an_error_describes_what_stands_there_instead),
		cmocka_unit_test(test_scale_keys_keep_their_values),
		cmocka_unit_test(test_keys_lie_at_1e9_seconds_at_most),
		cmocka_unit_test(test_an_animation_without_a_frame_moves_nothing),
		cmocka_unit_test(test_numbers_end_where_another_token_begins),
		cmocka_unit_test(
			test_counts_that_do_not_fit_into_the_file_are_refused),
		cmocka_unit_test(
			test_the_numbers_of_a_binary_file_take_four_bytes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
