/* The context's table of GL functions, and GL's initial state. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/state/state.h"

static const struct gl calls = {
#define GL_FUNCTION(result, name, parameters) .name = soft_gl_##name,
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
};

#define GRAY(value)                                 \
	{                                           \
		(value), (value), (value), FX16_ONE \
	}

/* black: the alpha of lights, and of specular and emitted light, is not read */
static const struct light dark = {
	.position = {0.0f, 0.0f, 1.0f, 0.0f},
	.towards = {0.0f, 0.0f, 1.0f},
	.half = {0.0f, 0.0f, 1.0f},
	.direction = {0.0f, 0.0f, -1.0f},
	.cutoff = 180 * FX16_ONE,
	.attenuation = {FX16_ONE, 0, 0},
};

static const struct material material = {
	.ambient = GRAY(FX16_ONE / 5),
	.diffuse = GRAY(FX16_ONE / 5 * 4),
};

static const struct texenv modulate = {
	.mode = GL_MODULATE,
	.combine_rgb = GL_MODULATE,
	.combine_alpha = GL_MODULATE,
	.source_rgb = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
	.source_alpha = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
	.operand_rgb = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
	.operand_alpha = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA},
	.scale_rgb = FX16_ONE,
	.scale_alpha = FX16_ONE,
};

static const struct fragment_state fragment = {
	.dither = true,
	.alpha_function = GL_ALWAYS,
	.depth_function = GL_LESS,
	.blend_source = GL_ONE,
	.blend_destination = GL_ZERO,
	.color_mask = {1, 1, 1, 1},
	.color_bits = UINT32_MAX,
	.depth_mask = 1,
	.cull_face = GL_BACK,
	.front_face = GL_CCW,
	.line_width = FX16_ONE,
	.point_size = FX16_ONE,
	.clear_depth = FX16_ONE,
	.stencil = {.function = GL_ALWAYS,
		.fail = GL_KEEP,
		.depth_fail = GL_KEEP,
		.pass = GL_KEEP,
		.mask = 255,
		.write_mask = 255},
};

void soft_init_state(struct soft *soft)
{
	const struct array array = {
		.size = 4, .type = GL_FLOAT, .stride_bytes = 16};
	struct lighting *lighting = &soft->lighting;

	soft->base.gl = calls;
	soft->fragment = fragment;
	soft->fog = (struct fog){
		.mode = GL_EXP, .density = FX16_ONE, .end = FX16_ONE};
	*lighting = (struct lighting){
		.material = material, .ambient = GRAY(FX16_ONE / 5)};
	for (int i = 0; i < SOFT_LIGHTS; i++) {
		lighting->light[i] = dark;
	}
	for (int i = 0; i < 3; i++) {
		lighting->light[0].diffuse[i] = FX16_ONE;
		lighting->light[0].specular[i] = FX16_ONE;
	}
	soft->arrays = (struct arrays){.vertex = array,
		.normal = array,
		.color = array,
		.texcoord = {array, array},
		.current_color = GRAY(FX16_ONE),
		.current_normal = {0, 0, FX16_ONE}};
	soft->textures = (struct textures){.none = soft_new_texture(0),
		.unit = {{.bound = &soft->textures.none, .env = modulate},
			{.bound = &soft->textures.none, .env = modulate}},
		.unpack_alignment = 4,
		.pack_alignment = 4};
	soft_init_matrices(&soft->matrices);
}
