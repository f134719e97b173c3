#include "app/scene/instance/bounds.h"

#include "platform/base/scalar.h"

#include <float.h>
#include <math.h>

/*
 * A box is flat if its height is less than flat_part of its extent; the ground
 * then lies lower by hairline_part of the extent.
 */
static const float flat_part = 0.1f;
static const float hairline_part = 0.001f;

struct bounds bounds_empty(void)
{
	return (struct bounds){
		.low = {FLT_MAX, FLT_MAX, FLT_MAX},
		.high = {-FLT_MAX, -FLT_MAX, -FLT_MAX},
	};
}

bool bounds_is_empty(const struct bounds *bounds)
{
	return bounds->low[0] > bounds->high[0];
}

void bounds_add(struct bounds *bounds, const float point[3])
{
	if (isnan(point[0]) || isnan(point[1]) || isnan(point[2])) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		float at = scalar_clamp(point[axis], -BOUNDS_MAX, BOUNDS_MAX);

		bounds->low[axis] = scalar_min(at, bounds->low[axis]);
		bounds->high[axis] = scalar_max(at, bounds->high[axis]);
	}
}

void bounds_stay(struct bounds *bounds, const float way[2])
{
	for (int i = 0; i < 2; i++) {
		float *side = way[i] > 0.0f ? bounds->high : bounds->low;

		side[2 * i] -= way[i];
	}
}

void bounds_join(struct bounds *bounds, const struct bounds *other)
{
	if (!bounds_is_empty(other)) {
		bounds_add(bounds, other->low);
		bounds_add(bounds, other->high);
	}
}

float bounds_extent(const struct bounds *bounds)
{
	float extent = 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		float side = bounds->high[axis] - bounds->low[axis];

		extent = scalar_max(side, extent);
	}
	return extent;
}

void bounds_center(const struct bounds *bounds, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = bounds_is_empty(bounds)
			? 0.0f
			: 0.5f * (bounds->low[axis] + bounds->high[axis]);
	}
}

float bounds_ground(const struct bounds *bounds)
{
	float extent = bounds_extent(bounds);

	if (bounds_is_empty(bounds)) {
		return 0.0f;
	}
	return bounds->high[1] - bounds->low[1] < flat_part * extent
		? bounds->low[1] - hairline_part * extent
		: bounds->low[1];
}
