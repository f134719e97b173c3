/* limber optimize: errors against a dense sampling, order, what is dropped. */
#include "app/compare/measure/screen_view.h"
#include "app/compare/optimize/optimize.h"
#include "app/compare/optimize/optimize_prune.h"
#include "app/compare/optimize/optimize_refs.h"
#include "app/compare/optimize/optimize_tipsify.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	DENSE = 20, /* moments in each interval of the grid */
	FEATURES = 5
};

static struct optimize_result optimized(const struct model *model, float px)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct optimize_request request = {
		.bound_px = px,
		.width = 480,
		.height = 640,
		.memory_bytes = MODEL_MEMORY_BYTES,
	};
	struct optimize_result result;

	assert_int_equal(optimize_model(model, &request, &log, &result), 0);
	return result;
}

/* Where a vertex is at some moments, which tells vertices apart. */
static void add_feature(const struct reference *reference, int moment,
	float (*feature)[FEATURES][3])
{
	for (int v = 0; v < reference->vertex_count; v++) {
		memcpy(feature[v][moment], reference->position[v],
			sizeof(float[3]));
	}
}

static float distance2(const float a[FEATURES][3], const float b[FEATURES][3])
{
	float sum = 0.0f;

	for (int i = 0; i < FEATURES; i++) {
		for (int axis = 0; axis < 3; axis++) {
			float apart = a[i][axis] - b[i][axis];

			sum += apart * apart;
		}
	}
	return sum;
}

/* The vertex of the new file, whose vertices have another order. */
static void match(struct reference *wanted, struct reference *found, int *to)
{
	float(*a)[FEATURES][3] =
		calloc((size_t)wanted->vertex_count, sizeof(*a));
	float(*b)[FEATURES][3] = calloc((size_t)found->vertex_count, sizeof(*b));

	assert_non_null(a);
	assert_non_null(b);
	for (int i = 0; i < FEATURES; i++) {
		float time_s = wanted->clip->duration_s * (float)i / FEATURES;

		reference_pose(wanted, time_s, false);
		reference_pose(found, time_s, false);
		add_feature(wanted, i, a);
		add_feature(found, i, b);
	}
	for (int v = 0; v < wanted->vertex_count; v++) {
		to[v] = 0;
		for (int w = 1; w < found->vertex_count; w++) {
			if (distance2((const float(*)[3])a[v],
				    (const float(*)[3])b[w]) <
				distance2((const float(*)[3])a[v],
					(const float(*)[3])b[to[v]])) {
				to[v] = w;
			}
		}
	}
	free(a);
	free(b);
}

static float dense_peak_px(struct reference *wanted, struct reference *found)
{
	int *to = calloc((size_t)wanted->vertex_count, sizeof(*to));
	struct screen_view screen;
	struct time_grid grid;
	float most = 0.0f;

	assert_non_null(to);
	assert_int_equal(time_grid_make(wanted->clip, &grid), 0);
	screen = screen_view_create(wanted, &grid, 480, 640);
	match(wanted, found, to);
	for (int i = 0; i < (grid.count - 1) * DENSE; i++) {
		const float *at = grid.time_s + i / DENSE;
		float time_s = at[0] +
			(at[1] - at[0]) * (float)(i % DENSE) / (float)DENSE;

		reference_pose(wanted, time_s, false);
		reference_pose(found, time_s, false);
		for (int v = 0; v < wanted->vertex_count; v++) {
			float px = screen_view_distance_px(&screen,
				wanted->position[v], found->position[to[v]]);

			most = px > most ? px : most;
		}
	}
	time_grid_release(&grid);
	free(to);
	return most;
}

static void compare(
	const struct model *wanted, const struct model *found, float bound_px)
{
	const struct log log = log_to_stderr(LOG_WARNING);

	assert_int_equal(wanted->clip_count, found->clip_count);
	for (int c = 0; c < wanted->clip_count; c++) {
		struct reference *a, *b;

		assert_string_equal(wanted->clip[c].name, found->clip[c].name);
		assert_near(found->clip[c].duration_s,
			wanted->clip[c].duration_s, 1e-6);
		assert_int_equal(reference_create(wanted, c, &log, &a), 0);
		assert_int_equal(reference_create(found, c, &log, &b), 0);
		/* The stated peak is within 5% of the true one. */
		assert_true(dense_peak_px(a, b) <= bound_px * 1.05f);
		reference_destroy(a);
		reference_destroy(b);
	}
}

static void load(const char *path, struct model **out)
{
	const struct log log = log_to_stderr(LOG_ERROR);

	assert_int_equal(model_load(path, &log, out), 0);
}

/* The file keeps to the bound, and a second run changes nothing. */
static void check_model(const char *path, float bound_px, double vertices)
{
	struct test_path folder = temp_dir_make();
	struct test_path small = path_join(&folder, "small.glb");
	struct optimize_result once, twice;
	struct model *model, *found;

	load(path, &model);
	once = optimized(model, bound_px);
	file_write(small.text, once.data, once.after.file);
	load(small.text, &found);
	assert_true(once.peak_px <= bound_px);
	assert_true(once.after.file < once.before.file);
	assert_true(once.after.keys <= once.before.keys);
	assert_true((double)once.after.vertices <=
		vertices * (double)once.before.vertices);
	compare(model, found, bound_px);

	twice = optimized(found, bound_px);
	assert_near(twice.peak_px, 0.0f, 1e-3);
	assert_int_equal(twice.after.file, once.after.file);
	assert_int_equal(twice.after.key_count, once.after.key_count);
	model_destroy(model);
	model_destroy(found);
	free(once.data);
	free(twice.data);
	temp_dir_remove(&folder);
}

static void test_a_skin_keeps_to_the_bound(void **state)
{
	(void)state;
	samples_require("RiggedFigure.glb");
	check_model(samples_path("RiggedFigure.glb").text, 0.5f, 0.5);
	check_model(samples_path("RiggedFigure.glb").text, 0.05f, 0.8);
	check_model(samples_path("RiggedSimple.glb").text, 0.5f, 0.5);
}

static void test_rigid_parts_and_targets_keep_to_the_bound(void **state)
{
	(void)state;
	samples_require("BoxAnimated.glb");
	check_model(samples_path("BoxAnimated.glb").text, 0.5f, 0.6);
	check_model(samples_path("AnimatedMorphCube.glb").text, 0.5f, 0.5);
}

static void test_half_turns_keep_their_direction(void **state)
{
	struct optimize_result result;
	struct model *model;

	(void)state;
	samples_require("BoxAnimated.glb");
	/* Its lid turns by exactly 180 degrees. */
	load(samples_path("BoxAnimated.glb").text, &model);
	result = optimized(model, 0.1f);
	assert_true(result.after.vertices < result.before.vertices);
	assert_true(result.peak_px <= 0.1f);
	model_destroy(model);
	free(result.data);
}

static void test_fixtures_keep_their_pictures(void **state)
{
	static const char *const names[] = {
		"gltf/accessor/interleaved.gltf",
		"gltf/accessor/sparse.gltf",
		"gltf/clip/cubic.gltf",
		"gltf/clip/late_start.gltf",
		"gltf/mesh/modes.gltf",
		"gltf/scene/cameras.gltf",
		"gltf/scene/matrices.gltf",
		"gltf/scene/tree.gltf",
		"gltf/skin/and_morph.gltf",
		"gltf/skin/eight_influences.gltf",
		"gltf/skin/no_inverse_bind.gltf",
		"gltf/skin/shared_mesh.gltf",
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct test_path folder = temp_dir_make();
		struct test_path small = path_join(&folder, "small.glb");
		struct optimize_result result;
		struct model *model, *found;

		load(fixture_path(names[i]).text, &model);
		result = optimized(model, 0.2f);
		file_write(small.text, result.data, result.after.file);
		load(small.text, &found);
		assert_true(result.peak_px <= 0.2f);
		assert_int_equal(model->camera_count, found->camera_count);
		compare(model, found, 0.2f);
		model_destroy(model);
		model_destroy(found);
		free(result.data);
		temp_dir_remove(&folder);
	}
}

/*
 * Weights in bytes miss both bounds here. Those and positions in shorts keep to
 * half of the first bound; the second one takes floats.
 */
static void test_numbers_lose_what_the_bound_allows(void **state)
{
	struct optimize_result loose, strict;
	struct model *model;

	(void)state;
	load(fixture_path("gltf/skin/no_inverse_bind.gltf").text, &model);
	loose = optimized(model, 0.2f);
	strict = optimized(model, 0.003f);
	assert_true(loose.after.vertices < strict.after.vertices);
	assert_true(strict.after.vertices <= strict.before.vertices);
	model_destroy(model);
	free(loose.data);
	free(strict.data);
}

static void count_step(void *context, int done, int total)
{
	int *steps = context;

	assert_int_equal(done, ++*steps);
	assert_int_equal(total, done + 1);
}

/* Returns how many steps an optimization takes beyond one for each clip. */
static int count_steps_beyond_clips(
	float bound_px, struct optimize_result *result)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	int steps = 0;
	const struct optimize_request request = {
		.bound_px = bound_px,
		.width = 48,
		.height = 64,
		.memory_bytes = MODEL_MEMORY_BYTES,
		.progress = count_step,
		.progress_context = &steps,
	};
	struct model *model;

	load(fixture_path("gltf/clip/cubic.gltf").text, &model);
	assert_int_equal(optimize_model(model, &request, &log, result), 0);
	steps -= model->clip_count;
	model_destroy(model);
	return steps;
}

/* Without a bound to use: two files are built, and each clip is measured. */
static void test_each_file_and_each_measured_clip_is_a_step(void **state)
{
	struct optimize_result result;

	(void)state;
	assert_int_equal(count_steps_beyond_clips(0, &result), 2);
	free(result.data);
}

/* However often a file is built, clips whose keys all stay are measured once. */
static void test_clips_that_stay_as_they_are_are_measured_once(void **state)
{
	struct optimize_result result;

	(void)state;
	assert_int_equal(count_steps_beyond_clips(1e-3f, &result), 2 + 7 + 1);
	assert_int_equal(result.after.key_count, result.before.key_count);
	free(result.data);
}

/* A clip that lasts no time is measured in its pose, not at rest. */
static void test_a_pose_keeps_all_channels(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path small = path_join(&folder, "small.glb");
	struct optimize_result result;
	struct model *model, *found;

	(void)state;
	load(fixture_path("gltf/clip/pose.gltf").text, &model);
	result = optimized(model, 0.2f);
	file_write(small.text, result.data, result.after.file);
	load(small.text, &found);
	assert_int_equal(found->clip_count, 1);
	assert_int_equal(found->clip[0].channel_count, 2);
	assert_true(result.peak_px <= 0.2f);
	model_destroy(model);
	model_destroy(found);
	free(result.data);
	temp_dir_remove(&folder);
}

/* A grid of quads whose triangles are shuffled by a fixed rule. */
static void test_triangles_are_ordered_for_the_cache(void **state)
{
	enum {
		SIDE = 20,
		QUADS = SIDE * SIDE,
		CORNERS = 6 * QUADS
	};
	static const int offset[6] = {0, 1, SIDE + 1, 1, SIDE + 2, SIDE + 1};
	static uint32_t index[CORNERS], ordered[CORNERS];
	int vertices = (SIDE + 1) * (SIDE + 1), before, after;

	(void)state;
	for (int q = 0; q < QUADS; q++) {
		int at = q * 7 % QUADS;

		for (int c = 0; c < 6; c++) {
			index[6 * q + c] = (uint32_t)(at / SIDE * (SIDE + 1) +
				at % SIDE + offset[c]);
		}
	}
	memcpy(ordered, index, sizeof(index));
	before = optimize_tipsify_misses(index, CORNERS, vertices);
	assert_int_equal(optimize_tipsify(ordered, CORNERS, vertices), 0);
	after = optimize_tipsify_misses(ordered, CORNERS, vertices);
	assert_true(after < before * 3 / 4);
	/* A cache of 16 fetches at least each vertex once. */
	assert_true(after >= vertices && after < vertices * 3 / 2);
}

static json_t *parse(const char *text)
{
	json_t *root = json_loads(text, 0, NULL);

	assert_non_null(root);
	return root;
}

static void test_unused_parts_are_removed_and_numbers_follow(void **state)
{
	json_t *root = parse(
		"{\"scenes\":[{\"nodes\":[1]},{\"nodes\":[3]}],"
		"\"nodes\":[{\"mesh\":0},{\"mesh\":1,\"skin\":0},"
		"{\"camera\":0},{\"name\":\"other\"},{\"name\":\"joint\"},"
		"{\"name\":\"lost\"}],"
		"\"cameras\":[{}],\"skins\":[{\"joints\":[4]}],"
		"\"meshes\":[{\"primitives\":[{\"material\":0}]},"
		"{\"primitives\":[{\"material\":1,\"attributes\":"
		"{\"TEXCOORD_0\":0,\"TEXCOORD_1\":1,\"TANGENT\":2}}]}],"
		"\"materials\":[{},{\"pbrMetallicRoughness\":"
		"{\"baseColorTexture\":{\"index\":1}}}],"
		"\"textures\":[{\"source\":0},{\"source\":1}],"
		"\"images\":[{},{\"name\":\"kept\"}],"
		"\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":5}},{\"target\":{\"node\":4}}]}]}");
	json_t *wanted = parse(
		"{\"scenes\":[{\"nodes\":[0]},{\"nodes\":[2]}],"
		"\"nodes\":[{\"mesh\":0,\"skin\":0},"
		"{\"camera\":0},{\"name\":\"other\"},{\"name\":\"joint\"}],"
		"\"cameras\":[{}],\"skins\":[{\"joints\":[3]}],"
		"\"meshes\":[{\"primitives\":[{\"material\":0,\"attributes\":"
		"{\"TEXCOORD_0\":0}}]}],"
		"\"materials\":[{\"pbrMetallicRoughness\":"
		"{\"baseColorTexture\":{\"index\":0}}}],"
		"\"textures\":[{\"source\":0}],"
		"\"images\":[{\"name\":\"kept\"}],"
		"\"animations\":[{\"channels\":["
		"{\"target\":{\"node\":3}}]}]}");

	(void)state;
	assert_int_equal(optimize_prune(root), 0);
	assert_true(json_equal(root, wanted));
	json_decref(root);
	json_decref(wanted);
}

static void count_removed(void *context, const char *name)
{
	assert_string_equal(name, "EXT_unheard_of");
	++*(int *)context;
}

static void test_extras_stay_and_unknown_extensions_go(void **state)
{
	json_t *root = parse(
		"{\"extensionsUsed\":[\"EXT_unheard_of\",\"MSFT_lod\"],"
		"\"extras\":{\"extensions\":{\"EXT_unheard_of\":1}},"
		"\"nodes\":[{\"extensions\":{\"EXT_unheard_of\":{\"mesh\":7},"
		"\"MSFT_lod\":{\"ids\":[]}}}]}");
	json_t *wanted = parse(
		"{\"extensionsUsed\":[\"MSFT_lod\"],"
		"\"extras\":{\"extensions\":{\"EXT_unheard_of\":1}},"
		"\"nodes\":[{\"extensions\":{\"MSFT_lod\":{\"ids\":[]}}}]}");
	int removed = 0;

	(void)state;
	optimize_strip_extensions(root, count_removed, &removed);
	assert_int_equal(removed, 1);
	assert_true(json_equal(root, wanted));
	json_decref(root);
	json_decref(wanted);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_skin_keeps_to_the_bound),
		cmocka_unit_test(test_rigid_parts_and_targets_keep_to_the_bound),
		cmocka_unit_test(test_half_turns_keep_their_direction),
		cmocka_unit_test(test_fixtures_keep_their_pictures),
		cmocka_unit_test(test_numbers_lose_what_the_bound_allows),
		cmocka_unit_test(test_each_file_and_each_measured_clip_is_a_step),
		cmocka_unit_test(
			test_clips_that_stay_as_they_are_are_measured_once),
		cmocka_unit_test(test_a_pose_keeps_all_channels),
		cmocka_unit_test(test_triangles_are_ordered_for_the_cache),
		cmocka_unit_test(
			test_unused_parts_are_removed_and_numbers_follow),
		cmocka_unit_test(test_extras_stay_and_unknown_extensions_go),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
