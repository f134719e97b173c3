/*
 * A small lit ball, the target of the walker's look-at and reach.
 */
#ifndef APP_SCENE_STAGE_BALL_H
#define APP_SCENE_STAGE_BALL_H

#include "app/scene/stage/stage.h"
#include "platform/gl/gl.h"

enum {
	BALL_RINGS = 9,
	BALL_SPOKES = 14,
	BALL_VERTICES = (BALL_RINGS + 1) * (BALL_SPOKES + 1),
	BALL_INDICES = BALL_RINGS * BALL_SPOKES * 6,
};

struct ball {
	float normal[BALL_VERTICES][3]; /* also the positions: the radius is 1 */
	uint16_t index[BALL_INDICES];
};

void ball_init(struct ball *ball);

/*
 * Draws the ball's shadow on the floor, level or uneven, with the camera's
 * matrix loaded.
 */
void ball_draw_shadow(const struct gl *gl, const float center[3], float radius,
	const struct stage *stage);

/*
 * Draws the ball with the camera's matrix and the lights loaded. center and
 * radius are in scene units, color is sRGB-encoded, 0 to 1.
 */
void ball_draw(const struct ball *ball, const struct gl *gl,
	const float center[3], float radius, const float color[3]);

#endif
