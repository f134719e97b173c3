/*
 * Measures how much moves in front of a camera, from the difference between
 * one picture and the next.
 */
#ifndef PLATFORM_CAMERA_MOTION_H
#define PLATFORM_CAMERA_MOTION_H

#include "platform/camera/camera.h"

enum {
	CAMERA_MOTION_COLUMNS = 32,
	CAMERA_MOTION_ROWS = 24,
};

struct camera_motion {
	bool seen; /* cell[] holds the last picture */
	uint16_t cell[CAMERA_MOTION_ROWS][CAMERA_MOTION_COLUMNS];
};

/*
 * Compares a picture with the last one: the mean over all cells of |change of
 * luma|, in 0..255 as Q8. The luma of a cell is the mean of four of its pixels.
 * Changes of up to 6 count as noise and are ignored. Returns 0 for the first
 * picture.
 */
int camera_motion_feed(
	struct camera_motion *motion, const struct camera_image *image);

/* Forgets the last picture. */
void camera_motion_reset(struct camera_motion *motion);

#endif
