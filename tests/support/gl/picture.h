/*
 * Pictures for tests: PNG files and how far apart two of them are.
 */
#ifndef TESTS_SUPPORT_GL_PICTURE_H
#define TESTS_SUPPORT_GL_PICTURE_H

#include <stdbool.h>
#include <stdint.h>

struct picture {
	int width, height;
	uint8_t *rgb; /* [height][width][3], top row first; owned */
};

/* 0, or -1 for a file that is no PNG; alpha is dropped. */
int picture_read(const char *path, struct picture *out);

/* 0, or -1 when it cannot be written. */
int picture_write(const char *path, const struct picture *picture);

/* A black picture; data NULL when memory is short. */
struct picture picture_new(int width, int height);

void picture_release(struct picture *picture);

/* How far a picture may be from its reference; steps are of 255. */
struct picture_tolerance {
	int step;           /* a pixel is near when no channel is further off */
	double far_percent; /* so many pixels may be further off */
	double mean;        /* so large may the mean difference be */
	double block_mean;  /* and the mean of any block of 16 x 16: what
			       catches a small part that is missing */
};

struct picture_difference {
	bool same_size; /* else nothing below is filled */
	double far_percent, mean, block_mean;
	int worst;            /* the largest difference of any channel */
	int block_x, block_y; /* top left of the worst block */
};

struct picture_difference picture_compare(
	const struct picture *a, const struct picture *b, int step);

bool picture_is_near(const struct picture_difference *difference,
	const struct picture_tolerance *tolerance);

/*
 * Both and their difference, eight times as strong, side by side, or a
 * picture without data when the sizes differ or memory is short.
 */
struct picture picture_show_difference(
	const struct picture *a, const struct picture *b);

#endif
