/* The reported peak of an error against a dense sampling of the whole clip. */
#include "app/compare/candidate/candidate_error.h"
#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/measure/grid_refine.h"
#include "app/compare/measure/sampling.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	DENSE = 10, /* samples in each interval of the grid */
	KEPT_BYTES = 1 << 24
};

static void begin(
	struct compared_clip *bench, const char *path, const char *clip)
{
	compared_clip_begin(bench, path, clip);
	assert_int_equal(grid_refine(bench->reference, &bench->screen, 0.25f,
				 &bench->grid),
		0);
}

static float largest_at(
	struct compared_clip *bench, struct candidate *candidate, float time_s)
{
	float(*shown)[3] =
		malloc((size_t)candidate->vertex_count * sizeof(*shown));
	float most = 0.0f;

	assert_non_null(shown);
	candidate_pose(candidate, time_s);
	candidate->take(candidate, shown, NULL);
	reference_pose(bench->reference, time_s, false);
	for (int v = 0; v < candidate->vertex_count; v++) {
		int source = candidate->source ? candidate->source[v] : v;
		float px = screen_view_distance_px(&bench->screen, shown[v],
			bench->reference->position[source]);

		most = px > most ? px : most;
	}
	free(shown);
	return most;
}

/* A candidate, its keys, and the largest error of a dense sampling. */
struct sampled {
	struct candidate candidate;
	struct fit_keys keys;
	float (*shown)[3];
	float peak_px;
};

/* All kinds of candidates whose error varies over the clip. */
enum {
	MORPHS = 3,
	RIGID = MORPHS,
	SKIN_1,
	SAMPLED
};

/* wanted: where the reference's vertices are on the screen. */
static void compare_with_reference(const struct screen_view *screen,
	struct sampled *sampled, float (*wanted)[2])
{
	const struct candidate *candidate = &sampled->candidate;
	float most = sampled->peak_px * sampled->peak_px, before = most;

	for (int v = 0; v < candidate->vertex_count; v++) {
		int source = candidate->source ? candidate->source[v] : v;
		float at[2], square;

		screen_view_project(screen, sampled->shown[v], at);
		at[0] -= wanted[source][0];
		at[1] -= wanted[source][1];
		square = at[0] * at[0] + at[1] * at[1];
		most = square > most ? square : most;
	}
	if (most > before) {
		sampled->peak_px = sqrtf(most);
	}
}

/* The reference comes last, because candidates may pose it for themselves. */
static void compare_all_at(struct compared_clip *bench,
	struct sampled all[SAMPLED], float (*wanted)[2], float time_s)
{
	const struct reference *reference = bench->reference;

	for (int i = 0; i < SAMPLED; i++) {
		struct candidate *candidate = &all[i].candidate;

		candidate_pose(candidate, time_s);
		candidate->take(candidate, all[i].shown, NULL);
	}
	reference_pose(bench->reference, time_s, false);
	for (int v = 0; v < reference->vertex_count; v++) {
		screen_view_project(
			&bench->screen, reference->position[v], wanted[v]);
	}
	for (int i = 0; i < SAMPLED; i++) {
		compare_with_reference(&bench->screen, &all[i], wanted);
	}
}

/* Ten times as dense as the grid and its middles. */
static void find_dense_peaks(
	struct compared_clip *bench, struct sampled all[SAMPLED])
{
	float(*wanted)[2] = malloc(
		(size_t)bench->reference->vertex_count * sizeof(*wanted));

	assert_non_null(wanted);
	for (int i = 0; i < SAMPLED; i++) {
		all[i].candidate.positions_only = true;
		all[i].shown = malloc((size_t)all[i].candidate.vertex_count *
			sizeof(*all[i].shown));
		assert_non_null(all[i].shown);
	}
	for (int i = 0; i + 1 < bench->grid.count; i++) {
		float from = bench->grid.time_s[i];
		float step = (bench->grid.time_s[i + 1] - from) / (2 * DENSE);

		for (int k = 0; k < 2 * DENSE; k++) {
			compare_all_at(
				bench, all, wanted, from + step * (float)k);
		}
	}
	for (int i = 0; i < SAMPLED; i++) {
		all[i].candidate.positions_only = false;
		free(all[i].shown);
	}
	free(wanted);
}

static void agrees(struct compared_clip *bench, struct candidate *candidate,
	float dense_px)
{
	struct candidate_error error;
	float allowed_px = 0.05f * dense_px;

	assert_int_equal(
		candidate_error_measure(candidate, &bench->screen, &bench->grid,
			SAMPLING_NORMALS_MAX, NULL, &error),
		0);
	allowed_px = allowed_px > 0.05f ? allowed_px : 0.05f;
	if (error.peak_px < dense_px - allowed_px) {
		fail_msg("reported %.3f px, but %.3f px were found",
			(double)error.peak_px, (double)dense_px);
	}
	assert_near(error.peak_px, largest_at(bench, candidate, error.peak_s),
		1e-3);
	assert_true(error.mean_px <= error.peak_px);
	assert_true(error.outline_px <= error.peak_px * 1.001f);
}

static void make_morph(
	struct compared_clip *bench, int keys, struct sampled *out)
{
	struct fixed_placement placement =
		candidate_morph_placement(&bench->screen.box);

	assert_int_equal(fit_keys_evenly(bench->reference->clip->duration_s,
				 keys, &out->keys),
		0);
	assert_int_equal(candidate_morph(&out->candidate, bench->reference,
				 kernel_find(NULL), &placement, &out->keys,
				 KEPT_BYTES, &bench->log),
		0);
}

static void check_clip(const char *path, const char *clip)
{
	static const int keys[MORPHS] = {4, 20, 33};
	struct sampled all[SAMPLED] = {0};
	struct compared_clip bench;

	begin(&bench, path, clip);
	for (int i = 0; i < MORPHS; i++) {
		make_morph(&bench, keys[i], &all[i]);
	}
	assert_int_equal(candidate_rigid(&all[RIGID].candidate, bench.reference,
				 &bench.log),
		0);
	assert_int_equal(
		candidate_original(&all[SKIN_1].candidate, bench.reference,
			kernel_find(NULL), 1, true, 60.0, &bench.log),
		0);
	find_dense_peaks(&bench, all);
	for (int i = 0; i < SAMPLED; i++) {
		agrees(&bench, &all[i].candidate, all[i].peak_px);
		candidate_destroy(&all[i].candidate);
		fit_keys_release(&all[i].keys);
	}
	compared_clip_end(&bench);
}

static void test_the_peak_is_found_between_keys(void **state)
{
	(void)state;
	check_clip("assets/walker.glb", "walk");
}

static void test_the_peak_of_fast_turns_is_found(void **state)
{
	(void)state;
	check_clip("assets/walker.glb", "jump");
}

static void test_the_peak_of_other_models_is_found(void **state)
{
	(void)state;
	samples_require("RiggedSimple.glb");
	check_clip(samples_path("RiggedSimple.glb").text, "0");
	check_clip(samples_path("BoxAnimated.glb").text, "0");
	check_clip(samples_path("AnimatedMorphCube.glb").text, "0");
}

/* Rigid parts have no targets, so the clip that is exported has no weights. */
static void test_rigid_parts_cost_no_weights(void **state)
{
	struct model_channel channel[64];
	struct candidate candidate;
	struct model_clip moving;
	struct board_cost wanted;
	struct compared_clip bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "jump");
	moving = *bench.reference->clip;
	assert_in_range(moving.channel_count, 1, ARRAY_COUNT(channel));
	moving.channel = channel;
	moving.channel_count = 0;
	for (int i = 0; i < bench.reference->clip->channel_count; i++) {
		channel[moving.channel_count] =
			bench.reference->clip->channel[i];
		moving.channel_count +=
			channel[moving.channel_count].path != MODEL_WEIGHTS;
	}
	assert_int_equal(
		moving.channel_count, bench.reference->clip->channel_count - 1);
	assert_int_equal(
		candidate_rigid(&candidate, bench.reference, &bench.log), 0);
	wanted = board_cost_sample(&moving, bench.model->node_count);
	assert_near(candidate.board.sample.cycles, wanted.cycles, 1e-6);
	assert_near(
		candidate.board.sample.instructions, wanted.instructions, 1e-6);
	candidate_destroy(&candidate);
	compared_clip_end(&bench);
}

/* How far a made-up candidate is from the reference: most at one moment. */
struct cusp {
	float peak_s, duration_s, moment_s;
};

static void cusp_pose(struct candidate *candidate, float time_s)
{
	struct cusp *cusp = candidate->state;

	cusp->moment_s = time_s;
	reference_pose(candidate->reference, time_s, true);
}

static void cusp_take(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct reference *reference = candidate->reference;
	const struct cusp *cusp = candidate->state;
	float apart = fabsf(cusp->moment_s - cusp->peak_s) / cusp->duration_s;
	size_t bytes = (size_t)candidate->vertex_count * sizeof(*position);

	memcpy(position, reference->position, bytes);
	for (int v = 0; v < candidate->vertex_count; v++) {
		position[v][0] += 0.1f * (1.0f - sqrtf(apart));
	}
	if (normal) {
		memcpy(normal, reference->normal, bytes);
	}
}

/* Halves of halves come near to a peak that no even division meets. */
static void test_a_sharp_peak_within_an_interval_is_found(void **state)
{
	static const float places[] = {1.0f / 3.0f, 2.0f / 3.0f};
	struct compared_clip bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "idle");
	for (int i = 0; i < 2; i++) {
		float duration_s = bench.reference->clip->duration_s;
		float ends_s[2] = {0.0f, duration_s}, largest_px;
		struct cusp cusp = {places[i] * duration_s, duration_s, 0.0f};
		const struct time_grid grid = {.time_s = ends_s, .count = 2};
		struct candidate_error error;
		struct candidate candidate = {.reference = bench.reference,
			.vertex_count = bench.reference->vertex_count,
			.pose = cusp_pose,
			.take = cusp_take,
			.state = &cusp};

		assert_int_equal(
			candidate_error_measure(&candidate, &bench.screen,
				&grid, SAMPLING_NORMALS_MAX, NULL, &error),
			0);
		largest_px = largest_at(&bench, &candidate, cusp.peak_s);
		assert_in_range(100.0f * error.peak_px / largest_px, 96, 100);
		assert_near(
			error.peak_s, cusp.peak_s, 2e-3 * (double)duration_s);
	}
	compared_clip_end(&bench);
}

/* A morph that keeps two keys at a time shows what one with all keys does. */
static void test_keys_that_are_baked_again_are_the_same(void **state)
{
	struct candidate_error error[2];
	struct compared_clip bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "run");
	for (int i = 0; i < 2; i++) {
		struct fixed_placement placement =
			candidate_morph_placement(&bench.screen.box);
		struct candidate candidate;
		struct fit_keys keys;

		assert_int_equal(fit_keys_within(bench.reference, &bench.screen,
					 &bench.grid, 1.0f, KEPT_BYTES, &keys),
			0);
		assert_true(keys.count > 4);
		assert_int_equal(candidate_morph(&candidate, bench.reference,
					 kernel_find(NULL), &placement, &keys,
					 (size_t)i * KEPT_BYTES, &bench.log),
			0);
		assert_int_equal(candidate_error_measure(&candidate,
					 &bench.screen, &bench.grid,
					 SAMPLING_NORMALS_MAX, NULL, &error[i]),
			0);
		candidate_destroy(&candidate);
		fit_keys_release(&keys);
	}
	assert_memory_equal(&error[0], &error[1], sizeof(error[0]));
	compared_clip_end(&bench);
}

static struct {
	const struct fixed_key *source, *destiny;
} lerped;

static void keep_keys(int count, const struct fixed_key *source,
	const struct fixed_key *destiny, struct fixed_weights weights,
	struct fixed_vector *out)
{
	lerped.source = source;
	lerped.destiny = destiny;
	fixed_loops_c.lerp_keys(count, source, destiny, weights, out);
}

/* Loops load two vertices, 12 bytes, as three words. */
static void test_each_key_begins_at_a_whole_word(void **state)
{
	struct fixed_loops loops = fixed_loops_c;
	const struct kernel kernel = {.fixed = &loops};
	struct compared_clip bench;
	struct fit_keys keys;
	int whole;

	(void)state;
	loops.lerp_keys = keep_keys;
	begin(&bench, "assets/walker.glb", "run");
	assert_int_equal(fit_keys_evenly(1.0f, 4, &keys), 0);
	whole = bench.reference->vertex_count;
	for (int count = 20; count < 26; count++) {
		struct fixed_placement placement =
			candidate_morph_placement(&bench.screen.box);
		struct candidate candidate;

		bench.reference->vertex_count = count;
		assert_int_equal(
			candidate_morph(&candidate, bench.reference, &kernel,
				&placement, &keys, KEPT_BYTES, &bench.log),
			0);
		for (int i = 0; i < 3; i++) {
			size_t apart;

			candidate_pose(&candidate, keys.time_s[i]);
			apart = (size_t)(lerped.destiny - lerped.source);
			assert_int_equal(apart, count + count % 2);
			assert_int_equal((uintptr_t)lerped.source % 4, 0);
		}
		candidate_destroy(&candidate);
	}
	bench.reference->vertex_count = whole;
	fit_keys_release(&keys);
	compared_clip_end(&bench);
}

/* Half way between normals that are nearly opposite. */
static void leave_little(int count, const struct fixed_key *source,
	const struct fixed_key *destiny, struct fixed_weights weights,
	struct fixed_vector *out)
{
	(void)source;
	(void)destiny;
	(void)weights;
	memset(out, 0, (size_t)count * sizeof(*out));
	out[0].y = -1;
	out[1].x = 3;
	out[1].z = 4;
}

static void test_the_shortest_normal_has_a_direction(void **state)
{
	static const float expected[3][3] = {
		{0, -1, 0}, {0.6f, 0, 0.8f}, {0, 0, 0}};
	struct fixed_loops loops = fixed_loops_c;
	const struct kernel kernel = {.fixed = &loops};
	struct fixed_placement placement;
	struct compared_clip bench;
	struct candidate candidate;
	struct fit_keys keys;
	float(*normal)[3], (*position)[3];

	(void)state;
	loops.lerp_keys = leave_little;
	begin(&bench, "assets/walker.glb", "run");
	placement = candidate_morph_placement(&bench.screen.box);
	assert_int_equal(fit_keys_evenly(1.0f, 4, &keys), 0);
	assert_int_equal(candidate_morph(&candidate, bench.reference, &kernel,
				 &placement, &keys, KEPT_BYTES, &bench.log),
		0);
	normal = calloc((size_t)candidate.vertex_count, sizeof(*normal));
	position = calloc((size_t)candidate.vertex_count, sizeof(*position));
	assert_non_null(normal);
	assert_non_null(position);
	candidate_pose(&candidate, 0.1f);
	candidate.take(&candidate, position, normal);
	for (int i = 0; i < 9; i++) {
		assert_near(normal[i / 3][i % 3], expected[i / 3][i % 3], 1e-6);
	}
	free(position);
	free(normal);
	candidate_destroy(&candidate);
	fit_keys_release(&keys);
	compared_clip_end(&bench);
}

/* With room for few moments a fit takes more keys, all within the bound. */
static void test_a_fit_in_little_memory_keeps_within_the_bound(void **state)
{
	struct fit_keys wide, narrow;
	struct compared_clip bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "idle");
	assert_int_equal(fit_keys_within(bench.reference, &bench.screen,
				 &bench.grid, 2.0f, KEPT_BYTES, &wide),
		0);
	assert_int_equal(fit_keys_within(bench.reference, &bench.screen,
				 &bench.grid, 2.0f, 1 << 18, &narrow),
		0);
	assert_true(wide.count >= 3);
	assert_true(narrow.count > wide.count);
	for (int i = 1; i < narrow.count; i++) {
		assert_true(narrow.time_s[i] > narrow.time_s[i - 1]);
	}
	assert_true(narrow.time_s[0] == 0.0f);
	assert_true(narrow.time_s[narrow.count - 1] ==
		bench.reference->clip->duration_s);
	fit_keys_release(&wide);
	fit_keys_release(&narrow);
	compared_clip_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_peak_is_found_between_keys),
		cmocka_unit_test(test_the_peak_of_fast_turns_is_found),
		cmocka_unit_test(test_the_peak_of_other_models_is_found),
		cmocka_unit_test(test_a_sharp_peak_within_an_interval_is_found),
		cmocka_unit_test(test_rigid_parts_cost_no_weights),
		cmocka_unit_test(test_keys_that_are_baked_again_are_the_same),
		cmocka_unit_test(test_each_key_begins_at_a_whole_word),
		cmocka_unit_test(test_the_shortest_normal_has_a_direction),
		cmocka_unit_test(
			test_a_fit_in_little_memory_keeps_within_the_bound),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
