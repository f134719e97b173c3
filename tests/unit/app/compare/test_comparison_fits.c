/* Each technique of a comparison is timed once, however many fits it takes. */
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

/* Some errors are found between the moments that a fit looks at. */
static void test_a_row_is_timed_after_its_last_fit(void **state)
{
	const struct log log = log_to_nowhere();
	struct model *model = model_fixture("../../assets/walker.glb", NULL);
	struct comparison_request request = {
		.clip = model_find_clip(model, "run"),
		.rate_hz = 30.0,
		.bound_px = 0.5f,
		.board = board_profile_find(NULL),
		.width = 240,
		.height = 320,
		.jobs = 1,
		.kernel = &kernel_float};
	struct comparison *comparison;

	(void)state;
	assert_int_equal(levels_make(model), 0);
	assert_int_equal(
		comparison_create(model, &request, &log, &comparison), 0);
	assert_int_equal(timed, comparison->clip_count * comparison->row_count);
	expect_refined(&comparison->clip[0], &model->clip[request.clip]);
	for (int r = 0; r < comparison->row_count; r++) {
		expect_filled(&comparison->row[r]);
	}
	comparison_destroy(comparison);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_row_is_timed_after_its_last_fit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
