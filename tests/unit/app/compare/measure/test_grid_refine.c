/* Moments that are added where vertices move along a curve. */
#include "app/compare/measure/grid_refine.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How far the pose in the middle is from that of the straight line. */
static float off_px(struct compared_clip *bench, float from_s, float to_s)
{
	struct reference *reference = bench->reference;
	int count = reference->vertex_count;
	size_t bytes = (size_t)count * sizeof(*reference->position);
	float(*line)[3] = malloc(bytes), most = 0.0f;

	assert_non_null(line);
	reference_pose(reference, from_s, false);
	memcpy(line, reference->position, bytes);
	reference_pose(reference, to_s, false);
	for (int i = 0; i < 3 * count; i++) {
		line[i / 3][i % 3] = 0.5f *
			(line[i / 3][i % 3] + reference->position[i / 3][i % 3]);
	}
	reference_pose(reference, 0.5f * (from_s + to_s), false);
	for (int v = 0; v < count; v++) {
		most = fmaxf(most,
			screen_view_distance_px(&bench->screen, line[v],
				reference->position[v]));
	}
	free(line);
	return most;
}

/* The most that a middle is off by. */
static float most_off_px(struct compared_clip *bench)
{
	const struct time_grid *grid = &bench->grid;
	float most = 0.0f;

	for (int i = 0; i + 1 < grid->count; i++) {
		most = fmaxf(most,
			off_px(bench, grid->time_s[i], grid->time_s[i + 1]));
	}
	return most;
}

static void refine(struct compared_clip *bench, float bound_px)
{
	assert_int_equal(grid_refine(bench->reference, &bench->screen, bound_px,
				 &bench->grid),
		0);
}

/* Keys that are joined by straight lines, and keys that jump. */
static void test_lines_and_jumps_get_no_more_moments(void **state)
{
	static const char *const clips[][2] = {
		{"tests/fixtures/gltf/clip/far.gltf", "circle"},
		{"tests/fixtures/gltf/clip/late_start.gltf", "late"},
	};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct compared_clip bench;
		int count;

		compared_clip_begin(&bench, clips[i][0], clips[i][1]);
		count = bench.grid.count;
		refine(&bench, 0.25f);
		assert_int_equal(bench.grid.count, count);
		compared_clip_end(&bench);
	}
}

/* Half a turn in a second: the same curve in each of 60 intervals. */
static void begin_turn(struct compared_clip *bench)
{
	compared_clip_begin(
		bench, "tests/fixtures/gltf/clip/normalized.gltf", "0");
	assert_int_equal(bench->grid.count, 61);
}

static void test_curves_get_as_many_moments_as_the_bound_needs(void **state)
{
	static const float bounds_px[] = {1.0f, 0.03f, 0.01f, 0.002f};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct compared_clip bench;
		float whole_px;
		int pieces;

		begin_turn(&bench);
		whole_px = most_off_px(&bench);
		pieces = (int)ceilf(sqrtf(whole_px / bounds_px[i]));
		refine(&bench, bounds_px[i]);
		assert_true(most_off_px(&bench) < 1.05f * bounds_px[i]);
		assert_in_range(bench.grid.count, 30 * pieces, 60 * pieces + 1);
		assert_near(bench.grid.time_s[bench.grid.count - 1], 1.0, 0.0);
		compared_clip_end(&bench);
	}
}

/* All others are at the node, which turns and does not move. */
static void test_any_vertex_that_bends_adds_moments(void **state)
{
	int vertex_count = 1;

	(void)state;
	for (int bent = 0; bent < vertex_count; bent++) {
		struct compared_clip bench;
		struct model_primitive *primitive;

		begin_turn(&bench);
		primitive = bench.model->mesh[0].primitive;
		vertex_count = primitive->vertex_count;
		/* Of the nodes that show the mesh, the first counts alone. */
		bench.reference->vertex_count = vertex_count;
		memset(primitive->position, 0,
			(size_t)vertex_count * sizeof(*primitive->position));
		primitive->position[bent][0] = 1.0f;
		primitive->position[bent][1] = 1.0f;
		primitive->position[bent][2] = 1.0f;
		refine(&bench, 0.01f);
		assert_true(bench.grid.count > 100);
		compared_clip_end(&bench);
	}
	assert_true(vertex_count > 2);
}

static void test_at_most_63_moments_are_added_between_two(void **state)
{
	struct compared_clip bench;

	(void)state;
	begin_turn(&bench);
	refine(&bench, 1e-7f);
	assert_int_equal(bench.grid.count, 60 * 64 + 1);
	for (int i = 0; i < bench.grid.count; i++) {
		assert_near(bench.grid.time_s[i], i / 3840.0, 1e-6);
	}
	compared_clip_end(&bench);
}

static void test_the_box_contains_the_middles(void **state)
{
	struct compared_clip bench;

	(void)state;
	begin_turn(&bench);
	bench.screen.box = bounds_empty();
	refine(&bench, 0.25f);
	for (int i = 0; i < 60; i++) {
		const struct reference *reference = bench.reference;
		const struct bounds *box = &bench.screen.box;

		reference_pose(
			bench.reference, (0.5f + (float)i) / 60.0f, false);
		for (int k = 0; k < 3 * reference->vertex_count; k++) {
			float x = reference->position[k / 3][k % 3];

			assert_true(x >= box->low[k % 3] - 1e-5f &&
				x <= box->high[k % 3] + 1e-5f);
		}
	}
	compared_clip_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lines_and_jumps_get_no_more_moments),
		cmocka_unit_test(
			test_curves_get_as_many_moments_as_the_bound_needs),
		cmocka_unit_test(test_any_vertex_that_bends_adds_moments),
		cmocka_unit_test(test_at_most_63_moments_are_added_between_two),
		cmocka_unit_test(test_the_box_contains_the_middles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
