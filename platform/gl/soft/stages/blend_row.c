#include "platform/gl/soft/stages/blend_row.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"

enum {
	SRC_ALPHA_SATURATE = 0x0308,
};

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
		return soft_scale_bytes(color, own);
	case GL_ONE_MINUS_SRC_ALPHA:
		return soft_scale_bytes(color, 255 - own);
	case GL_DST_ALPHA:
		return soft_scale_bytes(color, 255 - left);
	case GL_ONE_MINUS_DST_ALPHA:
		return soft_scale_bytes(color, left);
	case SRC_ALPHA_SATURATE:
		return (color & 0xFF000000) |
			(soft_scale_bytes(color, own < left ? own : left) &
				0x00FFFFFF);
	default:
		return color;
	}
}

static ALWAYS_INLINE void blend_8888(
	uint8_t *pixel, uint32_t from, GLenum source, GLenum destination)
{
	uint32_t to = load_32(pixel);
	uint32_t more = scale_by_factor(source, from, from, to);

	to = scale_by_factor(destination, to, from, to);
	to = BYTES_ADD_LIMITED(more, to);
	memcpy(pixel, &to, sizeof(to));
}

/* Red, and blue in the upper half; green. */
struct lanes {
	uint32_t red_blue, green;
};

/* Bytes times 0 to 256. */
static ALWAYS_INLINE struct lanes multiply(struct lanes a, struct lanes b)
{
	return (struct lanes){(uint32_t)HALVES_BB(a.red_blue, b.red_blue, 0) |
			(uint32_t)HALVES_TT(a.red_blue, b.red_blue, 0) << 16,
		a.green * b.green};
}

static ALWAYS_INLINE struct lanes multiply_by(struct lanes a, uint32_t by)
{
	return (struct lanes){a.red_blue * by, a.green * by};
}

/* 0 to 256 from bytes, and what 256 is more. */
static ALWAYS_INLINE struct lanes find_shares(struct lanes bytes)
{
	return (struct lanes){
		bytes.red_blue + (bytes.red_blue >> 7 & 0x00010001),
		bytes.green + (bytes.green >> 7)};
}

static ALWAYS_INLINE struct lanes find_rest(struct lanes bytes)
{
	struct lanes share = find_shares(bytes);

	return (struct lanes){0x01000100 - share.red_blue, 256 - share.green};
}

/* 256 times a colour's bytes times their factor; alpha is 0 to 256. */
static ALWAYS_INLINE struct lanes scale_lanes(GLenum factor, struct lanes color,
	struct lanes from, uint32_t alpha, struct lanes to)
{
	switch (factor) {
	case GL_ZERO:
		return (struct lanes){0, 0};
	case GL_SRC_COLOR:
		return multiply(color, find_shares(from));
	case GL_ONE_MINUS_SRC_COLOR:
		return multiply(color, find_rest(from));
	case GL_DST_COLOR:
		return multiply(color, find_shares(to));
	case GL_ONE_MINUS_DST_COLOR:
		return multiply(color, find_rest(to));
	case GL_SRC_ALPHA:
		return multiply_by(color, alpha);
	case GL_ONE_MINUS_SRC_ALPHA:
		return multiply_by(color, 256 - alpha);
	default:
		return multiply_by(color, 256);
	}
}

/*
 * Sums have RGB565's fields in the upper bits of 16: 31 is 31 * 2048 there, and
 * 255 * 256 of a fragment's bytes becomes that.
 */
static ALWAYS_INLINE void blend_565(
	uint8_t *pixel, uint32_t color, GLenum source, GLenum destination)
{
	const uint32_t old = load_16(pixel), alpha = color >> 24;
	const uint32_t share = alpha + (alpha >> 7);
	const struct lanes from = {BYTES_AS_HALVES(color), color >> 8 & 255};
	const struct lanes to = {
		((old & 0xF800) | old << 27) >> 8, (old & 0x07E0) >> 3};
	const struct lanes to_byte = {
		to.red_blue | (to.red_blue >> 5 & 0x00070007),
		to.green | to.green >> 6};
	struct lanes more = scale_lanes(source, from, from, share, to_byte);
	struct lanes sum = scale_lanes(destination, to, from, share, to_byte);

	more.red_blue -= more.red_blue >> 5 & 0x07FF07FF;
	more.green -= more.green >> 6;
	sum.red_blue = HALVES_ADD_LIMITED(sum.red_blue, more.red_blue);
	sum.red_blue = HALVES_ADD_LIMITED(sum.red_blue, 0x04000400);
	sum.green = HALVES_ADD_LIMITED(sum.green, more.green);
	sum.green = HALVES_ADD_LIMITED(sum.green, 0x0200);
	store_16(pixel,
		(uint16_t)((sum.red_blue & 0xF800) | sum.red_blue >> 27 |
			sum.green >> 10 << 5));
}

/* The loop for two factors: a function of its own where they are constants. */
static ALWAYS_INLINE void blend(const struct soft_row *row,
	const uint32_t *color, const uint16_t *before, const uint16_t *after,
	GLenum source, GLenum destination, bool wide)
{
	const uint32_t *end = color + row->count;
	uint8_t *pixel = row->pixel;

	for (; color != end; color++, pixel += wide ? 4 : 2) {
		if (*before++ == *after++) {
			continue;
		}
		if (wide) {
			blend_8888(pixel, *color, source, destination);
		} else {
			blend_565(pixel, *color, source, destination);
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
