/*
 * Fragments in any state, a span at a time through stages: tests, colour,
 * textures, fog, blending, writing (GL ES 1.1 chapters 3 and 4).
 */
#include "tests/support/soft/reference.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/vertex/number.h"

/* The fragments of a span, as one stage leaves them to the next. */
struct fragments {
	uint8_t color[REFERENCE_PIXELS][4];
	uint16_t alpha_q7[REFERENCE_PIXELS]; /* interpolated, untextured */
	bool passes[REFERENCE_PIXELS];
	int left; /* how many still pass */
};

static uint8_t apply_stencil(
	const struct stencil *stencil, GLenum action, uint8_t old)
{
	uint8_t value = old;

	switch (action) {
	case GL_ZERO:
		value = 0;
		break;
	case GL_REPLACE:
		value = stencil->reference;
		break;
	case GL_INCR:
		value = old < 255 ? (uint8_t)(old + 1) : old;
		break;
	case GL_DECR:
		value = old > 0 ? (uint8_t)(old - 1) : old;
		break;
	case GL_INVERT:
		value = (uint8_t)~old;
		break;
	default:
		break;
	}
	return (uint8_t)((old & ~stencil->write_mask) |
		(value & stencil->write_mask));
}

/*
 * The stencil test of a fragment, with what it writes. near: the fragment
 * passes the depth test.
 */
static bool test_stencil(const struct stencil *s, bool near, uint8_t *stencil)
{
	bool through = soft_compares(
		s->function, s->reference & s->mask, *stencil & s->mask);
	GLenum action = !through ? s->fail : near ? s->pass : s->depth_fail;

	*stencil = apply_stencil(s, action, *stencil);
	return through;
}

/* The stencil and depth tests of one fragment, and what they write. */
static bool test_fragment(const struct draw *draw, size_t place, uint16_t z)
{
	const struct fragment_state *state = &draw->soft->fragment;
	uint8_t *stencil = draw->soft->buffers.stencil;
	uint16_t *depth = draw->soft->buffers.depth + place;
	bool near = !state->depth_test ||
		soft_compares(state->depth_function, z, *depth);

	if (state->stencil.enabled && stencil) {
		near &= test_stencil(&state->stencil, near, stencil + place);
	}
	if (near && state->depth_test && state->depth_mask) {
		*depth = z;
	}
	return near;
}

static void run_tests(const struct draw *draw, const struct span *span,
	struct fragments *fragments)
{
	const size_t row = (size_t)span->y * (size_t)draw->soft->buffers.width;

	for (int i = 0; i < span->count; i++) {
		uint32_t z = span->value[DEPTH] +
			(uint32_t)span->step[DEPTH] * (uint32_t)i;

		if (fragments->passes[i]) {
			fragments->passes[i] =
				test_fragment(draw, row + (size_t)(span->x + i),
					(uint16_t)(z << 6 >> 16));
			fragments->left -= !fragments->passes[i];
		}
	}
}

static void fill_colors(const struct span *span, struct fragments *fragments)
{
	/* Q8.8, as the driver's runs of combined colours have them. */
	uint32_t c[3] = {span->value[RED] >> 8, span->value[GREEN] >> 8,
		span->value[BLUE] >> 8};
	uint32_t alpha_q7 = span->value[ALPHA] >> 9;
	uint32_t alpha_step = (uint32_t)soft_alpha_step(span->step[ALPHA]);

	for (int i = 0; i < span->count; i++) {
		for (int j = 0; j < 3; j++) {
			fragments->color[i][j] = (uint8_t)(c[j] >> 8);
			c[j] += (uint32_t)(span->step[j] >> 8) +
				((uint32_t)span->step[j] >> 31);
		}
		fragments->color[i][3] = (uint8_t)(alpha_q7 >> 7);
		fragments->alpha_q7[i] = (uint16_t)alpha_q7;
		alpha_q7 += alpha_step;
	}
}

/*
 * Like the driver, GL_MODULATE of the first texture multiplies a texel's alpha
 * by the interpolated alpha with its fraction.
 */
static void scale_alphas(const struct draw *draw, int count,
	const uint8_t (*texel)[4], struct fragments *fragments)
{
	const struct texture_input *input = &draw->texture[0];

	if (input->env->mode != GL_MODULATE ||
		input->base->base_format == GL_RGB ||
		input->base->base_format == GL_LUMINANCE) {
		return;
	}
	for (int i = 0; i < count; i++) {
		fragments->color[i][3] = (uint8_t)soft_scale_alpha(
			fragments->alpha_q7[i], texel[i][3]);
	}
}

static void add_textures(const struct draw *draw, const struct span *span,
	struct fragments *fragments)
{
	uint8_t primary[REFERENCE_PIXELS][4], texel[REFERENCE_PIXELS][4];
	size_t size = (size_t)span->count * 4;

	memcpy(primary, fragments->color, size);
	for (int unit = 0; unit < SOFT_UNITS; unit++) {
		if (draw->texture[unit].used) {
			reference_sample(&draw->texture[unit], span, unit,
				draw->soft->format == PIXELS_RGBA8888 ||
					unit > 0 || draw->spans.made ||
					draw->spans.blended_last,
				texel);
			reference_combine(&draw->texture[unit], span->count,
				(const uint8_t(*)[4])texel,
				(const uint8_t(*)[4])primary, fragments->color);
			if (unit == 0) {
				scale_alphas(draw, span->count,
					(const uint8_t(*)[4])texel, fragments);
			}
		}
	}
	/* The second unit's, with the first one's coordinates. */
	if (draw->spans.joined) {
		reference_sample(&draw->texture[1], span, 0, true, texel);
		reference_combine(&draw->texture[1], span->count,
			(const uint8_t(*)[4])texel,
			(const uint8_t(*)[4])primary, fragments->color);
	}
	/* The second unit adds a constant colour, and its texture is not read. */
	if (draw->added) {
		reference_combine(&draw->texture[1], span->count,
			(const uint8_t(*)[4])primary,
			(const uint8_t(*)[4])primary, fragments->color);
	}
}

static void add_fog(const struct draw *draw, const struct span *span,
	struct fragments *fragments)
{
	const GLfixed *fog = draw->soft->fog.color;
	uint32_t share = span->value[FOG];

	for (int i = 0; i < span->count; i++) {
		int own = (int)(share >> 16 & 255);

		for (int j = 0; j < 3; j++) {
			fragments->color[i][j] =
				(uint8_t)(scale_byte(
						  fragments->color[i][j], own) +
					scale_byte(soft_byte(fog[j]), 255 - own));
		}
		share += (uint32_t)span->step[FOG];
	}
}

static void test_alpha(const struct draw *draw, const struct span *span,
	struct fragments *fragments)
{
	const struct fragment_state *state = &draw->soft->fragment;
	int reference = soft_byte(state->alpha_reference);

	for (int i = 0; i < span->count; i++) {
		if (!soft_compares(state->alpha_function,
			    fragments->color[i][3], (uint32_t)reference)) {
			fragments->passes[i] = false;
			fragments->left--;
		}
	}
}

/* Returns a blend factor, 0..255, for channel i. */
static int blend_factor(
	GLenum factor, const uint8_t from[4], const uint8_t to[4], int i)
{
	switch (factor) {
	case GL_ZERO:
		return 0;
	case GL_SRC_COLOR:
		return from[i];
	case GL_ONE_MINUS_SRC_COLOR:
		return 255 - from[i];
	case GL_SRC_ALPHA:
		return from[3];
	case GL_ONE_MINUS_SRC_ALPHA:
		return 255 - from[3];
	case GL_DST_ALPHA:
		return to[3];
	case GL_ONE_MINUS_DST_ALPHA:
		return 255 - to[3];
	case GL_DST_COLOR:
		return to[i];
	case GL_ONE_MINUS_DST_COLOR:
		return 255 - to[i];
	case 0x0308: /* GL_SRC_ALPHA_SATURATE */
		return i == 3                   ? 255
			: from[3] < 255 - to[3] ? from[3]
						: 255 - to[3];
	default:
		return 255;
	}
}

static void blend(GLenum source_factor, GLenum destination_factor,
	const uint8_t to[4], uint8_t color[4])
{
	uint8_t out[4];

	for (int i = 0; i < 4; i++) {
		int source = blend_factor(source_factor, color, to, i);
		int destination = blend_factor(destination_factor, color, to, i);
		int sum = color[i] * source + to[i] * destination + 128;

		sum = (sum + (sum >> 8)) >> 8;
		out[i] = (uint8_t)(sum > 255 ? 255 : sum);
	}
	memcpy(color, out, 4);
}

static void write_colors(const struct draw *draw, const struct span *span,
	struct fragments *fragments)
{
	const struct pixels *target = &draw->soft->buffers.target;
	const struct fragment_state *state = &draw->soft->fragment;
	const GLboolean *mask = state->color_mask;
	bool masked = !(mask[0] && mask[1] && mask[2] && mask[3]);
	uint8_t *at = pixel_at(target, span->x, span->y);
	int bytes = pixel_bytes(target->format);
	uint8_t old[4];

	for (int i = 0; i < span->count; i++, at += bytes) {
		uint8_t *color = fragments->color[i];

		if (!fragments->passes[i]) {
			continue;
		}
		if (draw->blended || masked) {
			load_pixel(target->format, at, old);
		}
		if (draw->blended) {
			blend(state->blend_source, state->blend_destination,
				old, color);
		}
		for (int j = 0; j < 4 && masked; j++) {
			color[j] = mask[j] ? color[j] : old[j];
		}
		if (target->format == PIXELS_RGB565) {
			store_16(at, pack_565(color[0], color[1], color[2]));
		} else {
			memcpy(at, color, 4);
		}
	}
}

void reference_draw_span(struct draw *draw, const struct span *span)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const bool written = state->color_bits != 0;
	struct fragments fragments;

	fragments.left = span->count;
	memset(fragments.passes, true, (size_t)span->count);
	if (!state->alpha_test) {
		run_tests(draw, span, &fragments);
	}
	if (fragments.left == 0 || (!written && !state->alpha_test)) {
		return;
	}
	fill_colors(span, &fragments);
	add_textures(draw, span, &fragments);
	if (draw->fogged) {
		add_fog(draw, span, &fragments);
	}
	if (state->alpha_test) {
		test_alpha(draw, span, &fragments);
		run_tests(draw, span, &fragments);
	}
	if (fragments.left > 0 && written) {
		write_colors(draw, span, &fragments);
	}
}
