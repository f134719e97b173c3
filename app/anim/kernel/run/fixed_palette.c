/*
 * With vectors v scaled by s (scale[FIXED_POSITION] of the skin), matrices m
 * scaled by e (element below) and weights w in Q15, a loop sums m * v + t * w
 * and keeps the upper 16 of 32 bits. So positions come out scaled by
 * s * e / 2^16, and translations t are scaled by twice that.
 */
#include "app/anim/kernel/run/fixed_palette.h"

#include "app/anim/kernel/fixed_number.h"

#include <errno.h>
#include <math.h>

/* Limits of the matrices' scale, within which products fit a float. */
#define ELEMENT_MIN 1e-12f
#define ELEMENT_MAX 1e12f

/*
 * How far a frame's vertices can reach. The numbers are floats converted by
 * fixed_order_of(), since VFP11 takes long to compare floats.
 */
struct reach {
	int32_t low[3], high[3]; /* the box around the joints' boxes, each
				    transformed by its matrix */
	int32_t from[3], to[3];  /* the box around the centres of these boxes */
	int32_t element;         /* the largest |element| of any matrix */
};

static float larger(float a, float b)
{
	return a > b ? a : b;
}

static inline void extend_low(int32_t *low, int32_t key)
{
	*low = key < *low ? key : *low;
}

static inline void extend_high(int32_t *high, int32_t key)
{
	*high = key > *high ? key : *high;
}

static inline void reach_row(struct reach *reach, const vec4 *m,
	const struct fixed_joint *joint, int row)
{
	const float *c = joint->middle, *h = joint->half;
	float x = m[0][row], y = m[1][row], z = m[2][row];
	float at = x * c[0] + y * c[1] + z * c[2] + m[3][row];
	float half = fabsf(x) * h[0] + fabsf(y) * h[1] + fabsf(z) * h[2];
	int32_t key = fixed_order_of(at);

	extend_high(&reach->element, fixed_order_of_abs(x));
	extend_high(&reach->element, fixed_order_of_abs(y));
	extend_high(&reach->element, fixed_order_of_abs(z));
	extend_low(&reach->low[row], fixed_order_of(at - half));
	extend_high(&reach->high[row], fixed_order_of(at + half));
	extend_low(&reach->from[row], key);
	extend_high(&reach->to[row], key);
}

static void measure(
	const struct fixed_skin *skin, const mat4 *palette, struct reach *out)
{
	struct reach reach = {{INT32_MAX, INT32_MAX, INT32_MAX},
		{INT32_MIN, INT32_MIN, INT32_MIN},
		{INT32_MAX, INT32_MAX, INT32_MAX},
		{INT32_MIN, INT32_MIN, INT32_MIN}, 0};

	for (int j = 0; j < skin->joint_count; j++) {
		const struct fixed_joint *joint = &skin->joint[j];
		const vec4 *m = palette[joint->joint];

		if (joint->used) {
			reach_row(&reach, m, joint, 0);
			reach_row(&reach, m, joint, 1);
			reach_row(&reach, m, joint, 2);
		}
	}
	*out = reach;
}

/* A NaN lies beyond infinity in this order, so it fails too. */
static bool is_usable(const struct reach *reach)
{
	const int32_t most = fixed_order_of(1e18f),
		      least = fixed_order_of(-1e18f);
	bool usable = reach->element <= most;

	for (int row = 0; row < 3; row++) {
		usable = usable && reach->low[row] >= least &&
			reach->high[row] <= most && reach->from[row] >= least &&
			reach->to[row] <= most;
	}
	return usable;
}

/*
 * Returns the number that 1 becomes in the matrices, as large as the largest
 * element, the box and the translations allow. It is rounded down to a step, so
 * that not every frame rounds its matrices differently. The limits leave a
 * margin for rounding.
 */
static float choose_element(
	const struct reach *reach, const float middle[3], float position_scale)
{
	float size = 0.0f, away = 0.0f;
	float limit = 32767.0f / (fixed_float_of(reach->element) + 1e-18f);
	float rest;

	for (int row = 0; row < 3; row++) {
		size = larger(
			size, fixed_float_of(reach->high[row]) - middle[row]);
		away = larger(
			away, fixed_float_of(reach->to[row]) - middle[row]);
		away = larger(
			away, middle[row] - fixed_float_of(reach->from[row]));
	}
	rest = 32700.0f / (size + 1e-18f) * (65536.0f / position_scale);
	limit = rest < limit ? rest : limit;
	rest = 16380.0f / (away + 1e-18f) * (65536.0f / position_scale);
	limit = rest < limit ? rest : limit;
	return fixed_step(limit > ELEMENT_MAX ? ELEMENT_MAX : limit);
}

/*
 * Writes one row of a joint's matrix. per_unit is the number that a translation
 * of 1 becomes.
 */
static inline void write_row(const vec4 *m, const struct fixed_joint *joint,
	int row, float middle, float element, float per_unit, int16_t out[4])
{
	const float *c = joint->middle;
	float x = m[0][row], y = m[1][row], z = m[2][row];
	float at = x * c[0] + y * c[1] + z * c[2] + m[3][row] - middle;

	out[0] = fixed_round_fast(x * element);
	out[1] = fixed_round_fast(y * element);
	out[2] = fixed_round_fast(z * element);
	/* Weights are negative, so the translation is negated. The 1 is half of
	   the output's last bit and makes the result round. */
	out[3] = (int16_t)(-fixed_round_fast(at * per_unit) - 1);
}

int fixed_palette_make(const struct fixed_skin *skin, const mat4 *palette,
	struct fixed_matrix *matrix, struct fixed_placement *placement)
{
	struct reach reach;
	float *middle = placement->offset;
	float element, output;

	measure(skin, palette, &reach);
	if (!is_usable(&reach)) {
		return -ERANGE;
	}
	for (int row = 0; row < 3; row++) {
		middle[row] = 0.5f *
			(fixed_float_of(reach.low[row]) +
				fixed_float_of(reach.high[row]));
	}
	element = choose_element(&reach, middle, skin->scale[FIXED_POSITION]);
	if (element < ELEMENT_MIN) {
		return -ERANGE;
	}
	output = skin->scale[FIXED_POSITION] * element / 65536.0f;
	placement->scale = 1.0f / output;
	for (int j = 0; j < skin->joint_count; j++) {
		const struct fixed_joint *joint = &skin->joint[j];
		const vec4 *m = palette[joint->joint];

		for (int row = 0; row < 3 && joint->used; row++) {
			write_row(m, joint, row, middle[row], element,
				2.0f * output, matrix[j].row[row]);
		}
	}
	return 0;
}

/*
 * A matrix for normals has the Frobenius norm of the joint's matrix, which is
 * at most 3 times the largest element. So a third of the element for positions
 * makes rows at most 32767 long, and no product with a normal wraps.
 */
void fixed_palette_make_normals(const struct fixed_skin *skin,
	const struct fixed_placement *placement, const mat4 *palette,
	struct fixed_matrix *matrix)
{
	const float element = 65536.0f /
		(3.0f * skin->scale[FIXED_POSITION] * placement->scale);

	for (int j = 0; j < skin->joint_count; j++) {
		const struct fixed_joint *joint = &skin->joint[j];
		const vec4 *m = palette[joint->joint];

		for (int row = 0; row < 3 && joint->used; row++) {
			int16_t *out = matrix[j].row[row];

			out[0] = fixed_round_fast(m[0][row] * element);
			out[1] = fixed_round_fast(m[1][row] * element);
			out[2] = fixed_round_fast(m[2][row] * element);
			out[3] = 0;
		}
	}
}
