/*
 * How much moves before a camera: the difference between one picture and the
 * next.
 */
#ifndef PLATFORM_CAMERA_MOTION_H
#define PLATFORM_CAMERA_MOTION_H

#include "platform/camera/camera.h"

enum {
	CAMERA_MOTION_COLUMNS = 32,
	CAMERA_MOTION_ROWS = 24,
};

struct camera_motion {
	bool seen; /* cell holds a picture */
	uint16_t cell[CAMERA_MOTION_ROWS][CAMERA_MOTION_COLUMNS];
};

/*
 * The mean over a grid of cells of how far each cell's luma is from the last
 * picture's, of 255, in Q8; a cell's noise, differences of up to 6, does not
 * count. 0 for the first picture. A cell's luma is the mean of four points.
 */
int camera_motion_feed(
	struct camera_motion *motion, const struct camera_image *image);

/* Forgets the last picture. */
void camera_motion_reset(struct camera_motion *motion);

#endif
