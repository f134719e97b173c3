/*
 * Opaque runs in RGB565 without depth or stencil test: runs of one colour are
 * filled; runs that show a row of nearest texels unchanged, such as a camera's
 * picture, are copied.
 */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/vertex/draw.h"

enum {
	/* factors of 1.14 above which texels of 5 or 6 bits do not change */
	RED_BLUE_WHITE = 16384 - 16384 / 62,
	GREEN_WHITE = 16384 - 16384 / 126,
};

void soft_copy_texels(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16)
{
	const uint8_t *bytes = (const uint8_t *)texels;
	uint32_t even = 0x1FFFE;

	/* else compilers replace the mask by two shifts */
	OPAQUE(even);
#pragma GCC unroll 8
	for (int i = 0; i < count; i++) {
		pixel[i] = load_16(bytes + (s_q16 >> 15 & even));
		s_q16 += s_right_q16;
	}
}

void soft_fill_untested(const struct soft_run *run)
{
	const struct soft_row *row = run->rows, *end = row + run->row_count;

	if ((run->red_blue_right | run->green_alpha_right) != 0) {
		run->draw->spans.draw_tested(run);
		return;
	}
	for (; row < end; row++) {
		const uint32_t rb = row->red_blue;
		const uint32_t green = (row->green_alpha & 0x7FFF) >> 9;

		soft_fill_pixels((uint16_t *)(void *)row->pixel, (int)row->count,
			(uint16_t)((rb & 0xF800) | green << 5 | rb >> 27));
	}
}

/* Whether a run shows texels of a single row, not tinted. */
static bool is_copy(const struct soft_row *row)
{
	return (row->texel_right + 0x8000) >> 16 == 0 &&
		(row->red_blue & 0xFFFF) > RED_BLUE_WHITE &&
		row->red_blue >> 16 > RED_BLUE_WHITE &&
		(row->green_alpha & 0xFFFF) > GREEN_WHITE;
}

void soft_copy_untested(const struct soft_run *run)
{
	const struct soft_row *row = run->rows, *end = row + run->row_count;
	const int shift = 16 - SOFT_TEXEL_FRACTION;
	bool are_copies = (run->red_blue_right | run->green_alpha_right) == 0;

	for (const struct soft_row *at = row; at < end; at++) {
		are_copies &= is_copy(at);
	}
	if (!are_copies) {
		run->draw->spans.draw_tested(run);
		return;
	}
	for (; row < end; row++) {
		const uint8_t *texels = run->first_texel +
			(row->texel >> (16 + SOFT_TEXEL_FRACTION)
					<< run->stride_log2);

		soft_copy_texels((uint16_t *)(void *)row->pixel,
			(const uint16_t *)(const void *)texels, (int)row->count,
			(row->texel & 0xFFFF) << shift,
			row->texel_right << shift);
	}
}
