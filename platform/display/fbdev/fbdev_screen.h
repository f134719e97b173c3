/*
 * A framebuffer device: its layout, its memory and its pages. Nothing here
 * knows of pictures.
 */
#ifndef PLATFORM_DISPLAY_FBDEV_FBDEV_SCREEN_H
#define PLATFORM_DISPLAY_FBDEV_FBDEV_SCREEN_H

#include <linux/fb.h>
#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/display/fbdev/colormap.h"
#include "platform/display/packing.h"
#include "platform/process/device_calls.h"

enum {
	FBDEV_PATH_BYTES = 64
};

struct fbdev_screen {
	const struct device_calls *calls;
	struct log log;
	char path[FBDEV_PATH_BYTES];
	int fd;
	struct fb_fix_screeninfo fix;
	struct fb_var_screeninfo var;
	struct fb_var_screeninfo before; /* to be put back */
	bool changed;                    /* there is something to put back */
	struct pixel_layout layout;
	struct colormap colors;
	int width, height;
	int stride_bytes;
	int page_count; /* 2: flips by panning */
	int page;       /* the one that is shown */
	bool waits;     /* tells when the picture may be changed */
	void *map;
	size_t map_bytes;
	uint8_t *memory; /* of the device, within the map */
};

/*
 * Opens the device, asks for a second page, maps it. 0, or -errno after a
 * sentence, with everything put back and closed.
 */
int fbdev_screen_open(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log);

/*
 * What the device is, without a change to it: fills fix, var, layout, size and
 * stride, and leaves nothing open. 0, or -errno after a sentence.
 */
int fbdev_screen_inspect(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log);

/* The first pixel of the page to draw: not the one shown, if there are two. */
uint8_t *fbdev_screen_back_page(const struct fbdev_screen *screen);

/*
 * Shows the page that was drawn and waits until the other is not seen any
 * more. 0, or -errno after a sentence.
 */
int fbdev_screen_flip(struct fbdev_screen *screen);

/* Waits for the gap between two pictures, where the device can. */
void fbdev_screen_wait(const struct fbdev_screen *screen);

/* Times a second that the screen is drawn, 60 where the device is silent. */
double fbdev_screen_rate_hz(const struct fbdev_screen *screen);

void fbdev_screen_close(struct fbdev_screen *screen);

#endif
