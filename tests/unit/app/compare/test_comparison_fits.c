/*
 * Each technique of a comparison is timed once, however many fits it takes, and
 * errors are those of the view that is played, which is each clip's own.
 */
#include "app/compare/candidate/candidate_time.h"
#include "app/compare/comparison.h"
#include "app/model/levels/levels.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

static int timed;

struct candidate_time candidate_time_measure(
	struct candidate *candidate, int frames)
{
	(void)candidate;
	(void)frames;
	timed++;
	return (struct candidate_time){.frame_us = 1.0};
}

/* What a technique takes is known, whatever its error is. */
static void expect_filled(const struct comparison_row *row)
{
	const struct comparison_cell *cell = &row->cell[0];

	assert_true(cell->bytes.own + cell->bytes.shared > 10000);
	assert_true(cell->vertex_count > 100);
	assert_true(cell->board.vertices.cycles > 0.0);
	assert_true(cell->error.samples > 0);
	if (row->kind == COMPARISON_MORPH && row->listed) {
		assert_true(cell->error.peak_px <= row->bound_px);
	}
}

/* A clip that is compared as a whole gets moments where its motion bends. */
static void expect_refined(
	const struct comparison_clip *compared, const struct model_clip *clip)
{
	struct time_grid plain;

	assert_int_equal(time_grid_make(clip, &plain), 0);
	assert_true(compared->grid.count > plain.count);
	assert_false(compared->grid.thinned);
	time_grid_release(&plain);
}

static struct comparison *compare(
	const struct model *model, int clip, float bound_px)
{
	const struct log log = log_to_nowhere();
	const struct comparison_request request = {.clip = clip,
		.rate_hz = 30.0,
		.bound_px = bound_px,
		.board = board_profile_find(NULL),
		.width = 240,
		.height = 320,
		.jobs = 1,
		.kernel = &kernel_float};
	struct comparison *comparison;

	assert_int_equal(
		comparison_create(model, &request, &log, &comparison), 0);
	return comparison;
}

/* Some errors are found between the moments that a fit looks at. */
static void test_a_row_is_timed_after_its_last_fit(void **state)
{
	struct model *model = model_fixture("../../assets/walker.glb", NULL);
	struct comparison *comparison;

	(void)state;
	timed = 0;
	assert_int_equal(levels_make(model), 0);
	comparison = compare(model, model_find_clip(model, "run"), 0.5f);
	assert_int_equal(timed, comparison->clip_count * comparison->row_count);
	expect_refined(&comparison->clip[0],
		&model->clip[model_find_clip(model, "run")]);
	for (int r = 0; r < comparison->row_count; r++) {
		expect_filled(&comparison->row[r]);
	}
	comparison_destroy(comparison);
	model_destroy(model);
}

/* How much of the picture's height or width the box around a clip takes. */
static float covered_by(const struct screen_view *screen)
{
	float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f}, across, up;

	for (int i = 0; i < 8; i++) {
		const struct bounds *box = &screen->box;
		const float corner[3] = {i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2]};
		float at[2];

		screen_view_project(screen, corner, at);
		for (int axis = 0; axis < 2; axis++) {
			low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
			high[axis] =
				at[axis] > high[axis] ? at[axis] : high[axis];
		}
	}
	across = (high[0] - low[0]) / (float)screen->width;
	up = (high[1] - low[1]) / (float)screen->height;
	return across > up ? across : up;
}

static void test_each_clip_fills_the_picture(void **state)
{
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	struct comparison *comparison;

	(void)state;
	assert_int_equal(levels_make(model), 0);
	comparison = compare(model, -1, 8.0f);
	assert_true(comparison->clip_count > 1);
	for (int i = 0; i < comparison->clip_count; i++) {
		/* A margin of a tenth stays free around the box. */
		assert_near(covered_by(&comparison->clip[i].screen),
			1.0f / 1.1f, 0.01f);
	}
	comparison_destroy(comparison);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_row_is_timed_after_its_last_fit),
		cmocka_unit_test(test_each_clip_fills_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
