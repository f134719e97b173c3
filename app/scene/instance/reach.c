#include "app/scene/instance/reach.h"

#include "app/anim/math/vec.h"
#include "app/anim/skin.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

struct reach_box {
	float middle[3], half[3];
};

/* Returns the first joint of a skin; its other joints follow in the array. */
static struct reach_joint *joints_of(
	const struct reach *reach, const struct model *model, int skin)
{
	struct reach_joint *first = reach->joint;

	for (int i = 0; i < skin; i++) {
		first += model->skin[i].joint_count;
	}
	return first;
}

static void measure_vertex(const struct model_primitive *primitive,
	int target_count, int vertex, struct bounds *out)
{
	const float *base = primitive->position[vertex];

	bounds_add(out, base);
	for (int t = 0; t < target_count; t++) {
		float at[3];

		model_deltas_get(&primitive->target[t].position, vertex, at);
		vec_add_scaled(base, at, 1.0f, at);
		bounds_add(out, at);
	}
}

static void measure(const struct drawable *drawable, int target_count,
	struct reach_joint *joint)
{
	const struct model_primitive *primitive = drawable->primitive;
	struct skin_influence influence[SKIN_INFLUENCES_MAX];

	for (int v = 0; v < primitive->vertex_count; v++) {
		struct bounds box = bounds_empty();
		int count = skin_gather_influences(
			primitive, (uint32_t)v, influence);

		measure_vertex(primitive, target_count, v, &box);
		for (int i = 0; i < count; i++) {
			bounds_join(&joint[influence[i].joint].box, &box);
		}
	}
}

int reach_init(struct reach *reach, struct instance *instance)
{
	const struct model *model = instance->model;
	int count = 0;

	for (int i = 0; i < model->skin_count; i++) {
		count += model->skin[i].joint_count;
	}
	reach->joint_count = 0;
	reach->joint = ARENA_ARRAY(
		&instance->arena, struct reach_joint, (size_t)count);
	if (!reach->joint) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->skin_count; i++) {
		for (int j = 0; j < model->skin[i].joint_count; j++) {
			reach->joint[reach->joint_count++] = (struct reach_joint){
				.skin = i, .number = j, .box = bounds_empty()};
		}
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		int mesh = model->node[drawable->node].mesh;

		if (drawable->skin >= 0) {
			measure(drawable, model->mesh[mesh].target_count,
				joints_of(reach, model, drawable->skin));
		}
	}
	return 0;
}

/*
 * Transforms a box by a matrix, by the factor unit and by the view, and adds
 * the result's box along the view's axes to out.
 */
static void add_moved(struct bounds *out, const vec4 *view, const vec4 *matrix,
	float unit, const struct reach_box *box)
{
	float moved[4][3], point[2][3];

	for (int i = 0; i < 4; i++) {
		for (int axis = 0; axis < 3; axis++) {
			moved[i][axis] = unit *
				(view[0][axis] * matrix[i][0] +
					view[1][axis] * matrix[i][1] +
					view[2][axis] * matrix[i][2]);
		}
	}
	for (int axis = 0; axis < 3; axis++) {
		float at = view[3][axis] + moved[3][axis], side = 0.0f;

		for (int i = 0; i < 3; i++) {
			at += moved[i][axis] * box->middle[i];
			side += scalar_abs(moved[i][axis]) * box->half[i];
		}
		point[0][axis] = at - side;
		point[1][axis] = at + side;
	}
	bounds_add(out, point[0]);
	bounds_add(out, point[1]);
}

struct bounds reach_now(const struct reach *reach,
	const struct instance *instance, const vec4 *view)
{
	struct bounds now = bounds_empty();
	struct reach_box box;

	for (int i = 0; i < reach->joint_count; i++) {
		const struct reach_joint *joint = &reach->joint[i];

		if (!bounds_is_empty(&joint->box)) {
			bounds_center(&joint->box, box.middle);
			vec_subtract(joint->box.high, box.middle, box.half);
			add_moved(&now, view,
				(const vec4 *)instance
					->palette[joint->skin][joint->number],
				1.0f, &box);
		}
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->skin < 0 && !drawable->hidden) {
			memcpy(box.middle, drawable->box_middle,
				sizeof(box.middle));
			memcpy(box.half, drawable->box_half, sizeof(box.half));
			add_moved(&now, view,
				(const vec4 *)instance->world[drawable->node],
				instance->unit_scale, &box);
		}
	}
	return now;
}
