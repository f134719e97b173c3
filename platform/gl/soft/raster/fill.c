/* The rows of a triangle in any state, by the fastest way that takes it. */
#include "platform/gl/soft/fast/ground.h"
#include "platform/gl/soft/fast/luminance.h"
#include "platform/gl/soft/fast/mix.h"
#include "platform/gl/soft/fast/picture.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"

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
static void fill_constant(struct draw *draw, struct setup *setup)
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

	if (!draw->plain || raster->perspective) {
		return false;
	}
	for (int i = 0; i < raster->moving_count; i++) {
		across |= raster->plane[raster->moving[i]].dx;
	}
	return across == 0;
}

void soft_rows_fill(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;

	soft_raster_set_up(draw, setup);
	raster->span.step[DEPTH] = raster->plane[DEPTH].dx;
	if (draw->luminance && soft_luminance_begin(draw)) {
		raster_walk(draw, setup, soft_luminance_row, luminance_next);
		return;
	}
	if (draw->ground && soft_ground_begin(draw)) {
		raster_walk(draw, setup, soft_ground_row, ground_next);
		return;
	}
	if (is_constant_by_row(draw)) {
		fill_constant(draw, setup);
		return;
	}
	if (draw->picture && !raster->perspective) {
		for (int i = 0; i < raster->moving_count; i++) {
			int name = raster->moving[i];

			raster->span.step[name] = raster->plane[name].dx;
		}
		soft_rows_find_affine_lod(draw, &raster->span);
		if (soft_picture_begin(draw)) {
			raster_walk(draw, setup, soft_picture_row,
				soft_raster_next_row);
			return;
		}
	}
	soft_walk_rows(draw, setup);
}
