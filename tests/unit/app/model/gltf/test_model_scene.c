/* glTF nodes: scenes, decomposed matrices, cameras. */
#include "app/model/examine/examine.h"
#include "app/model/model.h"
#include "app/model/transform_decompose.h"
#include "tests/support/files.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* T * R * S of a transform in double precision, as four columns. */
static void compose(const struct transform *t, double out[4][4])
{
	double x = t->rotation[0], y = t->rotation[1];
	double z = t->rotation[2], w = t->rotation[3];
	double r[3][3] = {
		{1 - 2 * (y * y + z * z), 2 * (x * y + z * w),
			2 * (x * z - y * w)},
		{2 * (x * y - z * w), 1 - 2 * (x * x + z * z),
			2 * (y * z + x * w)},
		{2 * (x * z + y * w), 2 * (y * z - x * w),
			1 - 2 * (x * x + y * y)},
	};
	int c, k;

	for (c = 0; c < 3; c++) {
		for (k = 0; k < 3; k++) {
			out[c][k] = r[c][k] * t->scale[c];
		}
		out[c][3] = 0;
		out[3][c] = t->translation[c];
	}
	out[3][3] = 1;
}

static void expect_same(
	const float matrix[4][4], const struct transform *transform)
{
	double got[4][4];
	int c, k;

	compose(transform, got);
	for (c = 0; c < 4; c++) {
		for (k = 0; k < 4; k++) {
			assert_near(got[c][k], matrix[c][k], 2e-5);
		}
	}
	assert_near(transform->rotation[0] * transform->rotation[0] +
			transform->rotation[1] * transform->rotation[1] +
			transform->rotation[2] * transform->rotation[2] +
			transform->rotation[3] * transform->rotation[3],
		1, 1e-6);
}

static void test_decomposes_matrices(void **state)
{
	static const struct transform transforms[] = {
		{{1, 2, 3}, {0, 0, 0, 1}, {1, 1, 1}},
		{{0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}},
		{{0, 0, 0}, {0, 1, 0, 0}, {3, 2, 1}},
		{{0, 0, 0}, {0, 0, 1, 0}, {2, 2, 2}},
		{{9, 8, 7}, {0.5f, 0.5f, 0.5f, 0.5f}, {0.001f, 1, 10}},
		{{0, 0, 0}, {0.6f, 0, 0, -0.8f}, {1, -1, 1}},
		{{0, 0, 0}, {0, 0.6f, 0.8f, 0}, {-1, -1, -1}},
		{{0, 0, 0}, {0, 0.6f, 0.8f, 0}, {1, 0, 1}},
		{{0, 0, 0}, {0, 0.6f, 0, 0.8f}, {0, 0, 2}},
		{{0, 0, 0}, {0, 0.6f, 0, 0.8f}, {0, 5, 0}},
	};
	size_t i;
	int c, k;

	(void)state;
	for (i = 0; i < sizeof(transforms) / sizeof(transforms[0]); i++) {
		struct transform got;
		double exact[4][4];
		float matrix[4][4];

		compose(&transforms[i], exact);
		for (c = 0; c < 4; c++) {
			for (k = 0; k < 4; k++) {
				matrix[c][k] = (float)exact[c][k];
			}
		}
		assert_true(transform_decompose(matrix, &got));
		expect_same(matrix, &got);
	}
}

static void test_distinguishes_shear_from_scale(void **state)
{
	static const float shear[4][4] = {
		{1, 0, 0, 0}, {0.01f, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	struct transform out;

	(void)state;
	assert_false(transform_decompose(shear, &out));
	assert_near(out.scale[0], 1, 1e-3);
}

static void test_decomposes_the_matrices_of_nodes(void **state)
{
	static const float matrix[4][4] = {
		{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {5, 6, 7, 1}};
	static const float mirror[4][4] = {
		{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	struct model *model = model_fixture("gltf/scene/matrices.gltf", NULL);

	(void)state;
	assert_null(fixture_node(model, 0)->matrix);
	expect_same(matrix, &fixture_node(model, 0)->rest);
	assert_null(fixture_node(model, 1)->matrix);
	expect_same(mirror, &fixture_node(model, 1)->rest);
	model_destroy(model);
}

static void test_accepts_singular_matrices(void **state)
{
	static const float flat[4][4] = {
		{2, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	static const float null[4][4] = {{0}, {0}, {0}, {1, 2, 3, 1}};
	struct model *model = model_fixture("gltf/scene/matrices.gltf", NULL);

	(void)state;
	expect_same(flat, &fixture_node(model, 2)->rest);
	expect_same(null, &fixture_node(model, 4)->rest);
	model_destroy(model);
}

static void test_keeps_a_matrix_with_shear(void **state)
{
	struct model *model = model_fixture("gltf/scene/matrices.gltf", NULL);
	const struct model_node *node = fixture_node(model, 3);

	(void)state;
	assert_non_null(node->matrix);
	assert_near(node->matrix[1][0], 0.5, 0);
	assert_near(node->matrix[3][2], 3, 0);
	model_destroy(model);
}

static void test_drops_the_matrix_of_an_animated_node(void **state)
{
	static const float matrix[4][4] = {
		{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {5, 6, 7, 1}};
	struct log_capture logged;
	struct model *model = model_fixture("gltf/scene/matrices.gltf", &logged);

	(void)state;
	assert_null(fixture_node(model, 5)->matrix);
	expect_same(matrix, &fixture_node(model, 5)->rest);
	assert_null(fixture_node(model, 6)->matrix);
	assert_near(fixture_node(model, 6)->rest.translation[1], 2, 0);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/animations/0/channels/1/target: limber drops the shear of node 6"));
	model_destroy(model);
}

static void test_names_channels_of_pointers(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'nodes':[{}],'animations':"
			"[{'samplers':[{}],'channels':[{'sampler':0,'target':{"
			"'path':'pointer','extensions':{'KHR_animation_pointer'"
			":{'pointer':'/nodes/0/scale'}}}},{'sampler':0,'target'"
			":{'node':0,'path':'pointer'}}]}]}",
			&logged, &model),
		0);
	assert_int_equal(model->clip[0].channel_count, 0);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/animations/0: limber ignores 2 of 2 channels, which KHR_animation_pointer defines"));
	model_destroy(model);
}

static bool is_in_scene(const struct model *model, int file_index)
{
	return fixture_node(model, file_index)->in_scene;
}

static void test_shows_the_default_scene(void **state)
{
	struct model *model = model_fixture("gltf/scene/tree.gltf", NULL);

	(void)state;
	assert_true(is_in_scene(model, 0));
	assert_false(is_in_scene(model, 1));
	assert_true(is_in_scene(model, 2));
	assert_true(is_in_scene(model, 3));
	assert_true(is_in_scene(model, 4));
	model_destroy(model);
}

static void test_shows_scene_0_without_a_default(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text("{'asset':{'version':'2.0'},'nodes':[{},{}],"
				"'scenes':[{'nodes':[1]},{'nodes':[0]}]}",
			&logged, &model),
		0);
	assert_false(is_in_scene(model, 0));
	assert_true(is_in_scene(model, 1));
	model_destroy(model);
}

static void test_shows_everything_without_scenes(void **state)
{
	struct model *model = model_fixture("gltf/scene/matrices.gltf", NULL);
	int i;

	(void)state;
	for (i = 0; i < model->node_count; i++) {
		assert_true(model->node[i].in_scene);
	}
	model_destroy(model);
}

static void test_a_hidden_node_hides_what_is_below_it(void **state)
{
	static const bool shown[5] = {true};
	struct log_capture heard;
	struct model *model = model_fixture("gltf/scene/hidden.gltf", &heard);
	int warnings = 0;

	(void)state;
	for (int i = 0; i < 5; i++) {
		const struct model_node *node = fixture_node(model, i);

		assert_int_equal(model_node_shows_mesh(node), shown[i]);
		assert_int_equal(node->hidden, i != 0);
		assert_true(node->in_scene);
	}
	assert_true(model_has_triangles(model));
	assert_int_equal(model_find_morphed(model), -1);
	for (int i = 0; i < heard.count; i++) {
		warnings +=
			strstr(heard.sentence[i],
				"/animations/0/channels/1/target: the clip shows or hides a node, which limber does not play") !=
			NULL;
	}
	assert_int_equal(warnings, 1);
	assert_int_equal(heard.count, 2);
	model_destroy(model);
}

static void test_keeps_the_numbers_and_names_of_nodes(void **state)
{
	static const char *const names[] = {
		"leaf", "other root", "branch", "root", "second leaf"};
	struct model *model = model_fixture("gltf/scene/tree.gltf", NULL);
	int i;

	(void)state;
	for (i = 0; i < 5; i++) {
		assert_string_equal(fixture_node(model, i)->name, names[i]);
	}
	for (i = 0; i < model->node_count; i++) {
		assert_true(model->node[i].parent < i);
	}
	i = model_find_node(model, "leaf");
	assert_string_equal(model->node[model->node[i].parent].name, "branch");
	assert_int_equal(model_find_node(model, "nobody"), -1);
	model_destroy(model);
}

static void test_normalises_rest_rotations(void **state)
{
	static const float expected[4] = {0, 0.6f, 0, 0.8f};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text("{'asset':{'version':'2.0'},"
					 "'nodes':[{'rotation':[0,3.0,0,4]}]}",
				 &logged, &model),
		0);
	assert_all_near(model->node[0].rest.rotation, expected, 4, 1e-7);
	assert_near(model->node[0].rest.scale[2], 1, 0);
	model_destroy(model);
}

static void test_reads_cameras(void **state)
{
	struct model *model = model_fixture("gltf/scene/cameras.gltf", NULL);
	const struct model_camera *camera = model->camera;

	(void)state;
	assert_int_equal(model->camera_count, 3);
	assert_string_equal(camera[0].name, "eye");
	assert_true(camera[0].perspective);
	assert_near(camera[0].yfov_rad, 0.75, 0);
	assert_near(camera[0].aspect, 1.5, 0);
	assert_near(camera[0].znear, 0.1f, 0);
	assert_near(camera[0].zfar, 100, 0);
	assert_near(camera[1].aspect, 0, 0);
	assert_near(camera[1].zfar, 0, 0);
	assert_false(camera[2].perspective);
	assert_near(camera[2].xmag, 2, 0);
	assert_near(camera[2].ymag, 3, 0);
	assert_near(camera[2].zfar, 10, 0);
	assert_int_equal(fixture_node(model, 2)->camera, 2);
	assert_int_equal(fixture_node(model, 0)->mesh, -1);
	model_destroy(model);
}

/* All numbers of a camera but znear are only greater than 0. */
static void test_cameras_may_have_small_numbers(void **state)
{
	struct log_capture logged;
	struct model *model;
	const struct model_camera *camera;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'cameras':["
			"{'type':'perspective','perspective':{'yfov':0.5,"
			"'znear':0.125,'zfar':0.25,'aspectRatio':0.75}},"
			"{'type':'orthographic','orthographic':{'xmag':0.5,"
			"'ymag':0.25,'znear':0.125,'zfar':0.375}}]}",
			&logged, &model),
		0);
	camera = model->camera;
	assert_near(camera[0].yfov_rad, 0.5, 0);
	assert_near(camera[0].znear, 0.125, 0);
	assert_near(camera[0].zfar, 0.25, 0);
	assert_near(camera[0].aspect, 0.75, 0);
	assert_near(camera[1].xmag, 0.5, 0);
	assert_near(camera[1].ymag, 0.25, 0);
	assert_near(camera[1].znear, 0.125, 0);
	assert_near(camera[1].zfar, 0.375, 0);
	model_destroy(model);
}

/* Lists of numbers end at 1e9, other numbers where floats do. */
static void test_numbers_may_be_as_large_as_their_limits(void **state)
{
	static const struct {
		const char *scale, *zfar;
		int error;
	} cases[] = {{"1e9", "3.4028234663852886e38", 0}, {"-1e9", "2", 0},
		{"1.0001e9", "2", -EINVAL}, {"-1.0001e9", "2", -EINVAL},
		{"1", "3.4028235e38", -EINVAL}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		struct log_capture logged;
		struct model *model;
		char text[512];

		snprintf(text, sizeof(text),
			"{'asset':{'version':'2.0'},'nodes':[{'scale':[1,%s,1]"
			"}],'cameras':[{'type':'perspective','perspective':{"
			"'yfov':1,'znear':1,'zfar':%s}}]}",
			cases[i].scale, cases[i].zfar);
		assert_int_equal(
			model_from_text(text, &logged, &model), cases[i].error);
		model_destroy(model);
	}
}

static void count_backwards(void *context, const char *finding)
{
	*(int *)context += strstr(finding, "before their parents") != NULL;
}

/* Some exporters write integers with ".0", which the loader allows. */
static void test_children_written_as_reals_are_no_finding(void **state)
{
	static const char text[] =
		"{\"asset\":{\"version\":\"2.0\"},\"nodes\":["
		"{\"children\":[1.0]},{\"children\":[2.0]},{}]}";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "reals.gltf");
	int backwards = 0;
	const struct examiner examiner = {count_backwards, &backwards};
	struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	file_write(path.text, text, sizeof(text) - 1);
	assert_int_equal(
		model_examine(path.text, MODEL_MEMORY_BYTES, &examiner, &log),
		0);
	assert_int_equal(backwards, 0);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_decomposes_matrices),
		cmocka_unit_test(test_distinguishes_shear_from_scale),
		cmocka_unit_test(test_decomposes_the_matrices_of_nodes),
		cmocka_unit_test(test_accepts_singular_matrices),
		cmocka_unit_test(test_keeps_a_matrix_with_shear),
		cmocka_unit_test(test_drops_the_matrix_of_an_animated_node),
		cmocka_unit_test(test_names_channels_of_pointers),
		cmocka_unit_test(test_shows_the_default_scene),
		cmocka_unit_test(test_shows_scene_0_without_a_default),
		cmocka_unit_test(test_shows_everything_without_scenes),
		cmocka_unit_test(test_a_hidden_node_hides_what_is_below_it),
		cmocka_unit_test(test_keeps_the_numbers_and_names_of_nodes),
		cmocka_unit_test(test_normalises_rest_rotations),
		cmocka_unit_test(test_reads_cameras),
		cmocka_unit_test(test_cameras_may_have_small_numbers),
		cmocka_unit_test(test_numbers_may_be_as_large_as_their_limits),
		cmocka_unit_test(test_children_written_as_reals_are_no_finding),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
