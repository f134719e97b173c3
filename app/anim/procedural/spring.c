#include "app/anim/procedural/spring.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/anim/procedural/substep.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

static const float HIGHEST_HZ = 15;
static const float FASTEST_TURN = 40; /* limit of a bone's speed, in radians a
					 second */

/* The data of one call of spring_update(). */
struct swing {
	struct spring *spring;
	const struct pose *pose;
	const struct capsule_world *capsule;
	int capsule_count;
	bool mirrored;             /* the first bone's parent mirrors */
	float bone[SPRING_MAX][3]; /* vector to the bone's end, in its own axes,
				      mirrored if its parent mirrors, and the
				      world's unit */
	float length[SPRING_MAX];
	float turned[SPRING_MAX][4]; /* new world rotations */
	float total;
};

int spring_init(
	struct spring *spring, const struct model *model, int last, int count)
{
	*spring = (struct spring){
		.count = count,
		.frequency_hz = 2,
		.damping = 0.3f,
		.gravity = {0, -9.81f, 0},
		.weight = 1,
	};
	if (count < 1 || count > SPRING_MAX ||
		!bone_chain(model, last, count, spring->node)) {
		return -EINVAL;
	}
	memcpy(spring->end, model->node[last].rest.translation,
		sizeof(spring->end));
	return 0;
}

/* Computes bone[]: vectors to the next node; of the last, to its end. */
static void measure(
	struct swing *swing, const mat4 *world, const struct pose *pose)
{
	const struct spring *spring = swing->spring;

	swing->total = 0;
	for (int i = 0; i < spring->count; i++) {
		int node = spring->node[i];
		const float *to = i + 1 < spring->count
			? pose->local[spring->node[i + 1]].translation
			: spring->end;
		float above = matrix_scale(&world[node]);

		for (int k = 0; k < 3; k++) {
			swing->bone[i][k] = to[k] * above;
		}
		if (swing->mirrored) {
			swing->bone[i][2] = -swing->bone[i][2];
		}
		swing->length[i] = vec_length(swing->bone[i]);
		swing->total += swing->length[i];
	}
}

static void begin_at_rest(
	struct spring *spring, const struct swing *swing, const mat4 *world)
{
	for (int i = 0; i < spring->count; i++) {
		float rotation[4], bone[3];

		matrix_rotation(((mat4 *)world)[spring->node[i]], rotation);
		quat_rotate(rotation, swing->bone[i], bone);
		vec_add_scaled(world[spring->node[i]][3], bone, 1,
			spring->position[i]);
	}
	memset(spring->velocity, 0, sizeof(spring->velocity));
	spring->begun = true;
}

/*
 * Integrates one part of a step by the trapezoidal rule, which is stable for
 * any stiffness and neither adds nor removes energy.
 */
static void pull(struct spring *spring, int i, const float goal[3], float part_s)
{
	float hz = scalar_clamp(spring->frequency_hz, 0, HIGHEST_HZ);
	float omega = 2 * SCALAR_PI * hz;
	float stiffness = omega * omega;
	float half = part_s * spring->damping * omega +
		0.25f * part_s * part_s * stiffness;
	float *end = spring->position[i];
	float *velocity = spring->velocity[i];

	for (int k = 0; k < 3; k++) {
		float before = velocity[k];
		float force =
			stiffness * (goal[k] - end[k]) + spring->gravity[k];

		velocity[k] =
			((1 - half) * before + part_s * force) / (1 + half);
		end[k] += 0.5f * part_s * (before + velocity[k]);
	}
}

/*
 * Moves an end along the bone so that it is length away from the bone's origin.
 * If it is at the origin, the direction is fallback.
 */
static void hold_length(const float origin[3], const float fallback[3],
	float length, float end[3])
{
	float offset[3];

	vec_subtract(end, origin, offset);
	if (vec_normalize(offset) == 0) {
		memcpy(offset, fallback, sizeof(offset));
		vec_normalize(offset);
	}
	vec_add_scaled(origin, offset, length, end);
}

/*
 * Takes an end's velocity relative to the bone's origin, removes the component
 * along the bone, and limits the rest to FASTEST_TURN.
 */
static void hold_speed(const float origin[3], const float origin_velocity[3],
	float length, const float end[3], float velocity[3])
{
	float offset[3], relative[3];
	float speed;

	vec_subtract(end, origin, offset);
	vec_normalize(offset);
	vec_subtract(velocity, origin_velocity, relative);
	vec_add_scaled(relative, offset, -vec_dot(relative, offset), relative);
	speed = vec_length(relative);
	if (!(speed <= FASTEST_TURN * length)) {
		speed = vec_normalize(relative) > 0 ? FASTEST_TURN * length : 0;
		vec_add_scaled(origin_velocity, relative, speed, velocity);
		return;
	}
	vec_add_scaled(origin_velocity, relative, 1, velocity);
}

/*
 * Moves an end out of the capsules and stops the part of its velocity that
 * leads into them. ahead is the bone as it is animated.
 */
static void keep_out(
	struct swing *swing, int i, const float origin[3], const float ahead[3])
{
	struct spring *spring = swing->spring;
	float *end = spring->position[i];
	float *velocity = spring->velocity[i];
	float out[3] = {end[0], end[1], end[2]};
	float inward;

	if (!capsule_push_all(swing->capsule, swing->capsule_count,
		    spring->radius, end)) {
		return;
	}
	vec_subtract(end, out, out);
	if (vec_normalize(out) > 0) {
		inward = vec_dot(velocity, out);
		vec_add_scaled(
			velocity, out, inward < 0 ? -inward : 0, velocity);
	}
	hold_length(origin, ahead, swing->length[i], end);
}

/* The origin of a bone, in the world. */
struct base {
	float position[3], velocity[3];
};

/* Moves one bone's end and changes its animated rotation accordingly. */
static void swing_bone(struct swing *swing, int i, const struct base *base,
	float part_s, float rotation[4])
{
	struct spring *spring = swing->spring;
	const float *origin = base->position;
	float *end = spring->position[i];
	float animated[4] = {rotation[0], rotation[1], rotation[2], rotation[3]};
	float ahead[3], goal[3], offset[3], turn[4];

	quat_rotate(rotation, swing->bone[i], ahead);
	vec_add_scaled(origin, ahead, 1, goal);
	pull(spring, i, goal, part_s);
	hold_length(origin, ahead, swing->length[i], end);
	keep_out(swing, i, origin, ahead);
	hold_speed(origin, base->velocity, swing->length[i], end,
		spring->velocity[i]);
	vec_subtract(end, origin, offset);
	quat_between(ahead, offset, turn);
	quat_multiply(turn, rotation, rotation);
	quat_normalize(rotation);
	if (spring->limit_rad > 0 &&
		quat_limit(rotation, animated, spring->limit_rad)) {
		quat_rotate(rotation, swing->bone[i], offset);
		vec_add_scaled(origin, offset, 1, end);
		memcpy(spring->velocity[i], base->velocity, sizeof(offset));
	}
}

/*
 * Moves all bones by one part of a step. base is the first bone's origin, above
 * the world rotation of its parent.
 */
static void swing_chain(struct swing *swing, struct base base,
	const float above[4], float part_s)
{
	struct spring *spring = swing->spring;
	const float *parent = above;

	for (int i = 0; i < spring->count; i++) {
		float *turned = swing->turned[i];

		memcpy(turned, swing->pose->local[spring->node[i]].rotation,
			sizeof(swing->turned[i]));
		bone_mirror_rotation(swing->mirrored, turned);
		quat_multiply(parent, turned, turned);
		quat_normalize(swing->turned[i]);
		swing_bone(swing, i, &base, part_s, swing->turned[i]);
		memcpy(base.position, spring->position[i],
			sizeof(base.position));
		memcpy(base.velocity, spring->velocity[i],
			sizeof(base.velocity));
		parent = swing->turned[i];
	}
}

static void store(
	const struct swing *swing, const float above[4], struct pose *pose)
{
	const struct spring *spring = swing->spring;
	const float *parent = above;

	for (int i = 0; i < spring->count; i++) {
		float *local = pose->local[spring->node[i]].rotation;
		float goal[4];

		quat_conjugate(parent, goal);
		quat_multiply(goal, swing->turned[i], goal);
		bone_mirror_rotation(swing->mirrored, goal);
		quat_slerp(local, goal, spring->weight, local);
		quat_normalize(local);
		pose->animated[spring->node[i]] = true;
		parent = swing->turned[i];
	}
}

static bool jumped(
	const struct spring *spring, const float origin[3], float total)
{
	float offset[3];

	vec_subtract(origin, spring->origin, offset);
	return !(vec_length(offset) <= 4 * total);
}

static void keep_base(
	struct spring *spring, const float origin[3], const float above[4])
{
	memcpy(spring->origin, origin, sizeof(spring->origin));
	memcpy(spring->rotation, above, sizeof(spring->rotation));
}

void spring_update(struct spring *spring, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world, struct pose *pose)
{
	struct swing swing = {.spring = spring,
		.pose = pose,
		.capsule = capsule,
		.capsule_count = capsule_count,
		.mirrored = bone_is_mirrored(pose, world, spring->node[0])};
	const float *origin = world[spring->node[0]][3];
	struct base base;
	float above[4];
	const struct substep substep = substep_divide(step_s);

	measure(&swing, world, pose);
	bone_parent_rotation(pose, world, spring->node[0], above);
	if (!spring->begun || jumped(spring, origin, swing.total)) {
		begin_at_rest(spring, &swing, world);
		keep_base(spring, origin, above);
	}
	vec_subtract(origin, spring->origin, base.velocity);
	for (int k = 0; k < 3; k++) {
		base.velocity[k] /= substep.step_s;
	}
	for (int p = 1; p <= substep.count; p++) {
		float fraction = (float)p / (float)substep.count;
		float rotation[4];

		vec_mix(spring->origin, origin, fraction, base.position);
		quat_slerp(spring->rotation, above, fraction, rotation);
		swing_chain(&swing, base, rotation, substep.part_s);
	}
	store(&swing, above, pose);
	keep_base(spring, origin, above);
}
