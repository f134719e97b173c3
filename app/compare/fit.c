#include "app/compare/fit.h"

#include <errno.h>
#include <stdlib.h>

enum {
	MISSES_MAX = 8
};

/* A span that is tried, and where the last one failed. */
struct span {
	const struct reference *reference;
	const struct screen *screen;
	float bound_px;
	int from, to;
	int culprit; /* a vertex: likely to fail again */
};

float fit_omega(const struct reference *reference, int from, int to, int frame)
{
	const float *time_s = reference->time_s;

	return (time_s[frame] - time_s[from]) / (time_s[to] - time_s[from]);
}

static bool vertex_keeps(const struct span *span, int frame, int vertex)
{
	const float *from =
		reference_position(span->reference, span->from)[vertex];
	const float *to = reference_position(span->reference, span->to)[vertex];
	float omega = fit_omega(span->reference, span->from, span->to, frame);
	float straight[3];

	for (int axis = 0; axis < 3; axis++) {
		straight[axis] = from[axis] + (to[axis] - from[axis]) * omega;
	}
	return screen_distance_px(span->screen, straight,
		       reference_position(span->reference, frame)[vertex]) <=
		span->bound_px;
}

static bool frame_keeps(struct span *span, int frame)
{
	for (int v = 0; v < span->reference->vertex_count; v++) {
		if (!vertex_keeps(span, frame, v)) {
			span->culprit = v;
			return false;
		}
	}
	return true;
}

/* The middle, where a straight line is furthest off, comes first. */
static bool span_keeps(struct span *span)
{
	int middle = (span->from + span->to) / 2;

	if (span->to - span->from < 2) {
		return true;
	}
	for (int frame = span->from + 1; frame < span->to; frame++) {
		if (!vertex_keeps(span, frame, span->culprit)) {
			return false;
		}
	}
	if (!frame_keeps(span, middle)) {
		return false;
	}
	for (int frame = span->from + 1; frame < span->to; frame++) {
		if (frame != middle && !frame_keeps(span, frame)) {
			return false;
		}
	}
	return true;
}

/* Offers frame to as reached from frame from. */
static void offer(int *steps, int *before, int from, int to)
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

int fit_keys(const struct reference *reference, const struct screen *screen,
	float bound_px, int *key)
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
				if (span_keeps(&span)) {
					offer(steps, before, span.from, span.to);
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

int spread_keys(const struct reference *reference, int count, int *key)
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
