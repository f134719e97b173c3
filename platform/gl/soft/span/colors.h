/* Colours as runs have them. */
#ifndef PLATFORM_GL_SOFT_SPAN_COLORS_H
#define PLATFORM_GL_SOFT_SPAN_COLORS_H

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* Cut towards zero, so that what moves stays between its ends. */
static ALWAYS_INLINE uint32_t scale_step(int32_t step, int32_t scale)
{
	return (uint32_t)mul_high(step, scale) + ((uint32_t)step >> 31);
}

/* Alpha and fog stay what they are, see set_still(), unless they move. */
static ALWAYS_INLINE void set_colors(
	struct soft_spans *spans, int32_t red, int32_t green, int32_t blue)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->scales.red_blue,
		half = spans->scales.red_blue_half;

	run->row.red_blue = ((uint32_t)mul_high_add(half, blue, scale) << 16) +
		(uint32_t)mul_high_add(half, red, scale);
	run->row.green_alpha = (uint32_t)mul_high_add(
		spans->green_start, green, spans->scales.green);
}

static ALWAYS_INLINE int32_t limit_color(int32_t color)
{
	return clamp_int(color, ROWS_LEAST_COLOR, ROWS_MOST_COLOR);
}

#endif
