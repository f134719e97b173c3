#define SOFT_BY_FOUR

#include "platform/gl/soft/stages/made.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"

/* A colour times a blend factor; from is the source, to the destination. */
static ALWAYS_INLINE soft_word scale_by_factor(
	GLenum factor, soft_word color, soft_word from, soft_word to)
{
	const soft_word zero = {0};
	soft_word own = from >> 24, left = 255 - (to >> 24);

	switch (factor) {
	case GL_ZERO:
		return zero;
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
			(soft_scale_bytes(
				 color, own - BYTES_LESS_LIMITED(own, left)) &
				0x00FFFFFF);
	default:
		return color;
	}
}

/* A pixel of RGB565 as RGBA8888, as load_pixel() expands it. */
static ALWAYS_INLINE soft_word load_565(const void *pixel)
{
	const soft_word old = soft_get_halves(pixel);
	const soft_word red_blue = ((old & 0xF800) | old << 27) >> 8;
	const soft_word green = (old & 0x07E0) << 5;

	return 0xFF000000 | red_blue | (red_blue >> 5 & 0x00070007) | green |
		(green >> 6 & 0x0300);
}

/* pack_565() of a colour; red and blue are packed in one word. */
static ALWAYS_INLINE soft_word narrow_565(soft_word color)
{
	const soft_word red_blue = BYTES_AS_HALVES(color) * 249 + 1014 * 0x10001;
	const soft_word green = (color >> 8 & 255) * 253 + 505;

	return (red_blue & 0xF800) | green >> 10 << 5 | red_blue >> 27;
}

static ALWAYS_INLINE soft_word blend_colors(
	soft_word to, soft_word from, GLenum source, GLenum destination)
{
	return BYTES_ADD_LIMITED(scale_by_factor(source, from, from, to),
		scale_by_factor(destination, to, from, to));
}

/* Blends a row; inlined with constant factors for the common ones. */
static ALWAYS_INLINE void blend(const struct soft_row *row,
	const uint32_t *color, const uint16_t *before, const uint16_t *after,
	GLenum source, GLenum destination, bool wide)
{
	const size_t pixel_bytes = wide ? 4 : 2;
	uint8_t *pixel = row->pixel;
	uint32_t tail[SOFT_LANES] = {0};

	for (int left = (int)row->count; left > 0; left -= SOFT_LANES) {
		const size_t bytes = (size_t)left * pixel_bytes;
		const bool copied = left < SOFT_LANES;
		const soft_word unseen = (soft_word)(soft_get_halves(before) ==
			soft_get_halves(after));
		void *at = pixel;
		soft_word old, to;

		if (copied) {
			at = memcpy(tail, pixel, bytes);
		}
		if (!soft_all(unseen)) {
			old = wide ? soft_get_words(at) : load_565(at);
			to = blend_colors(old, soft_get_words(color), source,
				destination);
			if (wide) {
				soft_put_words(at, soft_choose(unseen, old, to));
			} else {
				soft_put_halves(at,
					soft_choose(unseen, soft_get_halves(at),
						narrow_565(to)));
			}
		}
		if (copied) {
			memcpy(pixel, at, bytes);
		}
		before += SOFT_LANES;
		after += SOFT_LANES;
		color += SOFT_LANES;
		pixel += SOFT_LANES * pixel_bytes;
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
