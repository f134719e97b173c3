#include "app/anim/procedural/muscle.h"

#include "app/anim/ease.h"
#include "app/anim/math/quat.h"
#include "app/anim/procedural/bone.h"

float muscle_bend_rad(const struct pose *pose, int joint)
{
	float turn[4];

	quat_conjugate(pose->model->node[joint].rest.rotation, turn);
	quat_multiply(turn, pose->local[joint].rotation, turn);
	return quat_angle(turn);
}

float muscle_at(const struct muscle *muscle, const struct pose *pose)
{
	float range = muscle->to_rad - muscle->from_rad;
	float bend = muscle_bend_rad(pose, muscle->joint);

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
