#include "app/compare/fit.h"

#include <errno.h>
#include <stdlib.h>

enum {
	MISSES_MAX = 8
};

/* A span between two keys that is checked. */
struct span {
	const struct reference *reference;
	const struct screen_view *screen;
	float bound_px;
	int from, to;
	int suspect; /* the vertex that exceeded the bound last */
};

/* Returns where a frame is between two others: 0 at from, 1 at to. */
static float omega_of(
	const struct reference *reference, int from, int to, int frame)
{
	const float *time_s = reference->time_s;

	return (time_s[frame] - time_s[from]) / (time_s[to] - time_s[from]);
}

static bool vertex_fits(const struct span *span, int frame, int vertex)
{
	const float *from =
		reference_position(span->reference, span->from)[vertex];
	const float *to = reference_position(span->reference, span->to)[vertex];
	float omega = omega_of(span->reference, span->from, span->to, frame);
	float straight[3];

	for (int axis = 0; axis < 3; axis++) {
		straight[axis] = from[axis] + (to[axis] - from[axis]) * omega;
	}
	return screen_view_distance_px(span->screen, straight,
		       reference_position(span->reference, frame)[vertex]) <=
		span->bound_px;
}

static bool frame_fits(struct span *span, int frame)
{
	for (int v = 0; v < span->reference->vertex_count; v++) {
		if (!vertex_fits(span, frame, v)) {
			span->suspect = v;
			return false;
		}
	}
	return true;
}

/* The suspect and the middle frame come first: they fail most often. */
static bool span_fits(struct span *span)
{
	int middle = (span->from + span->to) / 2;

	if (span->to - span->from < 2) {
		return true;
	}
	for (int frame = span->from + 1; frame < span->to; frame++) {
		if (!vertex_fits(span, frame, span->suspect)) {
			return false;
		}
	}
	if (!frame_fits(span, middle)) {
		return false;
	}
	for (int frame = span->from + 1; frame < span->to; frame++) {
		if (frame != middle && !frame_fits(span, frame)) {
			return false;
		}
	}
	return true;
}

/* Updates the shortest path to frame to with the one through frame from. */
static void relax(int *steps, int *before, int from, int to)
{
	if (steps[to] == 0 || steps[from] + 1 < steps[to]) {
		steps[to] = steps[from] + 1;
		before[to] = from;
	}
}

static int collect(const int *before, int last, int *key)
{
	int count = 1;

	for (int at = last; at > 0; at = before[at]) {
		count++;
	}
	for (int at = last, i = count - 1; i >= 0; i--) {
		key[i] = at;
		at = before[at];
	}
	return count;
}

int fit_keys(const struct reference *reference,
	const struct screen_view *screen, float bound_px, int *key)
{
	struct span span = {reference, screen, bound_px, 0, 0, 0};
	int frames = reference->frame_count;
	int *steps = calloc((size_t)frames, sizeof(*steps));
	int *before = calloc((size_t)frames, sizeof(*before));
	int count = -ENOMEM;

	if (steps && before) {
		for (span.from = 0; span.from < frames - 1; span.from++) {
			int misses = 0;

			for (span.to = span.from + 1;
				span.to < frames && misses < MISSES_MAX;
				span.to++) {
				if (span_fits(&span)) {
					relax(steps, before, span.from, span.to);
					misses = 0;
				} else {
					misses++;
				}
			}
		}
		count = collect(before, frames - 1, key);
	}
	free(steps);
	free(before);
	return count;
}

int fit_even_keys(const struct reference *reference, int count, int *key)
{
	int last = reference->frame_count - 1;

	if (count > last + 1) {
		count = last + 1;
	}
	for (int i = 0; i < count; i++) {
		key[i] = (i * last + (count - 1) / 2) / (count - 1);
	}
	return count;
}
