/*
 * A screen on a stand, beside what is on the stage, that shows a live picture.
 */
#ifndef APP_SCENE_STAGE_MONITOR_H
#define APP_SCENE_STAGE_MONITOR_H

#include "app/scene/draw/live_texture.h"
#include "app/scene/stage/camera.h"

enum {
	MONITOR_BOXES = 4,
	MONITOR_VERTICES = MONITOR_BOXES * 24,
	MONITOR_INDICES = MONITOR_BOXES * 36
};

struct monitor {
	float origin[3]; /* on the floor, scene units */
	float yaw_rad;   /* where its face looks: 0 along +Z */
	float scale;     /* scene units a unit of its own */

	/* Boxes, in units of which the face is one high. */
	float position[MONITOR_VERTICES][3];
	int8_t normal[MONITOR_VERTICES][4]; /* the last is padding */
	uint16_t index[MONITOR_INDICES];
};

/*
 * Its shape, and a place for it: behind what the camera looks at, on the
 * side that the framing leaves free, turned towards the eye. aspect: the
 * picture's, width / height; floor_y: the level that it stands on.
 */
void monitor_init(struct monitor *monitor, const struct camera *camera,
	float aspect, float floor_y);

/*
 * With the camera's matrix and the lights loaded; the picture glows by itself.
 * NULL for a dark screen.
 */
void monitor_draw(const struct monitor *monitor,
	const struct live_texture *picture, const struct gl *gl);

/* Its outline alone, in the current colour and state. */
void monitor_draw_geometry(const struct monitor *monitor, const struct gl *gl);

#endif
