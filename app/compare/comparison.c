#include "app/compare/comparison.h"

#include "app/compare/candidate_morph.h"
#include "app/compare/candidate_rigid.h"
#include "app/compare/fit.h"
#include "app/model/model_stats.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

/* AN4044, section 4: "20 key frames are required". */
enum {
	AN4044_KEYS = 20
};

/* Only the program for the board has this kernel. */
static const char board_kernel[] = "armv6";

/* The other points of the plot, as multiples of the bound. */
static const float other_bounds[] = {0.25f, 0.5f, 2.0f, 4.0f};
static const int caps[] = {4, 2, 1};

static struct candidate *next_candidate(struct comparison *comparison)
{
	return &comparison->candidate[comparison->candidate_count];
}

/* Counts the candidate that next_candidate() gave, unless it has failed. */
static int count_candidate(struct comparison *comparison, int error, bool listed)
{
	if (!error) {
		next_candidate(comparison)->listed = listed;
		comparison->candidate_count++;
	}
	return error;
}

static int most_influences(const struct model *model)
{
	struct model_stats stats;

	model_measure(model, &stats);
	return stats.max_influences;
}

static bool has_targets(const struct model *model)
{
	for (int i = 0; i < model->mesh_count; i++) {
		if (model->mesh[i].target_count > 0) {
			return true;
		}
	}
	return false;
}

static int add_originals(struct comparison *comparison, const struct log *log)
{
	const struct reference *reference = comparison->reference;
	const struct kernel *kernel = comparison->request.kernel;
	const struct model *model = reference->model;
	int most = most_influences(model);
	int error = count_candidate(comparison,
		candidate_original(next_candidate(comparison), reference,
			kernel, 0, true, log),
		true);

	if (!error && has_targets(model) && model->skin_count > 0) {
		error = count_candidate(comparison,
			candidate_original(next_candidate(comparison),
				reference, kernel, 0, false, log),
			true);
	}
	for (size_t i = 0; !error && i < ARRAY_COUNT(caps); i++) {
		if (caps[i] < most) {
			error = count_candidate(comparison,
				candidate_original(next_candidate(comparison),
					reference, kernel, caps[i], true, log),
				true);
		}
	}
	return error;
}

/* Adds a morph fitted to the bound; if that is 0, with AN4044's even keys. */
static int add_morph(struct comparison *comparison, float bound_px, bool listed,
	const struct log *log)
{
	const struct reference *reference = comparison->reference;
	int *key = malloc((size_t)reference->frame_count * sizeof(*key));
	int count = -ENOMEM;
	int error;

	if (key && bound_px > 0.0f) {
		count = fit_keys(reference, &comparison->screen, bound_px, key);
	} else if (key) {
		count = fit_even_keys(reference, AN4044_KEYS, key);
	}
	if (count < 0) {
		log_error(log,
			"%s: there is not enough memory to fit key frames",
			reference->model->path);
		free(key);
		return count;
	}
	error = count_candidate(comparison,
		candidate_morph(next_candidate(comparison), reference,
			comparison->request.kernel, key, count, log),
		listed);
	if (!error) {
		comparison->candidate[comparison->candidate_count - 1].even =
			!(bound_px > 0.0f);
	}
	free(key);
	return error;
}

static int add_all(struct comparison *comparison, const struct log *log)
{
	float bound_px = comparison->request.bound_px;
	int error = add_originals(comparison, log);

	if (!error) {
		error = add_morph(comparison, bound_px, true, log);
	}
	if (!error) {
		snprintf(comparison->candidate[comparison->candidate_count - 1].name,
			sizeof(comparison->candidate->name),
			"morph, %d keys fitted",
			comparison->candidate[comparison->candidate_count - 1]
				.key_count);
		error = add_morph(comparison, 0.0f, true, log);
	}
	if (!error) {
		error = count_candidate(comparison,
			candidate_rigid(next_candidate(comparison),
				comparison->reference, log),
			true);
	}
	for (size_t i = 0; !error && i < ARRAY_COUNT(other_bounds); i++) {
		error = add_morph(
			comparison, bound_px * other_bounds[i], false, log);
	}
	return error;
}

double comparison_cost_of(
	const struct comparison *comparison, const struct candidate *candidate)
{
	switch (comparison->cost) {
	case COMPARISON_COST_INSTRUCTIONS:
		return candidate->instructions;
	case COMPARISON_COST_TIME:
		return candidate->frame_us;
	default:
		return board_cost_us(&candidate->board);
	}
}

static enum comparison_cost choose_cost(const struct comparison *comparison)
{
	if (!kernel_find(board_kernel)) {
		return COMPARISON_COST_PREDICTED;
	}
	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].instructions < 0.0) {
			return COMPARISON_COST_TIME;
		}
	}
	return COMPARISON_COST_INSTRUCTIONS;
}

bool comparison_has(
	const struct comparison *comparison, enum technique technique)
{
	for (int i = 0; i < comparison->candidate_count; i++) {
		const struct candidate *candidate = &comparison->candidate[i];

		if (candidate->listed && candidate->technique == technique) {
			return true;
		}
	}
	return false;
}

static bool fits(
	const struct comparison *comparison, const struct candidate *candidate)
{
	size_t limit = comparison->request.memory_bytes;

	return limit == 0 || candidate->memory_bytes <= limit;
}

/* Whether a is the better choice. */
static bool is_better(const struct comparison *comparison,
	const struct candidate *a, const struct candidate *b)
{
	float bound_px = comparison->request.bound_px;
	double a_cost = comparison_cost_of(comparison, a);
	double b_cost = comparison_cost_of(comparison, b);
	bool a_fits = a->error.peak_px <= bound_px;
	bool b_fits = b->error.peak_px <= bound_px;

	if (fits(comparison, a) != fits(comparison, b)) {
		return fits(comparison, a);
	}
	if (!fits(comparison, a)) {
		return a->memory_bytes < b->memory_bytes;
	}
	if (a_fits != b_fits) {
		return a_fits;
	}
	if (!a_fits) {
		return a->error.peak_px < b->error.peak_px;
	}
	return a_cost < b_cost ||
		(a_cost <= b_cost && a->memory_bytes < b->memory_bytes);
}

static void advise(struct comparison *comparison)
{
	const struct candidate *best = &comparison->candidate[0];
	const char *why;

	for (int i = 1; i < comparison->candidate_count; i++) {
		const struct candidate *other = &comparison->candidate[i];

		if (other->listed && is_better(comparison, other, best)) {
			best = other;
		}
	}
	comparison->advised = (int)(best - comparison->candidate);
	if (!fits(comparison, best)) {
		why = "nothing fits the memory, and it needs the least";
	} else if (best->error.peak_px > comparison->request.bound_px) {
		why = "nothing that fits the memory keeps within the error, and it comes closest";
	} else if (comparison->cost != COMPARISON_COST_PREDICTED) {
		why = "it costs least of all that keep within the error and the memory";
	} else {
		why = "the timing model predicts that it takes the least time on an ARM1136 of all that keep within the error and the memory";
	}
	snprintf(comparison->reason, sizeof(comparison->reason), "%s", why);
}

static int prepare(struct comparison *comparison, const struct model *model,
	const struct log *log)
{
	const struct comparison_request *request = &comparison->request;
	int error = reference_create(model, request->clip, request->rate_hz,
		log, &comparison->reference);

	if (error) {
		return error;
	}
	comparison->screen = screen_view_create(
		comparison->reference, request->width, request->height);
	error = add_all(comparison, log);
	for (int i = 0; !error && i < comparison->candidate_count; i++) {
		candidate_measure(&comparison->candidate[i],
			comparison->reference, &comparison->screen);
	}
	return error;
}

int comparison_create(const struct model *model,
	const struct comparison_request *request, const struct log *log,
	struct comparison **out)
{
	struct comparison *comparison = calloc(1, sizeof(*comparison));
	int error;

	if (!comparison) {
		log_error(log, "%s: there is not enough memory to compare it",
			model->path);
		return -ENOMEM;
	}
	comparison->request = *request;
	error = prepare(comparison, model, log);
	if (error) {
		comparison_destroy(comparison);
		return error;
	}
	comparison->cost = choose_cost(comparison);
	advise(comparison);
	*out = comparison;
	return 0;
}

void comparison_destroy(struct comparison *comparison)
{
	if (comparison) {
		for (int i = 0; i < comparison->candidate_count; i++) {
			candidate_destroy(&comparison->candidate[i]);
		}
		reference_destroy(comparison->reference);
		free(comparison);
	}
}
