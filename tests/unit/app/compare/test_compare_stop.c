/* Each long computation gives up when limber is asked to end, and says nothing. */
#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/cost/board_cost.h"
#include "app/compare/measure/winding.h"
#include "platform/process/stop.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/test.h"

#include <errno.h>
#include <signal.h>

enum {
	KEPT_BYTES = 1 << 24
};

static const char walker[] = "assets/walker.glb";

static void ask(void)
{
	signal(SIGTERM, SIG_DFL);
	stop_catch();
	raise(SIGTERM);
}

static void test_fitting_keys_gives_up(void **state)
{
	struct compared_clip bench;
	struct fit_keys keys;
	int error;

	(void)state;
	compared_clip_begin(&bench, walker, "walk");
	ask();
	error = fit_keys_within(bench.reference, &bench.screen, &bench.grid,
		0.5f, KEPT_BYTES, &keys);
	stop_release();
	assert_int_equal(error, -EINTR);
	assert_null(keys.time_s);
	compared_clip_end(&bench);
}

static void test_baking_gives_up_and_says_nothing(void **state)
{
	struct log_capture capture;
	const struct log log = log_capture_begin(&capture);
	const struct kernel *kernel = kernel_find("fixed");
	struct fixed_placement placement;
	struct compared_clip bench;
	struct candidate candidate;
	struct fit_keys keys;
	int error, rigid_error;

	(void)state;
	compared_clip_begin(&bench, walker, "walk");
	placement = candidate_morph_placement(&bench.screen.box);
	assert_int_equal(fit_keys_evenly(1.0f, 5, &keys), 0);
	ask();
	error = candidate_morph(&candidate, bench.reference, kernel, &placement,
		&keys, KEPT_BYTES, &log);
	rigid_error = candidate_rigid(&candidate, bench.reference, &log);
	stop_release();
	assert_int_equal(error, -EINTR);
	assert_int_equal(rigid_error, -EINTR);
	assert_int_equal(capture.count, 0);
	fit_keys_release(&keys);
	compared_clip_end(&bench);
}

/* The view is not used: it frames the first moment alone. */
static void test_framing_a_clip_gives_up(void **state)
{
	struct screen_view view;
	struct bounds first = bounds_empty();
	struct compared_clip bench;

	(void)state;
	compared_clip_begin(&bench, walker, "walk");
	reference_pose(bench.reference, bench.grid.time_s[0], false);
	for (int v = 0; v < bench.reference->vertex_count; v++) {
		bounds_add(&first, bench.reference->position[v]);
	}
	ask();
	view = screen_view_create(bench.reference, &bench.grid, 64, 64);
	stop_release();
	assert_memory_equal(&view.box, &first, sizeof(first));
	compared_clip_end(&bench);
}

/* What is counted is not used either. */
static void test_counting_gives_up(void **state)
{
	struct compared_clip bench;
	struct board_frame whole, asked;
	struct instance *instance;
	struct clip_cursor cursor = {0};
	int mirrored[64] = {0};

	(void)state;
	compared_clip_begin(&bench, "tests/fixtures/gltf/clip/mirror.gltf", "0");
	assert_true(bench.reference->part_count <= 64);
	ask();
	winding_count(
		bench.reference, bench.grid.time_s, bench.grid.count, mirrored);
	stop_release();
	for (int i = 0; i < bench.reference->part_count; i++) {
		assert_int_equal(mirrored[i], 0);
	}
	winding_count(
		bench.reference, bench.grid.time_s, bench.grid.count, mirrored);
	assert_int_not_equal(mirrored[0], 0);
	compared_clip_end(&bench);

	compared_clip_begin(&bench, "assets/face.glb", "cycle");
	assert_int_equal(instance_create(bench.model, kernel_find("fixed"),
				 &bench.log, &instance),
		0);
	whole = board_cost_clip(
		bench.reference->clip, instance, &cursor, 0, 60.0);
	ask();
	asked = board_cost_clip(
		bench.reference->clip, instance, &cursor, 0, 60.0);
	stop_release();
	assert_true(asked.vertices.cycles < 0.5 * whole.vertices.cycles);
	instance_destroy(instance);
	compared_clip_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_fitting_keys_gives_up),
		cmocka_unit_test(test_baking_gives_up_and_says_nothing),
		cmocka_unit_test(test_framing_a_clip_gives_up),
		cmocka_unit_test(test_counting_gives_up),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
