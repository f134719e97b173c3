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
	/* GL_ONE_MINUS_ factors have odd numbers */
	const uint32_t invert = factor & 1 ? UINT32_MAX : 0;
	const soft_word own = from >> 24, left = 255 - (to >> 24);

	switch (factor) {
	case GL_ZERO:
		return zero;
	case GL_SRC_COLOR:
	case GL_ONE_MINUS_SRC_COLOR:
		return soft_multiply_bytes(color, from ^ invert);
	case GL_ONE_MINUS_DST_COLOR:
	case GL_DST_COLOR:
		return soft_multiply_bytes(color, to ^ invert);
	case GL_SRC_ALPHA:
	case GL_ONE_MINUS_SRC_ALPHA:
		return soft_scale_bytes(color, (from ^ invert) >> 24);
	case GL_DST_ALPHA:
	case GL_ONE_MINUS_DST_ALPHA:
		return soft_scale_bytes(color, (to ^ invert) >> 24);
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
		soft_word from, old, to;

		if (copied) {
			at = memcpy(tail, pixel, bytes);
		}
		if (!soft_all(unseen)) {
			from = soft_get_words(color);
			old = wide ? soft_get_words(at) : load_565(at);
			to = BYTES_ADD_LIMITED(
				scale_by_factor(source, from, from, old),
				scale_by_factor(destination, old, from, old));
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

void soft_blend_row(const struct draw *draw, const struct soft_row *row,
	const uint8_t *color, const uint16_t *before, const uint16_t *after)
{
	const bool wide = draw->soft->format == PIXELS_RGBA8888;
	const uint32_t *colors = (const uint32_t *)(const void *)color;
	GLenum source = draw->spans.stages.blend_source;
	GLenum destination = draw->spans.stages.blend_destination;

	if (source == GL_DST_COLOR && destination == GL_ZERO) {
		source = GL_ZERO;
		destination = GL_SRC_COLOR;
	}
#define BLEND(s, d)                                                 \
	if (wide) {                                                 \
		blend(row, colors, before, after, (s), (d), true);  \
	} else {                                                    \
		blend(row, colors, before, after, (s), (d), false); \
	}
#define PAIR(s, d)                                 \
	if (source == (s) && destination == (d)) { \
		BLEND(s, d)                        \
		return;                            \
	}
	PAIR(GL_SRC_ALPHA, GL_ONE)
	PAIR(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
	PAIR(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
	PAIR(GL_ZERO, GL_SRC_COLOR)
	PAIR(GL_ONE, GL_ONE_MINUS_SRC_COLOR)
#undef PAIR
	BLEND(source, destination)
#undef BLEND
}
