/* Tables of number.h, and its functions that are too long to be inline. */
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

#define EACH_4(f, i) f(i), f((i) + 1), f((i) + 2), f((i) + 3)
#define EACH_16(f, i)                                         \
	EACH_4(f, i), EACH_4(f, (i) + 4), EACH_4(f, (i) + 8), \
		EACH_4(f, (i) + 12)
#define EACH_64(f, i)                                              \
	EACH_16(f, i), EACH_16(f, (i) + 16), EACH_16(f, (i) + 32), \
		EACH_16(f, (i) + 48)
#define RECIPROCAL(i)      (1 << 25) / (513 + 2 * (i))
/* sqrt(v) of 0.25..1, by Newton's method */
#define ROOT_STEP(v, root) (((root) + (v) / (root)) / 2)
#define ROOT(v)            ROOT_STEP(v, ROOT_STEP(v, ROOT_STEP(v, ((v) + 0.5) / 1.5)))
#define INVERSE_ROOT(i)    (uint16_t)(32768 / ROOT((64.5 + (i)) / 256) + 0.5)
/* log2(1 + i / 64), by the series of atanh(z) for z = i / (128 + i) */
#define LOG_SERIES(w) \
	(1 + (w) * (1 / 3. + (w) * (1 / 5. + (w) * (1 / 7. + (w) * (1 / 9. + (w) / 11)))))
#define LOG_OF(z)               (2 / 0.69314718056 * (z)*LOG_SERIES((z) * (z)))
#define LOG(i)                  (uint32_t)(65536 * LOG_OF((i) / (128. + (i))) + 0.5)
/* 2^(i / 64): 2^(1/2) if bit 5 of i is set, times 2^(1/4) if bit 4 is, ... */
#define POWER_BIT(i, bit, root) ((i) >> (bit)&1 ? (root) : 1)
#define POWER(i)                                         \
	(uint32_t)(32768 * POWER_BIT(i, 6, 2.0) *        \
			POWER_BIT(i, 5, 1.41421356237) * \
			POWER_BIT(i, 4, 1.18920711500) * \
			POWER_BIT(i, 3, 1.09050773267) * \
			POWER_BIT(i, 2, 1.04427378243) * \
			POWER_BIT(i, 1, 1.02189714865) * \
			POWER_BIT(i, 0, 1.01088928605) + \
		0.5)

const uint16_t soft_reciprocal_table[256] = {EACH_64(RECIPROCAL, 0),
	EACH_64(RECIPROCAL, 64), EACH_64(RECIPROCAL, 128),
	EACH_64(RECIPROCAL, 192)};

const uint16_t soft_root_table[192] = {EACH_64(INVERSE_ROOT, 0),
	EACH_64(INVERSE_ROOT, 64), EACH_64(INVERSE_ROOT, 128)};

/* log2(1 + i / 64) in Q16, and 2^(i / 64) in Q15 */
static const uint32_t log_table[65] = {EACH_64(LOG, 0), LOG(64)};
static const uint32_t exp_table[65] = {EACH_64(POWER, 0), POWER(64)};

struct root soft_reciprocal_root(uint64_t value)
{
	int zeros = LEADING_ZEROS_64(value) & ~1;
	uint32_t r = reciprocal_root((uint32_t)(value << zeros >> 32));

	return (struct root){
		.mantissa_q30 = (int32_t)(r << 1),
		.shift = 31 - zeros / 2,
	};
}

/* log2 of a number above 0 in Q28; the result is Q16 and may be negative. */
static int32_t log2_q16(uint32_t value_q28)
{
	int zeros = LEADING_ZEROS_32(value_q28);
	uint32_t v = value_q28 << zeros;
	uint32_t i = v >> 25 & 63, part = v >> 9 & 0xFFFF;
	uint32_t fraction =
		log_table[i] + ((log_table[i + 1] - log_table[i]) * part >> 16);

	return (3 - zeros) * 65536 + (int32_t)fraction;
}

int32_t soft_power_q28(int32_t base_q28, int32_t exponent_q16)
{
	int64_t exponent;
	int32_t e;
	uint32_t i, part, mantissa;

	if (exponent_q16 <= 0 || base_q28 >= 1 << 28) {
		return 1 << 28;
	}
	if (base_q28 <= 0) {
		return 0;
	}
	exponent = (int64_t)log2_q16((uint32_t)base_q28) * exponent_q16 >> 16;
	if (exponent < -28 * 65536) {
		return 0;
	}
	e = (int32_t)exponent;
	i = (uint32_t)e >> 10 & 63;
	part = (uint32_t)e & 1023;
	mantissa =
		exp_table[i] * 1024 + (exp_table[i + 1] - exp_table[i]) * part;
	/* Q25 in 1..2; e >> 16 is -28..0. */
	return (int32_t)(mantissa << 3 >> -(e >> 16));
}

int32_t soft_slope_q16(int32_t dx, int32_t dy)
{
	int zeros = LEADING_ZEROS_32((uint32_t)dy);

	/* the product is below 2^49 */
	return saturate_64((int64_t)dx * reciprocal((uint32_t)dy << zeros) >>
		(46 - zeros));
}

uint32_t soft_largest_float(
	const uint8_t *at, int stride_bytes, uint32_t count, int size)
{
	uint32_t most = 0, bits;

	for (; count > 0; count--, at += stride_bytes) {
		for (int i = 0; i < size; i++) {
			memcpy(&bits, at + 4 * i, sizeof(bits));
			most = bits << 1 > most ? bits << 1 : most;
		}
	}
	return most;
}
