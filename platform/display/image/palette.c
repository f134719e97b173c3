#include "platform/display/image/palette.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/scalar.h"

enum {
	LEVELS = 64,
	CELLS = LEVELS * LEVELS * LEVELS,
	UNKNOWN = 0xFFFF,
	ERROR_STEP = 7, /* pixels between samples; divides no common width */
};

/* The visual weight of a difference in red, green and blue. */
static const int eye[3] = {2, 4, 3};

/* The number of pixels in a cell, and the sums of their channels modulo 4. */
struct count {
	uint32_t pixels;
	uint32_t low[3]; /* at most 3 * 2^26 */
};

struct cell {
	float rgb[3];
	float weight;
};

/* A range of cell[] and the distribution of the cells' colours. */
struct box {
	int first, count;
	float mean[3];
	float error; /* the sum of weight * distance^2 */
	int axis;    /* the channel with the largest variance */
};

struct palette_maker {
	struct palette palette;
	struct count count[CELLS];
	struct cell cell[CELLS];
	int cell_count;
	struct box box[PALETTE_COLORS_MAX];
	uint16_t nearest[CELLS]; /* index of a colour, or UNKNOWN */
};

struct palette_maker *palette_maker_create(void)
{
	return calloc(1, sizeof(struct palette_maker));
}

void palette_maker_destroy(struct palette_maker *maker)
{
	free(maker);
}

static int cell_of(int red, int green, int blue)
{
	return (red >> 2) << 12 | (green >> 2) << 6 | blue >> 2;
}

static void count_pixels(
	struct palette_maker *maker, const struct pixels *picture)
{
	memset(maker->count, 0, sizeof(maker->count));
	for (int y = 0; y < picture->height; y++) {
		const uint8_t *pixel = picture->data + y * picture->stride_bytes;

		for (int x = 0; x < picture->width; x++, pixel += 4) {
			struct count *count = &maker->count[cell_of(
				pixel[0], pixel[1], pixel[2])];

			count->pixels++;
			count->low[0] += pixel[0] & 3;
			count->low[1] += pixel[1] & 3;
			count->low[2] += pixel[2] & 3;
		}
	}
}

/*
 * A cell's weight is the square root of its number of pixels, so that small
 * objects in front of a large background keep their colours.
 */
static void list_cells(struct palette_maker *maker)
{
	maker->cell_count = 0;
	for (int i = 0; i < CELLS; i++) {
		const struct count *count = &maker->count[i];
		struct cell *cell = &maker->cell[maker->cell_count];
		const int corner[3] = {
			i >> 12 << 2, (i >> 6 & 63) << 2, (i & 63) << 2};

		if (count->pixels == 0) {
			continue;
		}
		for (int j = 0; j < 3; j++) {
			cell->rgb[j] = (float)corner[j] +
				(float)count->low[j] / (float)count->pixels;
		}
		cell->weight = scalar_sqrt((float)count->pixels);
		maker->cell_count++;
	}
}

static void measure(const struct palette_maker *maker, struct box *box)
{
	float weight = 0, sum[3] = {0}, variance[3] = {0};

	for (int i = box->first; i < box->first + box->count; i++) {
		const struct cell *cell = &maker->cell[i];

		weight += cell->weight;
		for (int j = 0; j < 3; j++) {
			sum[j] += cell->weight * cell->rgb[j];
		}
	}
	for (int j = 0; j < 3; j++) {
		box->mean[j] = sum[j] / weight;
	}
	for (int i = box->first; i < box->first + box->count; i++) {
		const struct cell *cell = &maker->cell[i];

		for (int j = 0; j < 3; j++) {
			float difference = cell->rgb[j] - box->mean[j];

			variance[j] += cell->weight * difference * difference *
				(float)eye[j];
		}
	}
	box->error = variance[0] + variance[1] + variance[2];
	box->axis = variance[1] >= variance[0] ? 1 : 0;
	box->axis = variance[2] > variance[box->axis] ? 2 : box->axis;
}

/*
 * Moves the cells of a box whose value on its axis is at most the mean to the
 * front. Returns their number.
 */
static int partition(struct palette_maker *maker, const struct box *box)
{
	float middle = box->mean[box->axis];
	int low = box->first;

	for (int i = box->first; i < box->first + box->count; i++) {
		if (maker->cell[i].rgb[box->axis] <= middle) {
			struct cell moved = maker->cell[i];

			maker->cell[i] = maker->cell[low];
			maker->cell[low++] = moved;
		}
	}
	return low - box->first;
}

/* Returns false when rounding left all cells on one side of their mean. */
static bool split(struct palette_maker *maker, struct box *box, struct box *out)
{
	int low = partition(maker, box);

	if (low == 0 || low == box->count) {
		box->error = 0;
		return false;
	}
	out->first = box->first + low;
	out->count = box->count - low;
	box->count = low;
	measure(maker, box);
	measure(maker, out);
	return true;
}

static int make_boxes(struct palette_maker *maker, int limit)
{
	struct box *box = maker->box;
	int count = 1;

	box[0] = (struct box){.count = maker->cell_count};
	measure(maker, &box[0]);
	while (count < limit) {
		struct box *worst = &box[0];

		for (int i = 1; i < count; i++) {
			worst = box[i].error > worst->error ? &box[i] : worst;
		}
		/* Smaller errors come from rounding only. */
		if (worst->error < 1e-3f) {
			break;
		}
		count += split(maker, worst, &box[count]);
	}
	return count;
}

void palette_choose(
	struct palette_maker *maker, const struct pixels *picture, int limit)
{
	struct palette *palette = &maker->palette;

	count_pixels(maker, picture);
	list_cells(maker);
	palette->count = make_boxes(maker, limit);
	for (int i = 0; i < palette->count; i++) {
		for (int j = 0; j < 3; j++) {
			palette->rgb[i][j] =
				(uint8_t)(maker->box[i].mean[j] + 0.5f);
		}
	}
	memset(maker->nearest, 0xFF, sizeof(maker->nearest));
}

const struct palette *palette_current(const struct palette_maker *maker)
{
	return &maker->palette;
}

static int distance(const uint8_t *color, int red, int green, int blue)
{
	int dr = color[0] - red, dg = color[1] - green, db = color[2] - blue;

	return eye[0] * dr * dr + eye[1] * dg * dg + eye[2] * db * db;
}

static int search(const struct palette *palette, int red, int green, int blue)
{
	int best = 0;
	int best_distance = distance(palette->rgb[0], red, green, blue);

	for (int i = 1; i < palette->count; i++) {
		int next = distance(palette->rgb[i], red, green, blue);

		if (next < best_distance) {
			best_distance = next;
			best = i;
		}
	}
	return best;
}

int palette_nearest(struct palette_maker *maker, int red, int green, int blue)
{
	uint16_t *known = &maker->nearest[cell_of(red, green, blue)];

	if (*known == UNKNOWN) {
		*known = (uint16_t)search(&maker->palette, (red & ~3) + 2,
			(green & ~3) + 2, (blue & ~3) + 2);
	}
	return *known;
}

float palette_error(struct palette_maker *maker, const struct pixels *picture)
{
	int pixels = picture->width * picture->height;
	float sum = 0;
	int count = 0;

	for (int i = 0; i < pixels; i += ERROR_STEP, count++) {
		const uint8_t *pixel = picture->data +
			i / picture->width * picture->stride_bytes +
			i % picture->width * 4;
		int index = palette_nearest(maker, pixel[0], pixel[1], pixel[2]);

		sum += (float)distance(maker->palette.rgb[index], pixel[0],
			pixel[1], pixel[2]);
	}
	return sum / (float)count;
}
