/* Chooses the path of a draw call's triangles: of fast/, or span functions. */
#include "platform/gl/soft/fast/narrow.h"

/* RGB565, one texture at most; opaque, or blended by alpha. */
static bool is_common(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	bool by_alpha = state->blend_source == GL_SRC_ALPHA &&
		state->blend_destination == GL_ONE_MINUS_SRC_ALPHA;

	return draw->soft->format == PIXELS_RGB565 &&
		state->color_bits == UINT32_MAX && !draw->texture[1].used &&
		!draw->spans.joined && !draw->fogged &&
		!draw->spans.alpha_tested && !draw->smooth && !draw->lists &&
		(!draw->blended || by_alpha);
}

/* One colour, drawn once where the stencil test is EQUAL. */
static bool is_shadow(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct stencil *stencil = &state->stencil;
	GLenum pass = stencil->pass;

	return stencil->enabled && draw->soft->buffers.stencil &&
		stencil->function == GL_EQUAL && stencil->mask == 255 &&
		stencil->write_mask == 255 && stencil->fail == GL_KEEP &&
		stencil->reference < 255 &&
		(pass == GL_INCR || pass == GL_KEEP || pass == GL_ZERO) &&
		!state->depth_test && !draw->soft->lighting.enabled &&
		!draw->soft->arrays.color.enabled && !draw->texture[0].used;
}

static bool is_modulated(const struct draw *draw, enum texel_format format,
	GLenum mag_filter, GLenum min_filter)
{
	const struct texture_input *input = &draw->texture[0];

	return input->used && input->base->format == format &&
		input->mode == GL_MODULATE &&
		input->texture->mag_filter == mag_filter &&
		input->texture->min_filter == min_filter;
}

static bool is_text(const struct draw *draw)
{
	return is_modulated(draw, TEXEL_A8, GL_NEAREST, GL_NEAREST) &&
		draw->blended && !draw->soft->lighting.enabled &&
		!draw->perspective && !draw->soft->fragment.depth_test;
}

/*
 * Opaque, by LESS or LEQUAL, which write. Depth and picture have the same
 * stride.
 */
static bool is_solid(const struct draw *draw)
{
	const struct buffers *buffers = &draw->soft->buffers;

	return buffers->target.stride_bytes == buffers->width * 2 &&
		draw->spans.depth_by_less && draw->spans.depth_written &&
		!draw->blended;
}

static bool is_bilinear(const struct draw *draw)
{
	return is_modulated(draw, TEXEL_565, GL_LINEAR, GL_LINEAR) ||
		is_modulated(
			draw, TEXEL_565, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST);
}

static bool is_tiled(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct texture_input *input = &draw->texture[0];

	return is_modulated(
		       draw, TEXEL_L8, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST) &&
		input->base->tiles && input->texture->wrap_s == GL_REPEAT &&
		input->texture->wrap_t == GL_REPEAT &&
		(!state->depth_test || state->depth_function == GL_ALWAYS);
}

/* The path of a state that is_common(), or NULL. */
static fill_function choose(struct draw *draw)
{
	static void (*const bands[3][2])(void *band) = {
		{soft_band_gray, soft_band_gray_equal},
		{soft_band_tint, soft_band_tint_equal},
		{soft_narrow_rows, soft_narrow_rows_equal}};
	const bool bilinear = is_bilinear(draw);

	if (!draw->added && is_shadow(draw)) {
		draw->attributes = 0; /* one colour: no vertex is shaded */
		return soft_fill_flat;
	}
	if (draw->soft->fragment.stencil.enabled) {
		return NULL;
	}
	if (is_solid(draw) && !draw->offset &&
		(bilinear ||
			(!draw->added &&
				is_modulated(draw, TEXEL_565, GL_NEAREST,
					GL_NEAREST)))) {
		draw->fill_band = bands[bilinear][draw->spans.equal_passes];
		return soft_fill_textured;
	}
	if (draw->added) {
		return NULL;
	}
	draw->rectangles = is_text(draw);
	draw->divides = is_tiled(draw);
	draw->fill_band = bands[2][draw->spans.equal_passes];
	return draw->divides                               ? soft_fill_luminance
		: !is_solid(draw) || draw->texture[0].used ? NULL
		: draw->offset ? soft_fill_narrow_offset
			       : soft_fill_narrow;
}

void soft_choose_path(struct draw *draw)
{
	fill_function fill = draw->soft->fill;

	draw->divides = draw->rectangles = false;
	if (!fill && is_common(draw)) {
		fill = choose(draw);
	}
	draw->fill = fill ? fill : soft_rows_fill;
}
