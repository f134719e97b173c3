#include "app/compare/optimize/optimize_measure.h"

#include "app/compare/candidate/candidate_error.h"
#include "app/compare/measure/sampling.h"
#include "app/compare/optimize/optimize_match.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * Vertices times moments that a search measures at once, within a second or so
 * (sampling_moments()).
 */
static const double vertices_usual = 1e7, vertices_most = 3e7;
static const double rate_hz = 60.0; /* of a time grid, about */

/* A model and the clip to play; the copy shares the model's memory. */
struct played {
	struct model model;
	struct model_clip still; /* stands for a clip without duration */
	struct reference *reference;
};

static int begin(struct played *played, const struct model *model, int clip,
	const struct log *log)
{
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
	return reference_create(&played->model, clip, log, &played->reference);
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

static int measure(struct reference *wanted, struct reference *found,
	const int *source, struct optimize_measure_view view,
	struct bounds *box, float *peak_px)
{
	struct candidate candidate = {
		.reference = wanted,
		.vertex_count = found->vertex_count,
		.source = source,
		.pose = pose,
		.take = take,
		.state = found,
	};
	struct candidate_error measured;
	struct screen_view screen;
	struct time_grid grid;
	int error = time_grid_make(wanted->clip, &grid);

	if (error) {
		return error;
	}
	if (bounds_is_empty(box)) {
		*box = screen_view_create(wanted, &grid, view.width, view.height)
			       .box;
	}
	screen = (struct screen_view){
		.width = view.width,
		.height = view.height,
		.unit = wanted->instance->unit_scale,
	};
	screen_view_frame(&screen, box);
	if (view.share < 1.0) {
		time_grid_thin(&grid, view.share);
	}
	/* No error of normals is asked for, and they take longest. */
	error = candidate_error_measure(
		&candidate, &screen, &grid, 1, NULL, &measured);
	time_grid_release(&grid);
	*peak_px = measured.peak_px;
	return error;
}

/* As measure(), but finds out which vertices are to be compared. */
static int compare(struct reference *wanted, struct reference *found,
	struct optimize_measure_view view, struct bounds *box, float *peak_px)
{
	int *source =
		malloc(((size_t)found->vertex_count + 1) * sizeof(*source));
	int error = source
		? optimize_match(wanted->instance, found->instance, source)
		: -ENOMEM;

	if (!error && found->vertex_count > 0) {
		error = measure(wanted, found, source, view, box, peak_px);
	}
	free(source);
	return error;
}

static int fail(const struct model *model, int error, const struct log *log)
{
	log_error(log,
		error == -E2BIG
			? "%s: a clip lasts longer than five hours: shorten it"
			: error == -EINVAL
			? "%s: limber cannot compare models with other vertices"
			: "%s: there is not enough memory to compare it",
		model->path);
	return error;
}

int optimize_measure(const struct model *wanted, const struct model *found,
	int clip, struct optimize_measure_view view, struct bounds *box,
	const struct log *log, float *peak_px)
{
	struct played a = {.reference = NULL}, b = {.reference = NULL};
	int error = begin(&a, wanted, clip, log);

	if (!error) {
		error = begin(&b, found, clip, log);
	}
	*peak_px = 0.0f;
	if (!error) {
		error = compare(a.reference, b.reference, view, box, peak_px);
		error = error ? fail(wanted, error, log) : 0;
	}
	reference_destroy(a.reference);
	reference_destroy(b.reference);
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

int optimize_measure_unit(const struct model *model,
	struct optimize_measure_view size, const struct log *log,
	struct bounds *box, float *px_per_unit)
{
	int first = model->clip_count > 0 ? 0 : -1;
	struct played played = {.reference = NULL};
	struct screen_view screen;
	struct time_grid grid;
	int error = begin(&played, model, first, log);

	*px_per_unit = 1.0f;
	*box = bounds_empty();
	if (!error && played.reference->vertex_count > 0) {
		error = time_grid_make(played.reference->clip, &grid);
		if (error) {
			error = fail(model, error, log);
		} else {
			screen = screen_view_create(played.reference, &grid,
				size.width, size.height);
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
