/*
 * Chooses the level of detail that runs read: its texels, the conversion of
 * coordinates to it, and its window.
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
