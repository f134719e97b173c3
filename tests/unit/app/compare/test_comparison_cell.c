/*
 * What a comparison finds of a grid that turns so fast that one fit of a
 * morph's key frames does not always keep to the bound between moments.
 */
#include "app/compare/candidate/candidate_time.h"
#include "app/compare/comparison.h"
#include "app/model/levels/levels.h"
#include "platform/base/compiler.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	KEYS = 9,
	SIDE = 2,
	VERTICES = (SIDE + 1) * (SIDE + 1)
};

static int timed;

struct candidate_time candidate_time_measure(
	struct candidate *candidate, int frames)
{
	(void)candidate;
	(void)frames;
	timed++;
	return (struct candidate_time){.frame_us = 1.0};
}

struct turning {
	struct model *model;
	struct model_clip clip;
	struct model_channel channel;
	float time_s[KEYS], value[KEYS][4];
	struct comparison *comparison;
};

/* Turns by speed radians a second, unevenly, and compares. */
static void begin(struct turning *turning, float speed, float bound_px)
{
	const struct log log = log_to_nowhere();
	const struct comparison_request request = {.rate_hz = 30.0,
		.bound_px = bound_px,
		.board = board_profile_find(NULL),
		.width = 240,
		.height = 320,
		.jobs = 1,
		.kernel = &kernel_float};

	*turning = (struct turning){
		.model = small_model_grid(SIDE, SIDE, 1, true),
		.channel = {.path = MODEL_ROTATION,
			.interpolation = MODEL_LINEAR,
			.width = 4,
			.key_count = KEYS,
			.time_s = turning->time_s,
			.value = turning->value[0]},
		.clip = {.name = "turn",
			.channel_count = 1,
			.channel = &turning->channel},
	};
	for (int k = 0; k < KEYS; k++) {
		float half = 0.5f * speed * 0.2f * (float)k +
			0.15f * sinf((float)(k * k));

		turning->time_s[k] = 0.2f * (float)k;
		turning->value[k][2] = sinf(half);
		turning->value[k][3] = cosf(half);
	}
	turning->clip.duration_s = turning->time_s[KEYS - 1];
	turning->model->path = "grid";
	turning->model->clip = &turning->clip;
	turning->model->clip_count = 1;
	assert_int_equal(levels_make(turning->model), 0);
	timed = 0;
	assert_int_equal(comparison_create(turning->model, &request, &log,
				 &turning->comparison),
		0);
}

static void end(struct turning *turning)
{
	comparison_destroy(turning->comparison);
	turning->model->clip = NULL;
	turning->model->clip_count = 0;
	model_destroy(turning->model);
}

/* The morph that a comparison lists, whose bound is the one that is asked for. */
static const struct comparison_row *listed_morph(const struct turning *turning)
{
	const struct comparison *comparison = turning->comparison;

	for (int r = 0; r < comparison->row_count; r++) {
		if (comparison->row[r].kind == COMPARISON_MORPH &&
			comparison->row[r].listed) {
			return &comparison->row[r];
		}
	}
	fail_msg("%s", "no morph is listed");
	return NULL;
}

/* A fit that misses the bound between moments is followed by another one. */
static void test_a_morph_keeps_to_the_bound_and_uses_it(void **state)
{
	(void)state;
	for (float bound_px = 0.6f; bound_px < 4.0f; bound_px *= 3.3f) {
		for (float speed = 6.0f; speed < 12.0f; speed += 2.5f) {
			const struct comparison_cell *cell;
			struct turning turning;

			begin(&turning, speed, bound_px);
			cell = listed_morph(&turning)->cell;
			assert_true(cell->error.peak_px <= bound_px);
			assert_true(cell->error.peak_px >= 0.85f * bound_px);
			assert_int_equal(timed, turning.comparison->row_count);
			end(&turning);
		}
	}
}

/* Moments are so far apart here that no fit of those keeps to the bound. */
static void test_a_morph_that_misses_the_bound_is_timed_as_well(void **state)
{
	const struct comparison_cell *cell;
	struct turning turning;

	(void)state;
	begin(&turning, 8.0f, 1e-3f);
	cell = listed_morph(&turning)->cell;
	assert_true(cell->error.peak_px > 1e-3f);
	assert_near(cell->time.frame_us, 1.0, 0.0);
	assert_int_equal(timed, turning.comparison->row_count);
	end(&turning);
}

/* Key frames that are spread evenly take the same memory each. */
static void test_each_technique_says_what_it_takes(void **state)
{
	const struct comparison_row *even = NULL, *original = NULL, *morph;
	struct turning turning;
	size_t key_bytes;

	(void)state;
	begin(&turning, 8.0f, 2.0f);
	morph = listed_morph(&turning);
	for (int r = 0; r < turning.comparison->row_count; r++) {
		const struct comparison_row *row = &turning.comparison->row[r];

		even = row->kind == COMPARISON_MORPH_EVEN ? row : even;
		original = row->kind == COMPARISON_ORIGINAL ? row : original;
		assert_int_equal(row->cell->vertex_count, VERTICES);
		assert_near(row->cell->time.frame_us, 1.0, 0.0);
		assert_true(row->cell->error.samples > 0);
	}
	assert_non_null(even);
	assert_non_null(original);
	assert_int_equal(even->cell->keys.count, 20);
	assert_int_equal(original->cell->keys.count, 0);
	assert_true(original->cell->error.peak_px < 1e-3f);
	assert_true(even->cell->error.peak_px > 2.0f);
	key_bytes = even->cell->bytes.own / 20;
	assert_true(key_bytes >= 2 * 3 * VERTICES * sizeof(int16_t));
	assert_int_equal(morph->cell->bytes.own,
		key_bytes * (size_t)morph->cell->keys.count);
	assert_true(original->cell->bytes.own < even->cell->bytes.own);
	assert_true(morph->cell->board.vertices.cycles >
		even->cell->board.vertices.cycles);
	assert_true(even->cell->board.vertices.cycles >
		2.0 * original->cell->board.vertices.cycles);
	end(&turning);
}

/* More of a bound takes fewer keys, and no bound is missed by far. */
static void test_rows_of_other_bounds_are_fitted_once(void **state)
{
	struct turning turning;
	int unlisted = 0;

	(void)state;
	begin(&turning, 8.0f, 2.0f);
	for (int r = 0; r < turning.comparison->row_count; r++) {
		const struct comparison_row *row = &turning.comparison->row[r];
		const struct comparison_row *listed = listed_morph(&turning);

		if (row->kind != COMPARISON_MORPH || row->listed) {
			continue;
		}
		unlisted++;
		assert_true(row->cell->error.peak_px > 0.7f * row->bound_px);
		assert_true(row->cell->error.peak_px < 1.2f * row->bound_px);
		assert_int_equal(
			row->cell->keys.count > listed->cell->keys.count,
			row->bound_px < listed->bound_px);
	}
	assert_true(unlisted > 2);
	end(&turning);
}

/*
 * Where a fit misses the bound at a moment that it has looked at, by rounding
 * or as only the middle between two moments is off, more moments do not help.
 */
static void test_a_fit_is_tightened_where_more_moments_do_not_help(void **state)
{
	static const struct {
		float speed, bound_px;
	} cases[] = {{22.09f, 0.15f}, {13.95f, 0.3375f}, {18.02f, 0.225f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct turning turning;

		begin(&turning, cases[i].speed, cases[i].bound_px);
		assert_true(listed_morph(&turning)->cell->error.peak_px <=
			cases[i].bound_px);
		assert_int_equal(timed, turning.comparison->row_count);
		end(&turning);
	}
}

/* The grid has a corner at the origin, and a side of 1. */
static void test_a_clip_knows_the_box_of_the_rest_pose(void **state)
{
	static const struct bounds wanted = {{0, 0, 0}, {1, 1, 0}};
	struct turning turning;

	(void)state;
	begin(&turning, 8.0f, 8.0f);
	for (int axis = 0; axis < 3; axis++) {
		const struct bounds *rest = &turning.comparison->clip[0].rest;

		assert_near(rest->low[axis], wanted.low[axis], 1e-6);
		assert_near(rest->high[axis], wanted.high[axis], 1e-6);
	}
	end(&turning);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_morph_keeps_to_the_bound_and_uses_it),
		cmocka_unit_test(
			test_a_morph_that_misses_the_bound_is_timed_as_well),
		cmocka_unit_test(test_each_technique_says_what_it_takes),
		cmocka_unit_test(test_rows_of_other_bounds_are_fitted_once),
		cmocka_unit_test(
			test_a_fit_is_tightened_where_more_moments_do_not_help),
		cmocka_unit_test(test_a_clip_knows_the_box_of_the_rest_pose),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
