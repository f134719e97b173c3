/*
 * The lights of a stage: a warm key light, a cool fill light, and ambient light.
 */
#ifndef APP_SCENE_STAGE_LIGHT_H
#define APP_SCENE_STAGE_LIGHT_H

#include "platform/gl/gl.h"

/*
 * Sets up the lights in world space. The model-view matrix must be the
 * camera's, because GL transforms light directions by it.
 */
void light_apply(const struct gl *gl);

/* Which part of the light a pass draws. */
enum light_selection {
	LIGHT_ALL,
	LIGHT_KEY_COLOR, /* the key light's colour, independent of normals */
	LIGHT_REMAINDER, /* all but the key light's diffuse term */
};

/* Call light_apply() first; the model-view matrix does not matter here. */
void light_select(const struct gl *gl, enum light_selection selection);

/*
 * Sets the state of an opaque, lit, untextured material with back faces culled.
 * color is sRGB-encoded, 0 to 1; specular (0 to 1, gray) and shininess (0 to
 * 128) are GL's.
 */
void light_set_material(const struct gl *gl, const float color[3],
	float specular, int shininess);

/*
 * Returns the unit vector from any point to the key light, which casts the
 * shadows.
 */
void light_direction(float out[3]);

#endif
