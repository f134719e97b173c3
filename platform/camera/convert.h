/*
 * Converts camera pictures to RGB565, cropped and scaled.
 */
#ifndef PLATFORM_CAMERA_CONVERT_H
#define PLATFORM_CAMERA_CONVERT_H

#include "platform/camera/camera.h"

/* A rectangle within a picture; x and y are even, width and height not 0. */
struct camera_part {
	int x, y, width, height;
};

/* The row buffers that scaling needs. */
struct camera_scaler {
	uint16_t row[2][CAMERA_SIDE_MAX];
};

/*
 * Converts count pixels of row y, from the even column x on, to RGB565. The
 * formula is that of ITU-R BT.601-7, 2.5.1 (limited range) in integers; each
 * channel is rounded to nearest. Chroma is not interpolated.
 */
void camera_convert_row(const struct camera_image *image, int x, int y,
	int count, uint16_t *out);

/*
 * Converts a part of a picture to width x height pixels of RGB565 in rows of
 * stride_pixels. If the part is at least twice as large in both directions,
 * 2 x 2 pixels are averaged first. Then the nearest pixels are taken.
 */
void camera_convert(struct camera_scaler *scaler,
	const struct camera_image *image, const struct camera_part *part,
	int width, int height, uint16_t *out, int stride_pixels);

/*
 * The largest centred part of a picture of this size that has the aspect ratio
 * aspect_width : aspect_height, both above 0.
 */
struct camera_part camera_part_cut(
	int width, int height, int aspect_width, int aspect_height);

#endif
