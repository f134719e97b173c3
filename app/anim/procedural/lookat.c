#include "app/anim/procedural/lookat.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "platform/base/scalar.h"

#include <string.h>

struct lookat lookat_default(int node)
{
	return (struct lookat){
		.node = node,
		.forward = {0, 0, 1},
		.up = {0, 1, 0},
		.yaw_limit_rad = 1.396f,
		.pitch_limit_rad = 0.873f,
		.release_rad = 2.094f,
		.rate = 8,
		.weight = 1,
	};
}

/*
 * Writes the target's direction in the bone's axes. Returns false if the target
 * is at the bone itself.
 */
static bool own_direction(const struct lookat *lookat, const float target[3],
	const mat4 *world, const struct pose *pose, float out[3])
{
	bool mirrored = bone_is_mirrored(pose, world, lookat->node);
	float parent[4], rotation[4];

	bone_parent_rotation(pose, world, lookat->node, parent);
	memcpy(rotation, pose->local[lookat->node].rotation, sizeof(rotation));
	bone_mirror_rotation(mirrored, rotation);
	quat_multiply(parent, rotation, rotation);
	quat_conjugate(rotation, rotation);
	vec_subtract(target, world[lookat->node][3], out);
	quat_rotate(rotation, out, out);
	out[2] = mirrored ? -out[2] : out[2];
	return vec_normalize(out) > 0;
}

static void find_angles(const struct lookat *lookat, const float target[3],
	const mat4 *world, const struct pose *pose, float *yaw, float *pitch)
{
	float right[3], direction[3];
	float ahead, aside, above;

	*yaw = 0;
	*pitch = 0;
	if (!target || !own_direction(lookat, target, world, pose, direction)) {
		return;
	}
	vec_cross(lookat->up, lookat->forward, right);
	ahead = vec_dot(direction, lookat->forward);
	aside = vec_dot(direction, right);
	above = vec_dot(direction, lookat->up);
	*yaw = scalar_atan2(aside, ahead);
	if (lookat->release_rad > 0 && scalar_abs(*yaw) > lookat->release_rad) {
		*yaw = 0;
		return;
	}
	*pitch = scalar_atan2(above, scalar_sqrt(ahead * ahead + aside * aside));
	*yaw = scalar_clamp(*yaw, -lookat->yaw_limit_rad, lookat->yaw_limit_rad);
	*pitch = scalar_clamp(
		*pitch, -lookat->pitch_limit_rad, lookat->pitch_limit_rad);
}

void lookat_update(struct lookat *lookat, const float target[3], float step_s,
	const mat4 *world, struct pose *pose)
{
	float *rotation = pose->local[lookat->node].rotation;
	float yaw, pitch, fraction;
	float right[3], turn[4];

	find_angles(lookat, target, world, pose, &yaw, &pitch);
	/* Exponential decay does not depend on the frame rate. */
	fraction = lookat->rate > 0 ? 1 - scalar_exp(-lookat->rate * step_s) : 1;
	lookat->yaw_rad += (yaw - lookat->yaw_rad) * fraction;
	lookat->pitch_rad += (pitch - lookat->pitch_rad) * fraction;

	vec_cross(lookat->up, lookat->forward, right);
	quat_from_axis_angle(lookat->up, lookat->yaw_rad * lookat->weight, turn);
	quat_multiply(rotation, turn, rotation);
	/* A positive angle about the right axis looks down. */
	quat_from_axis_angle(right, -lookat->pitch_rad * lookat->weight, turn);
	quat_multiply(rotation, turn, rotation);
	quat_normalize(rotation);
	pose->animated[lookat->node] = true;
}
