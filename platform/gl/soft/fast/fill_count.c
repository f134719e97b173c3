/*
 * Triangles of any size that count in the stencil, where they are hidden or
 * where they are seen: the hulls of volumes. See count.h.
 */
#include "platform/gl/soft/fast/count.h"
#include "platform/gl/soft/raster/raster.h"

static bool is_down(const struct stencil *stencil)
{
	return stencil->pass == GL_DECR || stencil->depth_fail == GL_DECR;
}

static void draw_band(void *band)
{
	soft_count_band(band);
}

void soft_fill_count(struct draw *draw, struct setup *setup)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct plane *z = &draw->raster.plane[DEPTH];
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	int top = raster_first_row(draw, setup);
	size_t first = (size_t)top * (size_t)buffers->width;
	struct count_band band;

	soft_raster_set_up(draw, setup);
	band = (struct count_band){
		.depth = buffers->depth + first,
		.stencil = buffers->stencil + first,
		.z = z->start + (uint32_t)z->dy * (uint32_t)(top - setup->top),
		.z_right = (uint32_t)z->dx,
		.z_down = (uint32_t)z->dy,
		.width = buffers->width,
		.from = draw->box.left,
		.to = draw->box.right,
		.kind = (uint8_t)((is_down(stencil) ? COUNT_DOWN : 0) +
			(stencil->pass != GL_KEEP ? COUNT_PASSED : 0)),
	};
	raster_draw_bands(draw, setup, setup->middle_left,
		&(struct band_ends){band.edge, band.edge_step, &band.rows},
		draw_band, &band);
}

static ALWAYS_INLINE void count_row(const struct count_band *band, int left,
	int right, bool down, bool passed)
{
	const uint16_t *depth = band->depth + left;
	uint8_t *stencil = band->stencil + left;
	uint32_t z_right = band->z_right;
	uint32_t z = band->z + z_right * (uint32_t)left;

	for (const uint16_t *end = band->depth + right; depth < end; depth++) {
		if ((z >> 10 < *depth) == passed) {
			int count = *stencil;

			*stencil = (uint8_t)(down ? count - (count > 0)
						  : count + (count < 255));
		}
		stencil++;
		z += z_right;
	}
}

static ALWAYS_INLINE void count_rows(
	struct count_band *band, bool down, bool passed)
{
	for (; band->rows > 0; band->rows--) {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		count_row(band, left > band->from ? left : band->from,
			right < band->to ? right : band->to, down, passed);
		band->depth += band->width;
		band->stencil += band->width;
		band->z += band->z_down;
		band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
		band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	}
}

void soft_count_band(struct count_band *band)
{
	bool passed = band->kind & COUNT_PASSED;

	if (band->kind & COUNT_DOWN) {
		if (passed) {
			count_rows(band, true, true);
		} else {
			count_rows(band, true, false);
		}
	} else if (passed) {
		count_rows(band, false, true);
	} else {
		count_rows(band, false, false);
	}
}
