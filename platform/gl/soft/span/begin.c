/* Sets what all runs of a triangle have in common. */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/made.h"

/* A steep colour's change a pixel: 32 steps of 255, in 8.16. */
#define STEEP (1u << 21)

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

/* Whether a colour of moving changes faster than STEEP to the right. */
static bool is_steep(const struct plane *plane, uint32_t moving)
{
	for (int i = RED; moving >> i; i++) {
		if ((moving >> i & 1) &&
			(uint32_t)plane[i].dx + STEEP > 2 * STEEP) {
			return true;
		}
	}
	return false;
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
static void set_constants(struct draw *draw, uint32_t moving)
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
		spans->steep = is_steep(raster->plane, moving);
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

uint32_t soft_begin_walk(struct draw *draw)
{
	uint32_t moving = draw->raster.moving_bits & ((2u << FOG) - 1);

	draw->spans.alpha_moves = moving >> ALPHA & 1;
	draw->spans.fog_moves = moving >> FOG & 1;
	set_constants(draw, moving);
	return moving;
}
