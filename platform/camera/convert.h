/*
 * Camera pictures into RGB565, cut out and scaled.
 */
#ifndef PLATFORM_CAMERA_CONVERT_H
#define PLATFORM_CAMERA_CONVERT_H

#include "platform/camera/camera.h"

/* A part of a picture, within it; x and y even, width and height from 1. */
struct camera_part {
	int x, y, width, height;
};

/* Room for the rows that scaling needs. */
struct camera_scaler {
	uint16_t row[2][CAMERA_SIDE_MAX];
};

/*
 * count pixels of row y, from column x (even) on, as RGB565: each channel is
 * the nearest that there is to BT.601's matrix (ITU-R BT.601-7, 2.5.1, limited
 * range), computed in integers. Chroma is that of the pair or the square.
 */
void camera_convert_row(const struct camera_image *image, int x, int y,
	int count, uint16_t *out);

/*
 * The part as width x height pixels of RGB565 with rows of stride_pixels. At
 * its own size nothing is scaled; where it is at least twice as large, both
 * ways, squares of 2 x 2 are averaged first; then the nearest are taken.
 */
void camera_convert(struct camera_scaler *scaler,
	const struct camera_image *image, const struct camera_part *part,
	int width, int height, uint16_t *out, int stride_pixels);

/*
 * The largest middle part of a picture of this size that has the aspect
 * aspect_width : aspect_height, both above 0.
 */
struct camera_part camera_part_cut(
	int width, int height, int aspect_width, int aspect_height);

#endif
