/* Fitted key frames, compared with a plain search over all moments. */
#include "app/compare/candidate/fit.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	MISSES = 8, /* fit.h: in a row, after which it gives up */
	PLENTY_BYTES = 1 << 26
};

struct bench {
	struct compared_clip of;
	float (*position)[3]; /* [grid.count][vertex_count] */
	struct fit_keys keys;
};

static void begin(struct bench *bench)
{
	size_t count;

	memset(bench, 0, sizeof(*bench));
	compared_clip_begin(&bench->of, "assets/walker.glb", "walk");
	count = (size_t)bench->of.reference->vertex_count;
	bench->position = malloc((size_t)bench->of.grid.count * count *
		sizeof(*bench->position));
	assert_non_null(bench->position);
	for (int i = 0; i < bench->of.grid.count; i++) {
		reference_pose(
			bench->of.reference, bench->of.grid.time_s[i], false);
		memcpy(bench->position + (size_t)i * count,
			bench->of.reference->position,
			count * sizeof(*bench->position));
	}
}

static void end(struct bench *bench)
{
	free(bench->position);
	compared_clip_end(&bench->of);
}

static const float (*positions(const struct bench *bench, int moment))[3]
{
	return (const float(*)[3])bench->position +
		(size_t)moment * (size_t)bench->of.reference->vertex_count;
}

/* How far the line between two keys is off at most at a moment. */
static float off_px(const struct bench *bench, int from, int to, int moment)
{
	const float *time_s = bench->of.grid.time_s;
	const float(*a)[3] = positions(bench, from),
	      (*b)[3] = positions(bench, to),
	      (*wanted)[3] = positions(bench, moment);
	float t = (time_s[moment] - time_s[from]) / (time_s[to] - time_s[from]);
	float most = 0.0f;

	for (int v = 0; v < bench->of.reference->vertex_count; v++) {
		float at[3], px;

		for (int i = 0; i < 3; i++) {
			at[i] = a[v][i] + (b[v][i] - a[v][i]) * t;
		}
		px = screen_view_distance_px(&bench->of.screen, at, wanted[v]);
		most = px > most ? px : most;
	}
	return most;
}

static bool fits(const struct bench *bench, int from, int to, float bound_px)
{
	for (int moment = from + 1; moment < to; moment++) {
		if (off_px(bench, from, to, moment) > bound_px) {
			return false;
		}
	}
	return true;
}

/* The next key by the rule of fit.h, in spans of at most so many moments. */
static int next_key(
	const struct bench *bench, int from, float bound_px, int span_max)
{
	int best = from + 1, misses = 0;

	for (int to = from + 1; to < bench->of.grid.count &&
		to - from <= span_max && misses < MISSES;
		to++) {
		if (fits(bench, from, to, bound_px)) {
			best = to;
			misses = 0;
		} else {
			misses++;
		}
	}
	return best;
}

static void expect_rule(
	struct bench *bench, float bound_px, size_t bytes, int span_max)
{
	const struct fit_keys *keys = &bench->keys;
	int at = 0;

	assert_int_equal(fit_keys_within(bench->of.reference, &bench->of.screen,
				 &bench->of.grid, bound_px, bytes, &bench->keys),
		0);
	assert_near(keys->time_s[0], 0.0, 0.0);
	for (int k = 1; k < keys->count; k++) {
		at = next_key(bench, at, bound_px, span_max);
		assert_near(keys->time_s[k], bench->of.grid.time_s[at], 0.0);
	}
	assert_int_equal(at, bench->of.grid.count - 1);
	fit_keys_release(&bench->keys);
	assert_null(bench->keys.time_s);
}

static void test_each_key_is_the_farthest_that_keeps_the_bound(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	expect_rule(&bench, 1.0f, PLENTY_BYTES, bench.of.grid.count);
	expect_rule(&bench, 6.0f, PLENTY_BYTES, bench.of.grid.count);
	end(&bench);
}

enum {
	LOW_MOMENTS = 24, /* at -0.75, after one at 0 */
	DANCE_MOMENTS = LOW_MOMENTS + MISSES + 2
};

/*
 * A square that goes to -0.75, stays at 0.75 for so many moments, which no line
 * from its begin reaches within 1, and ends at 0, which one does.
 */
struct dance {
	struct model_clip clip;
	struct model_channel channel;
	float time_s[DANCE_MOMENTS];
	float value[DANCE_MOMENTS][3];
};

static void make_dance(struct dance *dance, int high_moments)
{
	int last = LOW_MOMENTS + high_moments + 1;

	memset(dance, 0, sizeof(*dance));
	for (int i = 0; i <= last; i++) {
		dance->time_s[i] = (float)i / 64.0f;
		if (i > 0 && i < last) {
			dance->value[i][0] = i <= LOW_MOMENTS ? -0.75f : 0.75f;
		}
	}
	dance->channel = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = last + 1,
		.time_s = dance->time_s,
		.value = dance->value[0]};
	dance->clip = (struct model_clip){.name = "dance",
		.duration_s = dance->time_s[last],
		.channel_count = 1,
		.channel = &dance->channel};
}

/* The first key after the begin, as a moment of the dance. */
static int first_key_of(int high_moments)
{
	struct compared_clip of = {.log = log_to_stderr(LOG_WARNING)};
	static const float begin[3] = {0}, unit[3] = {1};
	struct fit_keys keys;
	struct dance dance;
	int moment;

	make_dance(&dance, high_moments);
	of.model = small_model_grid(1, 1, 1.0f, false);
	of.model->clip = &dance.clip;
	of.model->clip_count = 1;
	assert_int_equal(
		reference_create(of.model, 0, &of.log, &of.reference), 0);
	assert_int_equal(time_grid_make(&dance.clip, &of.grid), 0);
	assert_int_equal(of.grid.count, dance.channel.key_count);
	of.screen = screen_view_create(of.reference, &of.grid, 480, 640);
	assert_int_equal(
		fit_keys_within(of.reference, &of.screen, &of.grid,
			screen_view_distance_px(&of.screen, begin, unit),
			PLENTY_BYTES, &keys),
		0);
	moment = (int)(keys.time_s[1] * 64.0f + 0.5f);
	fit_keys_release(&keys);
	compared_clip_end(&of);
	return moment;
}

static void test_it_gives_up_after_eight_moments_that_do_not_fit(void **state)
{
	(void)state;
	assert_int_equal(first_key_of(1), LOW_MOMENTS + 2);
	assert_int_equal(first_key_of(MISSES - 1), LOW_MOMENTS + MISSES);
	assert_int_equal(first_key_of(MISSES), LOW_MOMENTS);
}

static void test_the_memory_limits_the_spans(void **state)
{
	struct bench bench;
	size_t moment;

	(void)state;
	begin(&bench);
	moment = (size_t)bench.of.reference->vertex_count * sizeof(float[3]);
	expect_rule(&bench, 6.0f, 5 * moment, 4);
	expect_rule(&bench, 6.0f, 6 * moment - 1, 4);
	/* It takes three moments at least. */
	expect_rule(&bench, 6.0f, 0, 2);
	end(&bench);
}

static void test_even_keys_reach_from_start_to_end(void **state)
{
	static const float wanted[] = {0, 0.5f, 1, 1.5f, 2};
	struct fit_keys keys;

	(void)state;
	assert_int_equal(fit_keys_evenly(2.0f, 5, &keys), 0);
	assert_int_equal(keys.count, 5);
	assert_all_near(keys.time_s, wanted, 5, 0);
	fit_keys_release(&keys);
	assert_int_equal(fit_keys_evenly(2.0f, 2, &keys), 0);
	assert_near(keys.time_s[1], 2.0, 0.0);
	fit_keys_release(&keys);
}

/*
 * A point that is up for a moment, down for some and up at the end: a line to
 * the end keeps to the bound, and a line to none of those where it is down.
 */
static int keys_over_a_gap(int down)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct model *model = small_model_grid(1, 1, 1, true);
	float time_s[MISSES + 4], value[MISSES + 4][3] = {{0}};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = down + 3,
		.time_s = time_s,
		.value = value[0]};
	struct model_clip clip = {
		.duration_s = 2.0f, .channel_count = 1, .channel = &channel};
	const struct time_grid grid = {.count = down + 3, .time_s = time_s};
	struct reference *reference;
	struct screen_view screen;
	struct fit_keys keys;
	const float a[3] = {0, 0, 0}, b[3] = {0, 1, 0};
	int count;

	time_s[0] = 0.0f;
	for (int i = 1; i <= down + 1; i++) {
		time_s[i] = 1.0f + 1e-3f * (float)i;
	}
	time_s[down + 2] = 2.0f;
	value[1][1] = value[down + 2][1] = 1.5f;
	model->clip = &clip;
	model->clip_count = 1;
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	screen = screen_view_create(reference, &grid, 480, 640);
	assert_int_equal(fit_keys_within(reference, &screen, &grid,
				 screen_view_distance_px(&screen, a, b),
				 PLENTY_BYTES, &keys),
		0);
	count = keys.count;
	fit_keys_release(&keys);
	reference_destroy(reference);
	model->clip = NULL;
	model->clip_count = 0;
	model_destroy(model);
	return count;
}

static void test_a_fit_gives_up_after_a_row_of_misses(void **state)
{
	(void)state;
	assert_int_equal(keys_over_a_gap(1), 2);
	assert_int_equal(keys_over_a_gap(MISSES - 1), 2);
	assert_true(keys_over_a_gap(MISSES) > 2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_key_is_the_farthest_that_keeps_the_bound),
		cmocka_unit_test(
			test_it_gives_up_after_eight_moments_that_do_not_fit),
		cmocka_unit_test(test_the_memory_limits_the_spans),
		cmocka_unit_test(test_even_keys_reach_from_start_to_end),
		cmocka_unit_test(test_a_fit_gives_up_after_a_row_of_misses),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
