/*
 * The layout of a screen's pixels: fields for the channels in up to 32 bits.
 */
#ifndef PLATFORM_DISPLAY_PIXEL_LAYOUT_H
#define PLATFORM_DISPLAY_PIXEL_LAYOUT_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/display/pixels.h"

struct pixel_field {
	int offset; /* of its lowest bit */
	int length; /* in bits; 0 when the channel does not exist */
};

/* A pixel is an integer of bits bits in the machine's byte order. */
struct pixel_layout {
	int bits; /* 1 to 32; stored in whole bytes */
	struct pixel_field red, green, blue;
	struct pixel_field alpha; /* written as opaque */
	bool gray;                /* the three fields are one: brightness */
};

/* The layout of a picture format. */
struct pixel_layout pixel_layout_of(enum pixel_format format);

/* Whether all fields lie within the pixel and do not overlap. */
bool pixel_layout_is_valid(const struct pixel_layout *layout);

/* The size of a pixel in bytes. */
int pixel_layout_bytes(const struct pixel_layout *layout);

/* The bits of a field of a valid layout. */
uint32_t pixel_layout_mask(struct pixel_field field);

#endif
