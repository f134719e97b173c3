/*
 * The loops over rotations of clips: arm/ for ARM11 cores, portable/ for
 * others; both compute the same floats.
 */
#ifndef APP_ANIM_TURNS_H
#define APP_ANIM_TURNS_H

#include "app/model/model.h"

/* A rotation channel: unit keys, interpolated along the shorter arc. */
struct turn {
	const float *time_s; /* [last + 1], strictly increasing; the first key
				time is at least 0 and not -0 */
	union {
		const float *value;         /* [last + 1][4], x y z w */
		const int16_t (*packed)[4]; /* see struct model_channel */
	};
	int offset;   /* bytes from the first of the pose's transforms to the
			 rotation */
	float weight; /* 0..1, by which turns_mix() multiplies amount */
	int key;      /* key found by the last call, 0..last - 1; any of these
			 at first */
	int last;     /* index of the last key; at least 1 */
};

/*
 * Writes the rotations of count turns at time_s, which is at least 0 and not
 * -0, into local, the transforms of a pose. Times before the first or after the
 * last key give that key's rotation. Turns that follow each other and share
 * time_s share one search. Formulas: glTF 2.0, appendix C.4;
 * inline_quat_slerp().
 */
void turns_set(
	struct turn *turn, int count, float time_s, struct transform *local);

/*
 * The same, but mixes the rotations with those in local, which should be of
 * unit length: local = normalize(local * (1 - t) + rotation * t), where t =
 * weight * amount. The rotation is negated first if it lies in the other half
 * of the sphere.
 */
void turns_mix(struct turn *turn, int count, float time_s,
	struct transform *local, float amount);

/*
 * The same for turns whose keys are packed. The rotations are as long as the
 * keys, 1 to within 4e-5; apart from the length their error is at most 4e-6.
 * Weights and products are integers: a weight of 1 is 2^38 / 32767 (Q23), and
 * the upper part of its product with a key has 2^22 to 1, like the mantissa of
 * a float between 2 and 4.
 */
void turns_set_packed(
	struct turn *turn, int count, float time_s, struct transform *local);
void turns_mix_packed(struct turn *turn, int count, float time_s,
	struct transform *local, float amount);

#endif
