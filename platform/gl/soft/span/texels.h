/*
 * Where a run's texels lie in its level: coordinates of the level from those of
 * the base, and the window in which no texel wraps around.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_TEXELS_H
#define PLATFORM_GL_SOFT_SPAN_TEXELS_H

#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"

/*
 * What a row does for texels besides, out of line: draws the run that is set up
 * where some of its texels lie outside of the window.
 */
void soft_draw_across(struct soft_spans *spans);

/*
 * Where a run of so many pixels begins, so that its middle is where it should
 * be: soft_texel_start() has the same bits.
 */
static ALWAYS_INLINE int32_t soft_find_start(int32_t at, int32_t step,
	uint32_t half_count, int32_t right, int shift, int32_t half_texel)
{
	uint32_t middle = (uint32_t)at + (uint32_t)step * half_count;

	return (int32_t)((uint32_t)((int32_t)middle >> shift) -
		(uint32_t)right * half_count - (uint32_t)half_texel);
}

/*
 * Whether all texels of the run lie in the window; sets first_texel and texel
 * then. A window of more texels than the halves of a word can count is entered
 * anew by each run.
 */
static ALWAYS_INLINE bool soft_find_window(const struct soft_window *window,
	const uint8_t *texels, uint32_t stride_log2, int texel_log2,
	struct soft_row *row)
{
	uint32_t last = row->count - 1;
	uint32_t s = ((uint32_t)row->s - window->s_first) & window->s_mask;
	uint32_t t = ((uint32_t)row->t - window->t_first) & window->t_mask;
	uint32_t s_end = s + (uint32_t)row->s_right * last;
	uint32_t t_end = t + (uint32_t)row->t_right * last;

	if (s >= window->s_room || s_end >= window->s_room ||
		t >= window->t_room || t_end >= window->t_room) {
		return false;
	}
	if (window->large) {
		uint32_t x = (s < s_end ? s : s_end) >> SOFT_TEXEL_FRACTION;
		uint32_t y = (t < t_end ? t : t_end) >> SOFT_TEXEL_FRACTION;

		row->first_texel =
			texels + (y << stride_log2) + (x << texel_log2);
		x <<= SOFT_TEXEL_FRACTION;
		y <<= SOFT_TEXEL_FRACTION;
		s -= x;
		t -= y;
		if ((s | t | (s_end - x) | (t_end - y)) >> 16 != 0) {
			return false;
		}
	}
	row->texel = (t << 16) + s;
	return true;
}

#endif
