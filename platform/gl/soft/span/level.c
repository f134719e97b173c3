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
	soft_use_view(&spans->view, &spans->run);
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
	const struct part s = find_part(
		raster->texel_range[0], view->s_shift, view->s_half, spare);
	const struct part t = find_part(
		raster->texel_range[1], view->t_shift, view->t_half, spare);
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

/* Pixels side by side whose texels lie inside of the window, or do not. */
struct stretch {
	uint32_t count;
	int32_t at, right; /* as the pixels are to be drawn */
	bool inside;
};

/*
 * From a coordinate on that does not repeat: what lies beyond the first or the
 * last texel stays there.
 */
static NEVER_INLINE struct stretch find_clamped(
	int32_t at, int32_t right, uint32_t step, uint32_t room, uint32_t last)
{
	bool below = at < 0;
	uint32_t beyond = below ? ~(uint32_t)at : (uint32_t)at - room;
	bool returns = below ? right > 0 : right < 0;

	return (struct stretch){
		returns ? count_steps(beyond, step) + 1 : SOFT_RUN_PIXELS,
		below ? 0 : (int32_t)(last << SOFT_TEXEL_FRACTION), 0, true};
}

/* Whether what repeats is worth being cut where it does. */
static bool is_far(int32_t right, uint32_t room, uint32_t mask)
{
	return mask == UINT32_MAX || raster_size(right) <= room / 32;
}

/* From a coordinate on, up to an edge; where close, only what is clamped. */
static ALWAYS_INLINE struct stretch find_stretch(int32_t given, int32_t right,
	uint32_t room, uint32_t mask, uint32_t last, bool close)
{
	uint32_t at = (uint32_t)given & mask, step = raster_size(right);

	if (close && mask != UINT32_MAX) {
		return (struct stretch){SOFT_RUN_PIXELS, given, right, false};
	}
	if (at < room) {
		return (struct stretch){
			count_steps(right < 0 ? at : room - 1 - at, step) + 1,
			(int32_t)at, right, true};
	}
	if (mask == UINT32_MAX) {
		return find_clamped(given, right, step, room, last);
	}
	return (struct stretch){
		count_steps(right < 0 ? at - room : mask - at, step) + 1,
		(int32_t)at, right, false};
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

static void set_coordinates(
	struct soft_run *run, const struct stretch *s, const struct stretch *t)
{
	run->s = s->at;
	run->t = t->at;
	run->s_right = s->right;
	run->t_right = t->right;
	run->row.texel_right = ((uint32_t)t->right << 16) + (uint32_t)s->right;
}

void soft_cut_run(struct soft_run *run, const struct soft_view *view,
	const soft_span_function function[2], int pixel_log2)
{
	const struct soft_window *window = &view->window;
	/* Of texels that count, which may be the last ones. */
	const struct soft_window all = {.s_mask = UINT32_MAX,
		.t_mask = UINT32_MAX,
		.s_room = INT32_MAX,
		.t_room = INT32_MAX,
		.large = window->large};
	const uint8_t *first_texel = run->first_texel;
	const bool close =
		!is_far(run->s_right, window->s_room, window->s_mask) ||
		!is_far(run->t_right, window->t_room, window->t_mask);

	run->first_texel = run->texels;
	for (uint32_t left = run->row.count; left > 0; left -= run->row.count) {
		const struct stretch s = find_stretch(run->s, run->s_right,
			window->s_room, window->s_mask, view->s_last, close);
		const struct stretch t = find_stretch(run->t, run->t_right,
			window->t_room, window->t_mask, view->t_last, close);
		const struct stretch s_own = {.at = run->s,
					     .right = run->s_right},
				     t_own = {.at = run->t,
					     .right = run->t_right};

		run->row.count = s.count < t.count ? s.count : t.count;
		run->row.count = run->row.count < left ? run->row.count : left;
		set_coordinates(run, &s, &t);
		function[s.inside && t.inside &&
			soft_find_window(&all, view->texel_log2, run)](run);
		set_coordinates(run, &s_own, &t_own);
		advance(run, run->row.count, pixel_log2);
	}
	run->first_texel = first_texel;
}

void soft_draw_across(struct soft_spans *spans)
{
	const soft_span_function function[2] = {
		spans->draw_anywhere, spans->draw};

	if (spans->made) {
		spans->draw(&spans->run);
	} else {
		soft_cut_run(
			&spans->run, &spans->view, function, spans->pixel_log2);
	}
}
