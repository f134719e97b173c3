/* The texture environment, as the program tells it; stages/ carries it out. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/state/parameter.h"

enum {
	/* Of ES 1.1, but of no call that limber makes by name. */
	ALPHA_SCALE = 0x0D1C,
	SRC2_RGB = 0x8582,
	SRC2_ALPHA = 0x858A,
	OPERAND2_RGB = 0x8592,
	OPERAND0_ALPHA = 0x8598,
	OPERAND1_ALPHA = 0x8599,
	OPERAND2_ALPHA = 0x859A,
	ADD_SIGNED = 0x8574,
	INTERPOLATE = 0x8575,
	SUBTRACT = 0x84E7,
};

static bool is_mode(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD,
		GL_REPLACE, GL_COMBINE);
}

static bool is_alpha_combiner(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, GL_REPLACE, GL_MODULATE, GL_ADD,
		ADD_SIGNED, INTERPOLATE, SUBTRACT);
}

static bool is_rgb_combiner(GLfixed value)
{
	return is_alpha_combiner(value) ||
		IS_ONE_OF((GLenum)value, GL_DOT3_RGB, GL_DOT3_RGBA);
}

static bool is_source(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, GL_TEXTURE, GL_CONSTANT,
		GL_PRIMARY_COLOR, GL_PREVIOUS);
}

static bool is_alpha_operand(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

static bool is_rgb_operand(GLfixed value)
{
	return is_alpha_operand(value) ||
		IS_ONE_OF((GLenum)value, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR);
}

static bool is_scale(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, FX16_ONE, 2 * FX16_ONE, 4 * FX16_ONE);
}

#define ENUM(name, member, takes) SOFT_ENUM(name, struct texenv, member, takes)
static const struct soft_parameter parameters[] = {
	ENUM(GL_TEXTURE_ENV_MODE, mode, is_mode),
	ENUM(GL_COMBINE_RGB, combine_rgb, is_rgb_combiner),
	ENUM(GL_COMBINE_ALPHA, combine_alpha, is_alpha_combiner),
	ENUM(GL_SRC0_RGB, source_rgb[0], is_source),
	ENUM(GL_SRC1_RGB, source_rgb[1], is_source),
	ENUM(SRC2_RGB, source_rgb[2], is_source),
	ENUM(GL_SRC0_ALPHA, source_alpha[0], is_source),
	ENUM(GL_SRC1_ALPHA, source_alpha[1], is_source),
	ENUM(SRC2_ALPHA, source_alpha[2], is_source),
	ENUM(GL_OPERAND0_RGB, operand_rgb[0], is_rgb_operand),
	ENUM(GL_OPERAND1_RGB, operand_rgb[1], is_rgb_operand),
	ENUM(OPERAND2_RGB, operand_rgb[2], is_rgb_operand),
	ENUM(OPERAND0_ALPHA, operand_alpha[0], is_alpha_operand),
	ENUM(OPERAND1_ALPHA, operand_alpha[1], is_alpha_operand),
	ENUM(OPERAND2_ALPHA, operand_alpha[2], is_alpha_operand),
	SOFT_NUMBER(GL_RGB_SCALE, struct texenv, scale_rgb, is_scale),
	SOFT_NUMBER(ALPHA_SCALE, struct texenv, scale_alpha, is_scale),
	SOFT_ANY(GL_TEXTURE_ENV_COLOR, struct texenv, color),
};

static void set_env(GLenum target, GLenum name, const GLfixed *values, int given)
{
	struct textures *textures = &soft_current()->textures;

	if (soft_check(target == GL_TEXTURE_ENV, GL_INVALID_ENUM)) {
		SET_PARAMETER(parameters, &textures->unit[textures->active].env,
			name, values, given);
	}
}

static void tex_env(GLenum target, GLenum name, GLfixed value)
{
	set_env(target, name, &value, 1);
}

static void tex_env_vector(GLenum target, GLenum name, const GLfixed *values)
{
	set_env(target, name, values, 4);
}

void soft_init_texenv(struct soft *soft)
{
	for (int i = 0; i < SOFT_UNITS; i++) {
		soft->textures.unit[i].env = (struct texenv){
			.mode = GL_MODULATE,
			.combine_rgb = GL_MODULATE,
			.combine_alpha = GL_MODULATE,
			.source_rgb = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
			.source_alpha = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
			.operand_rgb = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
			.operand_alpha = {GL_SRC_ALPHA, GL_SRC_ALPHA,
				GL_SRC_ALPHA},
			.scale_rgb = FX16_ONE,
			.scale_alpha = FX16_ONE,
		};
	}
	soft->base.gl.TexEnvx = tex_env;
	soft->base.gl.TexEnvxv = tex_env_vector;
}
