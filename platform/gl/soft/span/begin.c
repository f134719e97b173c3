/*
 * Sets what all runs of a triangle have in common: constant values, and the
 * level of detail that they read: its texels, the conversion of coordinates to
 * it, and its window.
 */
#include "platform/gl/soft/span/points.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* A coordinate along sides of 1 << log2 texels; across: s, else t. */
static struct soft_axis find_axis(const struct level *level, bool linear,
	bool across, int log2, int base_log2, GLenum wrap)
{
	const uint32_t texels = 1u << log2;

	if (log2 == 0) {
		/* all coordinates give the only texel */
		return (struct soft_axis){.shift = 31, .room = 1};
	}
	return (struct soft_axis){
		.shift = base_log2 - log2 + 16 - SOFT_TEXEL_FRACTION,
		.half = soft_half_texel(level->format, linear, across),
		.last = texels - 1,
		.mask = wrap == GL_REPEAT ? (texels << SOFT_TEXEL_FRACTION) - 1
					  : UINT32_MAX,
		.room = (texels - linear) << SOFT_TEXEL_FRACTION,
	};
}

static struct soft_view find_view(
	const struct texture_input *input, int number, bool linear)
{
	const struct texture *texture = input->texture;
	const struct level *level = &texture->level[number];
	const int s_log2 = level->width_log2, t_log2 = level->height_log2;
	int texel_log2 = soft_texel_bytes_log2(level->format);

	return (struct soft_view){
		.texels = level->texels,
		.stride_log2 = (uint32_t)(s_log2 + texel_log2),
		.texel_log2 = texel_log2,
		.large = (1 << s_log2) > SOFT_RUN_TEXELS ||
			(1 << t_log2) > SOFT_RUN_TEXELS,
		.s = find_axis(level, linear, true, s_log2, input->width_log2,
			texture->wrap_s),
		.t = find_axis(level, linear, false, t_log2, input->height_log2,
			texture->wrap_t),
	};
}

void soft_use_view(const struct soft_view *view, struct soft_run *run)
{
	run->stride_log2 = view->stride_log2;
	run->texels = view->texels;
	run->first_texel = view->texels;
	run->s_last = view->s.last;
	run->t_last = view->t.last;
}

/* Lets span functions read the first texture's level. */
static void use_level(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const struct soft_levels *levels = &spans->levels[0];
	const int source = (levels->linear ? SOFT_LINEAR : SOFT_NEAREST) +
		(int)draw->texture[0].base->format - 1;

	soft_set_functions(spans, (*spans->table)[source][spans->finish]);
	soft_use_view(&levels->view, &spans->run);
	if (spans->joined) {
		const struct texture *second = draw->texture[1].texture;

		spans->run.joint =
			(uintptr_t)second->level[levels->level].texels -
			(uintptr_t)levels->view.texels;
	}
}

static void set_sampler(
	const struct texture_input *input, struct soft_levels *levels)
{
	const int next = levels->level + 1, last = input->levels - 1;

	levels->sampler = levels->packed
		? soft_second_samplers[levels->linear]
		: soft_samplers[(levels->linear ? SOFT_LINEAR : SOFT_NEAREST) +
			  (int)input->base->format - 1];
	levels->next_view =
		find_view(input, next < last ? next : last, levels->linear);
}

void soft_set_level(struct draw *draw, int unit, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[unit];
	struct soft_levels *levels = &spans->levels[unit];
	const int last = input->levels - 1, line = lod & 255;
	bool mixed, linear, small;
	int level = 0;

	if (unit == 0 && spans->set_level) {
		spans->set_level(draw, lod);
		return;
	}
	small = soft_rows_is_small(input, lod);
	/* span functions read one level */
	mixed = small && (unit > 0 || spans->made) &&
		soft_rows_mixes_levels(input);
	linear = soft_rows_is_linear(small ? input->texture->min_filter
					   : input->texture->mag_filter);
	if (small) {
		level = clamp_int(mixed ? lod >> 8 : (lod + 127) >> 8, 0, last);
	}
	/* lod is linear between powers of two: this approximates log2 */
	levels->share = mixed && level < last
		? line + (line * (256 - line) * 92 >> 16)
		: 0;
	if (level == levels->level && linear == levels->linear) {
		return;
	}
	levels->level = level;
	levels->linear = linear;
	levels->view = find_view(input, level, linear);
	if (unit == 0 && !spans->made) {
		use_level(draw);
	} else {
		set_sampler(input, levels);
	}
}

struct soft_made_at soft_find_second(
	struct draw *draw, int row, int x, int count, int *lod)
{
	const struct walk_kind kind = {.textured = true};
	const struct line line = {.draw = draw, .row = row};
	const int32_t inverse = draw->inverse_q31[count - 1];
	const struct row_point from = find_point(&line, kind, 1, x);
	const struct texels at = from.texels,
			    to = find_point(&line, kind, 1, x + count - 1).texels;

	if (soft_rows_want_lod(&draw->texture[1])) {
		*lod = soft_rows_find_lod(&draw->raster, &from.divisor, 1, at);
	}
	return (struct soft_made_at){at,
		{rows_find_step(at.s, to.s, inverse),
			rows_find_step(at.t, to.t, inverse)}};
}

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
