/*
 * Relief in passes, into RGB565: a texture of normals by the light's direction
 * in the colour (GL_DOT3_RGB), then a tinted texture which the picture is
 * multiplied by, and one that is added to it, both where the depth is EQUAL.
 * Small triangles are fill_texture.c's.
 */
#include "platform/gl/soft/raster/raster.h"

static bool is_dot(const struct texenv *env)
{
	return env->mode == GL_COMBINE && env->combine_rgb == GL_DOT3_RGB &&
		env->source_rgb[0] == GL_TEXTURE &&
		env->source_rgb[1] == GL_PRIMARY_COLOR &&
		env->operand_rgb[0] == GL_SRC_COLOR &&
		env->operand_rgb[1] == GL_SRC_COLOR && env->scale_rgb == 65536;
}

static bool takes_texture(const struct texture_input *input)
{
	const struct texture *texture = input->texture;
	GLenum min = input->used ? texture->min_filter : GL_NEAREST;

	return input->used && input->base->format == TEXEL_565 &&
		texture->mag_filter == GL_LINEAR &&
		(min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST) &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT;
}

/* The second and the third pass; the depth that is there stays in any case. */
static bool is_repeated(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	GLenum from = state->blend_source, to = state->blend_destination;
	bool multiplies = from == GL_DST_COLOR && to == GL_ZERO;
	bool adds = from == GL_ONE && to == GL_ONE;

	return state->depth_function == GL_EQUAL && draw->blended &&
		(multiplies || adds) &&
		draw->texture[0].env->mode == GL_MODULATE;
}

bool soft_fill_is_relief(const struct draw *draw)
{
	const struct soft *soft = draw->soft;
	const struct fragment_state *state = &soft->fragment;
	const GLboolean *mask = state->color_mask;

	if (soft->format != PIXELS_RGB565 || state->alpha_test ||
		state->stencil.enabled || draw->fogged || !mask[0] ||
		!mask[1] || !mask[2] || !state->depth_test || state->flat ||
		state->offset_fill || draw->shading.two_side ||
		draw->texture[1].used || !takes_texture(&draw->texture[0])) {
		return false;
	}
	return is_repeated(draw) ||
		(state->depth_function == GL_LESS && state->depth_mask &&
			!draw->blended && is_dot(draw->texture[0].env));
}

void soft_fill_relief(struct draw *draw, struct setup *setup)
{
	if (!soft_fill_texture_tinted(draw, setup)) {
		soft_rows_fill(draw, setup);
	}
}
