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

/* A triangle's range of one coordinate in a level, 9 fraction bits. */
struct texel_place {
	int32_t low; /* a whole texel at or below the least coordinate */
	uint32_t first, room; /* low masked; the largest one minus low */
};

/*
 * Finds it from a triangle's least and largest coordinate, in 1/256 base texels,
 * with spare more at both ends. Far outside of the texture it wraps around.
 */
static ALWAYS_INLINE struct texel_place soft_find_place(int32_t least,
	int32_t most, int shift, int32_t half, int32_t spare, uint32_t mask)
{
	int32_t low = ((int32_t)((uint32_t)least * 256) >> shift) - half - spare;
	int32_t high = ((int32_t)((uint32_t)most * 256) >> shift) - half + spare;

	low &= ~((1 << SOFT_TEXEL_FRACTION) - 1);
	return (struct texel_place){
		low, (uint32_t)low & mask, (uint32_t)high - (uint32_t)low};
}

/* Sets a run's steps in the level from those in base texels, rounded. */
static ALWAYS_INLINE void soft_set_texel_steps(
	const struct soft_view *view, struct texels step, struct soft_run *run)
{
	run->s_right = soft_texel_step(step.s, view->s_shift);
	run->t_right = soft_texel_step(step.t, view->t_shift);
	run->row.texel_right =
		((uint32_t)run->t_right << 16) + (uint32_t)run->s_right;
}

/* Sets the first coordinates of a run of count pixels, whose steps are set. */
static ALWAYS_INLINE void soft_set_texels(const struct soft_view *view,
	struct texels at, struct texels step, uint32_t count,
	struct soft_run *run)
{
	run->s = soft_find_start(at.s, step.s, count >> 1, run->s_right,
		view->s_shift, view->s_half);
	run->t = soft_find_start(at.t, step.t, count >> 1, run->t_right,
		view->t_shift, view->t_half);
}

/*
 * Whether all texels of the run lie in the window; if so, sets row.texel and,
 * in a large window, first_texel: there, each run counts from a texel of its
 * own, as the halves of row.texel have room for SOFT_RUN_TEXELS only.
 */
static ALWAYS_INLINE bool soft_find_window(
	const struct soft_window *window, int texel_log2, struct soft_run *run)
{
	uint32_t last = run->row.count - 1;
	uint32_t s = (uint32_t)run->s & window->s_mask;
	uint32_t t = (uint32_t)run->t & window->t_mask;
	uint32_t s_end = s + (uint32_t)run->s_right * last;
	uint32_t t_end = t + (uint32_t)run->t_right * last;

	if (s >= window->s_room || s_end >= window->s_room ||
		t >= window->t_room || t_end >= window->t_room) {
		return false;
	}
	if (window->large) {
		uint32_t x = (s < s_end ? s : s_end) >> SOFT_TEXEL_FRACTION;
		uint32_t y = (t < t_end ? t : t_end) >> SOFT_TEXEL_FRACTION;

		run->first_texel = run->texels + (y << run->stride_log2) +
			(x << texel_log2);
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

#endif
