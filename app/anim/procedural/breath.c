#include "app/anim/procedural/breath.h"

#include "app/anim/ease.h"
#include "app/anim/math/quat.h"
#include "app/anim/procedural/bone.h"
#include "platform/base/scalar.h"

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
