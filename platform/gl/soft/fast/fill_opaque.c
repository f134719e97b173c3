/*
 * Opaque triangles into RGB565, tested and written with the depth function
 * LESS, with one RGB565 texture that repeats: the small ones are
 * fill_texture.c's, the others are drawn by the span functions.
 */
#include "platform/gl/soft/fast/limits.h"

static bool is_gray(const struct setup *setup)
{
	const int32_t *a = setup->v[0]->attribute + RED;
	const int32_t *b = setup->v[1]->attribute + RED;
	const int32_t *c = setup->v[2]->attribute + RED;

	return ((a[0] ^ a[1]) | (a[0] ^ a[2]) | (b[0] ^ b[1]) | (b[0] ^ b[2]) |
		       (c[0] ^ c[1]) | (c[0] ^ c[2])) == 0;
}

void soft_fill_textured(struct draw *draw, struct setup *setup)
{
	if (draw->texture[0].texture->mag_filter == GL_LINEAR) {
		if (!soft_fill_texture_tinted(draw, setup)) {
			soft_rows_fill(draw, setup);
		}
	} else if (is_gray(setup)) {
		if (!soft_fill_texture_gray(draw, setup)) {
			soft_rows_fill(draw, setup);
		}
	} else if (!soft_fill_texture_tinted(draw, setup)) {
		soft_rows_fill(draw, setup);
	}
}

bool soft_fill_is_opaque(const struct draw *draw)
{
	const struct soft *soft = draw->soft;
	const struct fragment_state *state = &soft->fragment;
	const GLboolean *mask = state->color_mask;

	return soft->format == PIXELS_RGB565 && !draw->blended &&
		!state->alpha_test && !state->stencil.enabled && !draw->fogged &&
		mask[0] && mask[1] && mask[2] && state->depth_test &&
		state->depth_mask && state->depth_function == GL_LESS &&
		!state->flat && !state->offset_fill &&
		!draw->shading.two_side && !draw->texture[1].used;
}

bool soft_fill_takes_texture(const struct texture_input *input)
{
	const struct texture *texture = input->texture;
	GLenum min = texture->min_filter;
	bool nearest = min == GL_NEAREST && texture->mag_filter == GL_NEAREST;
	bool linear = texture->mag_filter == GL_LINEAR &&
		(min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST);

	return input->base->format == TEXEL_565 &&
		input->env->mode == GL_MODULATE && (nearest || linear) &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT;
}
