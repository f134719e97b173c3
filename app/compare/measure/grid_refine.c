#include "app/compare/measure/grid_refine.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	PIECES_MAX = 64
};

/*
 * Returns the largest distance in pixels between the reference's pose and the
 * mean of two others. Adds the pose to the view's box.
 */
static float bend_px(const struct reference *reference,
	struct screen_view *screen, const float (*from)[3], const float (*to)[3])
{
	float most = 0.0f;

	for (int v = 0; v < reference->vertex_count; v++) {
		float middle[3], px;

		for (int axis = 0; axis < 3; axis++) {
			middle[axis] = 0.5f * (from[v][axis] + to[v][axis]);
		}
		px = screen_view_distance_px(
			screen, middle, reference->position[v]);
		bounds_add(&screen->box, reference->position[v]);
		most = fmaxf(most, px);
	}
	return most;
}

static void copy_pose(const struct reference *reference, float (*out)[3])
{
	memcpy(out, reference->position,
		(size_t)reference->vertex_count * sizeof(*out));
}

/* A value jumps between two moments that are closer than this. */
static const float jump_s = 1e-5f;

/* If the time is divided by n, the error of interpolation is divided by n^2. */
static int pieces_for(float gap_s, float bend, float bound_px)
{
	if (gap_s < jump_s) {
		return 1;
	}
	return scalar_to_int(
		(double)scalar_sqrt(bend / bound_px) + 0.999, 1, PIECES_MAX);
}

static int count_pieces(struct reference *reference, struct screen_view *screen,
	float bound_px, const struct time_grid *grid, int *pieces)
{
	size_t bytes = (size_t)reference->vertex_count * sizeof(float[3]) + 1;
	float(*from)[3] = malloc(bytes);
	float(*to)[3] = malloc(bytes);
	float(*passed)[3];
	int error = from && to ? 0 : -ENOMEM;

	if (!error) {
		reference_pose(reference, grid->time_s[0], false);
		copy_pose(reference, from);
	}
	for (int i = 0; !error && i < grid->count - 1; i++) {
		const float *at = grid->time_s + i;

		reference_pose(reference, at[1], false);
		copy_pose(reference, to);
		reference_pose(reference, 0.5f * (at[0] + at[1]), false);
		pieces[i] = pieces_for(at[1] - at[0],
			bend_px(reference, screen, (const float(*)[3])from,
				(const float(*)[3])to),
			bound_px);
		passed = from;
		from = to;
		to = passed;
	}
	free(from);
	free(to);
	return error;
}

static int divide(struct time_grid *grid, const int *pieces)
{
	struct time_grid finer = {.count = 0};
	size_t count = 1;

	for (int i = 0; i < grid->count - 1; i++) {
		count += (size_t)pieces[i];
	}
	finer.time_s = malloc(count * sizeof(*finer.time_s));
	if (!finer.time_s) {
		return -ENOMEM;
	}
	for (int i = 0; i < grid->count - 1; i++) {
		float from = grid->time_s[i], gap = grid->time_s[i + 1] - from;

		for (int p = 0; p < pieces[i]; p++) {
			finer.time_s[finer.count++] =
				from + gap * (float)p / (float)pieces[i];
		}
	}
	finer.time_s[finer.count++] = grid->time_s[grid->count - 1];
	time_grid_release(grid);
	*grid = finer;
	return 0;
}

int grid_refine(struct reference *reference, struct screen_view *screen,
	float bound_px, struct time_grid *grid)
{
	int *pieces = malloc((size_t)grid->count * sizeof(*pieces));
	int error = -ENOMEM;

	if (pieces) {
		error = count_pieces(reference, screen, bound_px, grid, pieces);
	}
	if (!error) {
		error = divide(grid, pieces);
	}
	free(pieces);
	return error;
}
