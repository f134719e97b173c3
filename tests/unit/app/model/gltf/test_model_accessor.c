/* glTF accessors: sparse, absent, interleaved, misaligned, quantised. */
#include "app/model/examine/examine.h"
#include "app/model/model.h"
#include "tests/support/files.h"
#include "tests/support/model/deltas.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/run.h"
#include "tests/support/test.h"

#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

static void test_replaces_sparse_values(void **state)
{
	static const float expected[4][3] = {
		{0, 0, 0}, {7, 8, 9}, {0, 1, 0}, {10, 11, 12}};
	struct model *model = model_fixture("gltf/accessor/sparse.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_int_equal(primitive->vertex_count, 4);
	assert_all_near(primitive->position, expected, 12, 0);
	model_destroy(model);
}

/* The sparse indices without a bufferView are 0 1 2 and 0 3 2. */
static void test_reads_sparse_indices_over_zeros(void **state)
{
	static const uint32_t expected[6] = {0, 1, 2, 0, 3, 2};
	struct model *model = model_fixture("gltf/accessor/sparse.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_int_equal(primitive->index_count, 6);
	assert_memory_equal(primitive->index, expected, sizeof(expected));
	model_destroy(model);
}

static void test_reads_an_accessor_without_a_view_as_zeros(void **state)
{
	static const float zeros[3][3];
	struct model *model = model_fixture("gltf/accessor/zeros.gltf", NULL);

	(void)state;
	assert_all_near(model->mesh[1].primitive[0].position, zeros, 9, 0);
	assert_deltas(&model->mesh[0].primitive[0].target[0].position, zeros, 3);
	model_destroy(model);
}

static void test_reads_sparse_morph_targets_without_a_view(void **state)
{
	static const float expected[3][3] = {{0}, {0}, {0, 0, 5}};
	struct model *model = model_fixture("gltf/accessor/zeros.gltf", NULL);

	(void)state;
	assert_deltas(
		&model->mesh[0].primitive[0].target[1].position, expected, 3);
	model_destroy(model);
}

static void test_reads_interleaved_attributes(void **state)
{
	static const float texcoord[3][2] = {{0, 0}, {1, 0}, {0, 0.2f}};
	static const float normal[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
	static const uint8_t color[3][4] = {
		{255, 0, 0, 255}, {0, 255, 0, 128}, {128, 188, 13, 0}};
	struct model *model =
		model_fixture("gltf/accessor/interleaved.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_all_near(primitive->position, triangle, 9, 0);
	assert_all_near(primitive->normal, normal, 9, 0);
	assert_all_near(primitive->texcoord, texcoord, 6, 1e-7);
	assert_memory_equal(primitive->color, color, sizeof(color));
	model_destroy(model);
}

static void test_reads_misaligned_floats_and_shorts(void **state)
{
	static const float moves[2][3] = {{1, 2, 3}, {4, 5, 6}};
	static const float times[2] = {0, 1};
	static const uint32_t index[3] = {2, 1, 0};
	struct model *model =
		model_fixture("gltf/accessor/misaligned.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_all_near(primitive->position, triangle, 9, 0);
	assert_memory_equal(primitive->index, index, sizeof(index));
	assert_all_near(model->clip[0].channel[0].time_s, times, 2, 0);
	assert_all_near(model->clip[0].channel[0].value, moves, 6, 0);
	model_destroy(model);
}

static void test_converts_quantised_positions_and_targets(void **state)
{
	static const float position[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
	static const float target[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
	static const float turned[3][3] = {{1, 0, -1}, {1, 0, -1}, {1, 0, -1}};
	struct model *model =
		model_fixture("gltf/accessor/quantized.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_all_near(primitive->position, position, 9, 0);
	assert_deltas(&primitive->target[0].position, target, 3);
	assert_deltas(&primitive->target[0].normal, turned, 3);
	model_destroy(model);
}

static void test_keeps_integer_positions_that_are_not_normalised(void **state)
{
	static const float position[3][3] = {
		{0, 0, 0}, {1000, 0, 0}, {0, 1000, 7}};
	static const float texcoord[3][2] = {{0, 0}, {3, 0}, {0, 255}};
	struct model *model =
		model_fixture("gltf/accessor/quantized.gltf", NULL);

	(void)state;
	assert_all_near(model->mesh[1].primitive[0].position, position, 9, 0);
	assert_all_near(model->mesh[0].primitive[0].texcoord, texcoord, 6, 0);
	model_destroy(model);
}

static void test_normalises_quantised_normals_and_tangents(void **state)
{
	static const float normal[3] = {0, 0, 1};
	static const float tangent[4] = {1, 0, 0, -1};
	struct model *model =
		model_fixture("gltf/accessor/quantized.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_all_near(primitive->normal[1], normal, 3, 0);
	assert_all_near(primitive->tangent[2], tangent, 4, 0);
	model_destroy(model);
}

/* Compiles a German locale into the folder and switches to it. */
static bool use_decimal_comma(const struct test_path *folder)
{
	struct test_path locale = path_join(folder, "de_DE.UTF-8");
	const char *const argv[] = {"localedef", "-i", "de_DE", "-f", "UTF-8",
		"--no-archive", locale.text, NULL};
	struct run_result result = run_command(argv, 60);
	char text[16];

	run_release(&result);
	setenv("LOCPATH", folder->text, 1);
	if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
		return false;
	}
	snprintf(text, sizeof(text), "%.1f", 0.5);
	return strchr(text, ',') != NULL;
}

static void test_reads_numbers_in_any_locale(void **state)
{
	static const float expected[3] = {0.5f, -1.25f, 1e-3f};
	struct test_path folder = temp_dir_make();
	bool has_comma = use_decimal_comma(&folder);
	struct log_capture logged;
	struct model *model;
	int error;

	(void)state;
	temp_dir_remove(&folder);
	if (!has_comma) {
		setlocale(LC_ALL, "C");
		skip_because(
			"localedef cannot compile a locale with a decimal comma");
	}
	error = model_from_text("{'asset':{'version':'2.0'},'nodes':[{"
				"'translation':[0.5,-1.25,1e-3]}]}",
		&logged, &model);
	setlocale(LC_ALL, "C");
	assert_int_equal(error, 0);
	assert_all_near(model->node[0].rest.translation, expected, 3, 0);
	model_destroy(model);
}

static void keep_sparse(void *context, const char *finding)
{
	if (strstr(finding, "sparse")) {
		snprintf(context, 100, "%s", finding);
	}
}

/* The first of two replaces one value. */
static void test_sparse_accessors_of_one_value_count(void **state)
{
	static const char two[] = "\"count\": 2,\n    \"indices\"";
	struct test_path from = fixture_path("gltf/accessor/sparse.gltf");
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "sparse.gltf");
	struct log log = log_to_stderr(LOG_WARNING);
	char heard[100] = "";
	const struct examiner examiner = {keep_sparse, heard};
	size_t size;
	char *text = file_read(from.text, &size), *at = strstr(text, two);

	(void)state;
	assert_non_null(at);
	*strchr(at, '2') = '1';
	file_write(path.text, text, size);
	free(text);
	assert_int_equal(
		model_examine(path.text, MODEL_MEMORY_BYTES, &examiner, &log),
		0);
	assert_contains(heard, "sparse accessors (2)");
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_replaces_sparse_values),
		cmocka_unit_test(test_sparse_accessors_of_one_value_count),
		cmocka_unit_test(test_reads_sparse_indices_over_zeros),
		cmocka_unit_test(test_reads_an_accessor_without_a_view_as_zeros),
		cmocka_unit_test(test_reads_sparse_morph_targets_without_a_view),
		cmocka_unit_test(test_reads_interleaved_attributes),
		cmocka_unit_test(test_reads_misaligned_floats_and_shorts),
		cmocka_unit_test(test_converts_quantised_positions_and_targets),
		cmocka_unit_test(
			test_keeps_integer_positions_that_are_not_normalised),
		cmocka_unit_test(test_normalises_quantised_normals_and_tangents),
		cmocka_unit_test(test_reads_numbers_in_any_locale),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
