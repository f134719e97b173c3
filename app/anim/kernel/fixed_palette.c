/*
 * A frame's matrices in 16 bits.
 *
 * With vectors v scaled by s (the skin's position_scale), matrices m scaled by
 * e (element below) and weights w in Q15, a loop sums m * v + t * w and keeps
 * the upper 16 of 32 bits. So positions come out scaled by s * e / 2^16, and
 * translations t are twice as fine as those.
 */
#include "app/anim/kernel/fixed_skin.h"

#include "app/anim/kernel/fixed_number.h"
#include "platform/base/scalar.h"

#include <errno.h>

/* Keeps scales within what float has room for. */
#define ELEMENT_MIN 1e-12f
#define ELEMENT_MAX 1e12f

/* What a frame's vertices can reach. */
struct reach {
	float low[3], high[3]; /* the box around what the matrices make of the
				  joints' boxes */
	float from[3], to[3];  /* and of their middles */
	float element;         /* the largest of any matrix */
	bool usable;
};

static void extend(float value, float *low, float *high)
{
	*low = value < *low ? value : *low;
	*high = value > *high ? value : *high;
}

static float larger(float a, float b)
{
	return a > b ? a : b;
}

static float carry_middle(
	const vec4 *m, const struct fixed_joint *joint, int row)
{
	return m[0][row] * joint->middle[0] + m[1][row] * joint->middle[1] +
		m[2][row] * joint->middle[2] + m[3][row];
}

static void reach_joint(
	struct reach *reach, const vec4 *m, const struct fixed_joint *joint)
{
	for (int row = 0; row < 3; row++) {
		float at = carry_middle(m, joint, row);
		float half = 0.0f;

		for (int column = 0; column < 3; column++) {
			float element = scalar_abs(m[column][row]);

			if (!(element <= 1e18f)) {
				reach->usable = false;
			}
			reach->element = larger(reach->element, element);
			half += element * joint->half[column];
		}
		reach->usable = reach->usable && fixed_can_use(at) &&
			fixed_can_use(half);
		extend(at - half, &reach->low[row], &reach->high[row]);
		extend(at + half, &reach->low[row], &reach->high[row]);
		extend(at, &reach->from[row], &reach->to[row]);
	}
}

static void measure(
	const struct fixed_skin *skin, const mat4 *palette, struct reach *reach)
{
	*reach = (struct reach){.usable = true};
	for (int row = 0; row < 3; row++) {
		reach->low[row] = reach->from[row] = 1e30f;
		reach->high[row] = reach->to[row] = -1e30f;
	}
	for (int j = 0; j < skin->joint_count; j++) {
		const struct fixed_joint *joint = &skin->joint[j];

		if (joint->used) {
			reach_joint(reach, palette[joint->joint], joint);
		}
	}
}

/*
 * What 1 is in the matrices: as fine as the largest element, the box and the
 * translations allow, in steps, lest all numbers change their rounding in each
 * frame. The margins are for rounding.
 */
static float choose_element(
	const struct reach *reach, const float middle[3], float position_scale)
{
	float size = 0.0f, away = 0.0f;
	float limit = 32767.0f / (reach->element + 1e-18f);
	float rest;

	for (int row = 0; row < 3; row++) {
		size = larger(size, reach->high[row] - middle[row]);
		away = larger(away, reach->to[row] - middle[row]);
		away = larger(away, middle[row] - reach->from[row]);
	}
	rest = 32700.0f / (size + 1e-18f) * (65536.0f / position_scale);
	limit = rest < limit ? rest : limit;
	rest = 16380.0f / (away + 1e-18f) * (65536.0f / position_scale);
	limit = rest < limit ? rest : limit;
	return fixed_step(limit > ELEMENT_MAX ? ELEMENT_MAX : limit);
}

int fixed_palette_make(const struct fixed_skin *skin, const mat4 *palette,
	struct fixed_matrix *matrix, struct fixed_placement *placement)
{
	struct reach reach;
	float *middle = placement->offset;
	float element, output;

	measure(skin, palette, &reach);
	if (!reach.usable) {
		return -ERANGE;
	}
	for (int row = 0; row < 3; row++) {
		middle[row] = 0.5f * (reach.low[row] + reach.high[row]);
	}
	element = choose_element(&reach, middle, skin->position_scale);
	if (element < ELEMENT_MIN) {
		return -ERANGE;
	}
	output = skin->position_scale * element / 65536.0f;
	placement->scale = 1.0f / output;
	for (int j = 0; j < skin->joint_count; j++) {
		const struct fixed_joint *joint = &skin->joint[j];
		const vec4 *m = palette[joint->joint];

		for (int row = 0; row < 3 && joint->used; row++) {
			float at = carry_middle(m, joint, row) - middle[row];
			int16_t *to = matrix[j].row[row];

			to[0] = fixed_round(m[0][row] * element);
			to[1] = fixed_round(m[1][row] * element);
			to[2] = fixed_round(m[2][row] * element);
			/* Weights are negative. The 1 is half of the
			   output's last bit, which rounds. */
			to[3] = (int16_t)(-fixed_round(at * 2.0f * output) - 1);
		}
	}
	return 0;
}
