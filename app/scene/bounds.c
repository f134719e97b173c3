#include "app/scene/bounds.h"

#include "app/anim/clip.h"

#include <float.h>

enum {
	CLIP_LOOKS = 12
};

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
	for (int axis = 0; axis < 3; axis++) {
		if (point[axis] < bounds->low[axis]) {
			bounds->low[axis] = point[axis];
		}
		if (point[axis] > bounds->high[axis]) {
			bounds->high[axis] = point[axis];
		}
	}
}

float bounds_extent(const struct bounds *bounds)
{
	float extent = 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		float side = bounds->high[axis] - bounds->low[axis];

		if (side > extent) {
			extent = side;
		}
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

struct bounds bounds_of_instance(const struct instance *instance)
{
	struct bounds bounds = bounds_empty();

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float point[3];

			instance_world_vertex(instance, drawable, v, point);
			for (int axis = 0; axis < 3; axis++) {
				point[axis] *= instance->unit_scale;
			}
			bounds_add(&bounds, point);
		}
	}
	return bounds;
}

void bounds_join(struct bounds *bounds, const struct bounds *other)
{
	if (!bounds_is_empty(other)) {
		bounds_add(bounds, other->low);
		bounds_add(bounds, other->high);
	}
}

struct bounds bounds_of_clip(struct instance *instance, int clip)
{
	struct bounds all = bounds_empty();
	struct clip_cursor none = {0};

	pose_rest(&instance->pose, instance->model);
	if (clip < 0) {
		instance_update(instance);
		return bounds_of_instance(instance);
	}
	for (int look = CLIP_LOOKS; look >= 0; look--) {
		const struct model_clip *c = &instance->model->clip[clip];
		struct bounds now;

		clip_sample(c, c->duration_s * (float)look / CLIP_LOOKS, &none,
			&instance->pose);
		instance_update(instance);
		now = bounds_of_instance(instance);
		bounds_join(&all, &now);
	}
	return all;
}
