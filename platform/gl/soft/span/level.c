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

struct soft_view soft_find_view(
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

static void choose_level(struct draw *draw, int number, bool small)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	const bool linear = soft_rows_is_linear(
		small ? input->texture->min_filter : input->texture->mag_filter);
	const int source = (linear ? SOFT_LINEAR : SOFT_NEAREST) +
		(int)input->base->format - 1;

	spans->level = number;
	spans->small = small;
	spans->view = soft_find_view(input, number, linear);
	soft_set_functions(spans, (*spans->table)[source][spans->finish]);
	soft_use_view(&spans->view, &spans->run);
	if (spans->joined) {
		const struct texture *second = draw->texture[1].texture;

		spans->run.joint = (uintptr_t)second->level[number].texels -
			(uintptr_t)spans->view.texels;
	}
}

void soft_set_level(struct draw *draw, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	bool small;
	int number;

	if (spans->set_level) {
		spans->set_level(draw, lod);
		return;
	}
	small = soft_rows_is_small(input, lod);
	number = small ? clamp_int((lod + 127) >> 8, 0, input->levels - 1) : 0;
	if (number != spans->level || small != spans->small) {
		choose_level(draw, number, small);
	}
}
