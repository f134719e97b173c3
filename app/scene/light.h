/*
 * The lights of a stage: a warm key light, a cool fill light, soft ambient.
 */
#ifndef APP_SCENE_LIGHT_H
#define APP_SCENE_LIGHT_H

#include "platform/gl/gl.h"

/* Sets them in world space: the model-view matrix is the camera's now. */
void light_apply(const struct gl *gl);

/* Unit vector from a point towards the key light, which casts shadows. */
void light_direction(float out[3]);

#endif
