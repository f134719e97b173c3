#include "app/scene/stage/light.h"

#include "platform/base/fixed.h"

#include <string.h>

struct directional_light {
	float towards[4]; /* to the light; w is 0 */
	float diffuse[4];
	float specular[4];
};

/*
 * Diffuse and ambient light add up to at most 1 for every normal, so that
 * drivers which clamp at different stages agree.
 */
static const struct directional_light key_light = {
	.towards = {0.389f, 0.778f, 0.494f, 0.0f},
	.diffuse = {0.62f, 0.60f, 0.55f, 1.0f},
	.specular = {1.0f, 0.97f, 0.9f, 1.0f},
};

/* From the left and a little from behind, for backs and far sides. */
static const struct directional_light fill_light = {
	.towards = {-0.862f, 0.259f, -0.436f, 0.0f},
	.diffuse = {0.30f, 0.32f, 0.36f, 1.0f},
	.specular = {0.0f, 0.0f, 0.0f, 1.0f},
};

static const float ambient[4] = {0.38f, 0.38f, 0.41f, 1.0f};
static const float black[4] = {0.0f, 0.0f, 0.0f, 1.0f};

static void set_vector(
	const struct gl *gl, GLenum light, GLenum name, const float value[4])
{
	GLfixed fixed[4];

	for (int i = 0; i < 4; i++) {
		fixed[i] = fx16_from_float(value[i]);
	}
	gl->Lightxv(light, name, fixed);
}

static void set_ambient(const struct gl *gl, const float value[4])
{
	GLfixed fixed[4];

	for (int i = 0; i < 4; i++) {
		fixed[i] = fx16_from_float(value[i]);
	}
	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, fixed);
}

static void set_light(const struct gl *gl, GLenum light,
	const struct directional_light *source)
{
	gl->Enable(light);
	set_vector(gl, light, GL_POSITION, source->towards);
	set_vector(gl, light, GL_DIFFUSE, source->diffuse);
	set_vector(gl, light, GL_SPECULAR, source->specular);
	set_vector(gl, light, GL_AMBIENT, black);
}

void light_apply(const struct gl *gl)
{
	set_ambient(gl, ambient);
	set_light(gl, GL_LIGHT0, &key_light);
	set_light(gl, GL_LIGHT1, &fill_light);
}

void light_select(const struct gl *gl, enum light_selection selection)
{
	if (selection == LIGHT_KEY_COLOR) {
		gl->Disable(GL_LIGHT0);
		gl->Disable(GL_LIGHT1);
		set_ambient(gl, key_light.diffuse);
		return;
	}
	gl->Enable(GL_LIGHT0);
	gl->Enable(GL_LIGHT1);
	set_ambient(gl, ambient);
	set_vector(gl, GL_LIGHT0, GL_DIFFUSE,
		selection == LIGHT_ALL ? key_light.diffuse : black);
}

void light_set_material(const struct gl *gl, const float color[3],
	float specular, int shininess)
{
	GLfixed strength = fx16_from_float(specular);
	const GLfixed specular_rgba[4] = {
		strength, strength, strength, FX16_ONE};

	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->Enable(GL_NORMALIZE);
	gl->Enable(GL_CULL_FACE);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_BLEND);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, specular_rgba);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, shininess * FX16_ONE);
	gl->Color4x(fx16_from_float(color[0]), fx16_from_float(color[1]),
		fx16_from_float(color[2]), FX16_ONE);
}

void light_direction(float out[3])
{
	memcpy(out, key_light.towards, sizeof(float[3]));
}
