/*
 * A framebuffer device: its layout, its memory and its pages.
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

enum {
	FBDEV_PAGES_MAX = 3
};

struct fbdev_screen {
	const struct device_calls *calls;
	struct log log;
	char path[FBDEV_PATH_BYTES];
	int fd;
	struct fb_fix_screeninfo fix;
	struct fb_var_screeninfo var;
	struct fb_var_screeninfo before; /* restored by fbdev_screen_close() */
	bool changed;                    /* before has to be restored */
	bool left;                       /* before has been restored */
	struct pixel_layout layout;
	struct colormap colors;
	int width, height;
	int stride_bytes;
	int page_count; /* 1, or up to FBDEV_PAGES_MAX to flip by panning */
	int page;       /* the page that is shown */
	int missed;     /* pictures in a row that were not shown in time */
	bool waits;     /* the device can wait for vertical blanking */
	void *map;
	size_t map_bytes;
	uint8_t *memory; /* the framebuffer, within map */
};

/*
 * Opens and maps the device, with two pages if possible; with three where it
 * cannot wait for vertical blanking. Returns 0, or -errno after logging an
 * error, with everything restored and closed.
 */
int fbdev_screen_open(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log);

/*
 * Fills fix, var, layout, size and stride without changing the device, and
 * leaves nothing open. Returns 0, or -errno after logging an error.
 */
int fbdev_screen_inspect(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log);

/* The first pixel of the page that is shown next, or of the only page. */
uint8_t *fbdev_screen_back_page(const struct fbdev_screen *screen);

/*
 * Shows the back page and, if the device supports waiting, waits until the page
 * shown before is off the screen. If the device is busy, as long as the screen
 * is off, the page is left out and stays the back page. Returns 0, or -errno
 * after logging an error: the device has failed, or was busy too often.
 */
int fbdev_screen_flip(struct fbdev_screen *screen);

/* Waits for vertical blanking, if the device supports that. */
void fbdev_screen_wait(const struct fbdev_screen *screen);

/* The refresh rate, or 60 when the device does not report a plausible one. */
double fbdev_screen_rate_hz(const struct fbdev_screen *screen);

/* Restores the device's settings for another program, until it comes back. */
void fbdev_screen_leave(struct fbdev_screen *screen);

/*
 * Sets the device as fbdev_screen_open() did, after fbdev_screen_leave(). Its
 * memory may have changed. Returns 0, or -errno after logging an error: another
 * program has changed what cannot be set back.
 */
int fbdev_screen_return(struct fbdev_screen *screen);

/* Restores the device's settings and closes it. */
void fbdev_screen_close(struct fbdev_screen *screen);

#endif
