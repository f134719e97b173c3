/* Sets what all runs of a triangle have in common. */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/made.h"

/* Sets alpha and fog, if they are constant; set_colors() sets the rest. */
static void set_still(struct draw *draw)
{
	const uint32_t *value = draw->raster.constant;
	struct soft_spans *spans = &draw->spans;

	spans->green_start = spans->scales.green_half;
	if (spans->alpha_read && !spans->alpha_moves) {
		spans->green_start += (int32_t)(value[ALPHA] >> 9 << 16);
	}
	if (!spans->fog_moves) {
		spans->run.row.fog =
			(uint32_t)mul_high((int32_t)value[FOG], SOFT_FOG_SCALE);
		spans->run.fog_right = 0;
	}
}

/*
 * Whether a colour of moving changes so fast to the right that rounded edges
 * move it by 1/16: they are off by up to 1/65536 of a pixel a row. That is 32
 * steps of 255 a pixel in 127 rows, and 256 in 15.
 */
static ALWAYS_INLINE bool is_steep(
	const struct plane *plane, uint32_t moving, int rows)
{
	const uint32_t most = rows < 16 ? 1u << 24 : 1u << 21;
	uint32_t all = raster_size(plane[RED].dx) |
		raster_size(plane[GREEN].dx) | raster_size(plane[BLUE].dx);

	if (moving >> ALPHA & 1) {
		all |= raster_size(plane[ALPHA].dx);
	}
	if (moving >> FOG & 1) {
		all |= raster_size(plane[FOG].dx);
	}
	return all >= most;
}

static void set_level(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;

	spans->level_by_row = spans->lod_wanted && raster->perspective;
	spans->level_unknown = spans->level_by_row;
	if (!spans->lod_wanted) {
		if (spans->levels[0].level < 0) {
			soft_set_level(draw, 0, 0);
		}
	} else if (!spans->level_by_row) {
		soft_rows_find_affine_lod(draw);
		soft_set_level(draw, 0, raster->lod[0]);
	}
	if (draw->texture[1].used && !raster->perspective) {
		soft_set_level(draw, 1, raster->lod[1]);
	}
}

/* Sets constant values, and the level where the triangle has only one. */
static void set_constants(struct draw *draw, uint32_t moving, int rows)
{
	const struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;

	spans->run.z_right = (uint32_t)raster->plane[DEPTH].dx << 6;
	set_still(draw);
	spans->steep = false;
	if (!moving) {
		const uint32_t *value = raster->constant;

		set_colors(spans, (int32_t)value[RED], (int32_t)value[GREEN],
			(int32_t)value[BLUE]);
		set_color_steps(spans, &(struct colors){0});
	} else if (!raster->colors_divided) {
		spans->steep = is_steep(raster->plane, moving, rows);
		spans->rare =
			spans->steep || spans->alpha_moves || spans->fog_moves;
	}
	if (spans->textured) {
		set_level(draw);
	}
}

void soft_begin_steps(struct draw *draw, uint32_t moving)
{
	const struct raster *raster = &draw->raster;
	const struct plane *plane = raster->plane;

	if (moving && !raster->colors_divided) {
		set_color_steps(&draw->spans,
			&(struct colors){plane[RED].dx, plane[GREEN].dx,
				plane[BLUE].dx, plane[ALPHA].dx, plane[FOG].dx});
	}
}

uint32_t soft_begin_walk(struct draw *draw, int rows)
{
	uint32_t moving = draw->raster.moving_bits & ((2u << FOG) - 1);

	draw->spans.alpha_moves = moving >> ALPHA & 1;
	draw->spans.fog_moves = moving >> FOG & 1;
	set_constants(draw, moving, rows);
	return moving;
}
