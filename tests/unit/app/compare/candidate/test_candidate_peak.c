/* The peak of an error that several threads search for together. */
#include "app/compare/candidate/candidate_error.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>

enum {
	THREADS = 4,
	WAIT_S = 60 /* a thread has begun by then */
};

/* Candidates that wait for each other, once. */
struct meeting {
	int count;
	atomic_int met;
};

/* A candidate that is off by a wave over time. */
struct wave {
	struct meeting *meeting;
	float time_s;
	int poses;
};

static void meet(struct meeting *meeting)
{
	const struct timespec moment = {.tv_nsec = 1000000};

	atomic_fetch_add(&meeting->met, 1);
	for (int i = 0; i < WAIT_S * 1000 &&
		atomic_load(&meeting->met) < meeting->count;
		i++) {
		nanosleep(&moment, NULL);
	}
}

static void pose_wave(struct candidate *candidate, float time_s)
{
	struct wave *wave = candidate->state;

	if (wave->poses++ == 0) {
		meet(wave->meeting);
	}
	wave->time_s = time_s;
	reference_pose(candidate->reference, time_s, !candidate->positions_only);
}

static void take_wave(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct reference *reference = candidate->reference;
	const struct wave *wave = candidate->state;
	size_t bytes = (size_t)candidate->vertex_count * sizeof(*position);

	memcpy(position, reference->position, bytes);
	for (int v = 0; v < candidate->vertex_count; v++) {
		position[v][1] += 0.01f * sinf(7.0f * wave->time_s + (float)v);
	}
	if (normal) {
		memcpy(normal, reference->normal, bytes);
	}
}

/* Searches with some threads, of which each is to compare some moments. */
static float find_peak(struct compared_clip *bench, int threads)
{
	struct meeting meeting = {.count = threads};
	struct candidate candidate[THREADS];
	struct reference *own[THREADS];
	struct wave wave[THREADS];
	float peak_px = 0.0f;

	for (int i = 0; i < threads; i++) {
		assert_int_equal(reference_create(bench->model,
					 bench->reference->clip_index,
					 &bench->log, &own[i]),
			0);
		wave[i] = (struct wave){.meeting = &meeting};
		candidate[i] = (struct candidate){
			.reference = own[i],
			.vertex_count = own[i]->vertex_count,
			.pose = pose_wave,
			.take = take_wave,
			.state = &wave[i],
		};
	}
	assert_int_equal(candidate_error_find_peak(candidate, threads,
				 &bench->screen, &bench->grid, &peak_px),
		0);
	for (int i = 0; i < threads; i++) {
		assert_true(wave[i].poses > 0);
		reference_destroy(own[i]);
	}
	assert_int_equal(atomic_load(&meeting.met), threads);
	return peak_px;
}

/* A clip, a candidate that is off by a wave, and its error. */
struct waving {
	struct compared_clip bench;
	struct meeting alone;
	struct wave wave;
	struct candidate candidate;
	struct candidate_error error;
};

static void begin(struct waving *waving)
{
	struct compared_clip *bench = &waving->bench;

	compared_clip_begin(bench, "assets/walker.glb", "idle");
	waving->alone = (struct meeting){.count = 1};
	waving->wave = (struct wave){.meeting = &waving->alone};
	waving->candidate = (struct candidate){
		.reference = bench->reference,
		.vertex_count = bench->reference->vertex_count,
		.pose = pose_wave,
		.take = take_wave,
		.state = &waving->wave,
	};
	assert_int_equal(
		candidate_error_measure(&waving->candidate, &bench->screen,
			&bench->grid, 1, NULL, &waving->error),
		0);
}

static void test_the_peak_does_not_depend_on_the_threads(void **state)
{
	struct waving waving;

	(void)state;
	begin(&waving);
	assert_true(waving.error.peak_px > 1.0f);
	for (int threads = 1; threads <= THREADS; threads++) {
		float peak_px = find_peak(&waving.bench, threads);

		assert_memory_equal(
			&peak_px, &waving.error.peak_px, sizeof(peak_px));
	}
	compared_clip_end(&waving.bench);
}

/* Finds the moments of an error beyond a bound, which must not change it. */
static void find_excess(
	struct waving *waving, float bound_px, struct candidate_excess *out)
{
	const struct compared_clip *bench = &waving->bench;
	struct candidate_error error;

	*out = (struct candidate_excess){.bound_px = bound_px};
	assert_int_equal(candidate_error_measure(&waving->candidate,
				 &bench->screen, &bench->grid, 1, out, &error),
		0);
	assert_near(error.peak_px, waving->error.peak_px, 0);
	assert_int_equal(error.samples, waving->error.samples);
}

static bool is_listed(const struct candidate_excess *excess, float time_s)
{
	for (int i = 0; i < excess->count; i++) {
		if (excess->time_s[i] == time_s) {
			return true;
		}
	}
	return false;
}

/* Of the first 512 of them; the bound itself is kept. */
static void test_moments_beyond_the_bound_are_listed(void **state)
{
	struct candidate_excess excess;
	struct waving waving;
	const struct candidate_error *error = &waving.error;

	(void)state;
	begin(&waving);
	find_excess(&waving, error->peak_px, &excess);
	assert_int_equal(excess.count, 0);
	find_excess(&waving, nextafterf(error->peak_px, 0), &excess);
	assert_in_range(excess.count, 1, 3);
	assert_true(is_listed(&excess, error->peak_s));
	find_excess(&waving, 0.0f, &excess);
	assert_int_equal(
		excess.count, error->samples < 512 ? error->samples : 512);
	for (int i = 0; i < 5; i++) {
		assert_true(is_listed(&excess, waving.bench.grid.time_s[i]));
	}
	compared_clip_end(&waving.bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_peak_does_not_depend_on_the_threads),
		cmocka_unit_test(test_moments_beyond_the_bound_are_listed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
