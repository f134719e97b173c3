#include "platform/gl/soft/tint.h"

#include "platform/gl/soft/pixel.h"

/* A channel's value times 2^18: 6 bits, and 5 and 13 of fraction. */
struct channels {
	uint32_t red, green, blue;
};

static uint32_t load_texel(const struct tint_band *band, uint32_t texel)
{
	uint32_t at = texel & band->texel_mask;
	uint32_t index = (at >> 8 & 255) + (at >> band->texel_shift);

	return load_16(band->texels + 2 * index);
}

/* Two texels by their weights; channel is moved to where it belongs. */
static uint32_t mix_pair(uint32_t left, uint32_t right, uint32_t mask,
	uint32_t weight_left, uint32_t weight_right)
{
	return (left & mask & 0xFFFF) * weight_left +
		(right & mask & 0xFFFF) * weight_right;
}

static struct channels load_linear(const struct tint_band *band, uint32_t at)
{
	uint32_t right = (at & 0xFFFF0000) | ((at + 0x100) & 0xFFFF);
	uint32_t below = 1u << 24;
	uint32_t a = load_texel(band, at), b = load_texel(band, right);
	uint32_t c = load_texel(band, at + below);
	uint32_t d = load_texel(band, right + below);
	uint32_t across = at >> 3 & 31, down = at >> 16 & 255;
	uint32_t c_weight = (32 - across) * down, d_weight = across * down;
	uint32_t a_weight = (32 - across) * 256 - c_weight;
	uint32_t b_weight = across * 256 - d_weight;

	return (struct channels){
		.red = mix_pair(a >> 6, b >> 6, TINT_RED_BLUE, a_weight,
			       b_weight) +
			mix_pair(c >> 6, d >> 6, TINT_RED_BLUE, c_weight,
				d_weight),
		.green = mix_pair(a, b, TINT_GREEN, a_weight, b_weight) +
			mix_pair(c, d, TINT_GREEN, c_weight, d_weight),
		.blue = mix_pair(a << 5, b << 5, TINT_RED_BLUE, a_weight,
				b_weight) +
			mix_pair(c << 5, d << 5, TINT_RED_BLUE, c_weight,
				d_weight),
	};
}

static struct channels load_nearest(const struct tint_band *band, uint32_t at)
{
	uint32_t texel = load_texel(band, at);

	return (struct channels){
		.red = texel >> 11 << 18,
		.green = (texel >> 5 & 63) << 18,
		.blue = (texel & 31) << 18,
	};
}

/* Below 2^24, and 2^15. */
static uint32_t tint(uint32_t channel, uint32_t color)
{
	uint32_t product = (uint32_t)((uint64_t)channel * color >> 16);

	return (product + TINT_ROUND_LINEAR) / (2 * TINT_ROUND_LINEAR);
}

static void run_tint(const struct tint_band *band, int column, int count,
	struct channels (*load)(const struct tint_band *band, uint32_t at))
{
	uintptr_t address = band->row.depth + 2 * (uintptr_t)column;
	uint16_t *depth = (uint16_t *)address;
	uint16_t *pixel = (uint16_t *)(address + 2 + band->pixels);
	uint32_t at = (uint32_t)column;
	uint32_t z = band->row.z_q16 + band->z_right * at;
	uint32_t texel = band->row.texel + band->texel_right * at;
	uint32_t red_blue = band->row.red_blue + band->red_blue_right * at;
	uint32_t green = band->row.green + band->green_right * at;

	for (int i = 0; i < count; i++) {
		if (z < (uint32_t)depth[i] << 16) {
			struct channels c = load(band, texel);

			depth[i] = (uint16_t)(z >> 16);
			pixel[i] = (uint16_t)(tint(c.red, red_blue >> 16) << 11 |
				tint(c.green, green & 0xFFFF) << 5 |
				tint(c.blue, red_blue & 0xFFFF));
		}
		z += band->z_right;
		texel += band->texel_right;
		red_blue += band->red_blue_right;
		green += band->green_right;
	}
}

static ALWAYS_INLINE void walk(struct tint_band *band,
	struct channels (*load)(const struct tint_band *band, uint32_t at))
{
	for (; band->rows > 0; band->rows--) {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		run_tint(band, left, right - left, load);
		band->row.depth += band->down.depth;
		band->row.z_q16 += band->down.z_q16;
		band->row.texel += band->down.texel;
		band->row.red_blue += band->down.red_blue;
		band->row.green += band->down.green;
		band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
		band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	}
}

void tint_linear_c(struct tint_band *band)
{
	walk(band, load_linear);
}

void tint_nearest_c(struct tint_band *band)
{
	walk(band, load_nearest);
}
