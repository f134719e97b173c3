/*
 * A camera's view of a level plane, row by row of the picture.
 *
 * The camera does not roll, so all ground in one row of pixels is equally far
 * ahead. A row is given by its slope: the height of its ray at depth 1 in eye
 * space.
 */
#ifndef APP_SCENE_STAGE_FLOOR_VIEW_H
#define APP_SCENE_STAGE_FLOOR_VIEW_H

#include "app/scene/stage/camera.h"

/* Lengths are in scene units. */
struct floor_view {
	mat4 world_to_eye;
	float eye[3];
	float left, right, bottom, top; /* the picture at depth 1, inset */
	float edge, row;    /* slope of the lower edge; step between rows */
	float error_px;     /* by which rounding may displace a point */
	float sine, cosine; /* of the camera's pitch below the horizon */
	float height;       /* of the eye above the plane */
	float near, far;    /* depths of the clip planes, inset */
};

/* Initializes the view of the plane at the height ground. */
void floor_view_init(struct floor_view *view, const struct camera *camera,
	int width, int height, float ground);

/*
 * These expect an eye above the plane and a row below the horizon. They return
 * the plane's depth in eye space in a row; the row in which the plane has a
 * depth, which a camera that looks straight down does not have; and the plane's
 * level distance ahead of the eye in a row.
 */
float floor_view_depth(const struct floor_view *view, float slope);
float floor_view_slope(const struct floor_view *view, float depth);
float floor_view_ahead(const struct floor_view *view, float slope);

/* Returns the row that shows the plane at a level distance ahead of the eye. */
float floor_view_slope_ahead(const struct floor_view *view, float ahead);

/*
 * Computes the point of the plane that appears in a row, this far to the right
 * of the line of sight; slope and across are taken at depth 1.
 */
void floor_view_unproject(
	const struct floor_view *view, float slope, float across, float out[3]);

#endif
