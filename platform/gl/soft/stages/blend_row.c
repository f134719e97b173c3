#include "platform/gl/soft/stages/blend_row.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"

enum {
	SRC_ALPHA_SATURATE = 0x0308,
};

/* RGB565 has no alpha: it reads as 255. */
static ALWAYS_INLINE uint32_t widen_pixel(uint32_t p)
{
	uint32_t r = p >> 11, g = p >> 5 & 63, b = p & 31;

	return r << 3 | r >> 2 | (g << 2 | g >> 4) << 8 |
		(b << 3 | b >> 2) << 16 | 0xFF000000;
}

static ALWAYS_INLINE uint32_t load(bool wide, const uint8_t *pixel)
{
	return wide ? load_32(pixel) : widen_pixel(load_16(pixel));
}

static ALWAYS_INLINE void store(bool wide, uint8_t *pixel, uint32_t color)
{
	if (wide) {
		memcpy(pixel, &color, sizeof(color));
	} else {
		store_16(pixel,
			pack_565((int)(color & 255), (int)(color >> 8 & 255),
				(int)(color >> 16 & 255)));
	}
}

/* All four bytes times one. */
static ALWAYS_INLINE uint32_t scale(uint32_t color, uint32_t by)
{
#ifdef HAS_COLOR_VECTORS
	return vector_multiply(color, by * 0x01010101);
#else
	const uint32_t half = 0x00800080;

	return soft_divide_lanes(BYTES_AS_HALVES(color) * by + half) |
		soft_divide_lanes(ODD_BYTES_AS_HALVES(color) * by + half) << 8;
#endif
}

/* A colour times its factor. */
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
		return scale(color, own);
	case GL_ONE_MINUS_SRC_ALPHA:
		return scale(color, 255 - own);
	case GL_DST_ALPHA:
		return scale(color, 255 - left);
	case GL_ONE_MINUS_DST_ALPHA:
		return scale(color, left);
	case SRC_ALPHA_SATURATE:
		return (color & 0xFF000000) |
			(scale(color, own < left ? own : left) & 0x00FFFFFF);
	default:
		return color;
	}
}

/* The loop for two factors: a function of its own where they are constants. */
static ALWAYS_INLINE void blend(const struct soft_run *run,
	const uint32_t *color, const uint16_t *drawn, GLenum source,
	GLenum destination, bool wide)
{
	const uint32_t *end = color + run->row.count;
	uint8_t *pixel = run->row.pixel;

	for (; color != end; color++, drawn++, pixel += wide ? 4 : 2) {
		if (*drawn == 1) {
			uint32_t from = *color, to = load(wide, pixel);
			uint32_t more = scale_by_factor(source, from, from, to);

			to = scale_by_factor(destination, to, from, to);
			store(wide, pixel, BYTES_ADD_LIMITED(more, to));
		}
	}
}

static ALWAYS_INLINE void blend_by_factors(const struct soft_run *run,
	const uint32_t *color, const uint16_t *drawn, bool wide)
{
	GLenum source = run->stages->blend_source;
	GLenum destination = run->stages->blend_destination;

	if (source == GL_SRC_ALPHA && destination == GL_ONE) {
		blend(run, color, drawn, GL_SRC_ALPHA, GL_ONE, wide);
	} else if (source == GL_SRC_ALPHA &&
		destination == GL_ONE_MINUS_SRC_ALPHA) {
		blend(run, color, drawn, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
			wide);
	} else if (source == GL_ONE && destination == GL_ONE_MINUS_SRC_ALPHA) {
		blend(run, color, drawn, GL_ONE, GL_ONE_MINUS_SRC_ALPHA, wide);
	} else if (source == GL_ONE && destination == GL_ONE) {
		blend(run, color, drawn, GL_ONE, GL_ONE, wide);
	} else {
		blend(run, color, drawn, source, destination, wide);
	}
}

void soft_blend_row(const struct soft_run *run, const uint32_t *color,
	const uint16_t *drawn)
{
	if (run->draw->soft->format == PIXELS_RGBA8888) {
		blend_by_factors(run, color, drawn, true);
	} else {
		blend_by_factors(run, color, drawn, false);
	}
}
