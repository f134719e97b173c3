/* Faces of .x files with any number of corners, and meshes without materials. */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

#define HEADER  "xof 0303txt 0032\n"
#define CORNERS "6; 0;0;0;, 1;0;0;, 0;1;0;, 5;5;5;, 6;6;6;, 1;1;0;; "

static struct model *load(const char *text)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	assert_int_equal(
		model_load_memory(text, strlen(text), "test.x", &log, &model),
		0);
	assert_int_equal(logged.count, 0);
	return model;
}

/* Twice the areas of all triangles, along z; each has the same sign. */
static double area_of(const struct model_primitive *primitive)
{
	double sum = 0;

	for (int i = 0; i < primitive->index_count; i += 3) {
		const float *a = primitive->position[primitive->index[i]];
		const float *b = primitive->position[primitive->index[i + 1]];
		const float *c = primitive->position[primitive->index[i + 2]];
		double area = (double)((b[0] - a[0]) * (c[1] - a[1]) -
			(b[1] - a[1]) * (c[0] - a[0]));

		assert_true(i == 0 || area * sum > 0);
		sum += area;
	}
	return fabs(sum);
}

/* Corners that only they use are no vertices. */
static void test_dots_and_lines_are_left_out(void **state)
{
	static const struct {
		const char *faces;
		int vertices, corners;
		double area;
	} rows[] = {
		{"1; 3;0,1,2;; ", 3, 3, 1},
		{"2; 2;3,4;, 3;0,1,2;; ", 3, 3, 1},
		{"2; 3;0,1,2;, 1;3;; ", 3, 3, 1},
		{"3; 1;4;, 3;0,1,2;, 2;4,3;; ", 3, 3, 1},
		{"1; 4;0,1,5,2;; ", 4, 6, 2},
		{"3; 2;3,4;, 4;0,1,5,2;, 3;0,1,2;; ", 4, 9, 3},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[400] = HEADER "Mesh M { " CORNERS;
		const struct model_primitive *primitive;
		struct model *model;

		strcat(text, rows[i].faces);
		strcat(text, "}");
		model = load(text);
		assert_int_equal(model->mesh_count, 1);
		assert_int_equal(model->mesh[0].primitive_count, 1);
		primitive = model->mesh[0].primitive;
		assert_int_equal(primitive->vertex_count, rows[i].vertices);
		assert_int_equal(primitive->index_count, rows[i].corners);
		assert_near(area_of(primitive), rows[i].area, 1e-6);
		model_destroy(model);
	}
}

/* One for all meshes that have none, behind those of the file. */
static void test_a_mesh_without_a_material_gets_a_plain_one(void **state)
{
	struct model *model = load(HEADER "Mesh M { " CORNERS "1; 3;0,1,2;; } "
					  "Mesh N { " CORNERS "1; 3;0,1,2;; }");

	(void)state;
	assert_int_equal(model->material_count, 1);
	for (int m = 0; m < 2; m++) {
		assert_int_equal(model->mesh[m].primitive[0].material, 0);
	}
	model_destroy(model);
	model = load(HEADER "Mesh M { " CORNERS "2; 3;0,1,2;, 3;0,1,5;; "
			    "MeshMaterialList { 1; 2; 0, 0;; "
			    "Material { 0.5;0.5;0.5;1;; 1; 0;0;0;; 0;0;0;; } } } "
			    "Mesh N { " CORNERS "1; 3;0,1,2;; }");
	assert_int_equal(model->material_count, 2);
	assert_int_equal(model->mesh[0].primitive[0].material, 0);
	assert_int_equal(model->mesh[1].primitive[0].material, 1);
	model_destroy(model);
}

#define PAINT "Material { 1;1;1;1;; 1; 0;0;0;; 0;0;0;; } "

/* The last of the list; the first material, if the list is empty. */
static void test_faces_behind_the_list_have_its_last_material(void **state)
{
	static const struct {
		const char *list;
		int corners[3]; /* of each primitive */
		int material[3];
	} rows[] = {
		{"0; ", {9}, {0}},
		{"1; 2; ", {9}, {2}},
		{"2; 1, 0; ", {6, 3}, {0, 1}},
		{"3; 2, 1, 0; ", {3, 3, 3}, {0, 1, 2}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[900] = HEADER "Mesh M { " CORNERS
					"3; 3;0,1,2;, 3;0,1,3;, 3;0,1,4;; "
					"MeshMaterialList { 3; ";
		struct model *model;

		strcat(text, rows[i].list);
		strcat(text, PAINT PAINT PAINT "} }");
		model = load(text);
		for (int p = 0; p < model->mesh[0].primitive_count; p++) {
			const struct model_primitive *primitive =
				&model->mesh[0].primitive[p];

			assert_int_equal(
				primitive->index_count, rows[i].corners[p]);
			assert_int_equal(
				primitive->material, rows[i].material[p]);
		}
		model_destroy(model);
	}
}

/* Vertices that MeshVertexColors does not name are white. */
static void test_each_vertex_may_have_a_colour(void **state)
{
	(void)state;
	for (int v = 0; v < 3; v++) {
		char text[300] = HEADER "Mesh M { " CORNERS "1; 3;0,1,2;; "
					"MeshVertexColors { 1; v;0;0;0;0.2;; } "
					"}";
		const struct model_primitive *primitive;
		struct model *model;

		*strchr(strstr(text, "1; v;"), 'v') = (char)('0' + v);
		model = load(text);
		primitive = model->mesh[0].primitive;
		for (int i = 0; i < 3; i++) {
			const float *at = primitive->position[i];
			bool is_coloured =
				at[0] == (v == 1) && at[1] == (v == 2);

			for (int c = 0; c < 4; c++) {
				assert_int_equal(primitive->color[i][c],
					!is_coloured     ? 255
						: c == 3 ? 51
							 : 0);
			}
		}
		model_destroy(model);
	}
}

static void test_normals_have_as_many_corners_as_faces(void **state)
{
	static const char text[] = HEADER
		"Mesh M { " CORNERS "2; 3;0,1,2;, 3;0,1,5;; MeshNormals { 1; "
		"0;0;1;; 2; 3;0,0,0;, 4;0,0,0,0;; } }";
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	(void)state;
	assert_true(model_load_memory(text, sizeof(text) - 1, "test.x", &log,
			    &model) < 0);
	assert_contains(logged.sentence[0],
		"face 1 has 4 corners in MeshNormals, but 3 in the mesh");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_dots_and_lines_are_left_out),
		cmocka_unit_test(test_a_mesh_without_a_material_gets_a_plain_one),
		cmocka_unit_test(
			test_faces_behind_the_list_have_its_last_material),
		cmocka_unit_test(test_each_vertex_may_have_a_colour),
		cmocka_unit_test(test_normals_have_as_many_corners_as_faces),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
