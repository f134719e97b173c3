/* The band with a texture in C, which arm/texture.S draws with the same bytes. */
#include "platform/gl/soft/fast/band.h"

#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"

enum {
	/* So many pixels the share runs before it is taken afresh. */
	SHARE_RUN = 16,
};

/* Addresses as numbers: arm/texture.S adds them up like all else. */
static uint16_t *at_address(uintptr_t address)
{
	return (uint16_t *)address;
}

static uint16_t shade_texel(
	const struct texture_band *band, uint32_t texel, uint32_t share)
{
	uint32_t at = texel & band->texel_mask;
	uint32_t index = (at >> 8 & 255) + (at >> band->texel_shift);
	uint32_t wide = widen(load_16(band->texels + 2 * index));

	return narrow((wide * share + WIDE_ROUND) >> 5 & WIDE_MASK);
}

static void run_texture(const struct texture_band *band, int column, int count)
{
	uintptr_t address = band->row.depth + 2 * (uintptr_t)column;
	uint16_t *depth = at_address(address);
	uint16_t *pixel = at_address(address + 2 + band->pixels);
	uint32_t at = (uint32_t)column;
	uint32_t z = band->row.z_q16 + band->z_right * at;
	uint32_t texel = band->row.texel + band->texel_right * at;
	uint32_t share = (band->row.share_q26 + band->share_right * at) >> 16;

	for (int i = 0; i < count; i++) {
		if (z < (uint32_t)depth[i] << 16) {
			depth[i] = (uint16_t)(z >> 16);
			pixel[i] = shade_texel(
				band, texel, (share & 0xFFFF) >> 10);
		}
		z += band->z_right;
		texel += band->texel_right;
		share += band->share_right >> 16;
	}
}

void soft_band_texture_c(struct texture_band *band)
{
	for (; band->rows > 0; band->rows--) {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		for (; left < right; left += SHARE_RUN) {
			run_texture(band, left,
				right - left < SHARE_RUN ? right - left
							 : SHARE_RUN);
		}
		band->row.depth += band->down.depth;
		band->row.z_q16 += band->down.z_q16;
		band->row.texel += band->down.texel;
		band->row.share_q26 += band->down.share_q26;
		band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
		band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	}
}
