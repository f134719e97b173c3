#include "app/compare/optimize/build/optimize_track.h"

#include "app/anim/math/quat.h"
#include "platform/base/scalar.h"

#include <string.h>

/* The relative error of rounding to floats. */
static const float rounding = 1e-6f;
static const float screen_px = 1000.0f;
/*
 * Rounding moves nothing by more: limber subtracts a far origin before it
 * interpolates, so that places beside it are exact.
 */
static const float rounding_px = 0.1f;

const float *optimize_track_value(const struct optimize_track *track, int key)
{
	size_t values = track->interpolation == MODEL_CUBICSPLINE
		? 3 * (size_t)key + 1
		: (size_t)key;

	return track->value + values * (size_t)track->width;
}

static float distance(const float *a, const float *b, int count, float sign)
{
	float sum = 0.0f;

	for (int i = 0; i < count; i++) {
		float apart = a[i] - sign * b[i];

		sum += apart * apart;
	}
	return scalar_sqrt(sum);
}

static float weights_px(
	const struct optimize_track *track, const float *a, const float *b)
{
	const struct optimize_reach_node *reach = track->reach;
	float sum = 0.0f;

	for (int i = 0; i < track->width && i < reach->target_count; i++) {
		sum += scalar_abs(a[i] - b[i]) * reach->target_px[i];
	}
	return sum;
}

static float distance_px(
	const struct optimize_track *track, const float *a, const float *b)
{
	float same, opposite;

	switch (track->path) {
	case MODEL_TRANSLATION:
		return distance(a, b, 3, 1.0f) * track->reach->move_px;
	case MODEL_ROTATION:
		/* The distance of unit quaternions is half the angle. */
		same = distance(a, b, 4, 1.0f);
		opposite = distance(a, b, 4, -1.0f);
		return 2.0f * (same < opposite ? same : opposite) *
			track->reach->turn_px;
	case MODEL_SCALE:
		return distance(a, b, 3, 1.0f) * track->reach->scale_px;
	case MODEL_WEIGHTS:
		break;
	}
	return weights_px(track, a, b);
}

/*
 * Returns the size to which the rounding of small values is relative: 1, or the
 * screen's in the units of a model that is smaller.
 */
static float least_size(const struct optimize_track *track)
{
	float move_px = track->reach->move_px;

	return track->path == MODEL_TRANSLATION && move_px > screen_px
		? screen_px / move_px
		: 1.0f;
}

/* By how much rounding may change a value. */
static float rounding_of(const struct optimize_track *track, float value)
{
	float least = least_size(track), own = scalar_abs(value);
	float apart = rounding * (own > least ? own : least);
	float move_px = track->reach->move_px, most_px = rounding_px;

	if (track->bound_px > 0.0f && track->bound_px < most_px) {
		most_px = track->bound_px;
	}
	return track->path == MODEL_TRANSLATION && apart * move_px > most_px
		? most_px / move_px
		: apart;
}

bool optimize_track_is_near(
	const struct optimize_track *track, const float *a, const float *b)
{
	bool equal = true;

	for (int i = 0; i < track->width; i++) {
		equal = equal &&
			scalar_abs(a[i] - b[i]) <= rounding_of(track, a[i]);
	}
	return equal ||
		(track->bound_px > 0.0f && !track->reach->exact &&
			distance_px(track, a, b) <= track->bound_px);
}

bool optimize_track_is_half_turn(const float a[4], const float b[4])
{
	float cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];

	return scalar_abs(cosine) < 1e-3f;
}

/* A spline is constant only if its tangents are 0, too. */
bool optimize_track_is_constant(const struct optimize_track *track)
{
	size_t width = (size_t)track->width;

	for (int key = 1; key < track->key_count; key++) {
		if (!optimize_track_is_near(track,
			    optimize_track_value(track, key),
			    optimize_track_value(track, 0))) {
			return false;
		}
	}
	if (track->interpolation != MODEL_CUBICSPLINE) {
		return true;
	}
	for (size_t i = 0; i < (size_t)track->key_count * 3 * width; i++) {
		if ((i / width) % 3 != 1 && track->value[i] != 0.0f) {
			return false;
		}
	}
	return true;
}

enum {
	WIDTH_MAX = 4 /* of all paths except weights */
};

/* Whether interpolation between the keys from and to can replace the key. */
static bool is_between(
	const struct optimize_track *track, int from, int to, int key)
{
	const float *a = optimize_track_value(track, from),
		    *b = optimize_track_value(track, to);
	const float *wanted = optimize_track_value(track, key);
	float u = (track->time_s[key] - track->time_s[from]) /
		(track->time_s[to] - track->time_s[from]);
	float between[WIDTH_MAX], sum = 0.0f;
	bool equal = true;

	if (track->interpolation == MODEL_STEP) {
		return optimize_track_is_near(track, wanted, a);
	}
	if (track->path == MODEL_ROTATION) {
		quat_slerp(a, b, u, between);
		return optimize_track_is_near(track, wanted, between) &&
			!optimize_track_is_half_turn(a, b);
	}
	if (track->path != MODEL_WEIGHTS) {
		for (int i = 0; i < track->width; i++) {
			between[i] = a[i] + u * (b[i] - a[i]);
		}
		return optimize_track_is_near(track, wanted, between);
	}
	for (int i = 0; i < track->width; i++) {
		float apart = scalar_abs(a[i] + u * (b[i] - a[i]) - wanted[i]);

		equal = equal && apart <= rounding;
		sum += i < track->reach->target_count
			? apart * track->reach->target_px[i]
			: 0.0f;
	}
	return equal ||
		(track->bound_px > 0.0f && !track->reach->exact &&
			sum <= track->bound_px);
}

static bool fits(
	const struct optimize_track *const *track, int count, int from, int to)
{
	for (int t = 0; t < count; t++) {
		for (int key = from + 1; key < to; key++) {
			if (!is_between(track[t], from, to, key)) {
				return false;
			}
		}
	}
	return true;
}

/*
 * Finds a far key such that all keys between it and from can be left out: steps
 * double while they fit, then a binary search follows.
 */
static int farthest(
	const struct optimize_track *const *track, int count, int from)
{
	int last = track[0]->key_count - 1;
	int good = from + 1, step = 2, bad;

	while (from + step <= last && fits(track, count, from, from + step)) {
		good = from + step;
		step *= 2;
	}
	bad = from + step;
	if (bad > last) {
		if (fits(track, count, from, last)) {
			return last;
		}
		bad = last;
	}
	while (bad - good > 1) {
		int middle = (good + bad) / 2;

		if (fits(track, count, from, middle)) {
			good = middle;
		} else {
			bad = middle;
		}
	}
	return good;
}

int optimize_track_reduce(
	const struct optimize_track *const *track, int count, int *kept)
{
	int last = track[0]->key_count - 1;
	int kept_count = 0, key = 0;

	kept[kept_count++] = 0;
	while (key < last) {
		key = farthest(track, count, key);
		kept[kept_count++] = key;
	}
	return kept_count;
}
