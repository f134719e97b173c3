/*
 * How large a walker of the crowd appears.
 */
#ifndef APP_DEMO_CROWD_CROWD_HEIGHT_H
#define APP_DEMO_CROWD_CROWD_HEIGHT_H

#include "app/demo/crowd/crowd_route.h"
#include "app/scene/stage/camera.h"

/*
 * Returns the height in pixels of a figure of this height in metres, in a
 * picture of picture_height.
 */
float crowd_height_px(const struct camera *camera,
	const struct crowd_position *position, float height_m,
	int picture_height);

#endif
