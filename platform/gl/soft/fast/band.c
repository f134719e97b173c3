/* Bands with a texture in C; arm/texture.S and arm/tint.S do the same. */
#include "platform/gl/soft/fast/band.h"

#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/span/sample.h"

/* A pixel's values, those of green in the lower half alone. */
struct band_pixel {
	uint32_t z, texel, red_blue, green;
};

/* Addresses are integers here, because the assembly adds them up so, too. */
static ALWAYS_INLINE uint16_t *find_depth(const struct band *band, int column)
{
	return (uint16_t *)(band->row.depth + 2 * (uintptr_t)column);
}

static ALWAYS_INLINE void write_pixel(
	const struct band *band, uint16_t *depth, uint32_t z, uint16_t pixel)
{
	*depth = (uint16_t)(z >> 16);
	*(uint16_t *)((uintptr_t)(depth + 1) + band->pixels) = pixel;
}

static ALWAYS_INLINE const uint8_t *find_texel(
	const struct band *band, uint32_t at)
{
	uint32_t index = (at >> 8 & 255) + (at >> band->texel_shift);

	return band->texels + 2 * index;
}

static uint16_t shade_gray(const struct band *band, const struct band_pixel *at)
{
	uint32_t wide =
		widen(load_16(find_texel(band, at->texel & band->texel_mask)));

	return narrow(
		(wide * (at->red_blue >> 26) + WIDE_ROUND) >> 5 & WIDE_MASK);
}

/* A filtered texel's channels of 5 or 6 bits, times 2^18 = 32 * 8192. */
struct channels {
	uint32_t red, green, blue;
};

void soft_tint_across(const struct band *band, uint32_t at, uint32_t pair[2])
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

static ALWAYS_INLINE struct channels load_linear(
	const struct band *band, uint32_t texel)
{
	const struct soft_weights weights = soft_weigh(texel >> 3, texel >> 16);
	uint32_t at = texel & band->texel_mask, beyond = at + TINT_NEXT;
	uint32_t pair[2];

	if (beyond < at || (beyond & ~band->texel_mask)) {
		soft_tint_across(band, at, pair);
	} else {
		const uint8_t *from = find_texel(band, at);

		pair[0] = load_32(from);
		pair[1] = load_32(from + band->stride_bytes);
	}
	return (struct channels){
		.red = soft_mix_masked(
			pair[0] >> 6, pair[1] >> 6, TINT_RED_BLUE, weights),
		.green = soft_mix_masked(pair[0], pair[1], TINT_GREEN, weights),
		.blue = soft_mix_masked(
			pair[0] << 5, pair[1] << 5, TINT_RED_BLUE, weights),
	};
}

/* Channels times the colour plus more, with 17 fraction bits, as RGB565. */
static ALWAYS_INLINE uint16_t shade_tinted(
	const struct band *band, const struct band_pixel *at)
{
	const struct channels c = load_linear(band, at->texel);
	const int32_t red =
		WORD_BY_TOP(c.red, at->red_blue, (int32_t)band->more.red);
	const int32_t green =
		WORD_BY_BOTTOM(c.green, at->green, (int32_t)band->more.green);
	const int32_t blue =
		WORD_BY_BOTTOM(c.blue, at->red_blue, (int32_t)band->more.blue);

	return (uint16_t)(LIMIT_SHIFTED(red, 17, 5) << 11 |
		LIMIT_SHIFTED(green, 17, 6) << 5 | LIMIT_SHIFTED(blue, 17, 5));
}

static ALWAYS_INLINE void draw_row(
	const struct band *band, int column, int count, bool tinted, bool equal)
{
	const struct band_row *row = &band->row;
	const uint32_t n = (uint32_t)column;
	/* a gray has its fraction in the upper half alone */
	const uint32_t mask = tinted ? UINT32_MAX : 0xFFFF0000;
	uint16_t *depth = find_depth(band, column);
	struct band_pixel at = {row->z_q16 + band->z_right * n,
		row->texel + band->texel_right * n,
		(row->red_blue + band->red_blue_right * n) & mask,
		row->green + band->green_right * n};

	for (; count > 0; count--, depth++) {
		if (at.z >> 16 < (uint32_t)*depth + equal) {
			write_pixel(band, depth, at.z,
				tinted ? shade_tinted(band, &at)
				       : shade_gray(band, &at));
		}
		at.z += band->z_right;
		at.texel += band->texel_right;
		at.red_blue += band->red_blue_right & mask;
		at.green += band->green_right;
	}
}

static ALWAYS_INLINE void draw_rows(struct band *band, bool tinted, bool equal)
{
	const struct band_row *down = &band->down;
	struct band_row *row = &band->row;

	for (; band->edges.rows > 0; band_next_row(&band->edges)) {
		int left = band_column(&band->edges, BAND_LEFT);
		int right = band_column(&band->edges, BAND_RIGHT);

		draw_row(band, left, right - left, tinted, equal);
		row->depth += down->depth;
		row->z_q16 += down->z_q16;
		row->texel += down->texel;
		row->red_blue += down->red_blue;
		row->green += down->green;
	}
}

void soft_band_gray_c(struct band *band, bool equal)
{
	draw_rows(band, false, equal);
}

void soft_band_tint_c(struct band *band, bool equal)
{
	draw_rows(band, true, equal);
}
