/* Fog, as the program tells it; shade.c says how much of it there is. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/state/parameter.h"

static bool is_mode(GLfixed value)
{
	return IS_ONE_OF((GLenum)value, GL_LINEAR, GL_EXP, GL_EXP2);
}

static bool is_density(GLfixed value)
{
	return value >= 0;
}

static const struct soft_parameter parameters[] = {
	SOFT_ENUM(GL_FOG_MODE, struct fog, mode, is_mode),
	SOFT_NUMBER(GL_FOG_DENSITY, struct fog, density, is_density),
	SOFT_ANY(GL_FOG_START, struct fog, start),
	SOFT_ANY(GL_FOG_END, struct fog, end),
	SOFT_ANY(GL_FOG_COLOR, struct fog, color),
};

static void fog_scalar(GLenum name, GLfixed value)
{
	SET_PARAMETER(parameters, &soft_current()->fog, name, &value, 1);
}

static void fog_vector(GLenum name, const GLfixed *values)
{
	SET_PARAMETER(parameters, &soft_current()->fog, name, values, 4);
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
