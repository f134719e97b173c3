/*
 * Reads and writes PNG files for tests, and measures the difference between two
 * pictures.
 */
#ifndef TESTS_SUPPORT_GL_PICTURE_H
#define TESTS_SUPPORT_GL_PICTURE_H

#include <stdbool.h>
#include <stdint.h>

struct picture {
	int width, height;
	uint8_t *rgb; /* [height][width][3], top row first; owned */
};

/* Returns 0, or -1 for a file that is not a PNG. Ignores alpha. */
int picture_read(const char *path, struct picture *out);

/* Returns 0, or -1 when the file cannot be written. */
int picture_write(const char *path, const struct picture *picture);

/* Makes a black picture; its rgb is NULL when memory is short. */
struct picture picture_new(int width, int height);

void picture_release(struct picture *picture);

/* How much a picture may differ from its reference; channels are 0..255. */
struct picture_tolerance {
	int step;           /* a pixel is far when a channel differs by more */
	double far_percent; /* of the pixels may be far */
	double mean;        /* limit of the mean difference of all channels */
	double block_mean;  /* the same for each block of 16 x 16 pixels, which
			       catches a small part that is missing */
	int block_strays;   /* stray pixels of any block of 16 x 16 pixels,
			       which catch a thin seam or a small patch */
};

/*
 * A stray is a far pixel whose colour the other picture does not have there: a
 * channel lies more than step outside the range of the 3 x 3 pixels around that
 * place. An edge that is off by less than a pixel makes no strays.
 */
struct picture_difference {
	bool same_size; /* if not, the members below are 0 */
	double far_percent, mean, block_mean;
	int worst;            /* the largest difference of any channel */
	int block_x, block_y; /* upper left corner of the worst block */
	int block_strays;     /* of the block with most */
	int stray_x, stray_y; /* upper left corner of that block */
};

struct picture_difference picture_compare(
	const struct picture *a, const struct picture *b, int step);

bool picture_is_near(const struct picture_difference *difference,
	const struct picture_tolerance *tolerance);

/*
 * Makes a picture of both and of eight times their difference, side by side.
 * Its rgb is NULL when the sizes differ or memory is short.
 */
struct picture picture_show_difference(
	const struct picture *a, const struct picture *b);

#endif
