/*
 * The fixed-point loops in portable C.
 */
#include "app/anim/kernel/fixed.h"

#include <string.h>

enum {
	INFLUENCES_MAX = 8,
	CHUNK = 64
};

/*
 * The dot product of length numbers. Like SMLAD it wraps if the sum does not
 * fit. If length is a constant multiple of 8, the compiler makes pmaddwd of
 * this loop. The pragma keeps GCC from unrolling the whole loop, which would
 * prevent this.
 */
static inline uint32_t dot(int length, const int16_t *row, const int16_t *base)
{
	uint32_t sum = 0;

#pragma GCC unroll 4
	for (int i = 0; i < length; i++) {
		sum += (uint32_t)(row[i] * base[i]);
	}
	return sum;
}

/*
 * Stores the upper halves of three sums, and the lower half of x as fraction.
 * Vectors are always loaded and stored as two words.
 */
static inline void narrow(
	uint32_t x, uint32_t y, uint32_t z, struct fixed_vector *out)
{
	const uint32_t words[2] = {x, y >> 16 | (z & 0xffff0000)};

	_Static_assert(sizeof(words) == sizeof(*out), "a vector is two words");
	memcpy(out, words, sizeof(words));
}

/*
 * The matrices of a run: the x rows of all matrices, then all y rows and all z
 * rows. An odd number of matrices is made even by zeros: loops take two
 * influences at a time, and the next vertex's base vector, which they load
 * then, counts nothing.
 */
struct rows {
	int16_t row[3][4 * INFLUENCES_MAX];
};

static inline void skin_run(int length, int count, int stride,
	const int16_t *base, const struct rows *rows, struct fixed_vector *out)
{
	for (int v = 0; v < count; v++, base += stride) {
		narrow(dot(length, rows->row[0], base),
			dot(length, rows->row[1], base),
			dot(length, rows->row[2], base), &out[v]);
	}
}

/* Makes a loop for each length, as a constant in a call of skin_run(). */
static void skin_run_of(int influences, int count, const struct fixed_base *from,
	const struct rows *rows, struct fixed_vector *out)
{
	const int16_t *base = (const int16_t *)from;
	int stride = 4 * influences;

	switch ((influences + 1) / 2) {
	case 1:
		skin_run(8, count, stride, base, rows, out);
		break;
	case 2:
		skin_run(16, count, stride, base, rows, out);
		break;
	case 3:
		skin_run(24, count, stride, base, rows, out);
		break;
	default:
		skin_run(32, count, stride, base, rows, out);
		break;
	}
}

static const int32_t *gather_rows(int influences, const int32_t *joint,
	const struct fixed_matrix *palette, struct rows *out)
{
	*out = (struct rows){{{0}}};
	for (int i = 0; i < influences; i++) {
		const struct fixed_matrix *matrix =
			(const struct fixed_matrix *)((const char *)palette +
				*joint++);

		for (int row = 0; row < 3; row++) {
			memcpy(&out->row[row][4 * i], matrix->row[row],
				sizeof(matrix->row[row]));
		}
	}
	return joint;
}

static void skin(const struct fixed_group *group, int group_count,
	const struct fixed_base *base, const struct fixed_matrix *palette,
	struct fixed_vector *out)
{
	for (int g = 0; g < group_count; g++) {
		const int32_t *run = group[g].run;
		int influences = group[g].influences;

		for (int r = 0; r < group[g].run_count; r++) {
			struct rows rows;
			int count = *run++;

			run = gather_rows(influences, run, palette, &rows);
			skin_run_of(influences, count, base, &rows, out);
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

/* A loop without stores of vectors, which compilers can vectorise. */
static void weigh_pairs(int count, const struct fixed_pair *pair,
	struct fixed_weights weights, uint32_t start, uint32_t *sum)
{
	for (int i = 0; i < count; i++) {
		sum[i] = start + weigh(&pair[i], weights);
	}
}

static void lerp(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_vector *out)
{
	const uint32_t half = 0x8000;

	for (int first = 0; first < count; first += CHUNK) {
		uint32_t sum[CHUNK][3];
		int left = count - first < CHUNK ? count - first : CHUNK;

		weigh_pairs(3 * left, pair[first], weights, half, sum[0]);
		for (int i = 0; i < left; i++) {
			narrow(sum[i][0], sum[i][1], sum[i][2], &out[first + i]);
		}
	}
}

/* A loop over coordinates, not vertices, which compilers can vectorise. */
static void weigh_keys(int count, const int16_t *source, const int16_t *destiny,
	struct fixed_weights weights, uint32_t start, uint32_t *sum)
{
	for (int i = 0; i < count; i++) {
		sum[i] = start + (uint32_t)(source[i] * weights.a) +
			(uint32_t)(destiny[i] * weights.b);
	}
}

static void lerp_keys(int count, const struct fixed_key *source,
	const struct fixed_key *destiny, struct fixed_weights weights,
	struct fixed_vector *out)
{
	const uint32_t half = 0x8000;

	for (int first = 0; first < count; first += CHUNK) {
		uint32_t sum[CHUNK][3];
		int left = count - first < CHUNK ? count - first : CHUNK;

		weigh_keys(3 * left, &source[first].x, &destiny[first].x,
			weights, half, &sum[0][0]);
		for (int i = 0; i < left; i++) {
			narrow(sum[i][0], sum[i][1], sum[i][2], &out[first + i]);
		}
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
	const int16_t *by = (const int16_t *)step;
	int16_t *to = (int16_t *)vector;

	for (int i = 0; i < 4 * count; i++) {
		to[i] = add_clamped(to[i], by[i]);
	}
}

/* Returns number * 2^16 + fraction. */
static inline uint32_t widen(int16_t number, int16_t fraction)
{
	return (uint32_t)(uint16_t)number << 16 | (uint16_t)fraction;
}

/* The inverse of narrow(). All three sums get the fraction of x. */
static inline void widen_all(const struct fixed_vector *vector, uint32_t out[3])
{
	uint32_t words[2];

	memcpy(words, vector, sizeof(words));
	out[0] = words[0];
	out[1] = words[1] << 16 | (words[0] & 0xffff);
	out[2] = (words[1] & 0xffff0000) | (words[0] & 0xffff);
}

static void morph_pair(int count, const struct fixed_vector *base,
	const struct fixed_pair (*pair)[3], struct fixed_weights weights,
	struct fixed_vector *out)
{
	for (int first = 0; first < count; first += CHUNK) {
		uint32_t sum[CHUNK][3];
		int left = count - first < CHUNK ? count - first : CHUNK;

		weigh_pairs(3 * left, pair[first], weights, 0, sum[0]);
		for (int i = 0; i < left; i++) {
			uint32_t from[3];

			widen_all(&base[first + i], from);
			narrow(sum[i][0] + from[0], sum[i][1] + from[1],
				sum[i][2] + from[2], &out[first + i]);
		}
	}
}

static void morph_begin(
	int count, const struct fixed_vector *base, struct fixed_sum *sum)
{
	for (int i = 0; i < count; i++) {
		uint32_t from[3];

		widen_all(&base[i], from);
		memcpy(&sum[i], from, sizeof(from));
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
		narrow((uint32_t)sum[i].x, (uint32_t)sum[i].y,
			(uint32_t)sum[i].z, &out[i]);
	}
}

static inline int16_t move(int16_t rest, int16_t delta, int16_t weight_q16)
{
	uint32_t sum = widen(rest, FIXED_HALF) + (uint32_t)(delta * weight_q16);

	return (int16_t)(sum >> 16);
}

static void rebase(int count, const struct fixed_rebase *rebase,
	const struct fixed_vector *delta, struct fixed_base *base)
{
	for (int i = 0; i < count; i++) {
		const struct fixed_rebase *r = &rebase[i];
		const struct fixed_vector *by = &delta[r->delta_index];

		base[r->base_index] = (struct fixed_base){
			move(r->rest.x, by->x, r->weight_q16),
			move(r->rest.y, by->y, r->weight_q16),
			move(r->rest.z, by->z, r->weight_q16), r->rest.w};
	}
}

const struct fixed_loops fixed_loops_c = {
	.skin = skin,
	.lerp = lerp,
	.lerp_keys = lerp_keys,
	.increment = increment,
	.morph_pair = morph_pair,
	.morph_begin = morph_begin,
	.morph_add = morph_add,
	.morph_end = morph_end,
	.rebase = rebase,
};
