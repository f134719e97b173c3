/*
 * Converts pictures to the pixel layout of a screen.
 */
#ifndef PLATFORM_DISPLAY_PACKING_H
#define PLATFORM_DISPLAY_PACKING_H

#include "platform/display/pixel_layout.h"

struct packing;

/* Converts a row of width pixels. */
typedef void (*packing_row)(const struct packing *packing, const uint8_t *in,
	uint8_t *out, int width);

/* Tables that convert pixels: the screen's pixel is the sum of three entries. */
struct packing {
	enum pixel_format from;
	bool same; /* the layout is that of the format without alpha: rows are
		      copied */
	int bytes; /* of a pixel of the layout */
	uint32_t opaque; /* the bits of alpha */
	packing_row copy_row;
	uint32_t red[256], green[256], blue[256]; /* [value of the channel] */
};

/*
 * Fills the tables for a valid layout. Channels are rounded to nearest, so that
 * a full channel stays full.
 */
void packing_init(struct packing *packing, enum pixel_format from,
	const struct pixel_layout *layout);

/*
 * Writes a picture to data, in rows stride_bytes apart. Each byte is written
 * once and in order, and none is read.
 */
void packing_copy(const struct packing *packing, const struct pixels *picture,
	uint8_t *data, int stride_bytes);

/*
 * Writes a row of black pixels, which are opaque if the layout has alpha: zeros
 * would let what is behind the screen show through.
 */
void packing_blacken(const struct packing *packing, uint8_t *data, int width);

#endif
