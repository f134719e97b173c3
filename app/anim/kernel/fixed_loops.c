/*
 * The fixed-point loops in portable C.
 */
#include "app/anim/kernel/fixed.h"

#include <string.h>

enum {
	INFLUENCES_MAX = 8
};

/* As SMLAD has it: should a sum not fit, it wraps and is nothing worse. */
static inline uint32_t dot(const int16_t row[4], const struct fixed_base *base)
{
	return (uint32_t)(row[0] * base->x) + (uint32_t)(row[1] * base->y) +
		(uint32_t)(row[2] * base->z) + (uint32_t)(row[3] * base->w);
}

static inline int16_t upper(uint32_t sum)
{
	return (int16_t)(sum >> 16);
}

static inline struct fixed_vector narrow(uint32_t x, uint32_t y, uint32_t z)
{
	return (struct fixed_vector){(int16_t)x, upper(x), upper(y), upper(z)};
}

static inline struct fixed_vector skin_vertex(int influences,
	const struct fixed_base *base, const struct fixed_matrix *matrix)
{
	uint32_t x = 0, y = 0, z = 0;

	for (int i = 0; i < influences; i++) {
		x += dot(matrix[i].row[0], &base[i]);
		y += dot(matrix[i].row[1], &base[i]);
		z += dot(matrix[i].row[2], &base[i]);
	}
	return (struct fixed_vector){(int16_t)x, upper(x), upper(y), upper(z)};
}

/* Inlined for each number of influences, so that inner loops unroll. */
static inline void skin_run(int influences, int count,
	const struct fixed_base *base, const struct fixed_matrix *matrix,
	struct fixed_vector *out)
{
	for (int v = 0; v < count; v++) {
		out[v] = skin_vertex(influences, base + v * influences, matrix);
	}
}

static void skin_run_of(int influences, int count, const struct fixed_base *base,
	const struct fixed_matrix *matrix, struct fixed_vector *out)
{
	switch (influences) {
	case 1:
		skin_run(1, count, base, matrix, out);
		break;
	case 2:
		skin_run(2, count, base, matrix, out);
		break;
	case 3:
		skin_run(3, count, base, matrix, out);
		break;
	case 4:
		skin_run(4, count, base, matrix, out);
		break;
	default:
		skin_run(influences, count, base, matrix, out);
		break;
	}
}

static void skin(const struct fixed_group *group, int group_count,
	const struct fixed_base *base, const struct fixed_matrix *palette,
	struct fixed_vector *out)
{
	for (int g = 0; g < group_count; g++) {
		const int32_t *run = group[g].run;
		int influences = group[g].influences;

		for (int r = 0; r < group[g].run_count; r++) {
			struct fixed_matrix matrix[INFLUENCES_MAX];
			int count = *run++;

			for (int i = 0; i < influences; i++) {
				memcpy(&matrix[i],
					(const char *)palette + *run++,
					sizeof(matrix[i]));
			}
			skin_run_of(influences, count, base, matrix, out);
			base += (size_t)count * (size_t)influences;
			out += count;
		}
	}
}

static inline uint32_t weigh(
	const struct fixed_pair *pair, struct fixed_weights weights)
{
	return (uint32_t)(pair->a * weights.a) + (uint32_t)(pair->b * weights.b);
}

static void lerp(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_vector *out)
{
	const uint32_t half = 0x8000;

	for (int i = 0; i < count; i++) {
		out[i] = narrow(half + weigh(&pair[i][0], weights),
			half + weigh(&pair[i][1], weights),
			half + weigh(&pair[i][2], weights));
	}
}

static inline int16_t add_clamped(int16_t a, int16_t b)
{
	int sum = a + b;

	if (sum > INT16_MAX) {
		return INT16_MAX;
	}
	return sum < INT16_MIN ? INT16_MIN : (int16_t)sum;
}

static void increment(
	int count, const struct fixed_vector *step, struct fixed_vector *vector)
{
	for (int i = 0; i < count; i++) {
		vector[i] = (struct fixed_vector){
			add_clamped(vector[i].fraction, step[i].fraction),
			add_clamped(vector[i].x, step[i].x),
			add_clamped(vector[i].y, step[i].y),
			add_clamped(vector[i].z, step[i].z)};
	}
}

/* A number and the fraction below it. */
static inline uint32_t widen(int16_t number, int16_t fraction)
{
	return (uint32_t)(uint16_t)number << 16 | (uint16_t)fraction;
}

static void morph_pair(int count, const struct fixed_vector *base,
	const struct fixed_pair (*pair)[3], struct fixed_weights weights,
	struct fixed_vector *out)
{
	for (int i = 0; i < count; i++) {
		int16_t fraction = base[i].fraction;

		out[i] = narrow(widen(base[i].x, fraction) +
				weigh(&pair[i][0], weights),
			widen(base[i].y, fraction) + weigh(&pair[i][1], weights),
			widen(base[i].z, fraction) + weigh(&pair[i][2], weights));
	}
}

static void morph_begin(
	int count, const struct fixed_vector *base, struct fixed_sum *sum)
{
	for (int i = 0; i < count; i++) {
		int16_t fraction = base[i].fraction;

		sum[i].x = (int32_t)widen(base[i].x, fraction);
		sum[i].y = (int32_t)widen(base[i].y, fraction);
		sum[i].z = (int32_t)widen(base[i].z, fraction);
	}
}

static void morph_add(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_sum *sum)
{
	for (int i = 0; i < count; i++) {
		sum[i].x = (int32_t)((uint32_t)sum[i].x +
			weigh(&pair[i][0], weights));
		sum[i].y = (int32_t)((uint32_t)sum[i].y +
			weigh(&pair[i][1], weights));
		sum[i].z = (int32_t)((uint32_t)sum[i].z +
			weigh(&pair[i][2], weights));
	}
}

static void morph_end(
	int count, const struct fixed_sum *sum, struct fixed_vector *out)
{
	for (int i = 0; i < count; i++) {
		out[i] = narrow((uint32_t)sum[i].x, (uint32_t)sum[i].y,
			(uint32_t)sum[i].z);
	}
}

static inline int16_t move(int16_t rest, int16_t delta, int16_t weight_q16)
{
	return upper(widen(rest, FIXED_HALF) + (uint32_t)(delta * weight_q16));
}

static void rebase(int count, const struct fixed_rebase *rebase,
	const struct fixed_vector *delta, struct fixed_base *base)
{
	for (int i = 0; i < count; i++) {
		const struct fixed_rebase *r = &rebase[i];
		const struct fixed_vector *by = &delta[r->moved];

		base[r->at] = (struct fixed_base){
			move(r->rest.x, by->x, r->weight_q16),
			move(r->rest.y, by->y, r->weight_q16),
			move(r->rest.z, by->z, r->weight_q16), r->rest.w};
	}
}

const struct fixed_loops fixed_loops_c = {
	.skin = skin,
	.lerp = lerp,
	.increment = increment,
	.morph_pair = morph_pair,
	.morph_begin = morph_begin,
	.morph_add = morph_add,
	.morph_end = morph_end,
	.rebase = rebase,
};
