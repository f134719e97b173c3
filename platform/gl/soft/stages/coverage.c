/*
 * The coverage of pixels by smooth points and lines, which multiplies fragments'
 * alpha (GL ES 1.1 sections 3.3.1, 3.4.2 and 3.9). It is linear in the distance of
 * the pixel's centre from the edge, from 1/2 pixel outside to 1/2 inside.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/number.h"

/* Coverage, of 256, between two edges half_q8 from the middle; thin ones less. */
static int32_t find_share(int32_t half_q8, int32_t from_middle_q8)
{
	return clamp_int(half_q8 + 128 - from_middle_q8, 0,
		half_q8 < 128 ? 2 * half_q8 : 256);
}

/* Coverage, of 256, of a pixel whose centre is (x, y) / 16 from the middle. */
static int32_t find_coverage(
	const struct soft_coverage *coverage, int32_t x, int32_t y)
{
	int32_t along, across;

	if (coverage->radius_q8 > 0) {
		uint64_t squared = (uint64_t)((int64_t)x * x + (int64_t)y * y);
		struct root root = soft_reciprocal_root(squared | 1);

		along = (int32_t)(squared * (uint64_t)root.mantissa_q30 >>
			(26 + root.shift));
		return find_share(coverage->radius_q8, along);
	}
	along = (int32_t)(((int64_t)x * coverage->u_q14 +
				  (int64_t)y * coverage->v_q14) >>
		10);
	across = (int32_t)(((int64_t)x * coverage->v_q14 -
				   (int64_t)y * coverage->u_q14) >>
		10);
	return find_share(coverage->half_length_q8, (int32_t)raster_size(along)) *
		find_share(coverage->half_width_q8,
			(int32_t)raster_size(across)) >>
		8;
}

uint32_t soft_cover(
	const struct draw *draw, struct soft_row *run, uint32_t *color)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_coverage *coverage = &spans->coverage;
	const struct buffers *buffers = &draw->soft->buffers;
	const int32_t place = (int32_t)(run->depth - buffers->depth);
	const int32_t row = place / buffers->width;
	const int32_t column = place - row * buffers->width;
	int32_t x = column * 16 + 8 - coverage->x;
	uint32_t first = run->count, end = 0;

	for (uint32_t i = 0; i < run->count; i++, x += 16) {
		uint32_t share = (uint32_t)find_coverage(
			coverage, x, row * 16 + 8 - coverage->y);

		if (share > 0) {
			first = i < first ? i : first;
			end = i + 1;
		}
		color[i] = (color[i] & 0x00FFFFFF) |
			((color[i] >> 24) * share + 128) >> 8 << 24;
	}
	run->depth += first;
	run->pixel += first << spans->pixel_log2;
	run->z += spans->run.z_right * first;
	run->count = end > first ? end - first : 0;
	return first;
}
