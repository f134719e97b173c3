#include "app/anim/turns.h"

#include "app/anim/math/transform_inline.h"

#include <string.h>

/* Where a time lies among keys; kept for the next turn with these times. */
struct moment {
	const float *time_s;
	int key;
	float u; /* 0..1 from this key to the next one */
};

/* Returns the last key, 0..last - 1, not after time_s; key 0 before all. */
static int find_key(const struct turn *turn, float time_s)
{
	int low = 0, high = turn->last;

	while (high - low > 1) {
		int middle = (low + high) / 2;

		if (turn->time_s[middle] <= time_s) {
			low = middle;
		} else {
			high = middle;
		}
	}
	return low;
}

static struct moment find(struct turn *turn, float time_s)
{
	const float *at = turn->time_s + turn->key;

	if (!(time_s >= at[0] && time_s < at[1])) {
		turn->key = find_key(turn, time_s);
		at = turn->time_s + turn->key;
	}
	time_s = time_s < at[0] ? at[0] : time_s;
	time_s = time_s > at[1] ? at[1] : time_s;
	return (struct moment){
		turn->time_s, turn->key, (time_s - at[0]) / (at[1] - at[0])};
}

static void sample(
	struct turn *turn, float time_s, struct moment *moment, float out[4])
{
	const float *from;

	if (turn->time_s != moment->time_s) {
		*moment = find(turn, time_s);
	}
	from = turn->value + moment->key * 4;
	inline_quat_slerp(from, from + 4, moment->u, out);
}

static float *rotation_of(const struct turn *turn, struct transform *local)
{
	return (float *)((char *)local + turn->offset);
}

void turns_set(
	struct turn *turn, int count, float time_s, struct transform *local)
{
	struct moment moment = {NULL, 0, 0};

	for (int i = 0; i < count; i++) {
		sample(&turn[i], time_s, &moment, rotation_of(&turn[i], local));
	}
}

void turns_mix(struct turn *turn, int count, float time_s,
	struct transform *local, float amount)
{
	struct moment moment = {NULL, 0, 0};

	for (int i = 0; i < count; i++) {
		float *q = rotation_of(&turn[i], local);
		float to[4];

		sample(&turn[i], time_s, &moment, to);
		inline_quat_mix(q, to, turn[i].weight * amount);
	}
}

/*
 * The weights of two packed keys at one u: the weight of key i is key[i] -
 * curve[i] * cosine / 2^32, for the cosine of the angle between the keys.
 */
struct packed_weights {
	int32_t key[2];   /* Q23, a little more than 1 - u and u */
	int32_t curve[2]; /* the cosine is an integer of which 2^30 are 1 */
};

#define HIGH_ONE   ((int64_t)1 << 32)
#define WEIGHT_ONE 8388864.0f /* 2^38 / MODEL_PACKED_UNIT */

enum {
	COSINE_ONE = 0x40000000,
	/* cosines for keys that are 14 and 38 degrees of rotation apart */
	COSINE_NEAR = 0x3f800000,
	COSINE_MIDDLE = 0x3c800000,
	THREE_BITS = 0x40400000, /* the bits of the float 3 */
};

static int32_t multiply_16(int32_t a, int16_t b)
{
	return (int32_t)(((int64_t)a * b) >> 16);
}

/*
 * Polynomials of u, the factors of u^3 first, for key[0], key[1], curve[0] and
 * curve[1] of struct packed_weights: the series in quat.c up to its first term.
 * With t = 1 - u or u and g(t) = 4/3 (t - t^3) WEIGHT_ONE, curve is g(t) and
 * key is t WEIGHT_ONE + g(t) MODEL_PACKED_UNIT^2 / 2^32.
 */
static const float WEIGHT_TERMS[4][4] = {
	{2796117.25f, -2796117.25f, 11185152, -11185152},
	{-8388352, 0, -33555456, 0},
	{-2796629.25f, 11184981, 22370304, 11185152},
	{8388864, 0, 0, 0},
};

static struct packed_weights weights_at(float u)
{
	int32_t lane[4];

	for (int i = 0; i < 4; i++) {
		float sum = WEIGHT_TERMS[0][i];

		for (int power = 1; power < 4; power++) {
			sum = WEIGHT_TERMS[power][i] + sum * u;
		}
		lane[i] = (int32_t)sum;
	}
	return (struct packed_weights){{lane[0], lane[1]}, {lane[2], lane[3]}};
}

/* Adds the second term of the series. distance2 is the square of 1 - cosine. */
static int32_t bend(int32_t weight, int32_t curve, int32_t distance2)
{
	int32_t t = weight << 7;

	t = COSINE_ONE - multiply_high(t, t);
	return weight + multiply_high(multiply_high(curve, t), distance2);
}

static void choose_weights(
	const struct packed_weights *at, int32_t cosine, int32_t weight[2])
{
	for (int i = 0; i < 2; i++) {
		int64_t product = (int64_t)at->curve[i] * cosine;

		/* one SMMLS instruction on ARM */
		weight[i] = (int32_t)((at->key[i] * HIGH_ONE - product) >> 32);
	}
	if (cosine >= COSINE_NEAR) {
		return;
	}
	if (cosine >= COSINE_MIDDLE) {
		int32_t distance = (COSINE_ONE - cosine) * 4;
		int32_t distance2 = multiply_high(
			multiply_high(distance, distance), 0x66666666);

		weight[0] = bend(weight[0], at->curve[0], distance2);
		weight[1] = bend(weight[1], at->curve[1], distance2);
	} else {
		int32_t u =
			at->key[1] - (at->curve[1] >> 2) + (at->curve[1] >> 16);
		float exact[2];

		quat_slerp_weights((float)cosine * 9.313794e-10f - 1,
			(float)u * (1 / WEIGHT_ONE), exact);
		weight[0] = (int32_t)(exact[0] * WEIGHT_ONE);
		weight[1] = (int32_t)(exact[1] * WEIGHT_ONE);
	}
}

static void sample_packed(struct turn *turn, float time_s,
	struct moment *moment, struct packed_weights *at, float out[4])
{
	const int16_t(*key)[4];
	int32_t weight[2];
	int32_t cosine = 0;

	if (turn->time_s != moment->time_s) {
		*moment = find(turn, time_s);
		*at = weights_at(moment->u);
	}
	key = turn->packed + moment->key;
	for (int i = 0; i < 4; i++) {
		cosine += key[0][i] * key[1][i];
	}
	choose_weights(at, cosine, weight);
	for (int i = 0; i < 4; i++) {
		int32_t bits = THREE_BITS + multiply_16(weight[0], key[0][i]) +
			multiply_16(weight[1], key[1][i]);
		float offset;

		memcpy(&offset, &bits, sizeof(offset));
		out[i] = offset - 3;
	}
}

void turns_set_packed(
	struct turn *turn, int count, float time_s, struct transform *local)
{
	struct moment moment = {NULL, 0, 0};
	struct packed_weights at;

	for (int i = 0; i < count; i++) {
		sample_packed(&turn[i], time_s, &moment, &at,
			rotation_of(&turn[i], local));
	}
}

void turns_mix_packed(struct turn *turn, int count, float time_s,
	struct transform *local, float amount)
{
	struct moment moment = {NULL, 0, 0};
	struct packed_weights at;

	for (int i = 0; i < count; i++) {
		float to[4];

		sample_packed(&turn[i], time_s, &moment, &at, to);
		inline_quat_mix(rotation_of(&turn[i], local), to,
			turn[i].weight * amount);
	}
}
