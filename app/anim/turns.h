/*
 * The loops over rotations of clips. toolchain/sources.mk chooses arm/ for the
 * board and portable/ for other targets; both compute the same floats.
 */
#ifndef APP_ANIM_TURNS_H
#define APP_ANIM_TURNS_H

#include "app/model/model.h"

/*
 * A rotation that changes over time: keys of unit length, interpolated along
 * the shorter arc.
 */
struct turn {
	const float *time_s; /* [last + 1], strictly increasing, the first one
				at least 0 and not -0 */
	union {
		const float *value;         /* [last + 1][4], x y z w */
		const int16_t (*packed)[4]; /* see struct model_channel */
	};
	int offset;   /* bytes from the transforms to the rotation */
	float weight; /* 0..1, multiplies amount of turns_mix() */
	int key;      /* of the last call; at first any one, 0..last - 1 */
	int last;     /* of the keys; at least 1 */
};

/*
 * Writes the rotations at time_s, which is at least 0 and not -0, into local.
 * Times beyond the first or last key give that key's rotation. Formulas: glTF
 * 2.0, appendix C.4; inline_quat_slerp().
 */
void turns_set(
	struct turn *turn, int count, float time_s, struct transform *local);

/*
 * The same, but mixes the rotations with those in local, which should be of
 * unit length: for t = weight * amount, normalize(local * (1 - t) + rotation *
 * t), with the sign of rotation that lies in local's half of the sphere.
 */
void turns_mix(struct turn *turn, int count, float time_s,
	struct transform *local, float amount);

/*
 * The same for turns of which packed is set. The rotations are as long as the
 * keys, which is 1 to 4e-5, and otherwise right to 4e-6. Weights and products
 * are integers: a key times a weight of 2^38 / 32767 is a number of 2^22 to 1,
 * the last bits of a float between 2 and 4.
 */
void turns_set_packed(
	struct turn *turn, int count, float time_s, struct transform *local);
void turns_mix_packed(struct turn *turn, int count, float time_s,
	struct transform *local, float amount);

#endif
