/*
 * The coverage of pixels by smooth points and lines, which multiplies fragments'
 * alpha (GL ES 1.1 sections 3.3.1, 3.4.2 and 3.9). It is linear in the distance of
 * the pixel's centre from the edge, from 1/2 pixel outside to 1/2 inside.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/number.h"

/* Coverage, of 256, between two edges half_q8 from the middle; thin ones less. */
static ALWAYS_INLINE int32_t find_share(int32_t half_q8, int32_t from_middle_q8)
{
	return clamp_int(half_q8 + 128 - from_middle_q8, 0,
		half_q8 < 128 ? 2 * half_q8 : 256);
}

/* The fragments of a row that are seen: from first to before end. */
struct covered {
	uint32_t first, end;
};

/* A row's pixel: its centre, in sixteenths from the middle; for lines, turned. */
struct place {
	int32_t x, y;
	uint32_t along, across; /* 2^18 a pixel */
};

/* Coverage, of 256, by a disk. A root is needed only where its edge is near. */
static ALWAYS_INLINE int32_t cover_disk(
	const struct soft_coverage *coverage, int32_t x, int32_t y)
{
	const int32_t squared = x * x + y * y;
	/* sixteenths; half a pixel from the edge, and what a root may be off by */
	const int32_t inner = (coverage->radius_q8 - 130) >> 4;
	const int32_t outer = (coverage->radius_q8 + 145) >> 4;
	struct root root;

	if (squared >= outer * outer) {
		return 0;
	}
	if (inner > 0 && squared <= inner * inner) {
		return 256;
	}
	root = soft_reciprocal_root((uint32_t)squared | 1);
	return find_share(coverage->radius_q8,
		(int32_t)((uint64_t)squared * (uint32_t)root.mantissa_q30 >>
			(26 + root.shift)));
}

static ALWAYS_INLINE int32_t cover_line(
	const struct soft_coverage *coverage, const struct place *at)
{
	const uint32_t along = raster_size((int32_t)at->along >> 10);
	const uint32_t across = raster_size((int32_t)at->across >> 10);

	return find_share(coverage->half_length_q8, (int32_t)along) *
		find_share(coverage->half_width_q8, (int32_t)across) >>
		8;
}

/* Covers a row's fragments. Inlined with a constant disk. */
static ALWAYS_INLINE struct covered cover_row(
	const struct soft_coverage coverage, bool disk, struct place at,
	uint32_t *color, uint32_t count)
{
	struct covered out = {count, 0};

	for (uint32_t i = 0; i < count; i++) {
		const uint32_t share =
			(uint32_t)(disk ? cover_disk(&coverage, at.x, at.y)
					: cover_line(&coverage, &at));

		if (share > 0) {
			out.first = i < out.first ? i : out.first;
			out.end = i + 1;
		}
		color[i] = (color[i] & 0x00FFFFFF) |
			((color[i] >> 24) * share + 128) >> 8 << 24;
		at.x += 16;
		at.along += (uint32_t)coverage.u_q14 * 16;
		at.across += (uint32_t)coverage.v_q14 * 16;
	}
	return out;
}

uint32_t soft_cover(
	const struct draw *draw, struct soft_row *run, uint32_t *color)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_coverage *coverage = &spans->coverage;
	const int32_t column = (int32_t)(run->place & 0xFFFF);
	const int32_t row = draw->raster.top + (int32_t)(run->place >> 16);
	const int32_t x = column * 16 + 8 - coverage->x;
	const int32_t y = row * 16 + 8 - coverage->y;
	/* below 2^31: fragments lie on the line, of 8192 pixels each way */
	const struct place at = {x, y,
		(uint32_t)(x * coverage->u_q14 + y * coverage->v_q14),
		(uint32_t)(x * coverage->v_q14 - y * coverage->u_q14)};
	const struct covered seen = coverage->radius_q8 > 0
		? cover_row(*coverage, true, at, color, run->count)
		: cover_row(*coverage, false, at, color, run->count);

	run->depth += seen.first;
	run->pixel += seen.first << spans->pixel_log2;
	run->z += spans->run.z_right * seen.first;
	run->count = seen.end > seen.first ? seen.end - seen.first : 0;
	return seen.first;
}
