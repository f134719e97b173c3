#include "platform/gl/soft/stages/made.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"

/* A colour times a blend factor; from is the source, to the destination. */
static ALWAYS_INLINE uint32_t scale_by_factor(
	GLenum factor, uint32_t color, uint32_t from, uint32_t to)
{
	uint32_t own = from >> 24, left = 255 - (to >> 24);

	switch (factor) {
	case GL_ZERO:
		return 0;
	case GL_SRC_COLOR:
		return soft_multiply_bytes(color, from);
	case GL_ONE_MINUS_SRC_COLOR:
		return soft_multiply_bytes(color, ~from);
	case GL_DST_COLOR:
		return soft_multiply_bytes(color, to);
	case GL_ONE_MINUS_DST_COLOR:
		return soft_multiply_bytes(color, ~to);
	case GL_SRC_ALPHA:
		return soft_scale_bytes(color, own);
	case GL_ONE_MINUS_SRC_ALPHA:
		return soft_scale_bytes(color, 255 - own);
	case GL_DST_ALPHA:
		return soft_scale_bytes(color, 255 - left);
	case GL_ONE_MINUS_DST_ALPHA:
		return soft_scale_bytes(color, left);
	case GL_SRC_ALPHA_SATURATE:
		return (color & 0xFF000000) |
			(soft_scale_bytes(color, own < left ? own : left) &
				0x00FFFFFF);
	default:
		return color;
	}
}

/* A pixel of RGB565 as RGBA8888, as load_pixel() expands it. */
static ALWAYS_INLINE uint32_t load_565(const uint8_t *pixel)
{
	const uint32_t old = load_16(pixel);
	const uint32_t red_blue = ((old & 0xF800) | old << 27) >> 8;
	const uint32_t green = (old & 0x07E0) << 5;

	return 0xFF000000 | red_blue | (red_blue >> 5 & 0x00070007) | green |
		(green >> 6 & 0x0300);
}

/* Stores pack_565() of a colour; red and blue are packed in one word. */
static ALWAYS_INLINE void store_565(uint8_t *pixel, uint32_t color)
{
	const uint32_t red_blue = BYTES_AS_HALVES(color) * 249 + 1014 * 0x10001;
	const uint32_t green = (color >> 8 & 255) * 253 + 505;

	store_16(pixel,
		(uint16_t)((red_blue & 0xF800) | green >> 10 << 5 |
			red_blue >> 27));
}

static ALWAYS_INLINE uint32_t blend_colors(
	uint32_t to, uint32_t from, GLenum source, GLenum destination)
{
	return BYTES_ADD_LIMITED(scale_by_factor(source, from, from, to),
		scale_by_factor(destination, to, from, to));
}

/* Blends a row; inlined with constant factors for the common ones. */
static ALWAYS_INLINE void blend(const struct soft_row *row,
	const uint32_t *color, const uint16_t *before, const uint16_t *after,
	GLenum source, GLenum destination, bool wide)
{
	const uint32_t *end = color + row->count;
	uint8_t *pixel = row->pixel;
	uint32_t to;

	for (; color != end; color++, pixel += wide ? 4 : 2) {
		if (*before++ == *after++) {
			continue;
		}
		to = blend_colors(wide ? load_32(pixel) : load_565(pixel),
			*color, source, destination);
		if (wide) {
			memcpy(pixel, &to, sizeof(to));
		} else {
			store_565(pixel, to);
		}
	}
}

static ALWAYS_INLINE void blend_by_factors(const struct soft_row *row,
	const uint32_t *color, const uint16_t *before, const uint16_t *after,
	GLenum source, GLenum destination, bool wide)
{
	if (source == GL_DST_COLOR && destination == GL_ZERO) {
		source = GL_ZERO;
		destination = GL_SRC_COLOR;
	}
#define PAIR(s, d)                                                \
	if (source == (s) && destination == (d)) {                \
		blend(row, color, before, after, (s), (d), wide); \
		return;                                           \
	}
	PAIR(GL_SRC_ALPHA, GL_ONE)
	PAIR(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
	PAIR(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
	PAIR(GL_ZERO, GL_SRC_COLOR)
	PAIR(GL_ONE, GL_ONE_MINUS_SRC_COLOR)
#undef PAIR
	blend(row, color, before, after, source, destination, wide);
}

void soft_blend_row(const struct draw *draw, const struct soft_row *row,
	const uint8_t *color, const uint16_t *before, const uint16_t *after)
{
	const struct soft_fragment_stages *stages = &draw->spans.stages;
	const uint32_t *colors = (const uint32_t *)(const void *)color;
	GLenum source = stages->blend_source;
	GLenum destination = stages->blend_destination;

	if (draw->soft->format == PIXELS_RGBA8888) {
		blend_by_factors(
			row, colors, before, after, source, destination, true);
	} else {
		blend_by_factors(
			row, colors, before, after, source, destination, false);
	}
}
