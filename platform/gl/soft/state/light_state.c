/* Lights, the material and the light model, as the program tells them. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/state/parameter.h"

static bool is_exponent(GLfixed value)
{
	return value >= 0 && value <= 128 * FX16_ONE;
}

static bool is_cutoff(GLfixed degrees)
{
	return (degrees >= 0 && degrees <= 90 * FX16_ONE) ||
		degrees == 180 * FX16_ONE;
}

static bool is_attenuation(GLfixed value)
{
	return value >= 0;
}

static const struct soft_parameter of_light[] = {
	SOFT_ANY(GL_AMBIENT, struct light, ambient),
	SOFT_ANY(GL_DIFFUSE, struct light, diffuse),
	SOFT_ANY(GL_SPECULAR, struct light, specular),
	SOFT_NUMBER(GL_SPOT_EXPONENT, struct light, exponent, is_exponent),
	SOFT_NUMBER(GL_SPOT_CUTOFF, struct light, cutoff, is_cutoff),
	SOFT_NUMBER(GL_CONSTANT_ATTENUATION, struct light, attenuation[0],
		is_attenuation),
	SOFT_NUMBER(GL_LINEAR_ATTENUATION, struct light, attenuation[1],
		is_attenuation),
	SOFT_NUMBER(GL_QUADRATIC_ATTENUATION, struct light, attenuation[2],
		is_attenuation),
};

static const struct soft_parameter of_model[] = {
	SOFT_ANY(GL_LIGHT_MODEL_AMBIENT, struct lighting, ambient),
	SOFT_ANY(GL_LIGHT_MODEL_TWO_SIDE, struct lighting, two_side),
};

static const struct soft_parameter of_material[] = {
	SOFT_ANY(GL_AMBIENT, struct material, ambient),
	SOFT_ANY(GL_DIFFUSE, struct material, diffuse),
	SOFT_ANY(GL_SPECULAR, struct material, specular),
	SOFT_ANY(GL_EMISSION, struct material, emission),
	SOFT_NUMBER(GL_SHININESS, struct material, shininess, is_exponent),
};

/* Positions and directions go into eye space as they are given. */
static void set_position(
	struct soft *soft, struct light *light, const GLfixed *values)
{
	float position[4];

	for (int i = 0; i < 4; i++) {
		position[i] = fx16_to_float(values[i]);
	}
	soft_matrix_transform(
		soft->matrices.modelview_stack.top, position, light->position);
}

static void set_direction(
	struct soft *soft, struct light *light, const GLfixed *values)
{
	float direction[4] = {fx16_to_float(values[0]),
		fx16_to_float(values[1]), fx16_to_float(values[2]), 0.0f};
	float out[4];

	soft_matrix_transform(
		soft->matrices.modelview_stack.top, direction, out);
	memcpy(light->direction, out, sizeof(light->direction));
}

static void set_light(GLenum name, GLenum what, const GLfixed *values, int given)
{
	struct soft *soft = soft_current();
	struct light *light;

	if (!soft_check(name - GL_LIGHT0 < SOFT_LIGHTS, GL_INVALID_ENUM)) {
		return;
	}
	light = &soft->lighting.light[name - GL_LIGHT0];
	if (what == GL_POSITION && given == 4) {
		set_position(soft, light, values);
	} else if (what == GL_SPOT_DIRECTION && given == 4) {
		set_direction(soft, light, values);
	} else {
		SET_PARAMETER(of_light, light, what, values, given);
	}
}

static void light_scalar(GLenum name, GLenum what, GLfixed value)
{
	set_light(name, what, &value, 1);
}

static void light_vector(GLenum name, GLenum what, const GLfixed *values)
{
	set_light(name, what, values, 4);
}

static void light_model(GLenum name, GLfixed value)
{
	SET_PARAMETER(of_model, &soft_current()->lighting, name, &value, 1);
}

static void light_model_vector(GLenum name, const GLfixed *values)
{
	SET_PARAMETER(of_model, &soft_current()->lighting, name, values, 4);
}

/* ES sets both faces at once only. */
static void set_material(
	GLenum face, GLenum name, const GLfixed *values, int given)
{
	struct material *material = &soft_current()->lighting.material;
	const bool both = name == GL_AMBIENT_AND_DIFFUSE;

	if (!soft_check(face == GL_FRONT_AND_BACK, GL_INVALID_ENUM)) {
		return;
	}
	SET_PARAMETER(
		of_material, material, both ? GL_AMBIENT : name, values, given);
	if (both) {
		SET_PARAMETER(of_material, material, GL_DIFFUSE, values, given);
	}
}

static void material_scalar(GLenum face, GLenum name, GLfixed value)
{
	set_material(face, name, &value, 1);
}

static void material_vector(GLenum face, GLenum name, const GLfixed *values)
{
	set_material(face, name, values, 4);
}

static void set_all(GLfixed color[4], GLfixed value)
{
	for (int i = 0; i < 3; i++) {
		color[i] = value;
	}
	color[3] = FX16_ONE;
}

static void set_defaults(struct lighting *lighting)
{
	*lighting = (struct lighting){0};
	set_all(lighting->ambient, FX16_ONE / 5);
	set_all(lighting->material.ambient, FX16_ONE / 5);
	set_all(lighting->material.diffuse, FX16_ONE / 5 * 4);
	set_all(lighting->material.specular, 0);
	set_all(lighting->material.emission, 0);
	for (int i = 0; i < SOFT_LIGHTS; i++) {
		struct light *light = &lighting->light[i];

		set_all(light->ambient, 0);
		set_all(light->diffuse, i ? 0 : FX16_ONE);
		set_all(light->specular, i ? 0 : FX16_ONE);
		light->position[2] = 1.0f;
		light->direction[2] = -1.0f;
		light->cutoff = 180 * FX16_ONE;
		light->attenuation[0] = FX16_ONE;
	}
}

void soft_init_lighting(struct soft *soft)
{
	struct gl *gl = &soft->base.gl;

	set_defaults(&soft->lighting);
	gl->Lightx = light_scalar;
	gl->Lightxv = light_vector;
	gl->LightModelx = light_model;
	gl->LightModelxv = light_model_vector;
	gl->Materialx = material_scalar;
	gl->Materialxv = material_vector;
}
