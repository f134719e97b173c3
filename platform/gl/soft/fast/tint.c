/* The band of four mixed texels under a colour of three channels; see tint.h. */
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

void soft_tint_across(
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
		soft_tint_across(band, at, pair);
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

/* The channels by a colour: 17 bits of fraction. */
static ALWAYS_INLINE void tint(
	struct channels *c, const struct tint_pixel *at, int32_t more)
{
	c->red = (uint32_t)WORD_BY_TOP(c->red, at->red_blue, more);
	c->green = (uint32_t)WORD_BY_BOTTOM(c->green, at->green, more);
	c->blue = (uint32_t)WORD_BY_BOTTOM(c->blue, at->red_blue, more);
}

static ALWAYS_INLINE uint16_t shade(
	struct channels c, const struct tint_pixel *at)
{
	tint(&c, at, 1 << 16);
	return (uint16_t)((c.red & 31 << 17) >> 6 | (c.green & 63 << 17) >> 12 |
		c.blue >> 17);
}

static NEVER_INLINE void draw_row(
	const struct tint_band *band, int column, int count)
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

		if (at.z < there << 16) {
			uintptr_t pixel = (uintptr_t)depth + band->pixels;

			depth[-1] = (uint16_t)(at.z >> 16);
			*(uint16_t *)pixel =
				shade(load_linear(band, at.texel), &at);
		}
		at.z += band->z_right;
		at.texel += band->texel_right;
		at.red_blue += band->red_blue_right;
		at.green += band->green_right;
	} while ((int32_t)at.green >= 0);
}

void soft_band_tint_c(struct tint_band *band)
{
	do {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		if (left < right) {
			draw_row(band, left, right - left);
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
