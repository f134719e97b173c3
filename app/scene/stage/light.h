/*
 * The lights of a stage: a warm key light, a cool fill light, soft ambient.
 */
#ifndef APP_SCENE_STAGE_LIGHT_H
#define APP_SCENE_STAGE_LIGHT_H

#include "platform/gl/gl.h"

/* Sets them in world space: the model-view matrix is the camera's now. */
void light_apply(const struct gl *gl);

/* What of them shines. */
enum light_selection {
	LIGHT_ALL,
	LIGHT_KEY_COLOR, /* the key light's colour, whatever way surfaces face */
	LIGHT_REMAINDER, /* fill and ambient, and the key light's highlight */
};

/* After light_apply(); under any model-view matrix. */
void light_select(const struct gl *gl, enum light_selection choice);

/*
 * What comes next is lit and of one colour, without texture, and only its
 * outside shows; specular and shininess are GL's. For the stage's own things.
 */
void light_set_material(const struct gl *gl, const float color[3],
	float specular, int shininess);

/* Unit vector from a point towards the key light, which casts shadows. */
void light_direction(float out[3]);

#endif
