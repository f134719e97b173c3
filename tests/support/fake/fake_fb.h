/*
 * A framebuffer and a console that are not there, behind struct device_calls.
 *
 * One at a time, since the calls carry no context. What a test looks at is
 * open to it; opened and closed things are counted.
 */
#ifndef TESTS_SUPPORT_FAKE_FAKE_FB_H
#define TESTS_SUPPORT_FAKE_FAKE_FB_H

#include <linux/fb.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/display/packing.h"
#include "platform/process/device_calls.h"

enum {
	FAKE_FB_ROOM = 1 << 20,
	FAKE_FB_LEAD = 64 /* bytes of its memory's page before it begins */
};

struct fake_fb {
	struct fb_fix_screeninfo fix;
	struct fb_var_screeninfo var;
	uint16_t colors[3][256]; /* red, green, blue tables */
	uint8_t map[FAKE_FB_ROOM];
	uint8_t *memory; /* smem_len bytes within the map */

	int open_error;             /* of the framebuffer, 0: it opens */
	unsigned long fail_request; /* an ioctl that fails, 0: none */
	int fail_from;              /* from its Nth call on, counted from 0 */
	int fail_error;
	bool fail_map;
	bool rounds_width; /* setting a mode changes more than was asked */
	bool has_wait;
	bool has_console;
	int console_mode;
	bool console_watched; /* by another program */
	int report_fd; /* console modes are written there, too; -1: not */

	int open_count; /* now */
	int map_count;
	int call_count; /* of fail_request */
	int put_count, pan_count, wait_count;
};

extern struct fake_fb fake_fb;
extern const struct device_calls fake_fb_calls;

/*
 * A screen of this size and layout, all bytes 0xEE. rows: of its memory,
 * virtual_rows: that it says it has.
 */
void fake_fb_begin(int width, int height, int rows, int virtual_rows,
	int stride_bytes, struct pixel_layout layout);

/* The pixel that is seen there, as a number. */
uint32_t fake_fb_seen(int x, int y);

#endif
