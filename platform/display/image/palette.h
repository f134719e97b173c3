/*
 * Reduces the colours of a picture to a palette (colour quantization).
 *
 * The pixels are counted in 64 x 64 x 64 cells of the colour cube. The box of
 * cells with the largest error is split until there are enough boxes. Only
 * palette_maker_create() allocates memory.
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

/* Returns NULL when memory is short. */
struct palette_maker *palette_maker_create(void);

/* Destroys it. NULL is fine. */
void palette_maker_destroy(struct palette_maker *maker);

/*
 * Chooses at most limit (1..PALETTE_COLORS_MAX) colours for an RGBA8888
 * picture. They become the current palette.
 */
void palette_choose(
	struct palette_maker *maker, const struct pixels *picture, int limit);

/* The palette that was chosen last. */
const struct palette *palette_current(const struct palette_maker *maker);

/* The index of the palette colour nearest to the centre of the colour's cell. */
int palette_nearest(struct palette_maker *maker, int red, int green, int blue);

/*
 * The mean squared distance between the picture's colours and the palette,
 * weighted by channel, over one in seven pixels.
 */
float palette_error(struct palette_maker *maker, const struct pixels *picture);

#endif
