/* How .x files write numbers, names and keys, and what has no effect. */
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
#define CORNERS "3; 0;0;0;, 1;0;0;, 0;1;0;; "
#define FACE    CORNERS "1; 3;0,1,2;; "
#define UNIT    "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;; "

static struct model *load(const char *text, struct log_capture *logged)
{
	struct log log = log_capture_begin(logged);
	struct model *model = NULL;

	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	return model;
}

/* Writes a mesh whose only number is x, and reads it back. */
static bool read_number(const char *number, float *out)
{
	char text[400];
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	snprintf(text, sizeof(text),
		HEADER "Frame F { FrameTransformMatrix { 1,0,0,0, 0,1,0,0, "
		       "0,0,1,0, %s,0,0,1;; } }",
		number);
	if (model_load_memory(text, strlen(text), "test.x", &log, &model) != 0) {
		assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
		return false;
	}
	*out = model->node[0].rest.translation[0];
	model_destroy(model);
	return true;
}

static void test_numbers_have_the_values_of_strtod(void **state)
{
	static const char *const numbers[] = {"0", "-0", "7", "+7", "-7", "1.5",
		".5", "-.25", "5.", "000012.5000", "1e2", "1E+2", "1e-2",
		"-2.5e-3", "25e-1", "0.1", "3.14159265358979",
		"0.1234567890123456789012345", "123456789012345678901234e-20",
		"99999999999999999999e-12", "0.000000000000000000001234e24",
		"0.00000000000000000000000000000000000001e38", "1e-30", "1e-44",
		"9.99999e8", "1e-400", "1e-100000", "0e99", "0e999999999",
		"0.0000001", "000000000000000000000000012"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(numbers); i++) {
		double wanted = strtod(numbers[i], NULL);
		float got = -1.0f;

		if (!read_number(numbers[i], &got)) {
			fail_msg("%s was refused", numbers[i]);
		}
		if (fabs((double)got - wanted) > 1e-6 * fabs(wanted) + 1e-38) {
			fail_msg("%s became %g", numbers[i], (double)got);
		}
	}
}

static void test_numbers_of_microsofts_library_become_zero(void **state)
{
	static const char *const numbers[] = {
		"1.#IND", "-1.#IND", "1.#INF", "-1.#INF00", "1.#QNAN"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(numbers); i++) {
		float got = -1.0f;

		assert_true(read_number(numbers[i], &got));
		assert_near(got, 0.0, 0.0);
	}
}

static void test_what_is_no_number_is_refused(void **state)
{
	static const char *const words[] = {"e5", "1e", "1e+", "-", "+", ".",
		"1.2.3", "1x", "1e5x", "--1", "+-1", ".#IND", "0x10", "nan",
		"inf", "1e39", "-1e400", "1e9999999999", "1.1e9", "-1.1e9"};
	float got;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(words); i++) {
		if (read_number(words[i], &got)) {
			fail_msg("%s became %g", words[i], (double)got);
		}
	}
}

static void test_comments_reach_to_the_end_of_the_line(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"// Mesh A { \n# Mesh B {\r\nFrame F// the first }\n"
		"{ # } \n} Frame G {}// the last",
		&logged);

	(void)state;
	assert_int_equal(model->node_count, 2);
	assert_string_equal(model->node[0].name, "F");
	assert_string_equal(model->node[1].name, "G");
	model_destroy(model);
}

/* Names in other encodings than UTF-8 are taken for Latin-1. */
static void test_names_become_utf_8(void **state)
{
	static const struct {
		const char *in, *out;
	} names[] = {
		{"Arm", "Arm"},
		{"J\xfcrgen", "J\xc3\xbcrgen"},
		{"J\xc3\xbcrgen", "J\xc3\xbcrgen"},
		{"\xe9", "\xc3\xa9"},
		{"a\xe2\x82\xac", "a\xe2\x82\xac"},
		{"\xf0\x9f\x98\x80", "\xf0\x9f\x98\x80"},
		{"\xef\xbf\xbd", "\xef\xbf\xbd"},
		{"\xf4\x8f\xbf\xbf", "\xf4\x8f\xbf\xbf"},
		{"\xe0\xa0\x80", "\xe0\xa0\x80"},
		{"\xed\x9f\xbf", "\xed\x9f\xbf"},
		/* Overlong, a surrogate, and beyond U+10FFFF. */
		{"\xc1\xbf", "\xc3\x81\xc2\xbf"},
		{"\xe0\x9f\xbf", "\xc3\xa0\xc2\x9f\xc2\xbf"},
		{"\xed\xa0\x80", "\xc3\xad\xc2\xa0\xc2\x80"},
		{"\xf0\x8f\xbf\xbf", "\xc3\xb0\xc2\x8f\xc2\xbf\xc2\xbf"},
		{"\xf4\x90\x80\x80", "\xc3\xb4\xc2\x90\xc2\x80\xc2\x80"},
		{"\xf5\x80\x80\x80", "\xc3\xb5\xc2\x80\xc2\x80\xc2\x80"},
		/* A sequence that is cut short. */
		{"\xc3", "\xc3\x83"},
		{"\xe2\x82", "\xc3\xa2\xc2\x82"},
		{"\xc3x", "\xc3\x83x"},
		{"a\x7f"
		 "b",
			"a b"},
		{"12", "12"},
		{"1e5", "1e5"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct log_capture logged;
		struct model *model;
		char text[100];

		snprintf(text, sizeof(text), HEADER "Frame %s { }", names[i].in);
		model = load(text, &logged);
		assert_int_equal(model->node_count, 1);
		assert_string_equal(model->node[0].name, names[i].out);
		model_destroy(model);
	}
}

/* The keys at 0 but the last one are never seen; those at 0.5 s are a jump. */
static void test_keys_are_sorted_and_equal_times_are_a_jump(void **state)
{
	static const float times[] = {0.0f, 0.5f, 0.5f, 2.0f};
	static const float places[][3] = {
		{5, 6, -7}, {8, 8, -8}, {4, 4, -4}, {1, 2, -3}};
	struct log_capture logged;
	struct model *model = load(HEADER
		"AnimTicksPerSecond { 2; }\nFrame Bone { }\n"
		"AnimationSet Move { Animation { { Bone } AnimationKey { 2; 5; "
		"4;3;1,2,3;;, 0;3;9,9,9;;, 1;3;8,8,8;;, 0;3;5,6,7;;, "
		"1;3;4,4,4;;; } } }",
		&logged);
	const struct model_channel *channel = &model->clip[0].channel[0];

	(void)state;
	assert_int_equal(channel->key_count, 4);
	assert_all_near(channel->time_s, times, 4, 1e-7f);
	assert_true(channel->time_s[1] < channel->time_s[2]);
	for (int i = 0; i < 4; i++) {
		assert_all_near(channel->value + 3 * i, places[i], 3, 0);
	}
	assert_near(model->clip[0].duration_s, 2.0, 0);
	model_destroy(model);
}

/*
 * The first clip leaves the numbers of its channels behind, and the last
 * position of the second one is followed neither by a longer clip nor by a
 * second channel, which a mix of clips would count twice.
 */
static void test_of_several_keys_that_move_a_frame_alike_the_last_count(
	void **state)
{
	static const float place[3] = {4, 5, -6};
	struct log_capture logged;
	struct model *model = load(HEADER
		"AnimTicksPerSecond { 1; }\nFrame Bone { } Frame Other { }\n"
		"AnimationSet A { Animation { { Other } AnimationKey { 1; 1; "
		"0;3;2,2,2;;; } } Animation { { Bone } AnimationKey { 1; 1; "
		"0;3;2,2,2;;; } } }\n"
		"AnimationSet B { Animation { { Bone } AnimationKey { 2; 1; "
		"9;3;1,2,3;;; } AnimationKey { 1; 1; 0;3;3,3,3;;; } } "
		"Animation { { Bone } AnimationKey { 2; 1; 1;3;4,5,6;;; } } }",
		&logged);
	const struct model_clip *clip = &model->clip[1];

	(void)state;
	assert_int_equal(model->clip[0].channel_count, 2);
	assert_int_equal(clip->channel_count, 2);
	assert_int_equal(clip->channel[0].path, MODEL_TRANSLATION);
	assert_all_near(clip->channel[0].value, place, 3, 0);
	assert_int_equal(clip->channel[1].path, MODEL_SCALE);
	assert_near(clip->duration_s, 1.0, 0);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0],
		"several keys move the frame \"Bone\" in the same way");
	model_destroy(model);
}

/* Exporters round weights of 0 to either side. */
static void test_a_weight_just_below_zero_is_zero(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Frame A { } Frame B { } Mesh T { " FACE
		"SkinWeights { \"A\"; 3; 0,1,2; 1,1,1; " UNIT "} "
		"SkinWeights { \"B\"; 2; 0,1; -0.0009,1; " UNIT "} }",
		&logged);
	const struct model_primitive *primitive = model->mesh[0].primitive;
	int halves = 0;

	(void)state;
	for (int v = 0; v < 3; v++) {
		const float *weight =
			primitive->weight + v * primitive->influences;

		halves += fabsf(weight[0] - 0.5f) < 1e-6f &&
			fabsf(weight[1] - 0.5f) < 1e-6f;
		assert_near(weight[0] + weight[1], 1.0, 1e-6);
		assert_true(weight[0] >= 0.0f && weight[1] >= 0.0f);
	}
	assert_int_equal(halves, 1);
	model_destroy(model);
}

static void test_faces_of_two_corners_draw_nothing(void **state)
{
	struct log_capture logged;
	struct model *model = load(HEADER
		"Mesh T { 3; 0;0;0;, 1;0;0;, 0;1;0;; 3; 2;0,1;, 3;0,1,2;, "
		"0;; }",
		&logged);

	(void)state;
	assert_int_equal(model->mesh[0].primitive_count, 1);
	assert_int_equal(model->mesh[0].primitive[0].index_count, 3);
	assert_int_equal(model->mesh[0].primitive[0].vertex_count, 3);
	model_destroy(model);
}

/* A count's elements, each as short as can be, are the last of the file. */
static void test_counts_that_just_fit_into_the_file_are_read(void **state)
{
	enum {
		COUNT = 90
	};
	static const struct {
		const char *name, *before, *element, *after;
	} cases[] = {
		{"faces", HEADER "Mesh T{" CORNERS "90;", "0;", "}"},
		{"corners", HEADER "Mesh T{" CORNERS "1;90;", "0;", "}"},
		{"colours", HEADER "Mesh T{" FACE "MeshVertexColors{90;",
			"0;0;0;0;0;", "}}"},
		{"weighted vertices",
			HEADER "Frame A{}Mesh T{" FACE "SkinWeights{\"A\";90;",
			"0;0;", UNIT "}}"},
		{"keys",
			HEADER "Frame A{}AnimationSet S{Animation{{A}"
			       "AnimationKey{2;90;",
			"0;3;0;0;0;", "}}}"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = NULL;
		char text[2000];
		size_t used = (size_t)snprintf(
			text, sizeof(text), "%s", cases[i].before);

		for (int n = 0; n < COUNT; n++) {
			used += (size_t)snprintf(text + used,
				sizeof(text) - used, "%s", cases[i].element);
		}
		used += (size_t)snprintf(
			text + used, sizeof(text) - used, "%s", cases[i].after);
		assert_true(used < sizeof(text));
		if (model_load_memory(text, used, "test.x", &log, &model) != 0) {
			fail_msg("%s: %s", cases[i].name, logged.sentence[0]);
		}
		model_destroy(model);
	}
}

static void test_normals_get_unit_length_and_zero_faces_the_viewer(void **state)
{
	static const float up[3] = {0, 1, 0}, viewer[3] = {0, 0, 1};
	static const float back[3] = {0, 0.6f, -0.8f};
	struct log_capture logged;
	struct model *model = load(HEADER
		"Mesh T { " FACE "MeshNormals { 3; 0;5;0;, 0;0;0;, 0;3;4;; 1; "
		"3;0,1,2;; } }",
		&logged);
	const struct model_primitive *primitive = model->mesh[0].primitive;

	(void)state;
	for (int v = 0; v < 3; v++) {
		const float *at = primitive->position[v];
		const float *wanted = at[0] > 0 ? viewer
			: at[1] > 0             ? back
						: up;

		assert_all_near(primitive->normal[v], wanted, 3, 1e-6);
	}
	model_destroy(model);
}

/* The x of the corner after the one at x = 1, in the first triangle. */
static float corner_after_the_first(const char *text)
{
	struct log_capture logged;
	struct model *model = load(text, &logged);
	const struct model_primitive *primitive = model->mesh[0].primitive;
	float x = 0.0f;

	for (int i = 0; i < 3; i++) {
		if (primitive->position[primitive->index[i]][0] == 1) {
			x = primitive->position[primitive->index[(i + 1) % 3]][0];
		}
	}
	model_destroy(model);
	return x;
}

/*
 * Direct3D shows the side of a triangle whose corners are clockwise in the
 * picture. Where a frame mirrors, glTF shows the other side.
 */
static void test_triangles_below_mirroring_frames_are_not_turned(void **state)
{
#define TRIANGLE     "Mesh T { 3; 1;2;3;, 4;5;6;, 7;8;10;; 1; 3;0,1,2;; "
#define SWAP         "1,0,0,0, 0,0,1,0, 0,1,0,0, 0,0,0,1;;"
#define SWAPS        "FrameTransformMatrix {" SWAP "}"
#define BONE(offset) "SkinWeights { \"B\"; 3; 0,1,2; 1,1,1;" offset "}"
#define PLAIN        "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;;"
	static const struct {
		const char *text;
		float x;
	} files[] = {
		{HEADER "Frame A {" TRIANGLE "} }", 7},
		{HEADER "Frame A {" SWAPS TRIANGLE "} }", 4},
		{HEADER "Frame A {" SWAPS "Frame B {" TRIANGLE "} } }", 4},
		{HEADER "Frame A {" SWAPS "Frame B {" SWAPS TRIANGLE "} } }", 7},
		{HEADER "Frame B {" SWAPS TRIANGLE BONE(SWAP) "} }", 4},
		{HEADER "Frame B {" SWAPS "}" TRIANGLE BONE(UNIT) "}", 4},
		{HEADER "Frame B {" SWAPS "}" TRIANGLE BONE(SWAP) "}", 7},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(files); i++) {
		assert_near(
			corner_after_the_first(files[i].text), files[i].x, 0);
	}
}

#define PAINTED(name)                                             \
	"Material { 1;1;1;1;; 0; 0;0;0;; 0;0;0;; TextureFilename" \
	" { \"" name "\"; } } "

static void test_materials_share_textures_of_one_name(void **state)
{
	static const char text[] = HEADER
		"Mesh T { " FACE "MeshMaterialList { 5; 1; 0; " PAINTED("a.png")
			PAINTED("b.png") PAINTED("a.png") PAINTED("c.png")
				PAINTED("b.png") "} }";
	static const int wanted[] = {0, 1, 0, 2, 1};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "model.x");
	struct test_path picture =
		fixture_path("gltf/material/parts/two by two.png");
	struct log log = log_to_stderr(LOG_WARNING);
	struct model *model;
	size_t size;
	char *data = file_read(picture.text, &size);

	(void)state;
	file_write(path_join(&folder, "a.png").text, data, size);
	file_write(path_join(&folder, "b.png").text, data, size);
	file_write(path_join(&folder, "c.png").text, data, size);
	free(data);
	file_write(path.text, text, sizeof(text) - 1);
	assert_int_equal(model_load(path.text, &log, &model), 0);
	assert_int_equal(model->texture_count, 3);
	for (size_t i = 0; i < ARRAY_COUNT(wanted); i++) {
		assert_int_equal(model->material[i].texture, wanted[i]);
	}
	model_destroy(model);
	temp_dir_remove(&folder);
}

static void write_far(char *text, size_t size, const char *place[2])
{
	snprintf(text, size,
		HEADER "Frame F { FrameTransformMatrix { 1,0,0,0, 0,1,0,0, "
		       "0,0,1,0, %s,1,2,1;; } Mesh M { " FACE "} } "
		       "AnimationSet A { Animation { { F } AnimationKey { 2; 2; "
		       "0; 3; %s,1,2;;, 4800; 3; %s,1,2;;; } } }",
		place[0], place[0], place[1]);
}

/* Floats are 6 cm apart there, but a triangle and its way are exact. */
static void test_a_model_1000_km_away_moves_with_its_keys(void **state)
{
	static const char *places[2][2] = {
		{"0.5", "0.75"}, {"1000000.5", "1000000.75"}};
	struct log_capture logged;
	char text[1000];

	(void)state;
	for (int far = 0; far < 2; far++) {
		const struct model_channel *channel;
		struct model *model;
		double start, end;

		write_far(text, sizeof(text), places[far]);
		model = load(text, &logged);
		assert_int_equal(logged.count, 0);
		channel = &model->clip[0].channel[0];
		start = (double)channel->value[0] + model->origin[0];
		end = (double)channel->value[3] + model->origin[0];
		assert_near(start, far ? 1000000.5 : 0.5, 0.0);
		assert_near(end - start, 0.25, 0.0);
		assert_near((double)model->node[0].rest.translation[0] +
				model->origin[0],
			start, 0.0);
		assert_true(fabsf(channel->value[0]) < 2.0f);
		assert_near(channel->value[1], 1.0, 0.0);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_numbers_have_the_values_of_strtod),
		cmocka_unit_test(test_numbers_of_microsofts_library_become_zero),
		cmocka_unit_test(test_what_is_no_number_is_refused),
		cmocka_unit_test(test_comments_reach_to_the_end_of_the_line),
		cmocka_unit_test(test_names_become_utf_8),
		cmocka_unit_test(test_keys_are_sorted_and_equal_times_are_a_jump),
		cmocka_unit_test(
			test_of_several_keys_that_move_a_frame_alike_the_last_count),
		cmocka_unit_test(test_a_weight_just_below_zero_is_zero),
		cmocka_unit_test(test_faces_of_two_corners_draw_nothing),
		cmocka_unit_test(
			test_counts_that_just_fit_into_the_file_are_read),
		cmocka_unit_test(
			test_normals_get_unit_length_and_zero_faces_the_viewer),
		cmocka_unit_test(
			test_triangles_below_mirroring_frames_are_not_turned),
		cmocka_unit_test(test_materials_share_textures_of_one_name),
		cmocka_unit_test(test_a_model_1000_km_away_moves_with_its_keys),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
