/*
 * The shadow of a distant walker: a flat outline in place of the figure.
 */
#ifndef APP_DEMO_CROWD_CROWD_SHADOW_H
#define APP_DEMO_CROWD_CROWD_SHADOW_H

#include "app/demo/crowd/crowd_route.h"
#include "platform/gl/gl.h"

#include <stdbool.h>

/* The outline: that of a person 1.72 m high, or an ellipse on the ground. */
struct crowd_shadow {
	bool fits; /* else only the figure's own shadow does */
	bool is_person;
	float half_width_m, height_m; /* of the ellipse */
};

/*
 * Draws the outline of a figure that stands at the position and faces the
 * light. Call it between stage_shadow_begin() and stage_shadow_end().
 * Restores the matrix.
 */
void crowd_shadow_draw(const struct crowd_shadow *shadow,
	const struct crowd_position *position, const struct gl *gl);

#endif
