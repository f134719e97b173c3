#include "app/compare/comparison_cell.h"

#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"

#include "app/compare/measure/grid_refine.h"
#include "app/compare/measure/winding.h"

#include <errno.h>

enum {
	/* AN4044, section 4: "20 key frames are required". */
	AN4044_KEYS = 20,
	FITS_MAX = 12,
	/* Poses and key frames that all threads together keep in memory. */
	KEPT_BYTES = 40 * 1024 * 1024
};

/* The first fit uses this share of the bound, to leave room between moments. */
static const float first_fit = 0.97f;

/* The first reference finds the model's scale, which all others take over. */
static int make_reference(struct comparison *comparison, int clip,
	struct jobs *jobs, const struct log *log, struct reference **out)
{
	int error;

	jobs_lock(jobs);
	error = reference_create_scaled(comparison->model,
		comparison->clip[clip].clip, comparison->unit_scale, log, out);
	if (!error) {
		comparison->unit_scale = (*out)->instance->unit_scale;
	}
	jobs_unlock(jobs);
	return error;
}

static void end_reference(struct reference *reference, struct jobs *jobs)
{
	jobs_lock(jobs);
	reference_destroy(reference);
	jobs_unlock(jobs);
}

/*
 * Frames the clip at the moments that are compared, and at even keys, so that
 * the box contains all that these show.
 */
static int frame_sampled(const struct comparison *comparison,
	struct comparison_clip *to, struct reference *reference)
{
	struct time_grid framed = {0};
	struct fit_keys keys = {0};
	int error;

	time_grid_thin(&to->grid, comparison->sampling.share);
	error = fit_keys_evenly(reference->clip->duration_s, AN4044_KEYS, &keys);
	if (!error) {
		error = time_grid_add(&framed, to->grid.time_s, to->grid.count);
	}
	if (!error) {
		error = time_grid_add(&framed, keys.time_s, keys.count);
	}
	if (!error) {
		to->screen = screen_view_create(reference, &framed,
			comparison->request.width, comparison->request.height);
	}
	time_grid_release(&framed);
	fit_keys_release(&keys);
	return error;
}

/* Half of the bound leaves the fit some choice of keys. */
static int frame_all(const struct comparison *comparison,
	struct comparison_clip *to, struct reference *reference)
{
	const struct comparison_request *request = &comparison->request;

	to->screen = screen_view_create(
		reference, &to->grid, request->width, request->height);
	return grid_refine(
		reference, &to->screen, 0.5f * request->bound_px, &to->grid);
}

int comparison_clip_prepare(struct comparison *comparison, int clip,
	struct jobs *jobs, const struct log *log)
{
	struct comparison_clip *to = &comparison->clip[clip];
	struct reference *reference;
	int error = make_reference(comparison, clip, jobs, log, &reference);

	if (error) {
		return error;
	}
	reference_rest(reference);
	to->rest = bounds_empty();
	for (int v = 0; v < reference->vertex_count; v++) {
		bounds_add(&to->rest, reference->position[v]);
	}
	error = comparison->sampling.share < 1.0
		? frame_sampled(comparison, to, reference)
		: frame_all(comparison, to, reference);
	if (!error) {
		error = winding_find_turns(reference, &to->grid, &to->turns);
	}
	if (error) {
		log_error(log,
			"%s: clip %d is too long to compare: there is not enough memory",
			comparison->model->path, to->clip);
	}
	end_reference(reference, jobs);
	return error;
}

/* One job: a row and a clip, and where its result goes. */
struct task {
	struct comparison *comparison;
	const struct comparison_row *row;
	const struct comparison_clip *clip;
	struct comparison_cell *cell;
	struct reference *reference;
	struct jobs *jobs;
	const struct log *log;
};

static size_t kept_bytes(const struct task *task)
{
	return KEPT_BYTES / 2 / (size_t)task->comparison->request.jobs;
}

static int create(struct task *task, struct candidate *candidate)
{
	const struct comparison *comparison = task->comparison;
	const struct comparison_request *request = &comparison->request;
	struct fixed_placement placement;
	int error;

	jobs_lock(task->jobs);
	switch (task->row->kind) {
	case COMPARISON_ORIGINAL:
		error = candidate_original(candidate, task->reference,
			request->kernel, task->row->max_influences,
			task->row->targets, request->rate_hz, task->log);
		break;
	case COMPARISON_RIGID:
		error = candidate_rigid(candidate, task->reference, task->log);
		break;
	default:
		placement = candidate_morph_placement(&comparison->box);
		error = candidate_morph(candidate, task->reference,
			request->kernel, &placement, &task->cell->keys,
			kept_bytes(task), task->log);
		break;
	}
	jobs_unlock(task->jobs);
	return error;
}

static int fail(const struct task *task)
{
	log_error(task->log, "%s: there is not enough memory to compare it",
		task->comparison->model->path);
	return -ENOMEM;
}

/*
 * Measures the error; and the time if this was the last fit or if the error
 * keeps to the bound, so that there will be no other fit.
 */
static int measure(struct task *task, struct candidate_excess *excess, bool last)
{
	struct comparison_cell *cell = task->cell;
	struct candidate candidate = {0};
	int error = create(task, &candidate);

	if (!error &&
		candidate_error_measure(&candidate, &task->clip->screen,
			&task->clip->grid,
			task->comparison->sampling.normal_moments, excess,
			&cell->error) != 0) {
		error = fail(task);
	}
	if (!error) {
		if (last || cell->error.peak_px <= excess->bound_px) {
			cell->time = candidate_time_measure(&candidate,
				task->comparison->sampling.timed_frames);
		}
		cell->board = candidate.board;
		cell->bytes = candidate.bytes;
		cell->vertex_count = candidate.vertex_count;
	}
	jobs_lock(task->jobs);
	candidate_destroy(&candidate);
	jobs_unlock(task->jobs);
	return error;
}

static bool has_moment(const struct time_grid *grid, float time_s)
{
	for (int i = 0; i < grid->count; i++) {
		if (grid->time_s[i] == time_s) {
			return true;
		}
	}
	return false;
}

/*
 * Fits keys until the error is within the bound between the grid's moments,
 * too. Times at which it exceeds the bound are added to the grid; if the time
 * of the peak is in the grid already, the bound of the fit shrinks.
 */
static int fit_on(struct task *task, struct time_grid *grid)
{
	float bound_px = task->row->bound_px, fit_px = bound_px * first_fit;
	struct comparison_cell *cell = task->cell;
	int error = 0;

	for (int i = 0; i < FITS_MAX && !error; i++) {
		struct candidate_excess excess = {.bound_px = bound_px};

		fit_keys_release(&cell->keys);
		error = fit_keys_within(task->reference, &task->clip->screen,
			grid, fit_px, kept_bytes(task), &cell->keys);
		error = error ? fail(task)
			      : measure(task, &excess,
					!task->row->listed || i == FITS_MAX - 1);
		if (error || cell->error.peak_px <= bound_px ||
			!task->row->listed) {
			break;
		}
		if (has_moment(grid, cell->error.peak_s)) {
			fit_px *= first_fit * bound_px / cell->error.peak_px;
		}
		if (time_grid_add(grid, excess.time_s, excess.count) != 0) {
			error = fail(task);
		}
	}
	return error;
}

static int fit_and_measure(struct task *task)
{
	const struct time_grid *own = &task->clip->grid;
	struct time_grid grid = {0};
	int error = time_grid_add(&grid, own->time_s, own->count);

	error = error ? fail(task) : fit_on(task, &grid);
	time_grid_release(&grid);
	return error;
}

static int fill(struct task *task)
{
	int error;

	switch (task->row->kind) {
	case COMPARISON_MORPH:
		return fit_and_measure(task);
	case COMPARISON_MORPH_EVEN:
		error = fit_keys_evenly(task->reference->clip->duration_s,
			AN4044_KEYS, &task->cell->keys);
		return error ? fail(task) : measure(task, NULL, true);
	default:
		return measure(task, NULL, true);
	}
}

int comparison_cell_measure(struct comparison *comparison, int row, int clip,
	struct jobs *jobs, const struct log *log)
{
	struct task task = {
		.comparison = comparison,
		.row = &comparison->row[row],
		.clip = &comparison->clip[clip],
		.cell = &comparison->row[row].cell[clip],
		.jobs = jobs,
		.log = log,
	};
	int error = make_reference(comparison, clip, jobs, log, &task.reference);

	if (error) {
		return error;
	}
	error = fill(&task);
	end_reference(task.reference, jobs);
	return error;
}
