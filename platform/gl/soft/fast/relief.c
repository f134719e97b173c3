/*
 * Spans of what relief is drawn in, into RGB565: a normal map by the light in
 * the primary colour, then two passes over the same depth that multiply with
 * what is there and add to it. Bilinear RGB565 textures that repeat. The stages
 * are those of fragment.c, a fragment at a time.
 */
#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/number.h"

enum relief_kind {
	RELIEF_NONE,
	RELIEF_LIGHT,
	RELIEF_TINT,
	RELIEF_REST,
};

/* Red, green and blue, 0 to 255. */
struct rgb {
	int32_t red, green, blue;
};

/* Where a span lies in a level, 16.16 of its texels. */
struct place_in_level {
	const uint16_t *texels;
	uint32_t s, t;
	int32_t s_right, t_right;
	uint32_t s_mask, t_mask;
	int log2;
};

static struct place_in_level find_place(
	const struct texture_input *input, const struct span *span)
{
	int number = clamp_int((span->lod[0] + 127) >> 8, 0, input->levels - 1);
	const struct level *level = &input->texture->level[number];
	int s_down = input->width_log2 - level->width_log2;
	int t_down = input->height_log2 - level->height_log2;

	return (struct place_in_level){
		.texels = (const uint16_t *)(const void *)level->texels,
		.s = (uint32_t)((int32_t)span->value[TEX_S] >> s_down) - 32768,
		.t = (uint32_t)((int32_t)span->value[TEX_S + 1] >> t_down) -
			32768,
		.s_right = span->step[TEX_S] >> s_down,
		.t_right = span->step[TEX_S + 1] >> t_down,
		.s_mask = (1u << level->width_log2) - 1,
		.t_mask = (1u << level->height_log2) - 1,
		.log2 = level->width_log2,
	};
}

/* Red in the upper half, blue in the lower. */
static ALWAYS_INLINE uint32_t red_blue(uint32_t texel)
{
	return (texel & 0xF800) << 5 | (texel & 31);
}

static ALWAYS_INLINE uint32_t mix_32(uint32_t a, uint32_t b, uint32_t share)
{
	return (a << 5) + (b - a) * share;
}

/*
 * By 32nds. Both halves are mixed at once; what one borrows from the other the
 * sum gives back. They have 10 bits more then, of 16.
 */
static ALWAYS_INLINE struct rgb sample(const struct place_in_level *place)
{
	uint32_t across = place->s >> 11 & 31, down = place->t >> 11 & 31;
	uint32_t x0 = place->s >> 16 & place->s_mask;
	uint32_t x1 = (x0 + 1) & place->s_mask;
	uint32_t y0 = place->t >> 16 & place->t_mask;
	uint32_t y1 = (y0 + 1) & place->t_mask;
	const uint16_t *row = place->texels + (y0 << place->log2);
	const uint16_t *next = place->texels + (y1 << place->log2);
	uint32_t a = row[x0], b = row[x1], c = next[x0], d = next[x1];
	uint32_t outer = mix_32(mix_32(red_blue(a), red_blue(b), across),
		mix_32(red_blue(c), red_blue(d), across), down);
	uint32_t green = mix_32(mix_32(a >> 5 & 63, b >> 5 & 63, across),
		mix_32(c >> 5 & 63, d >> 5 & 63, across), down);

	/* 255 / 31 and 255 / 63, over 1024 */
	return (struct rgb){
		.red = (int32_t)(((outer >> 16) * 16846 + (1 << 20)) >> 21),
		.green = (int32_t)((green * 8290 + (1 << 20)) >> 21),
		.blue = (int32_t)(((outer & 0xFFFF) * 16846 + (1 << 20)) >> 21),
	};
}

/* 4 times the sum of (a - 1/2)(b - 1/2), as combine.c has it. */
static ALWAYS_INLINE uint16_t find_light(struct rgb texel, struct rgb color)
{
	int sum = (2 * texel.red - 255) * (2 * color.red - 255) +
		(2 * texel.green - 255) * (2 * color.green - 255) +
		(2 * texel.blue - 255) * (2 * color.blue - 255);
	int value = sum <= 0 ? 0 : (sum * 257 + 257) >> 16;

	value = value > 255 ? 255 : value;
	return pack_565(value, value, value);
}

/* a b / 255 of bytes, rounded; or of one with fewer bits. */
static ALWAYS_INLINE int32_t scale(int32_t a, int32_t b)
{
	return (a * b * 257 + 32768) >> 16;
}

static ALWAYS_INLINE struct rgb modulate(struct rgb a, struct rgb b)
{
	return (struct rgb){scale(a.red, b.red), scale(a.green, b.green),
		scale(a.blue, b.blue)};
}

static ALWAYS_INLINE uint16_t multiply(uint16_t pixel, struct rgb own)
{
	return (uint16_t)(scale(pixel >> 11, own.red) << 11 |
		scale(pixel >> 5 & 63, own.green) << 5 |
		scale(pixel & 31, own.blue));
}

static ALWAYS_INLINE int32_t at_most(int32_t value, int32_t most)
{
	return value < most ? value : most;
}

static ALWAYS_INLINE uint16_t add(uint16_t pixel, struct rgb own)
{
	uint16_t more = pack_565(own.red, own.green, own.blue);

	return (uint16_t)(at_most((pixel >> 11) + (more >> 11), 31) << 11 |
		at_most((pixel >> 5 & 63) + (more >> 5 & 63), 63) << 5 |
		at_most((pixel & 31) + (more & 31), 31));
}

static ALWAYS_INLINE uint16_t shade(enum relief_kind kind, uint16_t pixel,
	struct rgb texel, struct rgb color)
{
	if (kind == RELIEF_LIGHT) {
		return find_light(texel, color);
	}
	texel = modulate(texel, color);
	return kind == RELIEF_TINT ? multiply(pixel, texel) : add(pixel, texel);
}

static ALWAYS_INLINE void draw_fragments(
	struct draw *draw, const struct span *span, enum relief_kind kind)
{
	const struct buffers *buffers = &draw->soft->buffers;
	struct place_in_level place = find_place(&draw->texture[0], span);
	uint16_t *pixel = (uint16_t *)(void *)pixel_at(
		&buffers->target, span->x, span->y);
	uint16_t *depth = buffers->depth +
		(size_t)span->y * (size_t)buffers->width + span->x;
	uint32_t z = span->value[DEPTH], red = span->value[RED];
	uint32_t green = span->value[GREEN], blue = span->value[BLUE];

	for (int i = 0; i < span->count; i++) {
		uint32_t own = z >> 10;

		if (kind == RELIEF_LIGHT ? own < depth[i] : own == depth[i]) {
			depth[i] = (uint16_t)own;
			pixel[i] = shade(kind, pixel[i], sample(&place),
				(struct rgb){(int32_t)(red >> 16 & 255),
					(int32_t)(green >> 16 & 255),
					(int32_t)(blue >> 16 & 255)});
		}
		z += (uint32_t)span->step[DEPTH];
		red += (uint32_t)span->step[RED];
		green += (uint32_t)span->step[GREEN];
		blue += (uint32_t)span->step[BLUE];
		place.s += (uint32_t)place.s_right;
		place.t += (uint32_t)place.t_right;
	}
}

static void draw_light(struct draw *draw, const struct span *span)
{
	draw_fragments(draw, span, RELIEF_LIGHT);
}

static void draw_tint(struct draw *draw, const struct span *span)
{
	draw_fragments(draw, span, RELIEF_TINT);
}

static void draw_rest(struct draw *draw, const struct span *span)
{
	draw_fragments(draw, span, RELIEF_REST);
}

static enum relief_kind find_kind(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct texenv *env = draw->texture[0].env;
	bool equal = state->depth_function == GL_EQUAL &&
		env->mode == GL_MODULATE && draw->blended;

	if (state->depth_function == GL_LESS && state->depth_mask &&
		!draw->blended && soft_is_plain_dot(env)) {
		return RELIEF_LIGHT;
	}
	if (equal && state->blend_source == GL_DST_COLOR &&
		state->blend_destination == GL_ZERO) {
		return RELIEF_TINT;
	}
	if (equal && state->blend_source == GL_ONE &&
		state->blend_destination == GL_ONE) {
		return RELIEF_REST;
	}
	return RELIEF_NONE;
}

static bool takes_texture(const struct texture_input *input)
{
	const struct texture *texture = input->texture;

	return input->base->format == TEXEL_565 &&
		texture->mag_filter == GL_LINEAR &&
		(texture->min_filter == GL_LINEAR ||
			texture->min_filter == GL_LINEAR_MIPMAP_NEAREST) &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT;
}

span_function soft_relief_choose_span(const struct draw *draw)
{
	static const span_function function[] = {
		[RELIEF_NONE] = NULL,
		[RELIEF_LIGHT] = draw_light,
		[RELIEF_TINT] = draw_tint,
		[RELIEF_REST] = draw_rest,
	};
	const struct fragment_state *state = &draw->soft->fragment;
	const GLboolean *mask = state->color_mask;

	if (draw->soft->format != PIXELS_RGB565 || draw->fogged ||
		state->alpha_test || state->stencil.enabled ||
		!state->depth_test || !draw->texture[0].used ||
		draw->texture[1].used || !mask[0] || !mask[1] || !mask[2] ||
		!takes_texture(&draw->texture[0])) {
		return NULL;
	}
	return function[find_kind(draw)];
}
