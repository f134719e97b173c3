/*
 * A camera's picture behind everything, all over the frame.
 */
#ifndef APP_SCENE_STAGE_BACKDROP_H
#define APP_SCENE_STAGE_BACKDROP_H

#include "app/scene/draw/live_texture.h"

/*
 * Draws it, whatever the matrices were, which are changed; lighting, blending
 * and culling are off. Leaves the depth as it is and the depth test on.
 */
void backdrop_draw(const struct live_texture *texture, const struct gl *gl);

#endif
