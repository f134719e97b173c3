/*
 * A monitor on a stand beside the figure, which shows a video camera's image.
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
	float origin[3]; /* the foot's centre on the floor, scene units */
	float yaw_rad;   /* 0 faces +Z */
	float scale;     /* from local units to scene units */

	/* The boxes' faces in local units: the screen is 1 high. */
	float position[MONITOR_VERTICES][3];
	int8_t normal[MONITOR_VERTICES][4]; /* the last byte is padding */
	uint16_t index[MONITOR_INDICES];
};

/* Makes the mesh, which monitor_place() gives its place. */
void monitor_init(struct monitor *monitor);

/*
 * Places the monitor behind the camera's target, on the side that the framing
 * leaves free, turned to the eye. aspect is the frame's width / height, floor_y
 * the height that the monitor stands on.
 */
void monitor_place(struct monitor *monitor, const struct camera *camera,
	float aspect, float floor_y);

/*
 * Draws the monitor with the camera's matrix and the lights loaded. The picture
 * is unlit; NULL draws a dark screen.
 */
void monitor_draw(const struct monitor *monitor,
	const struct live_texture *picture, const struct gl *gl);

/* Draws the boxes' positions in the current colour and state. */
void monitor_draw_geometry(const struct monitor *monitor, const struct gl *gl);

#endif
