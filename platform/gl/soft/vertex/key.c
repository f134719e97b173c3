/* Finds the key's bits, each group from the state that it stands for. */
#include "platform/gl/soft/vertex/key.h"

#include "platform/gl/soft/vertex/draw.h"

static uint32_t bit_if(bool is, uint32_t bit)
{
	return is ? bit : 0;
}

static uint32_t find_target(const struct draw *draw)
{
	const GLboolean *mask = draw->soft->fragment.color_mask;

	return bit_if(draw->soft->format == PIXELS_RGB565, KEY_565) |
		bit_if(!mask[0] || !mask[1] || !mask[2], KEY_COLOR_MASKED);
}

static uint32_t find_vertices(const struct draw *draw)
{
	return bit_if(draw->shading.lit, KEY_LIT) |
		bit_if(draw->shading.color_array, KEY_COLOR_ARRAY) |
		bit_if(draw->perspective, KEY_PERSPECTIVE) |
		bit_if(draw->offset || draw->shading.two_side, KEY_BY_TRIANGLE);
}

static uint32_t find_fragments(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	bool by_alpha = state->blend_source == GL_SRC_ALPHA &&
		state->blend_destination == GL_ONE_MINUS_SRC_ALPHA;

	return bit_if(draw->spans.alpha_tested, KEY_ALPHA_TEST) |
		bit_if(draw->fogged, KEY_FOG) | bit_if(draw->added, KEY_ADDED) |
		bit_if(draw->blended, KEY_BLENDED) |
		bit_if(draw->blended && !by_alpha, KEY_BLENDED_OTHER);
}

static uint32_t find_depth(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;

	if (!state->depth_test) {
		return KEY_DEPTH_ALWAYS;
	}
	return KEY_DEPTH_TEST |
		bit_if(state->depth_function == GL_LESS && state->depth_mask,
			KEY_DEPTH_LESS) |
		bit_if(state->depth_function == GL_ALWAYS, KEY_DEPTH_ALWAYS);
}

/* KEY_STENCIL_ONCE: the stencil states that fill_flat.c can draw. */
static uint32_t find_stencil(const struct draw *draw)
{
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	GLenum pass = stencil->pass;
	bool once;

	if (!stencil->enabled) {
		return 0;
	}
	once = stencil->function == GL_EQUAL && stencil->mask == 255 &&
		stencil->write_mask == 255 && stencil->fail == GL_KEEP &&
		stencil->reference < 255 &&
		(pass == GL_INCR || pass == GL_KEEP || pass == GL_ZERO);
	return KEY_STENCIL |
		bit_if(once && draw->soft->buffers.stencil, KEY_STENCIL_ONCE);
}

static uint32_t find_filter(const struct texture *texture)
{
	GLenum min = texture->min_filter;

	if (texture->mag_filter == GL_NEAREST) {
		return bit_if(min == GL_NEAREST, KEY_NEAREST);
	}
	return min == GL_LINEAR                   ? KEY_LINEAR
		: min == GL_LINEAR_MIPMAP_NEAREST ? KEY_LINEAR | KEY_MIPMAPS
						  : 0;
}

static uint32_t find_texture(const struct texture_input *input)
{
	const struct texture *texture;
	const struct level *base = input->base;

	if (!input->used) {
		return 0;
	}
	texture = input->texture;
	return KEY_TEXTURE | find_filter(texture) |
		bit_if(base->format == TEXEL_565, KEY_TEXTURE_565) |
		bit_if(base->format == TEXEL_A8, KEY_TEXTURE_ALPHA) |
		bit_if(base->tiles && input->width_log2 > 0 &&
				input->height_log2 > 0,
			KEY_TEXTURE_TILES) |
		bit_if(input->mode == GL_MODULATE, KEY_MODULATE) |
		bit_if(texture->wrap_s == GL_REPEAT &&
				texture->wrap_t == GL_REPEAT,
			KEY_REPEAT);
}

uint32_t soft_find_key(const struct draw *draw)
{
	return find_target(draw) | find_vertices(draw) | find_fragments(draw) |
		find_depth(draw) | find_stencil(draw) |
		find_texture(&draw->texture[0]) |
		bit_if(draw->texture[1].used || draw->spans.joined,
			KEY_TEXTURES);
}
