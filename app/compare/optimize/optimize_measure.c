#include "app/compare/optimize/optimize_measure.h"

#include "app/compare/candidate/candidate_error.h"
#include "app/compare/measure/sampling.h"
#include "app/compare/optimize/optimize_match.h"
#include "platform/base/scalar.h"
#include "platform/process/jobs.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * Vertices times moments that a search measures at once, within a second or so
 * (sampling_moments()).
 */
static const double vertices_usual = 1e7, vertices_most = 3e7;
static const double rate_hz = 60.0; /* of a time grid, about */
/* Vertices times moments that are worth a thread: some hundredths of a second. */
static const double thread_work = 1e6;

/* A model and the clip to play; the copy shares the model's memory. */
struct played {
	struct model model;
	struct model_clip still; /* stands for a clip without duration */
	struct reference *reference;
	size_t bytes; /* of the reference, from the model's budget */
};

/* Both models, once for each thread. */
struct players {
	int count;
	struct players_pair {
		struct played wanted, found;
	} pair[JOBS_THREADS_MAX];
	struct candidate candidate[JOBS_THREADS_MAX];
};

/* What to measure: a clip, or -1, of two models. */
struct task {
	const struct model *wanted, *found;
	int clip;
	struct optimize_measure_view view;
	struct bounds *box;
};

static size_t used_bytes(const struct model *model)
{
	return model->budget ? model->budget->used_bytes : 0;
}

static int begin(struct played *played, const struct model *model, int clip,
	float unit_scale, const struct log *log)
{
	size_t before = used_bytes(model);
	int error;

	played->model = *model;
	if (clip < 0 || !(model->clip[clip].duration_s > 0.0f)) {
		played->still = (struct model_clip){.name = ""};
		if (clip >= 0) {
			played->still = model->clip[clip];
		}
		played->still.duration_s = 1e-3f;
		played->model.clip = &played->still;
		played->model.clip_count = 1;
		clip = 0;
	}
	error = reference_create_scaled(
		&played->model, clip, unit_scale, log, &played->reference);
	played->bytes = used_bytes(model) - before;
	return error;
}

static void pose(struct candidate *candidate, float time_s)
{
	reference_pose(candidate->state, time_s, !candidate->positions_only);
}

static void take(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct reference *found = candidate->state;
	size_t bytes = (size_t)found->vertex_count * sizeof(float[3]);

	memcpy(position, found->position, bytes);
	if (normal) {
		memcpy(normal, found->normal, bytes);
	}
}

static void remove_pair(struct players *players)
{
	struct players_pair *pair = &players->pair[--players->count];

	reference_destroy(pair->wanted.reference);
	reference_destroy(pair->found.reference);
}

/* Takes both models once more. Returns 0, or -errno after logging an error. */
static int add_pair(
	struct players *players, const struct task *task, const struct log *log)
{
	struct players_pair *pair = &players->pair[players->count++];
	float scale = task->view.unit_scale;
	int error = begin(&pair->wanted, task->wanted, task->clip, scale, log);

	if (!error) {
		error = begin(&pair->found, task->found, task->clip, scale, log);
	}
	if (error) {
		remove_pair(players);
	}
	return error;
}

/* Whether another reference fits into half of what the budget has left. */
static bool has_room(const struct model *model, size_t bytes)
{
	const struct memory_budget *budget = model->budget;

	return !budget ||
		bytes <= (budget->limit_bytes - budget->used_bytes) / 2;
}

/* Prepares a thread for each processor, as far as the work is worth it. */
static void add_threads(
	struct players *players, const struct task *task, int moments)
{
	const struct log nowhere = log_to_nowhere();
	const struct players_pair *first = &players->pair[0];
	double work =
		(double)first->wanted.reference->vertex_count * (double)moments;
	int threads = scalar_to_int(work / thread_work, 1, jobs_processors());

	while (players->count < threads &&
		has_room(task->wanted, first->wanted.bytes) &&
		has_room(task->found, first->found.bytes) &&
		add_pair(players, task, &nowhere) == 0) {
	}
}

static void set_candidates(struct players *players, const int *source)
{
	for (int i = 0; i < players->count; i++) {
		struct reference *found = players->pair[i].found.reference;

		players->candidate[i] = (struct candidate){
			.reference = players->pair[i].wanted.reference,
			.vertex_count = found->vertex_count,
			.source = source,
			.pose = pose,
			.take = take,
			.state = found,
		};
	}
}

static int measure(const struct task *task, struct players *players,
	const int *source, float *peak_px)
{
	struct reference *wanted = players->pair[0].wanted.reference;
	struct screen_view screen =
		screen_view_begin(wanted, task->view.width, task->view.height);
	struct time_grid grid;
	int error = time_grid_make(wanted->clip, &grid);

	if (error) {
		return error;
	}
	if (bounds_is_empty(task->box)) {
		*task->box = screen_view_create(
			wanted, &grid, screen.width, screen.height)
				     .box;
	}
	screen_view_frame(&screen, task->box);
	if (task->view.share < 1.0) {
		time_grid_thin(&grid, task->view.share);
	}
	add_threads(players, task, grid.count);
	set_candidates(players, source);
	error = candidate_error_find_peak(
		players->candidate, players->count, &screen, &grid, peak_px);
	time_grid_release(&grid);
	return error;
}

/* As measure(), but finds out which vertices are to be compared. */
static int compare(
	const struct task *task, struct players *players, float *peak_px)
{
	const struct reference *wanted = players->pair[0].wanted.reference;
	const struct reference *found = players->pair[0].found.reference;
	int *source =
		malloc(((size_t)found->vertex_count + 1) * sizeof(*source));
	int error = source
		? optimize_match(wanted->instance, found->instance, source)
		: -ENOMEM;

	if (!error && found->vertex_count > 0) {
		error = measure(task, players, source, peak_px);
	}
	free(source);
	return error;
}

static int fail(
	const struct model *model, int clip, int error, const struct log *log)
{
	if (error == -E2BIG) {
		log_error(log,
			"%s: clip %d %s lasts longer than five hours: shorten it",
			model->path, clip, model->clip[clip].name);
		return error;
	}
	log_error(log,
		error == -EINVAL
			? "%s: limber cannot compare models with other vertices"
			: "%s: there is not enough memory to compare it",
		model->path);
	return error;
}

int optimize_measure(const struct model *wanted, const struct model *found,
	int clip, struct optimize_measure_view view, struct bounds *box,
	const struct log *log, float *peak_px)
{
	const struct task task = {wanted, found, clip, view, box};
	struct players *players = calloc(1, sizeof(*players));
	int error;

	*peak_px = 0.0f;
	if (!players) {
		return fail(wanted, clip, -ENOMEM, log);
	}
	error = add_pair(players, &task, log);
	if (!error) {
		error = compare(&task, players, peak_px);
		error = error ? fail(wanted, clip, error, log) : 0;
	}
	while (players->count > 0) {
		remove_pair(players);
	}
	free(players);
	return error;
}

static float closest_px(const struct screen_view *screen)
{
	const struct bounds *box = &screen->box;
	float nearest = 0.0f;

	for (int corner = 0; corner < 8; corner++) {
		float depth = -screen->view[3][2];

		for (int axis = 0; axis < 3; axis++) {
			depth -= screen->view[axis][2] *
				(corner >> axis & 1 ? box->high[axis]
						    : box->low[axis]);
		}
		nearest = corner == 0 || depth < nearest ? depth : nearest;
	}
	return screen->unit * screen->focal_px /
		(nearest > 1e-3f ? nearest : 1e-3f);
}

/* Of all clips: begin() leaves only one where it has no duration. */
static int find_scale(
	const struct model *model, const struct log *log, float *unit_scale)
{
	struct instance *instance;
	int error = instance_create(model, kernel_find("float"), log, &instance);

	if (!error) {
		*unit_scale = instance->unit_scale;
		instance_destroy(instance);
	}
	return error;
}

int optimize_measure_unit(const struct model *model,
	struct optimize_measure_view *view, const struct log *log,
	struct bounds *box, float *px_per_unit)
{
	int first = model->clip_count > 0 ? 0 : -1;
	struct played played = {.reference = NULL};
	struct screen_view screen;
	struct time_grid grid;
	int error = find_scale(model, log, &view->unit_scale);

	if (!error) {
		error = begin(&played, model, first, view->unit_scale, log);
	}

	*px_per_unit = 1.0f;
	*box = bounds_empty();
	if (!error && played.reference->vertex_count > 0) {
		error = time_grid_make(played.reference->clip, &grid);
		if (error) {
			error = fail(model, first, error, log);
		} else {
			screen = screen_view_create(played.reference, &grid,
				view->width, view->height);
			*px_per_unit = closest_px(&screen);
			*box = screen.box;
			time_grid_release(&grid);
		}
	}
	reference_destroy(played.reference);
	return error;
}

double optimize_measure_share(const struct model *model)
{
	double vertices = 1.0 + (double)sampling_vertices(model);
	double moments = 1.0, most;

	for (int c = 0; c < model->clip_count; c++) {
		moments += 2.0 + rate_hz * (double)model->clip[c].duration_s;
	}
	most = sampling_moments(vertices, vertices_usual, vertices_most);
	return most < moments ? most / moments : 1.0;
}
