/* What arm/ has in assembly, for other processors. */
#include "platform/gl/soft/fast/narrow.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/vertex/cache.h"

void soft_fill_pixels(uint16_t *at, int count, uint16_t value)
{
	const uint32_t pair = value * 0x10001u;

	for (; count >= 8; count -= 8, at += 8) {
		memcpy(at, &pair, 4);
		memcpy(at + 2, &pair, 4);
		memcpy(at + 4, &pair, 4);
		memcpy(at + 6, &pair, 4);
	}
	for (; count > 0; count--) {
		*at++ = value;
	}
}

uint32_t soft_largest_aligned_float(
	const uint8_t *at, int stride_bytes, uint32_t count)
{
	return soft_largest_float(at, stride_bytes, count, 3);
}

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	soft_transform_c(draw, index, out);
}

void soft_list(struct draw *draw, const struct source *source)
{
	for (uint32_t i = 0; i + 2 < source->count; i += 3) {
		soft_draw_triangle(draw, source, i, i + 1, i + 2);
	}
}

void soft_narrow_rows(struct narrow *narrow)
{
	soft_narrow_rows_c(narrow);
}

void soft_band_gray(void *band)
{
	soft_band_gray_c(band);
}

void soft_band_tint(void *band)
{
	soft_band_tint_c(band);
}

void soft_tile_row(const struct tile_run *run, int by_fine)
{
	soft_tile_row_c(run, by_fine);
}
