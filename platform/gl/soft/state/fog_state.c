/* Fog, as the program tells it; fog.c says how much of it there is. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/soft.h"

static void fog_scalar(GLenum name, GLfixed value)
{
	struct soft *soft = soft_current();
	struct fog *fog = &soft->fog;

	switch (name) {
	case GL_FOG_MODE:
		if (value != GL_LINEAR && value != GL_EXP && value != GL_EXP2) {
			soft_set_error(soft, GL_INVALID_ENUM);
			return;
		}
		fog->mode = (GLenum)value;
		return;
	case GL_FOG_DENSITY:
		if (value < 0) {
			soft_set_error(soft, GL_INVALID_VALUE);
			return;
		}
		fog->density = value;
		return;
	case GL_FOG_START:
		fog->start = value;
		return;
	case GL_FOG_END:
		fog->end = value;
		return;
	default:
		soft_set_error(soft, GL_INVALID_ENUM);
	}
}

static void fog_vector(GLenum name, const GLfixed *values)
{
	struct fog *fog = &soft_current()->fog;

	if (name == GL_FOG_COLOR) {
		memcpy(fog->color, values, sizeof(fog->color));
		return;
	}
	fog_scalar(name, values[0]);
}

void soft_init_fog(struct soft *soft)
{
	soft->fog = (struct fog){
		.mode = GL_EXP,
		.density = FX16_ONE,
		.end = FX16_ONE,
	};
	soft->base.gl.Fogx = fog_scalar;
	soft->base.gl.Fogxv = fog_vector;
}
