/* Which clips of a small model are compared, and what is said of them. */
#include "app/compare/comparison.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <errno.h>

enum {
	CLIPS_MAX = 4
};

/* A square of size 1 whose clips move it to the right. */
struct bench {
	struct model *model;
	struct model_clip clip[CLIPS_MAX];
	struct model_channel channel[CLIPS_MAX];
	float time_s[CLIPS_MAX][2], place[CLIPS_MAX][2][3];
	struct comparison *comparison;
	struct log_capture log;
};

static void begin(struct bench *bench)
{
	*bench = (struct bench){.model = small_model_grid(1, 1, 1.0f, true)};
	bench->model->clip = bench->clip;
}

/* Adds a clip that goes so far in so long; 0 seconds are a pose. */
static void add(
	struct bench *bench, const char *name, float duration_s, float far)
{
	int c = bench->model->clip_count++;

	bench->time_s[c][1] = duration_s > 0.0f ? duration_s : 1.0f;
	bench->place[c][1][0] = far;
	bench->channel[c] = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = duration_s > 0.0f ? 2 : 1,
		.time_s = bench->time_s[c],
		.value = bench->place[c][0]};
	bench->clip[c] = (struct model_clip){.name = name,
		.duration_s = duration_s,
		.channel_count = 1,
		.channel = &bench->channel[c]};
}

static int compare(struct bench *bench, int clip)
{
	const struct log log = log_capture_begin(&bench->log);
	const struct comparison_request request = {.clip = clip,
		.rate_hz = 60.0,
		.bound_px = 0.5f,
		.board = board_profile_find(NULL),
		.width = 48,
		.height = 64,
		.jobs = 1,
		.kernel = kernel_find("fixed")};

	bench->comparison = NULL;
	return comparison_create(
		bench->model, &request, &log, &bench->comparison);
}

static void expect_clips(
	struct bench *bench, int wanted, const int *clip, int count)
{
	assert_int_equal(compare(bench, wanted), 0);
	assert_int_equal(bench->comparison->clip_count, count);
	for (int c = 0; c < count; c++) {
		assert_int_equal(bench->comparison->clip[c].clip, clip[c]);
	}
	comparison_destroy(bench->comparison);
}

static void end(struct bench *bench)
{
	bench->model->clip = NULL;
	bench->model->clip_count = 0;
	model_destroy(bench->model);
}

/* A warning counts the poses and names the first one, wherever it is. */
static void test_poses_are_left_out_and_named(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, "hold", 0.0f, 0.5f);
	add(&bench, "step", 0.1f, 0.5f);
	add(&bench, "stay", 0.0f, 0.25f);
	expect_clips(&bench, -1, (const int[]){1}, 1);
	assert_int_equal(bench.log.count, 1);
	assert_true(log_capture_has(&bench.log, LOG_WARNING,
		"clips without a duration (2 of 3, the first is clip 0 hold) "
		"are poses"));
	end(&bench);
	begin(&bench);
	add(&bench, "step", 0.1f, 0.5f);
	add(&bench, "leap", 1.5f, 0.5f);
	add(&bench, "", 0.0f, 0.5f);
	add(&bench, "stay", 0.0f, 0.5f);
	expect_clips(&bench, -1, (const int[]){0, 1}, 2);
	assert_int_equal(bench.log.count, 1);
	assert_true(log_capture_has(&bench.log, LOG_WARNING,
		"(2 of 4, the first is clip 2) are poses"));
	/* Of those that were not asked for nothing is said. */
	expect_clips(&bench, 0, (const int[]){0}, 1);
	assert_int_equal(bench.log.count, 0);
	expect_clips(&bench, 1, (const int[]){1}, 1);
	assert_int_equal(bench.log.count, 0);
	end(&bench);
}

static void test_clips_that_all_move_cause_no_warning(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, "step", 0.1f, 0.5f);
	add(&bench, "leap", 0.2f, 0.5f);
	expect_clips(&bench, -1, (const int[]){0, 1}, 2);
	assert_int_equal(bench.log.count, 0);
	end(&bench);
}

static void test_a_model_of_poses_is_refused(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, "hold", 0.0f, 0.5f);
	assert_int_equal(compare(&bench, -1), -EINVAL);
	assert_null(bench.comparison);
	assert_int_equal(log_capture_count(&bench.log, LOG_ERROR), 1);
	assert_true(log_capture_has(
		&bench.log, LOG_ERROR, "none of its clips has a duration"));
	end(&bench);
}

/* It is 1 wide and goes by 9 in its longer clip: together they take 10. */
static void test_a_warning_says_how_far_a_model_goes(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, "far", 0.2f, 9.0f);
	add(&bench, "near", 0.1f, 1.0f);
	expect_clips(&bench, -1, (const int[]){0, 1}, 2);
	assert_int_equal(bench.log.count, 1);
	assert_true(log_capture_has(&bench.log, LOG_WARNING,
		"its clips go 10 times as far as it is large"));
	end(&bench);
	begin(&bench);
	add(&bench, "near", 0.1f, 4.5f);
	expect_clips(&bench, -1, (const int[]){0}, 1);
	assert_int_equal(bench.log.count, 0);
	end(&bench);
}

/* Four corners; a row to play all clips with, and why. */
static void test_a_comparison_has_its_vertices_and_an_advice(void **state)
{
	const struct comparison *found;
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, "step", 0.1f, 0.5f);
	add(&bench, "leap", 0.2f, 0.5f);
	assert_int_equal(compare(&bench, -1), 0);
	found = bench.comparison;
	assert_int_equal(found->vertex_count, 4);
	assert_true(found->row[0].front);
	assert_contains(found->reason, "it takes ");
	assert_near(found->time_limit_us, found->request.board->frame_ms * 1e3,
		1e-6);
	assert_true(comparison_has(found, TECHNIQUE_HIERARCHICAL));
	assert_true(comparison_has(found, TECHNIQUE_MORPHING));
	assert_false(comparison_has(found, TECHNIQUE_SKELETAL));
	comparison_destroy(bench.comparison);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_poses_are_left_out_and_named),
		cmocka_unit_test(test_clips_that_all_move_cause_no_warning),
		cmocka_unit_test(test_a_model_of_poses_is_refused),
		cmocka_unit_test(test_a_warning_says_how_far_a_model_goes),
		cmocka_unit_test(
			test_a_comparison_has_its_vertices_and_an_advice),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
