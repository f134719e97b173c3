/* The level of detail that runs are drawn from, and runs across its edges. */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/number.h"

static void choose_level(struct draw *draw, int number, bool small)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	GLenum min = input->texture->min_filter;
	bool linear = small ? min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST
			    : input->texture->mag_filter == GL_LINEAR;

	spans->level = number;
	spans->small = small;
	spans->view = soft_find_view(input, number, linear);
	soft_set_functions(spans, small ? spans->min : spans->mag);
	soft_use_view(&spans->view, spans->function, &spans->run,
		&spans->view.window);
	spans->window = spans->view.window;
}

void soft_set_level(struct draw *draw, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	bool small = soft_rows_is_small(input, lod);
	int number =
		small ? clamp_int((lod + 127) >> 8, 0, input->levels - 1) : 0;

	if (spans->made) {
		soft_set_made_levels(draw, lod);
	} else if (number != spans->level || small != spans->small) {
		choose_level(draw, number, small);
	}
}

/* The part of a window along one coordinate that a triangle needs. */
struct part {
	uint32_t low, room;
};

static ALWAYS_INLINE int32_t to_level(int32_t base_q8, int shift)
{
	/* Far outside of the texture it wraps, as the planes do. */
	return (int32_t)((uint32_t)base_q8 * 256) >> shift;
}

/*
 * From the triangle's least and largest coordinate, in 1/256 of the base's
 * texels, and so much to spare.
 */
static ALWAYS_INLINE struct part find_part(
	const int32_t range[2], int shift, int32_t half, int32_t spare)
{
	int32_t low = to_level(range[0], shift) - half - spare;
	int32_t high = to_level(range[1], shift) - half + spare;

	low &= ~((1 << SOFT_TEXEL_FRACTION) - 1);
	return (struct part){(uint32_t)low, (uint32_t)high - (uint32_t)low};
}

/*
 * What of the window the triangle needs, with so much to spare, up to the
 * level's edges. False where no run can lie in it.
 */
static bool find_window_part(
	struct soft_spans *spans, const struct raster *raster, int32_t spare)
{
	const struct soft_view *view = &spans->view;
	const struct soft_window *whole = &view->window;
	const uint32_t most = SOFT_RUN_TEXELS << SOFT_TEXEL_FRACTION;
	const struct part s = find_part(raster->texel_range[0], view->s_shift,
		view->s_half, spare);
	const struct part t = find_part(raster->texel_range[1], view->t_shift,
		view->t_half, spare);
	const uint32_t s_first = s.low & whole->s_mask;
	const uint32_t t_first = t.low & whole->t_mask;

	if (s.room >= most || t.room >= most || s_first >= whole->s_room ||
		t_first >= whole->t_room) {
		return false;
	}
	spans->part = (struct soft_window){s_first, t_first, whole->s_mask,
		whole->t_mask, s.room, t.room, false};
	spans->part_s = s.low;
	spans->part_t = t.low;
	spans->part_texel = view->texels +
		(t_first >> SOFT_TEXEL_FRACTION << view->stride_log2) +
		(s_first >> SOFT_TEXEL_FRACTION << view->texel_log2);
	return true;
}

/* Cuts it off at the level's edges. False where nothing is cut off. */
static bool cut_part(struct soft_spans *spans)
{
	struct soft_window *part = &spans->part;
	uint32_t s_room = spans->view.window.s_room - part->s_first;
	uint32_t t_room = spans->view.window.t_room - part->t_first;

	if (part->s_room <= s_room && part->t_room <= t_room) {
		return false;
	}
	part->s_room = part->s_room < s_room ? part->s_room : s_room;
	part->t_room = part->t_room < t_room ? part->t_room : t_room;
	return true;
}

/* An eighth of a texel; a texel where values bend, see bend.c. */
void soft_set_window(struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;
	const int32_t spare = 1 << (SOFT_TEXEL_FRACTION - 3);

	spans->certain = false;
	spans->window = spans->view.window;
	spans->run.first_texel = spans->run.texels;
	if (find_window_part(spans, raster, raster->bent ? 8 * spare : spare) &&
		!cut_part(spans)) {
		spans->certain = true;
	} else if (!find_window_part(spans, raster, spare)) {
		spans->part = spans->window;
		spans->part_texel = spans->run.texels;
		spans->part_s = spans->part_t = 0;
		return;
	} else if (cut_part(spans)) {
		return;
	}
	spans->window = spans->part;
	spans->run.first_texel = spans->part_texel;
}

/* How many whole steps fit the distance: at most SOFT_RUN_PIXELS - 1. */
static uint32_t count_steps(uint32_t distance, uint32_t step)
{
	uint32_t count = 0;

	if (distance / SOFT_RUN_PIXELS >= step) {
		return SOFT_RUN_PIXELS - 1;
	}
	for (uint32_t part = SOFT_RUN_PIXELS / 2; part > 0; part /= 2) {
		if (distance >= step * part) {
			distance -= step * part;
			count += part;
		}
	}
	return count;
}

/*
 * How many pixels from here on lie on the same side of the window's edges as
 * the first one, whose coordinate is at; *inside says which side.
 */
static uint32_t count_alike(
	uint32_t at, int32_t right, uint32_t room, uint32_t mask, bool *inside)
{
	uint32_t step = right < 0 ? 0u - (uint32_t)right : (uint32_t)right;
	bool below = (int32_t)at < 0; /* clamped ones alone */

	if (at < room) {
		return count_steps(right < 0 ? at : room - 1 - at, step) + 1;
	}
	*inside = false;
	if (below ? right > 0 : right < 0) {
		return count_steps(below ? ~at : at - room, step) + 1;
	}
	return mask == UINT32_MAX ? SOFT_RUN_PIXELS
				  : count_steps(mask - at, step) + 1;
}

static void advance(struct soft_run *run, uint32_t count, int pixel_log2)
{
	run->row.depth += count;
	run->row.pixel += count << pixel_log2;
	run->row.z += run->z_right * count;
	run->row.red_blue += run->red_blue_right * count;
	run->row.green_alpha += run->green_alpha_right * count;
	run->row.fog += run->fog_right * count;
	run->s = (int32_t)((uint32_t)run->s + (uint32_t)run->s_right * count);
	run->t = (int32_t)((uint32_t)run->t + (uint32_t)run->t_right * count);
}

/* Whether the pieces that edges cut a run into are long enough to pay. */
static bool is_cut(const struct soft_spans *spans)
{
	const struct soft_run *run = &spans->run;
	const struct soft_window *window = &spans->window;

	return raster_size(run->s_right) * 8 < window->s_room &&
		raster_size(run->t_right) * 8 < window->t_room;
}

void soft_draw_across(struct soft_spans *spans)
{
	const struct soft_window *window = &spans->window;
	struct soft_run *run = &spans->run;

	if (run->row.count == 1 || !is_cut(spans)) {
		spans->draw_anywhere(run);
		return;
	}
	for (uint32_t left = run->row.count; left > 0; left -= run->row.count) {
		bool inside = true;
		uint32_t s = count_alike(
			((uint32_t)run->s - window->s_first) & window->s_mask,
			run->s_right, window->s_room, window->s_mask, &inside);
		uint32_t t = count_alike(
			((uint32_t)run->t - window->t_first) & window->t_mask,
			run->t_right, window->t_room, window->t_mask, &inside);

		run->row.count = s < t ? s : t;
		run->row.count = run->row.count < left ? run->row.count : left;
		(inside && soft_find_window(window, spans->view.texel_log2, run)
				? spans->draw
				: spans->draw_anywhere)(run);
		advance(run, run->row.count, spans->pixel_log2);
	}
}
