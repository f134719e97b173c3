#include "platform/gl/soft/fast/tint.h"

#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/span/halves.h"

/* A texel's channels times 2^18: 5 or 6 bits, and 13 of fraction. */
struct channels {
	uint32_t red, green, blue;
};

/* What moves on with every pixel; green has the pixels that follow above it. */
struct tint_pixel {
	uint32_t z, texel, red_blue, green;
};

static ALWAYS_INLINE const uint8_t *find_texel(
	const struct tint_band *band, uint32_t at)
{
	uint32_t index = (at >> 8 & 255) + (at >> band->texel_shift);

	return band->texels + 2 * index;
}

/* The pairs above and below where one lies across the edge of the level. */
static NEVER_INLINE void load_across(
	const struct tint_band *band, uint32_t at, uint32_t pair[2])
{
	const uint32_t mask = band->texel_mask;
	uint32_t right = (at & 0xFF000000) | ((at + 0x100) & mask & 0xFFFF);
	uint32_t below = (at + 0x1000000) & mask & 0xFF000000;
	uint32_t column = at & 0xFFFF, next = right & 0xFFFF;

	pair[0] = load_16(find_texel(band, at)) |
		(uint32_t)load_16(find_texel(band, right)) << 16;
	pair[1] = load_16(find_texel(band, below | column)) |
		(uint32_t)load_16(find_texel(band, below | next)) << 16;
}

static ALWAYS_INLINE uint32_t mix_pairs(uint32_t above, uint32_t below,
	uint32_t mask, uint32_t above_weights, uint32_t below_weights)
{
	return HALVES_SUM_ADD(below & mask, below_weights,
		HALVES_SUM(above & mask, above_weights));
}

static ALWAYS_INLINE struct channels load_linear(
	const struct tint_band *band, uint32_t texel)
{
	uint32_t at = texel & band->texel_mask, beyond = at + TINT_NEXT;
	uint32_t right = texel >> 3 & 31;
	uint32_t across = (right << 16) - right + 32;
	uint32_t below = across * (texel >> 16 & 255);
	uint32_t above = (across << 8) - below;
	uint32_t pair[2], a, b;

	if (beyond < at || (beyond & ~band->texel_mask)) {
		load_across(band, at, pair);
		a = pair[0];
		b = pair[1];
	} else {
		const uint8_t *from = find_texel(band, at);

		a = load_32(from);
		b = load_32(from + band->stride_bytes);
	}
	return (struct channels){
		.red = mix_pairs(a >> 6, b >> 6, TINT_RED_BLUE, above, below),
		.green = mix_pairs(a, b, TINT_GREEN, above, below),
		.blue = mix_pairs(a << 5, b << 5, TINT_RED_BLUE, above, below),
	};
}

static ALWAYS_INLINE struct channels load_nearest(
	const struct tint_band *band, uint32_t texel)
{
	uint32_t own = load_16(find_texel(band, texel & band->texel_mask));

	return (struct channels){
		.red = own >> 11 << 18,
		.green = (own >> 5 & 63) << 18,
		.blue = (own & 31) << 18,
	};
}

/* The channels by a colour: 17 bits of fraction. */
static ALWAYS_INLINE void tint(
	struct channels *c, const struct tint_pixel *at, int32_t more)
{
	c->red = (uint32_t)WORD_BY_TOP(c->red, at->red_blue, more);
	c->green = (uint32_t)WORD_BY_BOTTOM(c->green, at->green, more);
	c->blue = (uint32_t)WORD_BY_BOTTOM(c->blue, at->red_blue, more);
}

static ALWAYS_INLINE uint32_t limit(int32_t value, int32_t most)
{
	return (uint32_t)(value < 0 ? 0 : value > most ? most : value);
}

static ALWAYS_INLINE uint16_t pack(uint32_t red, uint32_t green, uint32_t blue)
{
	return (uint16_t)(red << 11 | green << 5 | blue);
}

/* What a pixel becomes: the texel's channels, their colours, what it was. */
typedef uint16_t (*finish_function)(
	struct channels c, const struct tint_pixel *at, uint16_t old);

static ALWAYS_INLINE uint16_t replace(
	struct channels c, const struct tint_pixel *at, uint16_t old)
{
	(void)old;
	tint(&c, at, 1 << 16);
	return (uint16_t)((c.red & 31 << 17) >> 6 | (c.green & 63 << 17) >> 12 |
		c.blue >> 17);
}

static ALWAYS_INLINE uint16_t add(
	struct channels c, const struct tint_pixel *at, uint16_t old)
{
	tint(&c, at, 1 << 16);
	c.red += (uint32_t)(old >> 11) << 17;
	c.green += (uint32_t)(old >> 5 & 63) << 17;
	c.blue += (uint32_t)(old & 31) << 17;
	return pack(limit((int32_t)c.red >> 17, 31),
		limit((int32_t)c.green >> 17, 63),
		limit((int32_t)c.blue >> 17, 31));
}

/* By 31 or 63 parts, which go on in 1023 and 4095. */
static ALWAYS_INLINE uint32_t multiply_channel(
	uint32_t value, uint32_t part, int bits)
{
	return (uint32_t)WORD_BY_BOTTOM(
		       value, part << bits | part, 1 << 2 * bits) >>
		(2 * bits + 1);
}

static ALWAYS_INLINE uint16_t multiply(
	struct channels c, const struct tint_pixel *at, uint16_t old)
{
	tint(&c, at, 0);
	return pack(multiply_channel(c.red, old >> 11, 5),
		multiply_channel(c.green, old >> 5 & 63, 6),
		multiply_channel(c.blue, old & 31, 5));
}

/*
 * (2 texel - 1) (color - 1/2), as a gray. Red and blue to 63 parts, half as
 * large as green's: 31 by 65 / 64.
 */
static ALWAYS_INLINE uint16_t dot(
	struct channels c, const struct tint_pixel *at, uint16_t old)
{
	uint32_t red = c.red + (c.red >> 6) - (63 << 16);
	uint32_t green = c.green - (63 << 17);
	uint32_t blue = c.blue + (c.blue >> 6) - (63 << 16);
	int32_t sum = WORD_BY_BOTTOM(blue, at->red_blue,
		WORD_BY_TOP(red, at->red_blue,
			-((int32_t)red >> 2) - ((int32_t)blue >> 2)));
	uint32_t five;

	(void)old;
	sum = 2 * sum + WORD_BY_BOTTOM(green, at->green, -((int32_t)green >> 2));
	five = limit((sum - (sum >> 6) + (1 << 15)) >> 16, 31);
	return pack(five, limit((sum + (1 << 14)) >> 15, 63), five);
}

/* How a band looks at its pixels. */
struct look {
	struct channels (*load)(const struct tint_band *band, uint32_t texel);
	finish_function finish;
	bool equal; /* the depth has to be, and stays; the picture is read */
};

static ALWAYS_INLINE void draw_row(const struct tint_band *band, int column,
	int count, const struct look *look)
{
	const struct tint_row *row = &band->row;
	const uint32_t n = (uint32_t)column;
	uint16_t *depth = (uint16_t *)(row->depth + 2 * (uintptr_t)column);
	struct tint_pixel at = {
		.z = row->z_q16 + band->z_right * n,
		.texel = row->texel + band->texel_right * n,
		.red_blue = row->red_blue + band->red_blue_right * n,
		.green = ((row->green + band->green_right * n) & 0xFFFF) +
			((uint32_t)(count - 1) << 16),
	};

	do {
		uint32_t there = *depth++;

		if (look->equal ? at.z >> 16 == there : at.z < there << 16) {
			uintptr_t pixel = (uintptr_t)depth + band->pixels;
			uint16_t old = 0;

			if (look->equal) {
				old = *(uint16_t *)pixel;
			} else {
				depth[-1] = (uint16_t)(at.z >> 16);
			}
			*(uint16_t *)pixel = look->finish(
				look->load(band, at.texel), &at, old);
		}
		at.z += band->z_right;
		at.texel += band->texel_right;
		at.red_blue += band->red_blue_right;
		at.green += band->green_right;
	} while ((int32_t)at.green >= 0);
}

/* Rows of a band: row, which is out of line, draws one of them. */
static ALWAYS_INLINE void walk(struct tint_band *band,
	void (*row)(const struct tint_band *band, int column, int count))
{
	do {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		if (left < right) {
			row(band, left, right - left);
		}
		band->row.depth += band->down.depth;
		band->row.z_q16 += band->down.z_q16;
		band->row.texel += band->down.texel;
		band->row.red_blue += band->down.red_blue;
		band->row.green += band->down.green;
		band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
		band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	} while (--band->rows > 0);
}

#define TINT_ROWS(name, load, finish, equal)                         \
	static NEVER_INLINE void row_##name(                         \
		const struct tint_band *band, int column, int count) \
	{                                                            \
		draw_row(band, column, count,                        \
			&(const struct look){load, finish, equal});  \
	}                                                            \
                                                                     \
	void soft_tint_##name(struct tint_band *band)                \
	{                                                            \
		walk(band, row_##name);                              \
	}

TINT_ROWS(linear, load_linear, replace, false)
TINT_ROWS(nearest, load_nearest, replace, false)
TINT_ROWS(dot, load_linear, dot, false)
TINT_ROWS(multiply, load_linear, multiply, true)
TINT_ROWS(add, load_linear, add, true)
