/*
 * The colour map of framebuffers whose pixels are indices into tables.
 */
#ifndef PLATFORM_DISPLAY_FBDEV_COLORMAP_H
#define PLATFORM_DISPLAY_FBDEV_COLORMAP_H

#include <linux/fb.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/display/packing.h"
#include "platform/process/device_calls.h"

enum {
	COLORMAP_ENTRIES = 256
};

struct colormap {
	bool changed;   /* before[] must be restored */
	uint32_t count; /* the entries that are set; 0: no colour map */
	uint16_t before[3][COLORMAP_ENTRIES]; /* red, green, blue; 0..65535 */
};

/* The layout of 8-bit pixels with the palette that colormap_set() sets. */
struct pixel_layout colormap_palette_layout(void);

/*
 * Sets the device's colour map so that its pixels have the layout: a palette of
 * 256 colours (FB_VISUAL_PSEUDOCOLOR), or a linear table for each channel
 * (FB_VISUAL_DIRECTCOLOR). Does nothing for FB_VISUAL_TRUECOLOR, which has no
 * colour map. Returns false when the device refuses it.
 */
bool colormap_set(struct colormap *map, const struct device_calls *calls,
	int fd, uint32_t visual, const struct pixel_layout *layout);

/* Restores the colour map that the device had before colormap_set(). */
void colormap_restore(
	const struct colormap *map, const struct device_calls *calls, int fd);

#endif
