/*
 * A video camera's image as the background of the whole frame.
 */
#ifndef APP_SCENE_STAGE_BACKDROP_H
#define APP_SCENE_STAGE_BACKDROP_H

#include "app/scene/draw/live_texture.h"

/*
 * Draws the image over the whole viewport. Expects lighting, blending and
 * culling to be off. Replaces the projection and model-view matrices, does not
 * write depth, and leaves the depth test enabled.
 */
void backdrop_draw(const struct live_texture *texture, const struct gl *gl);

#endif
