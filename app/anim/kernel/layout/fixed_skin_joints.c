#include "app/anim/kernel/layout/fixed_skin_parts.h"

#include <errno.h>

enum {
	JOINTS_MAX = 2048,
	MATRIX_ONE = 28672, /* what 1 becomes in matrices without scale */
	FINER_BITS = 2
};

/* Returns one more than the largest joint index of the primitive. */
static size_t count_joint_indices(const struct fixed_skin *skin)
{
	const struct model_primitive *primitive = skin->primitive;
	size_t entries =
		(size_t)skin->vertex_count * (size_t)primitive->influences;
	size_t count = 0;

	for (size_t i = 0; i < entries; i++) {
		count = primitive->joint[i] >= count ? primitive->joint[i] + 1u
						     : count;
	}
	return count;
}

int fixed_skin_list_joints(struct fixed_skin *skin, struct arena *arena)
{
	size_t slots = count_joint_indices(skin);

	skin->joint_slot = ARENA_ARRAY(arena, uint16_t, slots);
	if (!skin->joint_slot) {
		return -ENOMEM;
	}
	/*
	 * joint_slot[] first holds a flag for each joint that moves vertices,
	 * later the joint's index in joint[].
	 */
	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		fixed_influences_gather(skin->primitive, v, 0, &in);
		for (int i = 0; i < in.count; i++) {
			skin->joint_slot[in.joint[i]] = 1;
		}
	}
	for (size_t j = 0; j < slots; j++) {
		skin->joint_count += skin->joint_slot[j];
	}
	if (skin->joint_count > JOINTS_MAX) {
		return -ERANGE;
	}
	skin->joint = ARENA_ARRAY(
		arena, struct fixed_joint, (size_t)skin->joint_count);
	if (!skin->joint) {
		return -ENOMEM;
	}
	for (size_t j = 0, next = 0; j < slots; j++) {
		if (skin->joint_slot[j]) {
			skin->joint[next].joint = (int)j;
			skin->joint_slot[j] = (uint16_t)next++;
		}
	}
	return 0;
}

/*
 * Extends a joint's box. While boxes are measured, middle holds the low corner
 * and half the high one.
 */
static void extend_box(struct fixed_joint *joint, const float position[3],
	const float extent[3])
{
	for (int axis = 0; axis < 3; axis++) {
		float low = position[axis] - extent[axis];
		float high = position[axis] + extent[axis];

		if (low < joint->middle[axis]) {
			joint->middle[axis] = low;
		}
		if (high > joint->half[axis]) {
			joint->half[axis] = high;
		}
	}
}

static struct fixed_joint *joint_of(
	const struct fixed_skin *skin, uint16_t joint)
{
	return &skin->joint[skin->joint_slot[joint]];
}

/* Computes the boxes of the vertices that joints move at the present cap. */
static void measure_boxes(struct fixed_skin *skin)
{
	const struct model_primitive *primitive = skin->primitive;

	for (int i = 0; i < skin->joint_count * 3; i++) {
		skin->joint[i / 3].middle[i % 3] = 1e30f;
		skin->joint[i / 3].half[i % 3] = -1e30f;
	}
	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		fixed_influences_gather(primitive, v, skin->max_influences, &in);
		for (int i = 0; i < in.count; i++) {
			extend_box(joint_of(skin, in.joint[i]),
				primitive->position[v],
				fixed_skin_extent(skin, v));
		}
	}
	for (int i = 0; i < skin->joint_count * 3; i++) {
		struct fixed_joint *joint = &skin->joint[i / 3];
		float low = joint->middle[i % 3];
		float high = joint->half[i % 3];

		joint->used = high >= low;
		joint->middle[i % 3] = joint->used ? 0.5f * (low + high) : 0.0f;
		joint->half[i % 3] = joint->used ? 0.5f * (high - low) : 0.0f;
	}
}

static float largest(float a, float b)
{
	return a > b ? a : b;
}

/* The largest coordinate of any base vector, before scaling. */
static float measure_bases(const struct fixed_skin *skin)
{
	const struct model_primitive *primitive = skin->primitive;
	float size = 0.0f;

	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		const float *extent = fixed_skin_extent(skin, v);
		struct fixed_influences in;

		fixed_influences_gather(primitive, v, skin->max_influences, &in);
		for (int i = 0; i < in.count * 3; i++) {
			const struct fixed_joint *joint =
				joint_of(skin, in.joint[i / 3]);
			float away = primitive->position[v][i % 3] -
				joint->middle[i % 3];

			away = (away < 0.0f ? -away : away) + extent[i % 3];
			size = largest(size,
				away * (float)in.weight_q14[i / 3] /
					FIXED_WEIGHT_ONE_Q14);
		}
	}
	return size;
}

/*
 * Computes half the largest side of the box around all vertices, and of the box
 * around the centres of all joints' boxes.
 */
static void measure_bind_pose(
	const struct fixed_skin *skin, float *vertices, float *middles)
{
	*vertices = *middles = 0.0f;
	for (int axis = 0; axis < 3; axis++) {
		float low = 1e30f, high = -1e30f, from = 1e30f, to = -1e30f;

		for (int j = 0; j < skin->joint_count; j++) {
			float at = skin->joint[j].middle[axis];
			float half = skin->joint[j].half[axis];

			if (!skin->joint[j].used) {
				continue;
			}
			low = at - half < low ? at - half : low;
			high = largest(high, at + half);
			from = at < from ? at : from;
			to = largest(to, at);
		}
		*vertices = largest(*vertices, 0.5f * (high - low));
		*middles = largest(*middles, 0.5f * (to - from));
	}
}

/*
 * Chooses scale[FIXED_POSITION]: with 1 in the matrices as MATRIX_ONE, the bind
 * pose, enlarged by a quarter, fills the output. If the base vectors are small
 * enough, the scale is doubled up to FINER_BITS times, and 1 in the matrices
 * becomes a half or a quarter of MATRIX_ONE, so that matrices and base vectors
 * use a similar number of bits.
 */
static float choose_scale(const struct fixed_skin *skin)
{
	const float per_output = 65536.0f / MATRIX_ONE;
	float vertices, middles, most, rest;
	float scale = 32766.0f / largest(measure_bases(skin), 1e-12f);

	measure_bind_pose(skin, &vertices, &middles);
	most = per_output * 32767.0f / largest(1.25f * vertices, 1e-12f);
	rest = per_output * 16383.0f / largest(1.25f * middles, 1e-12f);
	most = rest < most ? rest : most;
	rest = fixed_skin_scale_limit(skin, FIXED_POSITION);
	scale = rest < scale ? rest : scale;
	for (int i = 0; i < FINER_BITS && most * 2.0f <= scale; i++) {
		most *= 2.0f;
	}
	return scale < most ? scale : most;
}

void fixed_skin_measure_joints(struct fixed_skin *skin)
{
	measure_boxes(skin);
	skin->scale[FIXED_POSITION] = choose_scale(skin);
}
