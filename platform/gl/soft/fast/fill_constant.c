/* Opaque triangles without texture or tests whose colours differ by row only. */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/spans.h"

/* Rows of one colour with nothing to test or blend. */
static void row_constant(struct draw *draw, int y, int left, int right)
{
	const struct plane *plane = draw->raster.plane;

	soft_fill_pixels((uint16_t *)(void *)pixel_at(
				 &draw->soft->buffers.target, left, y),
		right - left,
		color_565(plane[RED].start, plane[GREEN].start,
			plane[BLUE].start));
}

static void next_constant(struct draw *draw)
{
	struct plane *plane = draw->raster.plane;

	for (int i = RED; i <= BLUE; i++) {
		plane[i].start += (uint32_t)plane[i].dy;
	}
}

/* Colours that stand still have planes too. */
static void fill_rows(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;
	uint32_t still = 7u << RED;

	for (int i = 0; i < raster->moving_count; i++) {
		still &= ~(1u << raster->moving[i]);
	}
	for (int i = RED; i <= BLUE; i++) {
		if (still >> i & 1) {
			raster->plane[i] =
				(struct plane){.start = raster->span.value[i]};
		}
	}
	raster_walk(draw, setup, row_constant, next_constant);
}

static bool is_constant_by_row(const struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	int32_t across = 0;

	if (raster->perspective) {
		return false;
	}
	for (int i = 0; i < raster->moving_count; i++) {
		across |= raster->plane[raster->moving[i]].dx;
	}
	return across == 0;
}

void soft_fill_constant(struct draw *draw, struct setup *setup)
{
	rows_set_up(draw, setup);
	if (is_constant_by_row(draw)) {
		fill_rows(draw, setup);
	} else {
		soft_walk_rows(draw, setup);
	}
}
