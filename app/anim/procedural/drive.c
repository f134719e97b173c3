#include "app/anim/procedural/drive.h"

#include "app/anim/blend.h"
#include "app/anim/transform.h"
#include "platform/base/scalar.h"

/* How long a child's axis has become by the scale of its parent. */
static float stretched(
	const struct transform *child, int axis, const float factor[3])
{
	float direction[3] = {0, 0, 0};

	direction[axis] = 1;
	quat_rotate(child->rotation, direction, direction);
	for (int i = 0; i < 3; i++) {
		direction[i] *= factor[i];
	}
	return vec_length(direction);
}

void bone_swell(struct pose *pose, int node, const float factor[3])
{
	for (int i = 0; i < 3; i++) {
		pose->local[node].scale[i] *= factor[i];
	}
	pose->animated[node] = true;
	for (int c = node + 1; c < pose->node_count; c++) {
		struct transform *child = &pose->local[c];

		if (pose->model->node[c].parent != node) {
			continue;
		}
		for (int i = 0; i < 3; i++) {
			float length = stretched(child, i, factor);

			child->scale[i] /= length > 1e-6f ? length : 1;
		}
		pose->animated[c] = true;
	}
}

struct breath breath_default(int chest)
{
	return (struct breath){
		.chest = chest,
		.rate_hz = 0.25f,
		.inhale = 0.4f,
		.swell = {0.02f, 0.01f, 0.05f},
		.lift_axis = {1, 0, 0},
		.lift_rad = -0.0175f,
		.weight = 1,
	};
}

float breath_at(const struct breath *breath, double time_s)
{
	double breaths = time_s * (double)breath->rate_hz;
	float inhale = scalar_clamp(breath->inhale, 0.05f, 0.95f);
	float phase;

	if (!(breaths > -2147483647.0 && breaths < 2147483647.0)) {
		return 0;
	}
	phase = (float)(breaths - (double)(int32_t)breaths);
	phase = phase < 0 ? phase + 1 : phase;
	return phase < inhale ? ease_at(EASE_CUBIC, phase / inhale)
			      : ease_at(EASE_CUBIC, (1 - phase) / (1 - inhale));
}

void breath_apply(const struct breath *breath, double time_s, struct pose *pose)
{
	float *rotation = pose->local[breath->chest].rotation;
	float full = breath_at(breath, time_s) * breath->weight;
	float factor[3], lift[4];

	for (int i = 0; i < 3; i++) {
		factor[i] = 1 + breath->swell[i] * full;
	}
	bone_swell(pose, breath->chest, factor);
	quat_from_axis_angle(breath->lift_axis, breath->lift_rad * full, lift);
	quat_multiply(rotation, lift, rotation);
	quat_normalize(rotation);
}

float bend_rad(const struct pose *pose, int joint)
{
	float turn[4];

	quat_conjugate(pose->model->node[joint].rest.rotation, turn);
	quat_multiply(turn, pose->local[joint].rotation, turn);
	return quat_angle(turn);
}

float muscle_at(const struct muscle *muscle, const struct pose *pose)
{
	float range = muscle->to_rad - muscle->from_rad;
	float bend = bend_rad(pose, muscle->joint);

	if (range == 0) {
		return bend >= muscle->to_rad ? 1 : 0;
	}
	return ease_at(EASE_CUBIC, (bend - muscle->from_rad) / range);
}

void muscle_apply(const struct muscle *muscle, struct pose *pose)
{
	float drawn = muscle_at(muscle, pose);

	if (muscle->node >= 0) {
		float factor[3];

		for (int i = 0; i < 3; i++) {
			factor[i] = 1 + muscle->swell[i] * drawn;
		}
		bone_swell(pose, muscle->node, factor);
	}
	if (muscle->weight >= 0) {
		pose->weight[muscle->weight] += muscle->amount * drawn;
	}
}
