#include "app/compare/candidate/fit.h"

#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>

enum {
	MISSES_MAX = 8,
	MOMENTS_MIN = 3,
	MOMENTS_MAX = 600,
	BLOCK = 256 /* vertices that are tested without a branch */
};

/*
 * A ring buffer of eye-space positions at the last moments posed. A moment has
 * all x, then all y, then all z, so that a compiler can test several vertices
 * at once by vector instructions.
 */
struct window {
	struct reference *reference;
	const struct screen_view *screen;
	const struct time_grid *grid;
	float bound_px;
	int capacity;    /* moments */
	int end;         /* the first moment that is not posed yet */
	float *position; /* [capacity][3][vertex_count] */
	int suspect;     /* the vertex that exceeded the bound last */
};

static float *moment_of(const struct window *window, int moment)
{
	size_t count = (size_t)window->reference->vertex_count;

	return window->position +
		(size_t)(moment % window->capacity) * 3 * count;
}

/*
 * Returns a moment's positions, posing up to it if needed. It must still be in
 * the ring: moment >= end - capacity.
 */
static const float *positions_of(struct window *window, int moment)
{
	struct reference *reference = window->reference;
	size_t count = (size_t)reference->vertex_count;

	for (; window->end <= moment; window->end++) {
		float *to = moment_of(window, window->end);

		reference_pose(
			reference, window->grid->time_s[window->end], false);
		for (size_t v = 0; v < count; v++) {
			float eye[3];

			screen_view_to_eye(
				window->screen, reference->position[v], eye);
			for (size_t axis = 0; axis < 3; axis++) {
				to[axis * count + v] = eye[axis];
			}
		}
	}
	return moment_of(window, moment);
}

/* Positions at two keys and at a moment between them: [3][vertex_count]. */
struct between {
	const float *from, *to, *wanted;
	float omega; /* 0 at from, 1 at to */
};

static struct between between_of(
	struct window *window, int from, int to, int moment)
{
	const float *time_s = window->grid->time_s;

	return (struct between){
		.from = positions_of(window, from),
		.to = positions_of(window, to),
		.wanted = positions_of(window, moment),
		.omega = (time_s[moment] - time_s[from]) /
			(time_s[to] - time_s[from]),
	};
}

static inline bool vertex_fits(const struct screen_view *screen, float bound_px,
	const struct between *between, size_t stride, size_t vertex)
{
	float wanted[3], straight[3];

	for (size_t axis = 0; axis < 3; axis++) {
		size_t at = axis * stride + vertex;
		float from = between->from[at];

		wanted[axis] = between->wanted[at];
		straight[axis] =
			from + (between->to[at] - from) * between->omega;
	}
	return screen_view_eyes_within(screen, wanted, straight, bound_px);
}

/* Whether these vertices fit; sets the suspect if one does not. */
static bool block_fits(struct window *window, const struct between *between,
	size_t first, size_t end)
{
	const struct screen_view screen = *window->screen;
	const struct between at = *between;
	const float bound_px = window->bound_px;
	const size_t stride = (size_t)window->reference->vertex_count;
	int outside = 0;

	for (size_t v = first; v < end; v++) {
		outside += !vertex_fits(&screen, bound_px, &at, stride, v);
	}
	for (size_t v = first; outside > 0 && v < end; v++) {
		if (!vertex_fits(&screen, bound_px, &at, stride, v)) {
			window->suspect = (int)v;
			break;
		}
	}
	return outside == 0;
}

static bool moment_fits(struct window *window, int from, int to, int moment)
{
	struct between between = between_of(window, from, to, moment);
	size_t count = (size_t)window->reference->vertex_count;

	for (size_t v = 0; v < count; v += BLOCK) {
		if (!block_fits(window, &between, v,
			    v + BLOCK < count ? v + BLOCK : count)) {
			return false;
		}
	}
	return true;
}

static bool suspect_fits(struct window *window, int from, int to)
{
	for (int moment = from + 1; moment < to; moment++) {
		struct between between = between_of(window, from, to, moment);

		if (!vertex_fits(window->screen, window->bound_px, &between,
			    (size_t)window->reference->vertex_count,
			    (size_t)window->suspect)) {
			return false;
		}
	}
	return true;
}

/*
 * Tests the suspect vertex and the middle moment first: they fail most often.
 */
static bool span_fits(struct window *window, int from, int to)
{
	int middle = (from + to) / 2;

	(void)positions_of(window, to);
	if (to - from < 2 || window->reference->vertex_count == 0) {
		return true;
	}
	if (!suspect_fits(window, from, to) ||
		!moment_fits(window, from, to, middle)) {
		return false;
	}
	for (int moment = from + 1; moment < to && !interrupt_pending();
		moment++) {
		if (moment != middle && !moment_fits(window, from, to, moment)) {
			return false;
		}
	}
	return true;
}

static int farthest_from(struct window *window, int from)
{
	int last = window->grid->count - 1, best = from + 1, misses = 0;

	for (int to = from + 1; to <= last && to - from < window->capacity &&
		misses < MISSES_MAX && !interrupt_pending();
		to++) {
		if (span_fits(window, from, to)) {
			best = to;
			misses = 0;
		} else {
			misses++;
		}
	}
	return best;
}

static int choose_keys(struct window *window, struct fit_keys *out)
{
	const struct time_grid *grid = window->grid;
	int at = 0;

	out->time_s[out->count++] = grid->time_s[0];
	while (at < grid->count - 1) {
		at = farthest_from(window, at);
		out->time_s[out->count++] = grid->time_s[at];
		if (interrupt_pending()) {
			return -EINTR;
		}
	}
	return 0;
}

static int capacity_of(
	size_t memory_bytes, size_t moment_bytes, int moment_count)
{
	size_t most = moment_bytes > 0 ? memory_bytes / moment_bytes
				       : (size_t)MOMENTS_MAX;

	most = most < MOMENTS_MAX ? most : (size_t)MOMENTS_MAX;
	most = most > MOMENTS_MIN ? most : (size_t)MOMENTS_MIN;
	return most < (size_t)moment_count ? (int)most : moment_count;
}

int fit_keys_within(struct reference *reference,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, size_t memory_bytes, struct fit_keys *out)
{
	size_t moment_bytes = (size_t)reference->vertex_count * sizeof(float[3]);
	struct window window = {
		.reference = reference,
		.screen = screen,
		.grid = grid,
		.bound_px = bound_px,
		.capacity = capacity_of(memory_bytes, moment_bytes, grid->count),
	};
	int error = -ENOMEM;

	window.position = malloc((size_t)window.capacity * moment_bytes + 1);
	*out = (struct fit_keys){
		.time_s = malloc((size_t)grid->count * sizeof(*out->time_s))};
	if (window.position && out->time_s) {
		error = choose_keys(&window, out);
	}
	if (error) {
		fit_keys_release(out);
	}
	free(window.position);
	return error;
}

int fit_keys_evenly(float duration_s, int count, struct fit_keys *out)
{
	*out = (struct fit_keys){.count = count,
		.time_s = malloc((size_t)count * sizeof(*out->time_s))};
	if (!out->time_s) {
		return -ENOMEM;
	}
	for (int i = 0; i < count; i++) {
		out->time_s[i] = duration_s * (float)i / (float)(count - 1);
	}
	return 0;
}

void fit_keys_release(struct fit_keys *keys)
{
	free(keys->time_s);
	*keys = (struct fit_keys){0};
}
