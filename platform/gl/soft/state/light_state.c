/* Lights, the material and the light model, as the program tells them. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/state/matrix.h"

static void set_scalar(struct light *light, GLenum name, GLfixed value)
{
	GLfixed *where, most = INT32_MAX;

	switch (name) {
	case GL_SPOT_EXPONENT:
		where = &light->exponent;
		most = 128 * FX16_ONE;
		break;
	case GL_SPOT_CUTOFF:
		where = &light->cutoff;
		most = value == 180 * FX16_ONE ? value : 90 * FX16_ONE;
		break;
	case GL_CONSTANT_ATTENUATION:
	case GL_LINEAR_ATTENUATION:
	case GL_QUADRATIC_ATTENUATION:
		where = &light->attenuation[name - GL_CONSTANT_ATTENUATION];
		break;
	default:
		soft_set_error(soft_current(), GL_INVALID_ENUM);
		return;
	}
	if (value < 0 || value > most) {
		soft_set_error(soft_current(), GL_INVALID_VALUE);
		return;
	}
	*where = value;
}

/* NULL, with GL's error, for another name. */
static struct light *find_light(GLenum name)
{
	struct soft *soft = soft_current();

	if (name - GL_LIGHT0 >= SOFT_LIGHTS) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return NULL;
	}
	return &soft->lighting.light[name - GL_LIGHT0];
}

static void light_scalar(GLenum name, GLenum what, GLfixed value)
{
	struct light *light = find_light(name);

	if (light) {
		set_scalar(light, what, value);
	}
}

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

static void light_vector(GLenum name, GLenum what, const GLfixed *values)
{
	struct light *light = find_light(name);

	if (!light) {
		return;
	}
	switch (what) {
	case GL_AMBIENT:
		memcpy(light->ambient, values, sizeof(light->ambient));
		break;
	case GL_DIFFUSE:
		memcpy(light->diffuse, values, sizeof(light->diffuse));
		break;
	case GL_SPECULAR:
		memcpy(light->specular, values, sizeof(light->specular));
		break;
	case GL_POSITION:
		set_position(soft_current(), light, values);
		break;
	case GL_SPOT_DIRECTION:
		set_direction(soft_current(), light, values);
		break;
	default:
		set_scalar(light, what, values[0]);
	}
}

static void light_model(GLenum name, GLfixed value)
{
	struct soft *soft = soft_current();

	if (name != GL_LIGHT_MODEL_TWO_SIDE) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	soft->lighting.two_side = value != 0;
}

static void light_model_vector(GLenum name, const GLfixed *values)
{
	struct lighting *lighting = &soft_current()->lighting;

	if (name == GL_LIGHT_MODEL_AMBIENT) {
		memcpy(lighting->ambient, values, sizeof(lighting->ambient));
		return;
	}
	light_model(name, values[0]);
}

/* ES sets both faces at once only. */
static struct material *find_material(GLenum face)
{
	struct soft *soft = soft_current();

	if (face != GL_FRONT_AND_BACK) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return NULL;
	}
	return &soft->lighting.material;
}

static void material_scalar(GLenum face, GLenum name, GLfixed value)
{
	struct material *material = find_material(face);

	if (!material) {
		return;
	}
	if (name != GL_SHININESS) {
		soft_set_error(soft_current(), GL_INVALID_ENUM);
		return;
	}
	if (value < 0 || value > 128 * FX16_ONE) {
		soft_set_error(soft_current(), GL_INVALID_VALUE);
		return;
	}
	material->shininess = value;
}

static void material_vector(GLenum face, GLenum name, const GLfixed *values)
{
	struct material *material = find_material(face);
	const size_t size = 4 * sizeof(GLfixed);

	if (!material) {
		return;
	}
	switch (name) {
	case GL_AMBIENT:
		memcpy(material->ambient, values, size);
		break;
	case GL_DIFFUSE:
		memcpy(material->diffuse, values, size);
		break;
	case GL_AMBIENT_AND_DIFFUSE:
		memcpy(material->ambient, values, size);
		memcpy(material->diffuse, values, size);
		break;
	case GL_SPECULAR:
		memcpy(material->specular, values, size);
		break;
	case GL_EMISSION:
		memcpy(material->emission, values, size);
		break;
	default:
		material_scalar(face, name, values[0]);
	}
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
