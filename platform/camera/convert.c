#include "platform/camera/convert.h"

#include <string.h>

/* The mean of four colours, each channel rounded to nearest. */
static uint16_t mean_of_4(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
	const uint32_t green = 0x07e0, others = 0xf81f;
	/* A sum of four values needs two more bits. Green is added apart from
	 * red and blue, so the bits above each channel are free. */
	uint32_t sum_green = (a & green) + (b & green) + (c & green) +
		(d & green) + (2u << 5);
	uint32_t sum_others = (a & others) + (b & others) + (c & others) +
		(d & others) + (2u << 11 | 2u);

	return (uint16_t)((sum_green >> 2 & green) | (sum_others >> 2 & others));
}

/* Averages 2 x 2 pixels of two rows, of 2 * count pixels each, into row. */
static void halve_rows(uint16_t *row, const uint16_t *below, int count)
{
	for (int i = 0; i < count; i++) {
		row[i] = mean_of_4(row[2 * i], row[2 * i + 1], below[2 * i],
			below[2 * i + 1]);
	}
}

static void pick_columns(
	const uint16_t *row, int row_width, uint16_t *out, int width)
{
	uint32_t step_q16 = ((uint32_t)row_width << 16) / (uint32_t)width;
	uint32_t at_q16 = step_q16 / 2;

	for (int i = 0; i < width; i++) {
		out[i] = row[at_q16 >> 16];
		at_q16 += step_q16;
	}
}

static void convert_scaled(struct camera_scaler *scaler,
	const struct camera_image *image, const struct camera_part *part,
	int width, int height, uint16_t *out, int stride_pixels)
{
	int halved = part->width >= 2 * width && part->height >= 2 * height;
	int row_width = part->width >> halved;
	int rows = part->height >> halved;
	uint32_t step_q16 = ((uint32_t)rows << 16) / (uint32_t)height;
	uint32_t at_q16 = step_q16 / 2;
	int last = -1;

	for (int i = 0; i < height; i++, out += stride_pixels) {
		int y = (int)(at_q16 >> 16);

		at_q16 += step_q16;
		if (y == last) {
			memcpy(out, out - stride_pixels,
				(size_t)width * sizeof(*out));
			continue;
		}
		last = y;
		y = part->y + (y << halved);
		camera_convert_row(
			image, part->x, y, row_width << halved, scaler->row[0]);
		if (halved) {
			camera_convert_row(image, part->x, y + 1,
				row_width << halved, scaler->row[1]);
			halve_rows(scaler->row[0], scaler->row[1], row_width);
		}
		pick_columns(scaler->row[0], row_width, out, width);
	}
}

void camera_convert(struct camera_scaler *scaler,
	const struct camera_image *image, const struct camera_part *part,
	int width, int height, uint16_t *out, int stride_pixels)
{
	if (part->width != width || part->height != height) {
		convert_scaled(
			scaler, image, part, width, height, out, stride_pixels);
		return;
	}
	for (int y = 0; y < height; y++) {
		camera_convert_row(image, part->x, part->y + y, width, out);
		out += stride_pixels;
	}
}

struct camera_part camera_part_cut(
	int width, int height, int aspect_width, int aspect_height)
{
	struct camera_part part = {0, 0, width, height};
	int64_t fitting = (int64_t)height * aspect_width / aspect_height;

	if (fitting < width) {
		part.width = fitting < 1 ? 1 : (int)fitting;
	} else {
		int64_t high = (int64_t)width * aspect_height / aspect_width;

		part.height = high < 1 ? 1 : high > height ? height : (int)high;
	}
	part.x = (width - part.width) / 2 & ~1;
	part.y = (height - part.height) / 2 & ~1;
	return part;
}
