/* How a level of detail is read: its texels, and how coordinates lead there. */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/draw.h"

static struct soft_wrap find_wrap(GLenum mode, int log2)
{
	int32_t last = (1 << log2) - 1;
	bool repeats = mode == GL_REPEAT;

	return (struct soft_wrap){repeats ? INT32_MIN : 0,
		repeats ? INT32_MAX : last, (uint32_t)last};
}

/* The masks of coordinates that repeat, else all ones. */
static uint32_t find_mask(GLenum mode, int log2)
{
	return mode == GL_REPEAT ? (1u << (log2 + SOFT_TEXEL_FRACTION)) - 1
				 : UINT32_MAX;
}

static uint32_t find_room(int log2, bool linear)
{
	return ((1u << log2) - linear) << SOFT_TEXEL_FRACTION;
}

static struct soft_window find_window(
	const struct texture *texture, const struct level *level, bool linear)
{
	return (struct soft_window){
		.s_mask = find_mask(texture->wrap_s, level->width_log2),
		.t_mask = find_mask(texture->wrap_t, level->height_log2),
		.s_room = find_room(level->width_log2, linear),
		.t_room = find_room(level->height_log2, linear),
		.large = (1 << level->width_log2) >= SOFT_RUN_TEXELS ||
			(1 << level->height_log2) >= SOFT_RUN_TEXELS,
	};
}

struct soft_view soft_find_view(
	const struct texture_input *input, int number, bool linear)
{
	const struct texture *texture = input->texture;
	const struct level *level = &texture->level[number];
	const int more = 16 - SOFT_TEXEL_FRACTION;
	int texel_log2 = soft_texel_bytes_log2(level->format);

	return (struct soft_view){
		.texels = level->texels,
		.stride_log2 = (uint32_t)(level->width_log2 + texel_log2),
		.texel_log2 = texel_log2,
		.s_shift = input->width_log2 - level->width_log2 + more,
		.t_shift = input->height_log2 - level->height_log2 + more,
		.s_half = soft_half_texel(level->format, linear, true),
		.t_half = soft_half_texel(level->format, linear, false),
		.wrap_s = find_wrap(texture->wrap_s, level->width_log2),
		.wrap_t = find_wrap(texture->wrap_t, level->height_log2),
		.window = find_window(texture, level, linear),
	};
}

void soft_use_view(const struct soft_view *view,
	const soft_span_function function[2], struct soft_run *run,
	struct soft_window *window)
{
	run->stride_log2 = view->stride_log2;
	run->texels = view->texels;
	run->first_texel = view->texels;
	run->wrap_s = view->wrap_s;
	run->wrap_t = view->wrap_t;
	*window = view->window;
	if (function[0] == function[1]) {
		window->s_room = 0;
	}
}
