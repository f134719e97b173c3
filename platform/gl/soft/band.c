#include "platform/gl/soft/band.h"

/* Addresses as numbers: arm/band.S adds them up like all else. */
static uint16_t *at_address(uintptr_t address)
{
	return (uint16_t *)address;
}

static void run_color(const struct band *band, int column, int count)
{
	uintptr_t address = band->row.depth + 2 * (uintptr_t)column;
	uint16_t *depth = at_address(address);
	uint16_t *pixel = at_address(address + 2 + band->pixels);
	uint32_t at = (uint32_t)column;
	uint32_t z = band->row.z_q16 + band->z_right * at;
	uint32_t packed =
		band_pack(band->row.red_blue + band->red_blue_right * at,
			band->row.green_q26 + band->green_right * at);

	for (int i = 0; i < count; i++) {
		if (z < (uint32_t)depth[i] << 16) {
			depth[i] = (uint16_t)(z >> 16);
			pixel[i] = band_unpack(packed);
		}
		z += band->z_right;
		packed += band->packed_right;
	}
}

static void move_down(struct band *band)
{
	band->row.depth += band->down.depth;
	band->row.z_q16 += band->down.z_q16;
	band->row.red_blue += band->down.red_blue;
	band->row.green_q26 += band->down.green_q26;
	band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
	band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	band->pixels += band->pixels_step;
}

void band_color_c(struct band *band)
{
	for (; band->rows > 0; band->rows--) {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		left = left > band->from ? left : band->from;
		right = right < band->to ? right : band->to;
		for (; left < right; left += BAND_RUN) {
			run_color(band, left,
				right - left < BAND_RUN ? right - left
							: BAND_RUN);
		}
		move_down(band);
	}
}
