#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/anim/procedural/ik.h"
#include "platform/base/scalar.h"

#include <string.h>

/*
 * The positions of the three joints in the world, and the solved ones of the
 * last two.
 */
struct limb_shape {
	float upper[3], lower[3], tip[3];
	float new_lower[3], new_tip[3];
	float bend[3]; /* unit length, from the line between upper and tip
			  towards lower */
};

/*
 * Writes the component of v at right angles to a unit direction, normalised.
 * Returns false if there is none.
 */
static bool make_side(const float v[3], const float direction[3], float out[3])
{
	float length = vec_length(v);

	vec_add_scaled(v, direction, -vec_dot(v, direction), out);
	/* If v is nearly parallel to the direction, only rounding is left. */
	if (!(vec_length(out) > 1e-4f * length)) {
		return false;
	}
	return vec_normalize(out) > 0;
}

static void find_bend(
	struct limb_shape *shape, const float direction[3], const float pole[3])
{
	static const float axis[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
	float offset[3];

	if (pole) {
		vec_subtract(pole, shape->upper, offset);
		if (make_side(offset, direction, shape->bend)) {
			return;
		}
	}
	vec_subtract(shape->lower, shape->upper, offset);
	for (int i = 0; i < 4; i++) {
		const float *v = i == 0 ? offset : axis[i - 1];

		if (make_side(v, direction, shape->bend)) {
			return;
		}
	}
}

/*
 * Places the joints by the law of cosines. Returns the distance from the target
 * to the nearest point that the limb can reach.
 */
static float place_joints(
	struct limb_shape *shape, const float target[3], const float pole[3])
{
	float to_lower[3], to_tip[3], direction[3];
	float a, b, distance, reach, cosine;

	vec_subtract(shape->lower, shape->upper, to_lower);
	vec_subtract(shape->tip, shape->lower, to_tip);
	vec_subtract(target, shape->upper, direction);
	a = vec_length(to_lower);
	b = vec_length(to_tip);
	distance = vec_normalize(direction);
	if (distance == 0) {
		/* The target is the shoulder: any direction will do. */
		memcpy(direction, to_lower, sizeof(direction));
		vec_normalize(direction);
	}
	reach = scalar_clamp(distance, scalar_abs(a - b), a + b);
	reach = reach > 1e-6f * (a + b) ? reach : 1e-6f * (a + b);
	cosine = scalar_clamp(
		(a * a + reach * reach - b * b) / (2 * a * reach), -1, 1);
	find_bend(shape, direction, pole);
	vec_add_scaled(shape->upper, direction, a * cosine, shape->new_lower);
	vec_add_scaled(shape->new_lower, shape->bend,
		a * scalar_sqrt(1 - cosine * cosine), shape->new_lower);
	vec_add_scaled(shape->upper, direction, reach, shape->new_tip);
	return scalar_abs(distance - reach);
}

/*
 * Writes the rotation of a frame with x along direction and z close to normal.
 * Returns false if they do not define one.
 */
static bool frame(const float direction[3], const float normal[3], float out[4])
{
	mat4 m = {{0}};

	memcpy(m[0], direction, sizeof(float[3]));
	if (vec_normalize(m[0]) == 0 || !make_side(normal, m[0], m[2])) {
		return false;
	}
	vec_cross(m[2], m[0], m[1]);
	matrix_rotation(m, out);
	return true;
}

/*
 * Writes the rotation, in world axes, from the old upper bone to the new one.
 * It also rotates the plane of the bend, so that the elbow stays a hinge; a
 * straight limb has no such plane.
 */
static void upper_turn(const struct limb_shape *shape, float out[4])
{
	float old_bone[3], old_tip[3], new_bone[3], new_tip[3];
	float old_normal[3], new_normal[3];
	float old_frame[4], new_frame[4];

	vec_subtract(shape->lower, shape->upper, old_bone);
	vec_subtract(shape->tip, shape->lower, old_tip);
	vec_subtract(shape->new_lower, shape->upper, new_bone);
	vec_subtract(shape->new_tip, shape->upper, new_tip);
	vec_cross(old_bone, old_tip, old_normal);
	/* The bend and the direction to the tip span the new plane. */
	vec_cross(shape->bend, new_tip, new_normal);
	if (vec_length(old_normal) >
			1e-3f * vec_length(old_bone) * vec_length(old_tip) &&
		frame(old_bone, old_normal, old_frame) &&
		frame(new_bone, new_normal, new_frame)) {
		quat_conjugate(old_frame, old_frame);
		quat_multiply(new_frame, old_frame, out);
		return;
	}
	quat_between(old_bone, new_bone, out);
}

/*
 * Rotates the lower bone by `lower` in world axes, after its parent was rotated
 * with the upper bone by `upper`.
 */
static void set_lower(const struct ik_limb *limb, const float upper[4],
	const float lower[4], const mat4 *world, struct pose *pose)
{
	float *local = pose->local[limb->lower].rotation;
	bool mirrored = bone_is_mirrored(pose, world, limb->lower);
	float parent[4], goal[4];

	bone_parent_rotation(pose, world, limb->lower, parent);
	quat_multiply(upper, parent, parent);
	memcpy(goal, local, sizeof(goal));
	bone_mirror_rotation(mirrored, goal);
	quat_multiply(parent, goal, goal);
	quat_multiply(lower, goal, goal);
	quat_conjugate(parent, parent);
	quat_multiply(parent, goal, goal);
	bone_mirror_rotation(mirrored, goal);
	quat_normalize(goal);
	quat_slerp(local, goal, limb->weight, local);
	pose->animated[limb->lower] = true;
}

float ik_limb_solve(const struct ik_limb *limb, const float target[3],
	const float pole[3], const mat4 *world, struct pose *pose)
{
	struct limb_shape shape;
	float upper[4], lower[4];
	float now[3], wanted[3];
	float left;

	memcpy(shape.upper, world[limb->upper][3], sizeof(shape.upper));
	memcpy(shape.lower, world[limb->lower][3], sizeof(shape.lower));
	memcpy(shape.tip, world[limb->tip][3], sizeof(shape.tip));
	vec_subtract(shape.lower, shape.upper, now);
	vec_subtract(shape.tip, shape.lower, wanted);
	if (!(vec_length(now) > 1e-9f && vec_length(wanted) > 1e-9f)) {
		vec_subtract(target, shape.tip, now);
		return vec_length(now);
	}
	left = place_joints(&shape, target, pole);
	upper_turn(&shape, upper);
	vec_subtract(shape.tip, shape.lower, now);
	quat_rotate(upper, now, now);
	vec_subtract(shape.new_tip, shape.new_lower, wanted);
	quat_between(now, wanted, lower);
	set_lower(limb, upper, lower, world, pose);
	bone_turn_world(pose, world, limb->upper, upper, limb->weight);
	return left;
}
