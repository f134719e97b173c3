#include "tests/support/fake/fake_fb.h"

#include <errno.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <termios.h>
#include <unistd.h>

enum {
	FB_FD = 0, /* a descriptor like any other */
	CONSOLE_FD = 1001
};

struct fake_fb fake_fb;

static int fail_with(int error)
{
	errno = error;
	return -1;
}

static int fake_open(const char *path, int flags)
{
	(void)flags;
	if (strncmp(path, "/dev/fb", 7) == 0) {
		if (fake_fb.open_error) {
			return fail_with(fake_fb.open_error);
		}
		fake_fb.open_count++;
		return FB_FD;
	}
	if (strcmp(path, "/dev/tty0") == 0 && fake_fb.has_console) {
		fake_fb.open_count++;
		return CONSOLE_FD;
	}
	return fail_with(ENOENT);
}

static int fake_close(int fd)
{
	(void)fd;
	fake_fb.open_count--;
	return 0;
}

static int put_var(const struct fb_var_screeninfo *var)
{
	uint64_t bytes = (uint64_t)var->yres_virtual * fake_fb.fix.line_length;

	fake_fb.put_count++;
	if (bytes > fake_fb.fix.smem_len) {
		return fail_with(EINVAL);
	}
	if ((var->activate & FB_ACTIVATE_MASK) != FB_ACTIVATE_NOW) {
		return 0; /* Linux, too, succeeds here and sets nothing */
	}
	fake_fb.var = *var;
	fake_fb.var.activate = FB_ACTIVATE_NXTOPEN;
	if (fake_fb.rounds_width) {
		fake_fb.var.xres -= 2;
		fake_fb.rounds_width = false;
	}
	return 0;
}

static int pan(const struct fb_var_screeninfo *var)
{
	if (var->yoffset + fake_fb.var.yres > fake_fb.var.yres_virtual ||
		fake_fb.fix.ypanstep == 0 ||
		var->yoffset % fake_fb.fix.ypanstep) {
		return fail_with(EINVAL);
	}
	fake_fb.pan_count++;
	fake_fb.var.xoffset = var->xoffset;
	fake_fb.var.yoffset = var->yoffset;
	return 0;
}

static int copy_colors(const struct fb_cmap *map, bool put)
{
	uint16_t *given[] = {map->red, map->green, map->blue};

	if (map->start + map->len > 256 ||
		fake_fb.fix.visual == FB_VISUAL_TRUECOLOR) {
		return fail_with(EINVAL);
	}
	for (int channel = 0; channel < 3; channel++) {
		for (uint32_t i = 0; i < map->len; i++) {
			if (put) {
				fake_fb.colors[channel][i] = given[channel][i];
			} else {
				given[channel][i] = fake_fb.colors[channel][i];
			}
		}
	}
	return 0;
}

static int control_screen(unsigned long request, void *argument)
{
	switch (request) {
	case FBIOGET_FSCREENINFO:
		memcpy(argument, &fake_fb.fix, sizeof(fake_fb.fix));
		return 0;
	case FBIOGET_VSCREENINFO:
		memcpy(argument, &fake_fb.var, sizeof(fake_fb.var));
		return 0;
	case FBIOPUT_VSCREENINFO:
		return put_var(argument);
	case FBIOPAN_DISPLAY:
		return pan(argument);
	case FBIO_WAITFORVSYNC:
		fake_fb.wait_count++;
		return fake_fb.has_wait ? 0 : fail_with(ENOTTY);
	case FBIOBLANK:
		return 0;
	case FBIOGETCMAP:
	case FBIOPUTCMAP:
		return copy_colors(argument, request == FBIOPUTCMAP);
	default:
		return fail_with(ENOTTY);
	}
}

static int control_console(unsigned long request, void *argument)
{
	char mode = (char)(uintptr_t)argument;

	switch (request) {
	case KDGETMODE:
		memcpy(argument, &fake_fb.console_mode, sizeof(int));
		return 0;
	case VT_GETMODE:
		*(struct vt_mode *)argument = fake_fb.console_watched
			? (struct vt_mode){.mode = VT_PROCESS}
			: fake_fb.console_switching;
		return 0;
	case VT_SETMODE:
		memcpy(&fake_fb.console_switching, argument,
			sizeof(fake_fb.console_switching));
		return 0;
	case VT_RELDISP:
		fake_fb.console_answers++;
		fake_fb.console_answer = mode;
		return 0;
	case KDSETMODE:
		fake_fb.console_mode = mode;
		if (fake_fb.report_fd >= 0 &&
			write(fake_fb.report_fd, &mode, 1) != 1) {
			return fail_with(EIO);
		}
		return 0;
	case TCFLSH:
		fake_fb.console_flushes += mode == TCIFLUSH;
		return 0;
	default:
		return fail_with(ENOTTY);
	}
}

static int fake_ioctl(int fd, unsigned long request, void *argument)
{
	if (request == fake_fb.fail_request &&
		fake_fb.call_count++ >= fake_fb.fail_from) {
		return fail_with(fake_fb.fail_error);
	}
	return fd == FB_FD ? control_screen(request, argument)
			   : control_console(request, argument);
}

static void *fake_map(int fd, size_t size, off_t offset)
{
	(void)fd;
	(void)offset;
	if (fake_fb.fail_map || size > FAKE_FB_BYTES) {
		errno = ENOMEM;
		return MAP_FAILED;
	}
	fake_fb.map_count++;
	return fake_fb.map;
}

static int fake_unmap(void *address, size_t size)
{
	(void)address;
	(void)size;
	fake_fb.map_count--;
	return 0;
}

const struct device_calls fake_fb_calls = {
	.open = fake_open,
	.close = fake_close,
	.ioctl = fake_ioctl,
	.map = fake_map,
	.unmap = fake_unmap,
};

static struct fb_bitfield bitfield(struct pixel_field field)
{
	return (struct fb_bitfield){
		.offset = (uint32_t)field.offset,
		.length = (uint32_t)field.length,
	};
}

void fake_fb_begin(int width, int height, int rows, int virtual_rows,
	int stride_bytes, struct pixel_layout layout)
{
	fake_fb = (struct fake_fb){
		.fix =
			{
				.type = FB_TYPE_PACKED_PIXELS,
				.visual = FB_VISUAL_TRUECOLOR,
				.smem_start = FAKE_FB_LEAD,
				.smem_len = (uint32_t)(stride_bytes * rows),
				.line_length = (uint32_t)stride_bytes,
				.ypanstep = 1,
			},
		.var =
			{
				.xres = (uint32_t)width,
				.yres = (uint32_t)height,
				.xres_virtual = (uint32_t)width,
				.yres_virtual = (uint32_t)virtual_rows,
				.bits_per_pixel = (uint32_t)layout.bits,
				.red = bitfield(layout.red),
				.green = bitfield(layout.green),
				.blue = bitfield(layout.blue),
				.transp = bitfield(layout.alpha),
				.grayscale = layout.gray,
				.activate = FB_ACTIVATE_NXTOPEN,
			},
		.fail_error = EIO,
		.console_mode = KD_TEXT,
		.report_fd = -1,
	};
	fake_fb.memory = fake_fb.map + FAKE_FB_LEAD;
	memset(fake_fb.map, 0xEE, sizeof(fake_fb.map));
}

uint32_t fake_fb_seen(int x, int y)
{
	int bytes = ((int)fake_fb.var.bits_per_pixel + 7) / 8;
	const uint8_t *at = fake_fb.memory +
		(size_t)((int)fake_fb.var.yoffset + y) * fake_fb.fix.line_length +
		(size_t)(((int)fake_fb.var.xoffset + x) * bytes);
	uint32_t pixel = 0;

	/* All machines that the tests run on are little-endian. */
	for (int i = 0; i < bytes; i++) {
		pixel |= (uint32_t)at[i] << (8 * i);
	}
	return pixel;
}
