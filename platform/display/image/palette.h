/*
 * Few colours for a picture of many.
 *
 * Colours are counted in 64 x 64 x 64 cells; boxes of cells are split where
 * they vary most until there are as many as colours asked for. Nothing is
 * allocated but by palette_maker_create().
 */
#ifndef PLATFORM_DISPLAY_IMAGE_PALETTE_H
#define PLATFORM_DISPLAY_IMAGE_PALETTE_H

#include <stdint.h>

#include "platform/display/pixels.h"

enum {
	PALETTE_COLORS_MAX = 256
};

struct palette {
	uint8_t rgb[PALETTE_COLORS_MAX][3];
	int count;
};

struct palette_maker;

/* NULL when memory is short. */
struct palette_maker *palette_maker_create(void);

/* NULL is fine. */
void palette_maker_destroy(struct palette_maker *maker);

/*
 * Chooses at most limit (1..PALETTE_COLORS_MAX) colours for an RGBA8888
 * picture. palette_nearest() searches among them from now on.
 */
void palette_choose(
	struct palette_maker *maker, const struct pixels *picture, int limit);

/* What was chosen last. */
const struct palette *palette_current(const struct palette_maker *maker);

/* The index of the colour nearest to this one, to a precision of 1/64. */
int palette_nearest(struct palette_maker *maker, int red, int green, int blue);

/*
 * The mean squared distance of the picture's colours (one in so many pixels)
 * from those chosen.
 */
float palette_error(struct palette_maker *maker, const struct pixels *picture);

#endif
