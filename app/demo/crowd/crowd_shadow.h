/*
 * The shadow of somebody far off: a flat outline in place of a figure.
 */
#ifndef APP_DEMO_CROWD_CROWD_SHADOW_H
#define APP_DEMO_CROWD_CROWD_SHADOW_H

#include "app/demo/crowd/crowd_route.h"
#include "platform/gl/gl.h"

/*
 * Draws the outline of somebody who stands upright at the spot and faces the
 * light, 1.72 m high. Between stage_shadow_begin() and stage_shadow_end();
 * leaves the matrix as it was.
 */
void crowd_shadow_draw(
	const struct crowd_position *position, const struct gl *gl);

#endif
