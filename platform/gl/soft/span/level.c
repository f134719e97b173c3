/*
 * Chooses the level of detail that runs read: its texels, the conversion of
 * coordinates to it, and its window.
 */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/*
 * The mask of coordinates that repeat, else all ones; 0 for a side of one
 * texel, where all coordinates give that texel.
 */
static uint32_t find_mask(GLenum mode, int log2)
{
	return log2 == 0            ? 0
		: mode == GL_REPEAT ? (1u << (log2 + SOFT_TEXEL_FRACTION)) - 1
				    : UINT32_MAX;
}

static uint32_t find_room(int log2, bool linear)
{
	return log2 == 0 ? 1 : ((1u << log2) - linear) << SOFT_TEXEL_FRACTION;
}

static struct soft_window find_window(
	const struct texture *texture, const struct level *level, bool linear)
{
	return (struct soft_window){
		.s_mask = find_mask(texture->wrap_s, level->width_log2),
		.t_mask = find_mask(texture->wrap_t, level->height_log2),
		.s_room = find_room(level->width_log2, linear),
		.t_room = find_room(level->height_log2, linear),
		.large = (1 << level->width_log2) > SOFT_RUN_TEXELS ||
			(1 << level->height_log2) > SOFT_RUN_TEXELS,
	};
}

/* The shift from 16.16 base texels to the level's; 31 for a side of one texel. */
static int find_shift(int base_log2, int log2)
{
	return log2 == 0 ? 31 : base_log2 - log2 + 16 - SOFT_TEXEL_FRACTION;
}

static int32_t find_half(
	const struct level *level, bool linear, bool across, int log2)
{
	return log2 == 0 ? 0 : soft_half_texel(level->format, linear, across);
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
		.s_shift = find_shift(input->width_log2, s_log2),
		.t_shift = find_shift(input->height_log2, t_log2),
		.s_half = find_half(level, linear, true, s_log2),
		.t_half = find_half(level, linear, false, t_log2),
		.s_last = (1u << s_log2) - 1,
		.t_last = (1u << t_log2) - 1,
		.window = find_window(texture, level, linear),
	};
}

void soft_use_view(const struct soft_view *view, struct soft_run *run)
{
	run->stride_log2 = view->stride_log2;
	run->texels = view->texels;
	run->first_texel = view->texels;
	run->s_last = view->s_last;
	run->t_last = view->t_last;
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
