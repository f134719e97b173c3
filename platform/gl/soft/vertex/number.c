/* Tables of number.h, and its functions that are too long to be inline. */
#include "platform/gl/soft/vertex/number.h"

#define EACH_4(f, i) f(i), f((i) + 1), f((i) + 2), f((i) + 3)
#define EACH_16(f, i)                                         \
	EACH_4(f, i), EACH_4(f, (i) + 4), EACH_4(f, (i) + 8), \
		EACH_4(f, (i) + 12)
#define EACH_64(f, i)                                              \
	EACH_16(f, i), EACH_16(f, (i) + 16), EACH_16(f, (i) + 32), \
		EACH_16(f, (i) + 48)
#define RECIPROCAL(i) (1 << 25) / (513 + 2 * (i))

const uint16_t soft_reciprocal_table[256] = {EACH_64(RECIPROCAL, 0),
	EACH_64(RECIPROCAL, 64), EACH_64(RECIPROCAL, 128),
	EACH_64(RECIPROCAL, 192)};

/* clang-format off */
const uint16_t soft_root_table[192] = {
	65281, 64781, 64292, 63814, 63347, 62889, 62442, 62004,
	61575, 61154, 60742, 60339, 59943, 59555, 59175, 58801,
	58435, 58075, 57722, 57376, 57035, 56700, 56372, 56049,
	55731, 55419, 55112, 54810, 54513, 54221, 53933, 53650,
	53371, 53097, 52826, 52560, 52298, 52040, 51785, 51535,
	51288, 51044, 50804, 50567, 50333, 50103, 49876, 49652,
	49430, 49212, 48997, 48784, 48574, 48367, 48163, 47961,
	47761, 47564, 47370, 47178, 46988, 46800, 46615, 46432,
	46251, 46072, 45895, 45720, 45547, 45376, 45207, 45040,
	44875, 44711, 44550, 44390, 44232, 44075, 43920, 43767,
	43615, 43465, 43316, 43169, 43024, 42879, 42737, 42595,
	42456, 42317, 42180, 42044, 41910, 41776, 41644, 41514,
	41384, 41256, 41129, 41003, 40878, 40754, 40631, 40510,
	40390, 40270, 40152, 40035, 39919, 39803, 39689, 39576,
	39464, 39352, 39242, 39133, 39024, 38916, 38810, 38704,
	38599, 38494, 38391, 38289, 38187, 38086, 37986, 37887,
	37788, 37690, 37593, 37497, 37401, 37307, 37213, 37119,
	37027, 36935, 36843, 36753, 36663, 36573, 36485, 36397,
	36309, 36222, 36136, 36051, 35966, 35882, 35798, 35715,
	35632, 35550, 35469, 35388, 35307, 35228, 35148, 35070,
	34991, 34914, 34837, 34760, 34684, 34608, 34533, 34458,
	34384, 34310, 34237, 34164, 34092, 34020, 33949, 33878,
	33807, 33737, 33668, 33599, 33530, 33461, 33393, 33326,
	33259, 33192, 33126, 33060, 32994, 32929, 32864, 32800,
};

/* log2(1 + i / 64) in Q16. */
static const uint32_t log_table[65] = {
	0, 1466, 2909, 4331, 5732, 7112, 8473, 9814,
	11136, 12440, 13727, 14996, 16248, 17484, 18704, 19909,
	21098, 22272, 23433, 24579, 25711, 26830, 27936, 29029,
	30109, 31178, 32234, 33279, 34312, 35334, 36346, 37346,
	38336, 39316, 40286, 41246, 42196, 43137, 44068, 44990,
	45904, 46809, 47705, 48593, 49472, 50344, 51207, 52063,
	52911, 53751, 54584, 55410, 56229, 57040, 57845, 58643,
	59434, 60219, 60997, 61769, 62534, 63294, 64047, 64794,
	65536,
};

/* 2^(i / 64) in Q15. */
static const uint32_t exp_table[65] = {
	32768, 33125, 33486, 33850, 34219, 34591, 34968, 35349,
	35734, 36123, 36516, 36914, 37316, 37722, 38133, 38548,
	38968, 39392, 39821, 40255, 40693, 41136, 41584, 42037,
	42495, 42958, 43425, 43898, 44376, 44859, 45348, 45842,
	46341, 46846, 47356, 47871, 48393, 48920, 49452, 49991,
	50535, 51085, 51642, 52204, 52773, 53347, 53928, 54515,
	55109, 55709, 56316, 56929, 57549, 58176, 58809, 59449,
	60097, 60751, 61413, 62081, 62757, 63441, 64132, 64830,
	65536,
};
/* clang-format on */

struct root soft_reciprocal_root(uint64_t value)
{
	int zeros = LEADING_ZEROS_64(value) & ~1;
	uint32_t v = (uint32_t)(value << zeros >> 32); /* 0.25..1 in Q32 */
	uint32_t r = (uint32_t)soft_root_table[(v >> 24) - 64] << 13; /* Q28 */

	/* r (3 - v r^2) / 2, twice: 7 bits become 14, then 28. */
	for (int i = 0; i < 2; i++) {
		uint32_t squared_q24 = mul_high_unsigned(r, r);
		uint32_t product_q24 = mul_high_unsigned(squared_q24, v);

		r = mul_high_unsigned(r, (3u << 24) - product_q24) << 7;
	}
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
