#include "app/compare/comparison.h"

#include "app/compare/advice.h"
#include "app/compare/comparison_cell.h"
#include "app/compare/comparison_draw.h"
#include "app/compare/comparison_rows.h"

#include <errno.h>
#include <stdlib.h>

static const float rest_extent_most = 2.0f; /* times the extent of all clips */
static const float far_extents = 6.0f; /* times the extent of the rest pose */

struct run {
	struct comparison *comparison;
	const struct log *log;
	int done;
};

bool comparison_has(
	const struct comparison *comparison, enum technique technique)
{
	for (int i = 0; i < comparison->row_count; i++) {
		const struct comparison_row *row = &comparison->row[i];

		if (row->listed && row->technique == technique) {
			return true;
		}
	}
	return false;
}

static void count_done(struct run *run, struct jobs *jobs)
{
	struct comparison *comparison = run->comparison;
	const struct comparison_request *request = &comparison->request;

	jobs_lock(jobs);
	run->done++;
	if (request->progress) {
		request->progress(request->progress_context, run->done,
			(comparison->row_count + 1) * comparison->clip_count);
	}
	jobs_unlock(jobs);
}

static int prepare_clip(struct jobs *jobs, int job, void *context)
{
	struct run *run = context;
	int error =
		comparison_clip_prepare(run->comparison, job, jobs, run->log);

	count_done(run, jobs);
	return error;
}

static int measure_cell(struct jobs *jobs, int job, void *context)
{
	struct run *run = context;
	int clips = run->comparison->clip_count;
	int error = comparison_cell_measure(
		run->comparison, job / clips, job % clips, jobs, run->log);

	count_done(run, jobs);
	return error;
}

/* Says which clips are missing in the report and in exported files. */
static void warn_if_still(const struct model *model, const struct log *log)
{
	int count = 0, first = -1;

	for (int i = 0; i < model->clip_count; i++) {
		if (model->clip[i].duration_s <= 0.0f) {
			first = first < 0 ? i : first;
			count++;
		}
	}
	if (count > 0) {
		log_warning(log,
			"%s: clips without a duration (%d of %d, the first is clip %d%s%s) are poses: they are neither compared nor exported",
			model->path, count, model->clip_count, first,
			*model->clip[first].name ? " " : "",
			model->clip[first].name);
	}
}

/* Chooses the requested clip, or else all clips that have a duration. */
static int choose_clips(struct comparison *comparison, const struct log *log)
{
	const struct model *model = comparison->model;
	int wanted = comparison->request.clip;

	if (!model_has_triangles(model)) {
		log_error(log,
			"%s: it shows no triangles: give a model with a mesh",
			model->path);
		return -EINVAL;
	}
	comparison->clip =
		calloc((size_t)model->clip_count, sizeof(*comparison->clip));
	if (!comparison->clip) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->clip_count; i++) {
		if (wanted < 0 ? model->clip[i].duration_s > 0.0f : i == wanted) {
			comparison->clip[comparison->clip_count++].clip = i;
		}
	}
	if (comparison->clip_count == 0) {
		log_error(log,
			"%s: none of its clips has a duration: give a model with a clip that moves",
			model->path);
		return -EINVAL;
	}
	if (wanted < 0) {
		warn_if_still(model, log);
	}
	return 0;
}

/*
 * Finds the box around all clips, in which key frames are quantized. A rest
 * pose far from them is left out, because they would lose precision. Each clip
 * is seen as it is played.
 */
static void find_box(struct comparison *comparison)
{
	struct bounds box = bounds_empty(), with;

	for (int i = 0; i < comparison->clip_count; i++) {
		bounds_join(&box, &comparison->clip[i].screen.box);
	}
	with = box;
	bounds_join(&with, &comparison->clip[0].rest);
	if (bounds_extent(&with) <= rest_extent_most * bounds_extent(&box)) {
		box = with;
	}
	comparison->box = box;
}

/* The player follows a model that goes far, and shows it larger. */
static void warn_if_far(
	const struct comparison *comparison, const struct log *log)
{
	float rest = bounds_extent(&comparison->clip[0].rest);
	float whole = bounds_extent(&comparison->box);

	if (rest > 0.0f && whole > far_extents * rest) {
		log_warning(log,
			"%s: its clips go %.0f times as far as it is large: errors and drawing are those of a picture of the whole way, and larger in limber play, which follows it",
			comparison->model->path, (double)(whole / rest));
	}
}

/* The winding of a morph's triangles is the same in all key frames. */
static void warn_if_turned(
	const struct comparison *comparison, const struct log *log)
{
	for (int i = 0; i < comparison->clip_count; i++) {
		const struct comparison_clip *clip = &comparison->clip[i];

		if (clip->turns) {
			log_warning(log,
				"%s: clip %d %s turns a surface inside out, as the sign of a scale changes: a morph shows it from inside for a part of the time and is not recommended",
				comparison->model->path, clip->clip,
				comparison->model->clip[clip->clip].name);
		}
	}
}

static int count_vertices(const struct comparison *comparison)
{
	const struct comparison_cell *cell = &comparison->row[0].cell[0];

	return cell->vertex_count;
}

static int measure_all(struct comparison *comparison, const struct log *log)
{
	struct run run = {comparison, log, 0};
	int jobs = comparison->request.jobs, clips = comparison->clip_count;
	int error = jobs_run(clips, jobs, prepare_clip, &run);

	if (!error) {
		find_box(comparison);
		warn_if_far(comparison, log);
		warn_if_turned(comparison, log);
		error = jobs_run(comparison->row_count * clips, jobs,
			measure_cell, &run);
	}
	if (!error) {
		error = comparison_draw_predict(comparison, log);
	}
	return error;
}

/* Finds the moments of all clips, and how many of them to compare. */
static int choose_moments(struct comparison *comparison, const struct log *log)
{
	const struct model *model = comparison->model;
	double moments = 0.0;

	for (int i = 0; i < comparison->clip_count; i++) {
		struct comparison_clip *to = &comparison->clip[i];
		int error = time_grid_make(&model->clip[to->clip], &to->grid);

		if (error == -E2BIG) {
			log_error(log,
				"%s: clip %d is too long to compare: it lasts more than five hours: choose another one with --clip",
				model->path, to->clip);
		}
		if (error) {
			return error;
		}
		moments += (double)to->grid.count;
	}
	comparison->sampling = sampling_choose(
		sampling_vertices(model), comparison->clip_count, moments);
	return 0;
}

static int prepare(struct comparison *comparison, const struct log *log)
{
	int error = choose_clips(comparison, log);

	if (!error) {
		error = choose_moments(comparison, log);
	}
	if (!error) {
		error = comparison_rows_choose(comparison);
	}
	if (error == -ENOMEM) {
		log_error(log, "%s: there is not enough memory to compare it",
			comparison->model->path);
	}
	/* The jobs log their errors themselves. */
	return error ? error : measure_all(comparison, log);
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
	comparison->model = model;
	error = prepare(comparison, log);
	if (error) {
		comparison_destroy(comparison);
		return error;
	}
	comparison->vertex_count = count_vertices(comparison);
	comparison_rows_sum_up(comparison);
	advice_give(comparison);
	*out = comparison;
	return 0;
}

void comparison_destroy(struct comparison *comparison)
{
	if (!comparison) {
		return;
	}
	for (int i = 0; i < comparison->row_count; i++) {
		struct comparison_row *row = &comparison->row[i];

		for (int c = 0; row->cell && c < comparison->clip_count; c++) {
			fit_keys_release(&row->cell[c].keys);
		}
		free(row->cell);
	}
	for (int c = 0; c < comparison->clip_count; c++) {
		time_grid_release(&comparison->clip[c].grid);
	}
	free(comparison->clip);
	free(comparison);
}
