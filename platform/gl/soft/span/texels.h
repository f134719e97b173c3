/*
 * Where a run's texels lie in its level: converts texture coordinates from base
 * texels to the level's, and tests whether they lie in the window.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_TEXELS_H
#define PLATFORM_GL_SOFT_SPAN_TEXELS_H

#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"

/*
 * cut.c: draws the run that is set up, spans->run, some of whose texels lie
 * outside of the window.
 */
void soft_draw_across(struct soft_spans *spans);

/*
 * cut.c: draws a run whose texels may lie outside of the level: by function[0]
 * where they wrap around, else by function[1]. Changes the run, but not its steps.
 */
void soft_cut_run(struct soft_run *run, const struct soft_view *view,
	const soft_span_function function[2], int pixel_log2);

/* Sets a run's steps in the level from those in base texels, rounded. */
static ALWAYS_INLINE void soft_set_texel_steps(
	const struct soft_view *view, struct texels step, struct soft_run *run)
{
	run->s.right = soft_texel_step(step.s, view->s.shift);
	run->t.right = soft_texel_step(step.t, view->t.shift);
	run->row.texel_right = (run->t.right << 16) + run->s.right;
}

/* Sets the first coordinates of a run of count pixels, whose steps are set. */
static ALWAYS_INLINE void soft_set_texels(const struct soft_view *view,
	struct texels at, struct texels step, uint32_t count,
	struct soft_run *run)
{
	run->s.at = soft_find_start(at.s, step.s, count >> 1, run->s.right,
		view->s.shift, view->s.half);
	run->t.at = soft_find_start(at.t, step.t, count >> 1, run->t.right,
		view->t.shift, view->t.half);
}

/*
 * Whether all texels of the run lie in the window; if so, sets row.texel and,
 * in a large window, first_texel: there, each run counts from a texel of its
 * own, as the halves of row.texel have room for SOFT_RUN_TEXELS only.
 */
static ALWAYS_INLINE bool soft_find_window(
	const struct soft_view *view, struct soft_run *run)
{
	uint32_t last = run->row.count - 1;
	uint32_t s = run->s.at & view->s.mask, s_end = s + run->s.right * last;
	uint32_t t = run->t.at & view->t.mask, t_end = t + run->t.right * last;

	if (s >= view->s.room || s_end >= view->s.room || t >= view->t.room ||
		t_end >= view->t.room) {
		return false;
	}
	if (view->large) {
		uint32_t x = (s < s_end ? s : s_end) >> SOFT_TEXEL_FRACTION;
		uint32_t y = (t < t_end ? t : t_end) >> SOFT_TEXEL_FRACTION;

		run->first_texel = run->texels + (y << run->stride_log2) +
			(x << view->texel_log2);
		x <<= SOFT_TEXEL_FRACTION;
		y <<= SOFT_TEXEL_FRACTION;
		s -= x;
		t -= y;
		if ((s | t | (s_end - x) | (t_end - y)) >> 16 != 0) {
			return false;
		}
	}
	run->row.texel = (t << 16) + s;
	return true;
}

/* Steps a run's row, and its second texels, by count pixels; not the first ones. */
static inline void soft_advance(struct soft_run *run, struct soft_row *row,
	uint32_t count, int pixel_log2)
{
	row->depth += count;
	row->pixel += count << pixel_log2;
	row->z += run->z_right * count;
	row->red_blue += run->red_blue_right * count;
	row->green_alpha += run->green_alpha_right * count;
	row->fog += run->fog_right * count;
	row->place += count;
	run->second += 4 * count;
}

#endif
