/*
 * Spans of what limber draws most into RGB565: one texture or none, modulated,
 * opaque or blended by alpha. The stages are those of fragment.c; colours stay
 * packed, red and blue with room between them and green above, so that one
 * multiplication scales all three in steps of 1/32.
 */
#include "platform/gl/soft/number.h"
#include "platform/gl/soft/pixel.h"
#include "platform/gl/soft/raster.h"

enum {
	/* Half of 1/32, so that 255 is 32/32. */
	SHARE_ROUND = 4 << 16,
};

/* What the stages hand on. */
struct wide_span {
	uint32_t color[SPAN_PIXELS]; /* wide */
	uint8_t alpha[SPAN_PIXELS];  /* 0..32 */
	bool passes[SPAN_PIXELS];
};

/* Depth LESS alone; how many pass. */
static int test_less(const struct draw *draw, const struct span *span,
	bool write, bool *passes)
{
	const struct buffers *buffers = &draw->soft->buffers;
	uint16_t *depth = buffers->depth +
		(size_t)span->y * (size_t)buffers->width + span->x;
	uint32_t z = span->value[DEPTH];
	int left = 0;

	for (int i = 0; i < span->count; i++) {
		uint32_t own = z >> 10;

		passes[i] = own < depth[i];
		if (passes[i]) {
			left++;
			if (write) {
				depth[i] = (uint16_t)own;
			}
		}
		z += (uint32_t)span->step[DEPTH];
	}
	return left;
}

static ALWAYS_INLINE uint32_t texel_wide(
	const struct level *level, int x, int y, uint32_t *alpha)
{
	uint32_t at = ((uint32_t)y << level->width_log2) + (uint32_t)x;
	uint32_t texel;

	if (level->format == TEXEL_A8) {
		*alpha = (level->texels[at] + 4u) >> 3;
		return WIDE_MASK;
	}
	texel = load_16(level->texels + 2 * at);
	if (level->format == TEXEL_4444) {
		uint32_t a = texel & 15;

		*alpha = a * 2 + (a >> 3) + (a == 15);
		texel = (texel & 0xF000) | (texel >> 4 & 0x0800) |
			(texel >> 1 & 0x0780) | (texel >> 5 & 0x0060) |
			(texel >> 3 & 0x001E) | (texel >> 7 & 1);
	} else {
		*alpha = 32;
	}
	return widen(texel);
}

static ALWAYS_INLINE int wrap(bool repeat, int at, int last)
{
	return repeat ? at & last : at < 0 ? 0 : at > last ? last : at;
}

/* Where a span lies in a level. */
struct walk {
	const struct level *level;
	uint32_t s, t;
	int32_t ds, dt;
	bool repeat_s, repeat_t;
	int last_s, last_t;
};

static void sample_nearest(
	const struct walk *walk, int count, struct wide_span *out)
{
	uint32_t s = walk->s, t = walk->t;

	for (int i = 0; i < count; i++) {
		uint32_t alpha;

		out->color[i] = texel_wide(walk->level,
			wrap(walk->repeat_s, (int32_t)s >> 16, walk->last_s),
			wrap(walk->repeat_t, (int32_t)t >> 16, walk->last_t),
			&alpha);
		out->alpha[i] = (uint8_t)alpha;
		s += (uint32_t)walk->ds;
		t += (uint32_t)walk->dt;
	}
}

static void sample_linear(
	const struct walk *walk, int count, struct wide_span *out)
{
	const struct level *level = walk->level;
	uint32_t s = walk->s - 32768, t = walk->t - 32768;

	for (int i = 0; i < count; i++) {
		int32_t x = (int32_t)s >> 16, y = (int32_t)t >> 16;
		int x0 = wrap(walk->repeat_s, x, walk->last_s);
		int x1 = wrap(walk->repeat_s, x + 1, walk->last_s);
		int y0 = wrap(walk->repeat_t, y, walk->last_t);
		int y1 = wrap(walk->repeat_t, y + 1, walk->last_t);
		uint32_t across = s >> 11 & 31, down = t >> 11 & 31;
		uint32_t a[4];
		uint32_t above = mix_wide(texel_wide(level, x0, y0, &a[0]),
			texel_wide(level, x1, y0, &a[1]), across);
		uint32_t below = mix_wide(texel_wide(level, x0, y1, &a[2]),
			texel_wide(level, x1, y1, &a[3]), across);

		out->color[i] = mix_wide(above, below, down);
		out->alpha[i] =
			(uint8_t)(((a[0] * (32 - across) + a[1] * across) *
						  (32 - down) +
					  (a[2] * (32 - across) + a[3] * across) *
						  down +
					  512) >>
				10);
		s += (uint32_t)walk->ds;
		t += (uint32_t)walk->dt;
	}
}

/* RGB565 that repeats, as floors and most skins do. */
static void sample_linear_565(
	const struct walk *walk, int count, struct wide_span *out)
{
	const uint8_t *texels = walk->level->texels;
	const int log2 = walk->level->width_log2;
	const uint32_t mask_s = (uint32_t)walk->last_s;
	const uint32_t mask_t = (uint32_t)walk->last_t;
	uint32_t s = walk->s - 32768, t = walk->t - 32768;

	for (int i = 0; i < count; i++) {
		uint32_t x0 = s >> 16 & mask_s, x1 = (x0 + 1) & mask_s;
		uint32_t y0 = t >> 16 & mask_t;
		const uint8_t *row = texels + (y0 << log2) * 2;
		const uint8_t *next = texels + (((y0 + 1) & mask_t) << log2) * 2;
		uint32_t across = s >> 11 & 31;
		uint32_t above = mix_wide(widen(load_16(row + 2 * x0)),
			widen(load_16(row + 2 * x1)), across);
		uint32_t below = mix_wide(widen(load_16(next + 2 * x0)),
			widen(load_16(next + 2 * x1)), across);

		out->color[i] = mix_wide(above, below, t >> 11 & 31);
		s += (uint32_t)walk->ds;
		t += (uint32_t)walk->dt;
	}
	memset(out->alpha, 32, (size_t)count);
}

static bool is_linear(GLenum filter)
{
	return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST;
}

static void sample(const struct texture_input *input, const struct span *span,
	struct wide_span *out)
{
	const struct texture *texture = input->texture;
	int lod = span->lod[0];
	bool small = lod > 0;
	int number =
		small ? clamp_int((lod + 127) >> 8, 0, input->levels - 1) : 0;
	bool linear =
		is_linear(small ? texture->min_filter : texture->mag_filter);
	const struct level *level = &texture->level[number];
	int down_s = input->width_log2 - level->width_log2;
	int down_t = input->height_log2 - level->height_log2;
	struct walk walk = {
		.level = level,
		.s = (uint32_t)((int32_t)span->value[TEX_S] >> down_s),
		.t = (uint32_t)((int32_t)span->value[TEX_S + 1] >> down_t),
		.ds = span->step[TEX_S] >> down_s,
		.dt = span->step[TEX_S + 1] >> down_t,
		.repeat_s = texture->wrap_s == GL_REPEAT,
		.repeat_t = texture->wrap_t == GL_REPEAT,
		.last_s = (1 << level->width_log2) - 1,
		.last_t = (1 << level->height_log2) - 1,
	};

	if (!linear) {
		sample_nearest(&walk, span->count, out);
	} else if (level->format == TEXEL_565 && walk.repeat_s && walk.repeat_t) {
		sample_linear_565(&walk, span->count, out);
	} else {
		sample_linear(&walk, span->count, out);
	}
}

static bool is_constant(const struct span *span, int first, int count)
{
	int32_t all = 0;

	for (int i = 0; i < count; i++) {
		all |= span->step[first + i];
	}
	return all == 0;
}

static void fill_colors(const struct span *span, struct wide_span *out)
{
	uint32_t r = span->value[RED], g = span->value[GREEN];
	uint32_t b = span->value[BLUE];

	for (int i = 0; i < span->count; i++) {
		out->color[i] = widen_color(r, g, b);
		r += (uint32_t)span->step[RED];
		g += (uint32_t)span->step[GREEN];
		b += (uint32_t)span->step[BLUE];
	}
	memset(out->alpha, 32, (size_t)span->count);
}

static bool is_gray(const struct span *span)
{
	return span->value[RED] == span->value[GREEN] &&
		span->value[RED] == span->value[BLUE] &&
		span->step[RED] == span->step[GREEN] &&
		span->step[RED] == span->step[BLUE];
}

static void modulate_gray(const struct span *span, struct wide_span *out)
{
	uint32_t share = span->value[RED] + SHARE_ROUND;

	if (share >> 19 == 32 && span->step[RED] == 0) {
		return;
	}
	for (int i = 0; i < span->count; i++) {
		out->color[i] =
			(out->color[i] * (share >> 19) + WIDE_ROUND) >> 5 &
			WIDE_MASK;
		share += (uint32_t)span->step[RED];
	}
}

static void modulate_tinted(const struct span *span, struct wide_span *out)
{
	uint32_t r = span->value[RED] + SHARE_ROUND;
	uint32_t g = span->value[GREEN] + SHARE_ROUND;
	uint32_t b = span->value[BLUE] + SHARE_ROUND;

	for (int i = 0; i < span->count; i++) {
		uint32_t c = out->color[i];

		out->color[i] =
			(((c & 0xF800) * (r >> 19) + 0x8000) >> 5 & 0xF800) |
			((c >> 21) * (g >> 19) + 16) >> 5 << 21 |
			((c & 31) * (b >> 19) + 16) >> 5;
		r += (uint32_t)span->step[RED];
		g += (uint32_t)span->step[GREEN];
		b += (uint32_t)span->step[BLUE];
	}
}

static void modulate_alpha(const struct span *span, struct wide_span *out)
{
	uint32_t a = span->value[ALPHA] + SHARE_ROUND;

	if (a >> 19 == 32 && span->step[ALPHA] == 0) {
		return;
	}
	for (int i = 0; i < span->count; i++) {
		out->alpha[i] = (uint8_t)(out->alpha[i] * (a >> 19) >> 5);
		a += (uint32_t)span->step[ALPHA];
	}
}

/* The three of a floor: its shade, its fading, and the mix with the picture. */
static void write_shaded(
	const struct span *span, const struct wide_span *in, uint16_t *pixel)
{
	uint32_t share = span->value[RED] + SHARE_ROUND;
	uint32_t alpha = span->value[ALPHA] + SHARE_ROUND;

	for (int i = 0; i < span->count; i++) {
		if (in->passes[i]) {
			uint32_t own =
				(in->color[i] * (share >> 19) + WIDE_ROUND) >> 5 &
				WIDE_MASK;

			pixel[i] = narrow(
				mix_wide(widen(pixel[i]), own, alpha >> 19));
		}
		share += (uint32_t)span->step[RED];
		alpha += (uint32_t)span->step[ALPHA];
	}
}

static void write_opaque(const struct wide_span *in, int count, uint16_t *pixel)
{
	for (int i = 0; i < count; i++) {
		if (in->passes[i]) {
			pixel[i] = narrow(in->color[i]);
		}
	}
}

static void write_blended(const struct wide_span *in, int count, uint16_t *pixel)
{
	for (int i = 0; i < count; i++) {
		uint32_t alpha = in->alpha[i];

		if (!in->passes[i] || alpha == 0) {
			continue;
		}
		pixel[i] = alpha == 32
			? narrow(in->color[i])
			: narrow(mix_wide(widen(pixel[i]), in->color[i], alpha));
	}
}

static void fill_constant(const struct span *span, uint16_t *pixel)
{
	uint16_t value = narrow(widen_color(
		span->value[RED], span->value[GREEN], span->value[BLUE]));
	uint16_t *const end = pixel + span->count;

	for (; end - pixel >= 4; pixel += 4) {
		pixel[0] = value;
		pixel[1] = value;
		pixel[2] = value;
		pixel[3] = value;
	}
	while (pixel < end) {
		*pixel++ = value;
	}
}

void soft_draw_span_565(struct draw *draw, const struct span *span)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct pixels *target = &draw->soft->buffers.target;
	uint16_t *pixel = (uint16_t *)(void *)pixel_at(target, span->x, span->y);
	bool textured = draw->texture[0].used;
	struct wide_span wide;

	if (draw->tests) {
		int left = state->stencil.enabled
			? soft_test_span(draw, span, wide.passes)
			: test_less(draw, span, state->depth_mask, wide.passes);

		if (left == 0 || !draw->color_written) {
			return;
		}
	} else if (!draw->color_written) {
		return;
	} else if (!textured && !draw->blended && is_constant(span, RED, 3)) {
		fill_constant(span, pixel);
		return;
	} else {
		memset(wide.passes, true, (size_t)span->count);
	}
	if (!textured) {
		fill_colors(span, &wide);
	} else {
		sample(&draw->texture[0], span, &wide);
		if (draw->blended && is_gray(span) &&
			draw->texture[0].base->format == TEXEL_565) {
			write_shaded(span, &wide, pixel);
			return;
		}
		if (is_gray(span)) {
			modulate_gray(span, &wide);
		} else {
			modulate_tinted(span, &wide);
		}
	}
	if (draw->blended) {
		modulate_alpha(span, &wide);
		write_blended(&wide, span->count, pixel);
	} else {
		write_opaque(&wide, span->count, pixel);
	}
}

static bool takes_texture(const struct texture_input *input)
{
	const struct level *base = input->base;
	GLenum min = input->texture->min_filter;

	return input->env->mode == GL_MODULATE &&
		min != GL_NEAREST_MIPMAP_LINEAR &&
		min != GL_NEAREST_MIPMAP_NEAREST &&
		min != GL_LINEAR_MIPMAP_LINEAR &&
		(base->format == TEXEL_565 || base->format == TEXEL_4444 ||
			base->format == TEXEL_A8);
}

bool soft_takes_span_565(const struct draw *draw)
{
	const struct soft *soft = draw->soft;
	const struct fragment_state *state = &soft->fragment;
	const GLboolean *mask = state->color_mask;
	bool by_alpha = state->blend_source == GL_SRC_ALPHA &&
		state->blend_destination == GL_ONE_MINUS_SRC_ALPHA;

	return soft->format == PIXELS_RGB565 && !draw->fogged &&
		!state->alpha_test && (!draw->blended || by_alpha) &&
		(!draw->color_written || (mask[0] && mask[1] && mask[2])) &&
		(!state->depth_test || state->stencil.enabled ||
			state->depth_function == GL_LESS) &&
		!draw->texture[1].used &&
		(!draw->texture[0].used || takes_texture(&draw->texture[0]));
}
