#include "platform/camera/motion.h"

enum {
	NOISE = 6 * 4, /* a change of 6 in each of a cell's four pixels */
};

/* RGB formats have no luma, so green stands for it. */
static int luma_at(const struct camera_image *image, int x, const uint8_t *row)
{
	switch (image->format) {
	case CAMERA_RGB565:
		return ((row[2 * x + 1] & 7) << 3 | row[2 * x] >> 5) * 255 / 63;
	case CAMERA_UYVY:
		return row[2 * x + 1];
	case CAMERA_YUYV:
		return row[2 * x];
	case CAMERA_RGB24:
	case CAMERA_BGR24:
		return row[3 * x + 1];
	default:
		return row[x];
	}
}

/* Sums four pixels, at 1/4 and 3/4 of the cell's width and height. */
static int sum_cell(const struct camera_image *image, int column, int row)
{
	int sum = 0;

	for (int i = 0; i < 4; i++) {
		int x = (4 * column + 1 + i % 2 * 2) * image->width /
			(4 * CAMERA_MOTION_COLUMNS);
		int y = (4 * row + 1 + i / 2 * 2) * image->height /
			(4 * CAMERA_MOTION_ROWS);

		sum += luma_at(
			image, x, image->plane[0] + y * image->stride_bytes[0]);
	}
	return sum;
}

int camera_motion_feed(
	struct camera_motion *motion, const struct camera_image *image)
{
	const int cells = CAMERA_MOTION_COLUMNS * CAMERA_MOTION_ROWS;
	int total = 0; /* at most 4 * 255 * 768 */

	for (int i = 0; i < cells; i++) {
		int column = i % CAMERA_MOTION_COLUMNS;
		int row = i / CAMERA_MOTION_COLUMNS;
		int sum = sum_cell(image, column, row);
		int change = sum - motion->cell[row][column];

		change = change < 0 ? -change : change;
		if (motion->seen && change > NOISE) {
			total += change;
		}
		motion->cell[row][column] = (uint16_t)sum;
	}
	motion->seen = true;
	return total * 64 / cells;
}

void camera_motion_reset(struct camera_motion *motion)
{
	motion->seen = false;
}
