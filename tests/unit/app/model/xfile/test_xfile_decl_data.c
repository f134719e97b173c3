/* Vertex data of .x files with the layout of a Direct3D vertex declaration. */
#include "app/model/model.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Types, and usages, of D3DVERTEXELEMENT9. */
#define FLOAT2   "1;0;"
#define FLOAT3   "2;0;"
#define FLOAT4   "3;0;"
#define COLOR    "4;0;"
#define NORMAL   "3;"
#define TEXCOORD "5;"
#define TANGENT  "6;"
#define DIFFUSE  "10;"

static const float corner[3][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};

struct words {
	uint32_t word[64];
	int count;
};

static void add(struct words *words, float value)
{
	memcpy(&words->word[words->count++], &value, sizeof(value));
}

/* A triangle with vertex data of these elements; more ends the mesh. */
static int load(const char *elements, const struct words *words,
	const char *more, struct log_capture *logged, struct model **out)
{
	char text[2048];
	struct log log = log_capture_begin(logged);
	int length = snprintf(text, sizeof(text),
		"xof 0303txt 0032\nMesh T { 3; 1;2;3;, 4;5;6;, 7;8;10;; 1; "
		"3;0,1,2;;\n%s DeclData { %s %d; ",
		more, elements, words->count);

	for (int i = 0; i < words->count; i++) {
		length += snprintf(text + length, sizeof(text) - (size_t)length,
			"%" PRIu32 "%s", words->word[i],
			i + 1 < words->count ? ", " : ";");
	}
	length += snprintf(
		text + length, sizeof(text) - (size_t)length, "\n} }\n");
	assert_true(length < (int)sizeof(text));
	*out = NULL;
	return model_load_memory(text, (size_t)length, "test.x", &log, out);
}

/* The vertex of the corner; z is negated. */
static int vertex_of(const struct model_primitive *primitive, int c)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		if (primitive->position[v][0] == corner[c][0]) {
			return v;
		}
	}
	fail_msg("there is no vertex of corner %d", c);
	return 0;
}

static void test_normals_coordinates_and_colors_are_found(void **state)
{
	struct log_capture logged;
	struct words words = {.count = 0};
	const struct model_primitive *primitive;
	struct model *model;

	(void)state;
	for (int c = 0; c < 3; c++) {
		for (int i = 0; i < 4; i++) {
			add(&words, 99); /* a tangent, which limber skips */
		}
		add(&words, c == 0 ? 1.0f : 0.0f);
		add(&words, c == 1 ? 1.0f : 0.0f);
		add(&words, c == 2 ? 1.0f : 0.0f);
		words.word[words.count++] = 0xFF204060u + (uint32_t)c * 0x100;
		add(&words, 0.25f * (float)c);
		add(&words, 1.0f - 0.25f * (float)c);
	}
	assert_int_equal(load("4; " FLOAT4 TANGENT "0;, " FLOAT3 NORMAL
			      "0;, " COLOR DIFFUSE "0;, " FLOAT2 TEXCOORD "0;;",
				 &words, "", &logged, &model),
		0);
	primitive = model->mesh[0].primitive;
	for (int c = 0; c < 3; c++) {
		const float normal[3] = {c == 0 ? 1.0f : 0.0f,
			c == 1 ? 1.0f : 0.0f, c == 2 ? -1.0f : 0.0f};
		const float texcoord[2] = {
			0.25f * (float)c, 1.0f - 0.25f * (float)c};
		int v = vertex_of(primitive, c);

		assert_all_near(primitive->normal[v], normal, 3, 1e-6);
		assert_all_near(primitive->texcoord[v], texcoord, 2, 1e-6);
		assert_int_equal(primitive->color[v][0], 0x20);
		assert_int_equal(primitive->color[v][1], 0x40 + c);
		assert_int_equal(primitive->color[v][2], 0x60);
		assert_int_equal(primitive->color[v][3], 0xFF);
	}
	model_destroy(model);
}

/* Behind an element of each D3DDECLTYPE there are coordinates. */
static void test_each_type_has_its_size(void **state)
{
	/* FLOAT1 to FLOAT4, D3DCOLOR, UBYTE4, SHORT2, SHORT4, UBYTE4N, SHORT2N,
	 * SHORT4N, USHORT2N, USHORT4N, UDEC3, DEC3N, FLOAT16_2, FLOAT16_4 */
	static const int bytes[] = {
		4, 8, 12, 16, 4, 4, 4, 8, 4, 4, 8, 4, 8, 4, 4, 4, 8};

	(void)state;
	for (int type = 0; type < (int)ARRAY_COUNT(bytes); type++) {
		struct log_capture logged;
		struct words words = {.count = 0};
		const struct model_primitive *primitive;
		struct model *model;
		char elements[64];

		for (int c = 0; c < 3; c++) {
			words.count += bytes[type] / 4;
			add(&words, 0.25f * (float)(c + 1));
			add(&words, 0.5f);
		}
		snprintf(elements, sizeof(elements),
			"2; %d;0;" TANGENT "0;, " FLOAT2 TEXCOORD "0;;", type);
		assert_int_equal(load(elements, &words, "", &logged, &model), 0);
		primitive = model->mesh[0].primitive;
		for (int c = 0; c < 3; c++) {
			assert_near(
				primitive->texcoord[vertex_of(primitive, c)][0],
				0.25 * (c + 1), 1e-6);
		}
		model_destroy(model);
	}
}

/* A second set of coordinates, and coordinates of three numbers. */
static void test_other_sets_and_types_are_skipped(void **state)
{
	struct log_capture logged;
	struct words words = {.count = 0};
	struct model *model;

	(void)state;
	for (int i = 0; i < 3 * 5; i++) {
		add(&words, 0.5f);
	}
	assert_int_equal(load("2; " FLOAT2 TEXCOORD "1;, " FLOAT3 TEXCOORD "0;;",
				 &words, "", &logged, &model),
		0);
	assert_null(model->mesh[0].primitive[0].texcoord);
	model_destroy(model);
	/* Normals and colours of other types, and these types for other uses. */
	words.count = 0;
	for (int i = 0; i < 3 * 12; i++) {
		add(&words, 0.5f);
	}
	assert_int_equal(load("4; " FLOAT4 NORMAL "0;, " FLOAT3 TANGENT
			      "0;, " FLOAT4 DIFFUSE "0;, " COLOR TANGENT "0;;",
				 &words, "", &logged, &model),
		0);
	assert_null(model->mesh[0].primitive[0].normal);
	assert_null(model->mesh[0].primitive[0].color);
	model_destroy(model);
}

static void test_a_member_of_the_mesh_comes_first(void **state)
{
	static const char member[] =
		"MeshTextureCoords { 3; 0.5;0.5;, 0.5;0.5;, 0.5;0.5;; }";
	struct log_capture logged;
	struct words words = {.count = 0};
	const struct model_primitive *primitive;
	struct model *model;

	(void)state;
	for (int i = 0; i < 3 * 2; i++) {
		add(&words, 0.125f);
	}
	assert_int_equal(load("1; " FLOAT2 TEXCOORD "0;;", &words, member,
				 &logged, &model),
		0);
	primitive = model->mesh[0].primitive;
	assert_near(primitive->texcoord[vertex_of(primitive, 1)][0], 0.5, 1e-6);
	model_destroy(model);
}

static void expect_refusal(
	const char *elements, const struct words *words, const char *why)
{
	struct log_capture logged;
	struct model *model;

	assert_int_equal(load(elements, words, "", &logged, &model), -EINVAL);
	assert_null(model);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0], "test.x:");
	assert_contains(logged.sentence[0], why);
}

static void test_data_that_does_not_fit_is_refused(void **state)
{
	struct words words = {.count = 0};

	(void)state;
	for (int i = 0; i < 3 * 2; i++) {
		add(&words, 0.5f);
	}
	expect_refusal("1; 17;0;" TEXCOORD "0;;", &words, "undefined type 17");
	expect_refusal("1; " FLOAT3 NORMAL "0;;", &words,
		"has 6 words, but 3 vertices need 9");
	add(&words, 0.5f);
	expect_refusal("1; " FLOAT2 TEXCOORD "0;;", &words,
		"has 7 words, but 3 vertices need 6");
	words.count = 4;
	add(&words, NAN);
	add(&words, 0.5f);
	expect_refusal("1; " FLOAT2 TEXCOORD "0;;", &words,
		"a number for vertex 2 that is not finite");
	words.count = 4;
	add(&words, 0.5f);
	add(&words, NAN);
	expect_refusal("1; " FLOAT2 TEXCOORD "0;;", &words,
		"a number for vertex 2 that is not finite");
	words.count = 5;
	add(&words, 2e9f);
	expect_refusal("1; " FLOAT2 TEXCOORD "0;;", &words,
		"a number for vertex 2 that is larger than 1e9");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_normals_coordinates_and_colors_are_found),
		cmocka_unit_test(test_each_type_has_its_size),
		cmocka_unit_test(test_other_sets_and_types_are_skipped),
		cmocka_unit_test(test_a_member_of_the_mesh_comes_first),
		cmocka_unit_test(test_data_that_does_not_fit_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
