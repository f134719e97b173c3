/*
 * Framebuffers whose pixels are looked up in tables of colours.
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
	bool changed; /* there is one to put back */
	uint32_t count;
	uint16_t before[3][COLORMAP_ENTRIES]; /* red, green, blue */
};

/* What pixels of 8 bits mean with the palette of colormap_set(). */
struct pixel_layout colormap_palette_layout(void);

/*
 * Fills the device's tables so that pixels mean what layout says: a palette of
 * 256 (FB_VISUAL_PSEUDOCOLOR), or a straight table for each channel
 * (FB_VISUAL_DIRECTCOLOR). Where there are none (FB_VISUAL_TRUECOLOR) nothing
 * is done. False when the device does not take them.
 */
bool colormap_set(struct colormap *map, const struct device_calls *calls,
	int fd, uint32_t visual, const struct pixel_layout *layout);

/* As they were. */
void colormap_restore(
	const struct colormap *map, const struct device_calls *calls, int fd);

#endif
