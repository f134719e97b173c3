/*
 * A made-up framebuffer with a console, behind struct device_calls.
 *
 * There is one at a time, because the calls carry no context. Tests read and
 * write the members of fake_fb themselves.
 */
#ifndef TESTS_SUPPORT_FAKE_FAKE_FB_H
#define TESTS_SUPPORT_FAKE_FAKE_FB_H

#include <linux/fb.h>
#include <linux/vt.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/display/packing.h"
#include "platform/process/device_calls.h"

enum {
	FAKE_FB_BYTES = 1 << 20,
	FAKE_FB_LEAD = 64 /* bytes of the first page before the memory */
};

struct fake_fb {
	struct fb_fix_screeninfo fix;
	struct fb_var_screeninfo var;
	uint16_t colors[3][256]; /* red, green, blue tables */
	uint8_t map[FAKE_FB_BYTES];
	uint8_t *memory; /* smem_len bytes within map */

	int open_error;             /* errno of open(); 0 lets it succeed */
	unsigned long fail_request; /* the ioctl that fails; 0 means none */
	int fail_from; /* its first call that fails, counted from 0 */
	int fail_error;
	bool fail_map;
	bool rounds_width; /* the driver narrows the next mode that is set */
	bool has_wait;
	bool has_console;
	int console_mode;
	int console_flushes;  /* of what was typed */
	bool console_watched; /* another program handles console switches */
	struct vt_mode console_switching;
	int console_answers; /* to questions whether to switch */
	int console_answer;  /* the last one */
	int report_fd; /* also gets each console mode as a byte; -1 means none */

	int open_count; /* open descriptors */
	int map_count;
	int call_count; /* of fail_request */
	int put_count, pan_count, wait_count;
};

extern struct fake_fb fake_fb;
extern const struct device_calls fake_fb_calls;

/*
 * Makes a screen of this size and layout, whose bytes are all 0xEE. Its memory
 * has space for rows; it claims virtual_rows.
 */
void fake_fb_begin(int width, int height, int rows, int virtual_rows,
	int stride_bytes, struct pixel_layout layout);

/* The value of the pixel that the screen shows at (x, y). */
uint32_t fake_fb_seen(int x, int y);

#endif
