/*
 * Pictures in the pixels of a screen: whatever fields of up to 32 bits it has.
 */
#ifndef PLATFORM_DISPLAY_PACKING_H
#define PLATFORM_DISPLAY_PACKING_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/display/pixels.h"

struct pixel_field {
	int offset; /* of its lowest bit */
	int length; /* in bits, 0: not there */
};

/* A pixel is a number of that many bits in the machine's byte order. */
struct pixel_layout {
	int bits; /* 1 to 32; stored in whole bytes */
	struct pixel_field red, green, blue;
	struct pixel_field alpha; /* stored as opaque */
	bool gray;                /* the fields are the same: brightness */
};

/*
 * How pictures of one format become pixels of a layout: what each value of a
 * channel adds to the pixel.
 */
struct packing {
	enum pixel_format from;
	bool same; /* the layout is the format */
	int bytes; /* a pixel of the layout */
	uint32_t red[256], green[256], blue[256];
};

/* The layout of a format's own pixels. */
struct pixel_layout pixel_layout_of(enum pixel_format format);

/* Whether all fields lie within the pixel, and do not overlap. */
bool pixel_layout_is_sound(const struct pixel_layout *layout);

/* Bytes a pixel takes. */
int pixel_layout_bytes(const struct pixel_layout *layout);

/* For a sound layout. Channels are rounded to nearest, full stays full. */
void packing_init(struct packing *packing, enum pixel_format from,
	const struct pixel_layout *layout);

/*
 * A picture into memory of the layout; data has room for the picture's rows,
 * stride_bytes apart. Each byte is written once, in order, none is read.
 */
void packing_copy(const struct packing *packing, const struct pixels *picture,
	uint8_t *data, int stride_bytes);

#endif
