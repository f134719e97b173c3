/* What .x files get wrong: the sentence and the line that limber names. */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

#define HEADER "xof 0303txt 0032\n"
#define FACE   "3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,1,2;; "
#define UNIT   "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;; "
#define MESH   HEADER "Mesh T { " FACE "\n"
#define BONE   HEADER "Frame Bone { }\nAnimationSet A { Animation { { Bone }\n"

struct mistake {
	const char *text;
	const char *where; /* a line, or NULL */
	const char *sentence;
};

static const struct mistake mistakes[] = {
	{MESH "MeshNormals { 1; 0;0;1;; 2; 3;0,0,0;, 3;0,0,0;; } }", "line 3",
		"MeshNormals has 2 faces, but the mesh has 1"},
	{MESH "MeshNormals { 1; 0;0;1;; 1; 4;0,0,0,0;; } }", "line 3",
		"face 0 has 4 corners in MeshNormals, but 3 in the mesh"},
	{MESH "MeshTextureCoords { 2; 0;0;, 1;1;; } }", "line 3",
		"MeshTextureCoords has 2 entries, but the mesh has 3 vertices"},
	{MESH "MeshVertexColors {\n1; 3; 1;1;1;1;;; } }", "line 4",
		"MeshVertexColors refers to vertex 3, but the mesh has 3 vertices"},
	{MESH "MeshMaterialList { 1;\n2; 0,0; } }", "line 4",
		"MeshMaterialList has 2 faces, but the mesh has 1"},
	{MESH "MeshMaterialList { 1; 1; 1; } }", "line 3",
		"face 0 has material 1, but the mesh has 1 materials"},
	/* Four numbers of a colour, one of a power, three of each other colour. */
	{MESH "MeshMaterialList { 1; 1; 0; Material { 1;0;0;;\n} } }", "line 4",
		"a material's colour or power"},
	{MESH "MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;;\n} } }",
		"line 4", "a material's colour or power"},
	{MESH "MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;; 1; 0;0;;\n"
	      "} } }",
		"line 4", "a material's colour or power"},
	{MESH "MeshMaterialList { 1; 1; 0; Material { 1;0;0;1;; 1; 0;0;0;;\n"
	      "0;0;; } } }",
		"line 4", "a material's colour or power"},
	{MESH "SkinWeights { \"B\"; 1; 2;\n-0.002; " UNIT "} }", "line 4",
		"vertex 2 has a negative skin weight"},
	{MESH "SkinWeights { \"B\"; 1;\n3; 1; " UNIT "} }", "line 4",
		"refers to vertex 3, but the mesh has 3 vertices"},
	{HEADER "AnimTicksPerSecond {\n0; }", "line 3",
		"AnimTicksPerSecond is 0, but must be greater than 0"},
	{BONE "AnimationKey { 2; 1; -1;3;1,2,3;;; } } }", "line 4",
		"a key's time is negative"},
	{BONE "AnimationKey { 2; 1; 0;4;1,2,3,4;;; } } }", "line 4",
		"a key has 4 values, but its type has 3"},
	{BONE "AnimationKey { 0; 1; 0;3;1,2,3;;; } } }", "line 4",
		"a key has 3 values, but its type has 4"},
	{BONE "AnimationKey { 5; 1; 0;3;1,2,3;;; } } }", "line 4",
		"the type of an animation key is 5, but must be 0 to 4"},
	{BONE "AnimationKey { 2; 1;\n0;\n4;1,2,3;;; } } }", "line 6",
		"a key has 4 values, but its type has 3"},
	{BONE "AnimationKey { 2; 1;\n-1;\n3;1,2,3;;; } } }", "line 5",
		"a key's time is negative"},
	{BONE "AnimationKey { 4; 1; 0;15;" UNIT "} } }", NULL,
		"a key has 15 values, but its type has 16"},
	{BONE "AnimationKey { 3; 1; 0;15;" UNIT "} } }", NULL,
		"a key has 15 values, but its type has 16"},
	{BONE "AnimationKey { 2; 1; 4.9e12;3;1,2,3;;; } } }", NULL,
		"the time of an animation key is beyond 1e9 s"},
	{HEADER "Mesh T { 1; 1e39;0;0;; 0;; }", "line 2",
		"is not a finite number"},
	{HEADER "Mesh T { 1; 0;-2e9;0;; 0;; }", "line 2", "is larger than 1e9"},
	{HEADER "Mesh T { 1.5;", "line 2",
		"is 1.5, but must be an integer from 0 to 4294967295"},
	{HEADER "Mesh T { 4294967296;", "line 2", "but must be an integer"},
	{HEADER "Mesh T {\n20; 1;2;3;; }", "line 3",
		"is 20, which is more than the rest of the file can hold"},
	{HEADER "Mesh T { three;", "line 2", "but there is \"three\""},
	{HEADER "Mesh T { \"3\";", "line 2", "but there is \"3\""},
	{HEADER "Mesh T { a\x7f\xc3z;", "line 2", "but there is \"a??z\""},
	{HEADER "Mesh T { abcdefghijklmnopqrstuvwxyz0123456789;", "line 2",
		"but there is \"abcdefghijklmnopqrstuvwxyz012345\""},
	{HEADER "Mesh T { {", "line 2", "but there is an opening brace"},
	{HEADER "Mesh T { }", "line 2", "but there is a closing brace"},
	{HEADER "Mesh T { 1; <1-2> 0;0;0; 0;", "line 2", "but there is a GUID"},
	{HEADER "Mesh T { [", "line 2", "but there is a punctuation mark"},
	{HEADER "Mesh T {\n\n", "line 4", "but the file ends"},
	{HEADER "\n12 Mesh", "line 3",
		"a data object is expected here, but there is 12"},
	{HEADER "Frame F G {", "line 2",
		"the opening brace of a data object is expected here"},
	{HEADER "Frame F {\nMesh {\n", "line 4", "but the file ends"},
	{HEADER "Frame F {\n", "line 3", "the file ends before a closing brace"},
	{HEADER "template T {\n<1-2>\n}\n12 Mesh", "line 5",
		"a data object is expected here, but there is 12"},
	{HEADER "template T {\n\"a\nb\"\n}\n12 Mesh", "line 6",
		"a data object is expected here, but there is 12"},
	{HEADER "Nonsense {\n{ }\n", "line 4",
		"the file ends before a closing brace"},
	{HEADER "\"Frame\n\n", "line 2", "the file ends before the closing \""},
	{HEADER "Frame F { <12", "line 2", "the file ends before the closing >"},
	{"xof 0303txt 0016\n", NULL, "must be 0032 or 0064"},
	{"xof 0303tex 0032\n", NULL, "must be txt, bin, tzip or bzip"},
	{"xof 0304txt 0032\n", NULL, "must be 0302 or 0303"},
	{"xof 0303txt 003", NULL, "byte 15: the file ends within its header"},
};

static void test_a_mistake_is_refused_with_its_line(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(mistakes); i++) {
		const struct mistake *mistake = &mistakes[i];
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = NULL;

		assert_true(
			model_load_memory(mistake->text, strlen(mistake->text),
				"test.x", &log, &model) < 0);
		assert_null(model);
		assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
		assert_contains(
			logged.sentence[logged.count - 1], mistake->sentence);
		if (mistake->where) {
			assert_contains(logged.sentence[logged.count - 1],
				mistake->where);
		}
	}
}

/* Other programs show these files, so limber does, too. */
static const struct mistake harmless[] = {
	{BONE "} Animation {\nAnimationKey { 2; 1; 0;3;1,2,3;;; } } }", "line 5",
		"this animation does not name a frame; limber ignores it"},
	{HEADER "Frame Bone { }\nAnimationSet A {\nAnimation { { Gone } "
		"AnimationKey { 2; 1; 0;3;1,2,3;;; } } }",
		"line 4", "moves the frame \"Gone\", which does not exist"},
	{HEADER "Frame Bone { }\nAnimationSet Still { Animation { { Bone } } }",
		"line 3", "the animation set \"Still\" moves no frame"},
	{MESH "MeshMaterialList { 1; 1; 0;\n{ Gone } } }", "line 4",
		"refers to the material \"Gone\", which does not exist"},
	{HEADER "Frame Bone { FrameTransformMatrix { 1,0,0,0, 1,1,0,0, "
		"0,0,1,0, 0,0,0,1;; } }\nAnimationSet A { Animation { { Bone } "
		"AnimationKey { 2; 1; 0;3;1,2,3;;; } } }",
		NULL, "limber drops the shear of frame \"Bone\""},
	{BONE "AnimationKey { 2; 1; 0;3;1,2,3;;; } } }\n"
	      "Frame Bone { } Frame Bone { }",
		NULL,
		"earlier frame, such as \"Bone\" (2): clips and skins move the earlier one"},
	{MESH "SkinWeights { \"Bone\"; 1; 0; 1; " UNIT "} }\n"
	      "Frame Bone { } Frame Bone { }",
		NULL, "earlier frame, such as \"Bone\" (1)"},
};

static void test_frames_that_nothing_names_may_have_equal_names(void **state)
{
	static const char text[] = HEADER "Frame A { } Frame A { }";
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	(void)state;
	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	assert_int_equal(logged.count, 0);
	model_destroy(model);
}

static void test_a_harmless_mistake_causes_a_warning(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(harmless); i++) {
		const struct mistake *mistake = &harmless[i];
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = NULL;
		bool found = false;

		assert_int_equal(
			model_load_memory(mistake->text, strlen(mistake->text),
				"test.x", &log, &model),
			0);
		for (int s = 0; s < logged.count; s++) {
			found = found ||
				(strstr(logged.sentence[s], mistake->sentence) &&
					(!mistake->where ||
						strstr(logged.sentence[s],
							mistake->where)));
		}
		if (!found) {
			fail_msg("%s, but not: %s", logged.sentence[0],
				mistake->sentence);
		}
		model_destroy(model);
	}
}

/*
 * A model loads without a texture that is missing, but not without memory for
 * one. A warning would be too little: after some of them, others are left out.
 */
static void test_a_texture_beyond_the_budget_is_an_error(void **state)
{
	static const char text[] = HEADER
		"Material M { 1;1;1;1;; 1; 0;0;0;; 0;0;0;; TextureFilename { "
		"\"large.png\"; } }";
	static char data[1024 * 1024];
	struct test_path folder = temp_dir_make();
	struct test_path model_path = path_join(&folder, "model.x");
	struct test_path texture = path_join(&folder, "large.png");
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	(void)state;
	file_write(model_path.text, text, sizeof(text) - 1);
	file_write(texture.text, data, sizeof(data));
	assert_int_equal(model_load_within(model_path.text, sizeof(data) / 2,
				 &log, &model),
		-ENOMEM);
	assert_null(model);
	assert_int_equal(logged.count, 1);
	assert_true(log_capture_has(&logged, LOG_ERROR, "--memory"));
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_mistake_is_refused_with_its_line),
		cmocka_unit_test(test_a_harmless_mistake_causes_a_warning),
		cmocka_unit_test(
			test_frames_that_nothing_names_may_have_equal_names),
		cmocka_unit_test(test_a_texture_beyond_the_budget_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
