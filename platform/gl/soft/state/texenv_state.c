/* The texture environment, as the program tells it; stages/ carries it out. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/soft.h"

enum {
	/* Of ES 1.1, but of no call that limber makes by name. */
	ALPHA_SCALE = 0x0D1C,
	SRC2_RGB = 0x8582,
	SRC2_ALPHA = 0x858A,
	OPERAND2_RGB = 0x8592,
	OPERAND0_ALPHA = 0x8598,
	OPERAND2_ALPHA = 0x859A,
	ADD_SIGNED = 0x8574,
	INTERPOLATE = 0x8575,
	SUBTRACT = 0x84E7,
};

static bool is_mode(GLenum mode)
{
	return mode == GL_MODULATE || mode == GL_DECAL || mode == GL_BLEND ||
		mode == GL_ADD || mode == GL_REPLACE || mode == GL_COMBINE;
}

static bool is_combiner(GLenum value, bool rgb)
{
	bool dot = value == GL_DOT3_RGB || value == GL_DOT3_RGBA;

	return value == GL_REPLACE || value == GL_MODULATE || value == GL_ADD ||
		value == ADD_SIGNED || value == INTERPOLATE ||
		value == SUBTRACT || (rgb && dot);
}

static bool is_source(GLenum value)
{
	return value == GL_TEXTURE || value == GL_CONSTANT ||
		value == GL_PRIMARY_COLOR || value == GL_PREVIOUS;
}

static bool is_operand(GLenum value, bool rgb)
{
	return value == GL_SRC_ALPHA || value == GL_ONE_MINUS_SRC_ALPHA ||
		(rgb &&
			(value == GL_SRC_COLOR ||
				value == GL_ONE_MINUS_SRC_COLOR));
}

/* Where an enumerant goes and whether it may; NULL for another name. */
static GLenum *find_enum(
	struct texenv *env, GLenum name, GLenum value, bool *known)
{
	if (name == GL_TEXTURE_ENV_MODE) {
		*known = is_mode(value);
		return &env->mode;
	}
	if (name == GL_COMBINE_RGB || name == GL_COMBINE_ALPHA) {
		*known = is_combiner(value, name == GL_COMBINE_RGB);
		return name == GL_COMBINE_RGB ? &env->combine_rgb
					      : &env->combine_alpha;
	}
	if (name >= GL_SRC0_RGB && name <= SRC2_RGB) {
		*known = is_source(value);
		return &env->source_rgb[name - GL_SRC0_RGB];
	}
	if (name >= GL_SRC0_ALPHA && name <= SRC2_ALPHA) {
		*known = is_source(value);
		return &env->source_alpha[name - GL_SRC0_ALPHA];
	}
	if (name >= GL_OPERAND0_RGB && name <= OPERAND2_RGB) {
		*known = is_operand(value, true);
		return &env->operand_rgb[name - GL_OPERAND0_RGB];
	}
	if (name >= OPERAND0_ALPHA && name <= OPERAND2_ALPHA) {
		*known = is_operand(value, false);
		return &env->operand_alpha[name - OPERAND0_ALPHA];
	}
	return NULL;
}

static void set_scale(struct soft *soft, GLfixed *scale, GLfixed value)
{
	if (value != FX16_ONE && value != 2 * FX16_ONE && value != 4 * FX16_ONE) {
		soft_set_error(soft, GL_INVALID_VALUE);
		return;
	}
	*scale = value;
}

static void tex_env(GLenum target, GLenum name, GLfixed value)
{
	struct soft *soft = soft_current();
	struct texenv *env = &soft->textures.unit[soft->textures.active].env;
	bool known = false;
	GLenum *where;

	if (target != GL_TEXTURE_ENV) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	if (name == GL_RGB_SCALE || name == ALPHA_SCALE) {
		set_scale(soft,
			name == GL_RGB_SCALE ? &env->scale_rgb
					     : &env->scale_alpha,
			value);
		return;
	}
	where = find_enum(env, name, (GLenum)value, &known);
	if (!where || !known) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	*where = (GLenum)value;
}

static void tex_env_vector(GLenum target, GLenum name, const GLfixed *values)
{
	struct soft *soft = soft_current();
	struct texenv *env = &soft->textures.unit[soft->textures.active].env;

	if (target == GL_TEXTURE_ENV && name == GL_TEXTURE_ENV_COLOR) {
		memcpy(env->color, values, sizeof(env->color));
		return;
	}
	tex_env(target, name, values[0]);
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
