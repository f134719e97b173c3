#include "platform/display/fbdev/fbdev_screen.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "platform/display/pixels.h"

enum {
	MISSED_MAX = 100 /* seconds, as the frame loop or the driver waits */
};

static int control(const struct fbdev_screen *screen, unsigned long request,
	void *argument)
{
	return device_control(screen->calls, screen->fd, request, argument);
}

static int failed(const struct fbdev_screen *screen, const char *what)
{
	int error = errno ? errno : EIO;

	log_error(&screen->log,
		"--display fbdev: %s: %s: %s: name another with --display fbdev:/dev/fbN, or choose another --display",
		screen->path, what, strerror(error));
	return -error;
}

static int refused(const struct fbdev_screen *screen, const char *why)
{
	log_error(&screen->log,
		"--display fbdev: %s: %s: set another mode with fbset, or choose another --display",
		screen->path, why);
	return -ENOTSUP;
}

static int open_device(struct fbdev_screen *screen)
{
	screen->fd = screen->calls->open(screen->path, O_RDWR | O_CLOEXEC);
	if (screen->fd >= 0) {
		return 0;
	}
	if (errno == EACCES || errno == EPERM) {
		log_error(&screen->log,
			"--display fbdev: %s: no permission: run as root, or join the group that owns it (usually video)",
			screen->path);
		return -EACCES;
	}
	if (errno == ENOENT || errno == ENODEV || errno == ENXIO) {
		log_error(&screen->log,
			"--display fbdev: %s: this machine has no such framebuffer: load its driver, name another with --display fbdev:/dev/fbN, or choose another --display",
			screen->path);
		return -ENODEV;
	}
	return failed(screen, "cannot be opened");
}

static int read_info(struct fbdev_screen *screen)
{
	if (control(screen, FBIOGET_FSCREENINFO, &screen->fix) < 0 ||
		control(screen, FBIOGET_VSCREENINFO, &screen->var) < 0) {
		return failed(screen, "does not answer as a framebuffer");
	}
	return 0;
}

static struct pixel_field read_field(const struct fb_bitfield *field)
{
	/* Larger values are invalid in any case. */
	return (struct pixel_field){
		.offset = field->offset > 64 ? 64 : (int)field->offset,
		.length = field->length > 64 ? 64 : (int)field->length,
	};
}

static int read_layout(struct fbdev_screen *screen)
{
	const struct fb_var_screeninfo *var = &screen->var;

	if (screen->fix.type != FB_TYPE_PACKED_PIXELS || var->nonstd != 0 ||
		var->red.msb_right || var->green.msb_right ||
		var->blue.msb_right || var->grayscale > 1) {
		return refused(
			screen, "its pixels are not packed into integers");
	}
	if (screen->fix.visual == FB_VISUAL_PSEUDOCOLOR &&
		var->bits_per_pixel == 8) {
		screen->layout = colormap_palette_layout();
		return 0;
	}
	if (screen->fix.visual != FB_VISUAL_TRUECOLOR &&
		screen->fix.visual != FB_VISUAL_DIRECTCOLOR) {
		return refused(
			screen, "its kind of colour map is not supported");
	}
	screen->layout = (struct pixel_layout){
		.bits = var->bits_per_pixel > 32 ? 64 : (int)var->bits_per_pixel,
		.red = read_field(&var->red),
		.green = read_field(&var->green),
		.blue = read_field(&var->blue),
		.alpha = read_field(&var->transp),
		.gray = var->grayscale == 1,
	};
	if (screen->layout.bits < 8 || !pixel_layout_is_valid(&screen->layout)) {
		return refused(screen, "its pixel layout is not valid");
	}
	return 0;
}

static int read_size(struct fbdev_screen *screen)
{
	const struct fb_var_screeninfo *var = &screen->var;
	uint64_t bytes = (uint64_t)pixel_layout_bytes(&screen->layout);
	uint64_t stride, last;

	if (var->xres < 1 || var->yres < 1 || var->xres > PIXELS_SIZE_MAX ||
		var->yres > PIXELS_SIZE_MAX) {
		return refused(screen, "its size is not valid");
	}
	stride = screen->fix.line_length ? screen->fix.line_length
					 : (uint64_t)var->xres_virtual * bytes;
	last = (uint64_t)var->yoffset + var->yres;
	if (stride > INT32_MAX / PIXELS_SIZE_MAX ||
		stride < ((uint64_t)var->xoffset + var->xres) * bytes ||
		screen->fix.smem_len < stride * last) {
		return refused(screen, "it has less memory than its size needs");
	}
	screen->width = (int)var->xres;
	screen->height = (int)var->yres;
	screen->stride_bytes = (int)stride;
	return 0;
}

static int read_all(struct fbdev_screen *screen)
{
	int error = read_info(screen);

	error = error ? error : read_layout(screen);
	return error ? error : read_size(screen);
}

static bool pan(struct fbdev_screen *screen, int page)
{
	struct fb_var_screeninfo var = screen->var;

	var.xoffset = 0;
	var.yoffset = (uint32_t)(page * screen->height);
	return control(screen, FBIOPAN_DISPLAY, &var) == 0;
}

static bool has_pages(const struct fbdev_screen *screen, int count)
{
	uint64_t rows = (uint64_t)count * (uint64_t)screen->height;

	return screen->var.yres_virtual >= rows &&
		screen->fix.smem_len >= rows * (uint64_t)screen->stride_bytes;
}

/*
 * Whether a driver has kept the size and the layout; drivers may change a
 * requested mode.
 */
static bool is_still_good(
	const struct fbdev_screen *screen, const struct fbdev_screen *was)
{
	return screen->width == was->width && screen->height == was->height &&
		memcmp(&screen->layout, &was->layout, sizeof(screen->layout)) ==
		0;
}

/*
 * Asks the driver for a virtual screen of count pages, then reads everything
 * again, because the driver may have allocated other memory. Undoes the request
 * if it was not granted. Returns false if the driver changed more than the
 * virtual height, so that no smaller number need be tried.
 */
static bool request_pages(struct fbdev_screen *screen, int count)
{
	struct fbdev_screen was = *screen;
	struct fb_var_screeninfo var = screen->var;
	bool good;

	var.yres_virtual = (uint32_t)count * var.yres;
	var.activate = FB_ACTIVATE_NOW;
	if (control(screen, FBIOPUT_VSCREENINFO, &var) < 0) {
		return true;
	}
	screen->changed = true;
	good = read_info(screen) == 0 && read_layout(screen) == 0 &&
		read_size(screen) == 0 && is_still_good(screen, &was);
	if (!good || !has_pages(screen, count)) {
		control(screen, FBIOPUT_VSCREENINFO, &was.before);
		*screen = was;
	}
	return good;
}

/*
 * If the device cannot wait for vertical blanking, the former page may still be
 * shown for a frame after panning, so a third page is needed to draw into. Uses
 * one page when there is no memory for two, or panning fails.
 */
static void find_pages(struct fbdev_screen *screen)
{
	uint32_t step = screen->fix.ypanstep;

	screen->page_count = 1;
	if (step == 0 || screen->var.yres % step != 0) {
		return;
	}
	for (int count = screen->waits ? 2 : FBDEV_PAGES_MAX;
		screen->page_count == 1 && count > 1; count--) {
		if (!has_pages(screen, count) && !request_pages(screen, count)) {
			return;
		}
		if (has_pages(screen, count) && pan(screen, 0)) {
			screen->page_count = count;
			screen->changed = true;
		}
	}
}

/*
 * Maps the device. The map starts at a page of the processor's memory, the
 * framebuffer possibly within that page.
 */
static int map_memory(struct fbdev_screen *screen)
{
	size_t page_bytes = (size_t)sysconf(_SC_PAGESIZE);
	size_t before = screen->fix.smem_start & (page_bytes - 1);
	uint64_t bytes = (uint64_t)before + screen->fix.smem_len;

	if (bytes > SIZE_MAX) {
		return refused(screen,
			"it claims more memory than this machine can address");
	}
	screen->map_bytes = (size_t)bytes;
	screen->map = screen->calls->map(screen->fd, screen->map_bytes, 0);
	if (screen->map == MAP_FAILED) {
		return failed(screen, "its memory cannot be mapped");
	}
	screen->memory = (uint8_t *)screen->map + before;
	return 0;
}

/* Any error means that the device cannot wait: drivers return various ones. */
static bool can_wait(const struct fbdev_screen *screen)
{
	uint32_t crtc = 0;

	return control(screen, FBIO_WAITFORVSYNC, &crtc) == 0;
}

static int set_colors(struct fbdev_screen *screen)
{
	return colormap_set(&screen->colors, screen->calls, screen->fd,
		       screen->fix.visual, &screen->layout)
		? 0
		: refused(screen, "its colour map cannot be set");
}

static void restore(const struct fbdev_screen *screen)
{
	colormap_restore(&screen->colors, screen->calls, screen->fd);
	if (screen->changed) {
		struct fb_var_screeninfo before = screen->before;

		control(screen, FBIOPUT_VSCREENINFO, &before);
		control(screen, FBIOPAN_DISPLAY, &before);
	}
}

/* Returns 0, or -errno with nothing left open. */
static int open_and_read(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log)
{
	int error;

	*screen = (struct fbdev_screen){.calls = calls, .log = *log};
	if (snprintf(screen->path, sizeof(screen->path), "%s", path) >=
		(int)sizeof(screen->path)) {
		log_error(
			log, "--display fbdev: %s: the name is too long", path);
		return -ENAMETOOLONG;
	}
	error = open_device(screen);
	if (error) {
		return error;
	}
	error = read_all(screen);
	if (error) {
		calls->close(screen->fd);
	}
	return error;
}

int fbdev_screen_inspect(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log)
{
	int error = open_and_read(screen, calls, path, log);

	if (!error) {
		calls->close(screen->fd);
	}
	return error;
}

int fbdev_screen_open(struct fbdev_screen *screen,
	const struct device_calls *calls, const char *path,
	const struct log *log)
{
	int error = open_and_read(screen, calls, path, log);

	if (error) {
		return error;
	}
	screen->before = screen->var;
	/* The driver's own value may mean to set the mode later or not at all. */
	screen->before.activate = FB_ACTIVATE_NOW;
	/* Wakes the screen up; many devices do not support that. */
	(void)control(screen, FBIOBLANK, (void *)(uintptr_t)FB_BLANK_UNBLANK);
	screen->waits = can_wait(screen);
	find_pages(screen);
	error = set_colors(screen);
	error = error ? error : map_memory(screen);
	if (!error) {
		return 0;
	}
	restore(screen);
	calls->close(screen->fd);
	return error;
}

static int next_page(const struct fbdev_screen *screen)
{
	return (screen->page + 1) % screen->page_count;
}

uint8_t *fbdev_screen_back_page(const struct fbdev_screen *screen)
{
	size_t stride = (size_t)screen->stride_bytes;

	if (screen->page_count > 1) {
		size_t row = (size_t)next_page(screen) * (size_t)screen->height;

		return screen->memory + row * stride;
	}
	return screen->memory + screen->var.yoffset * stride +
		screen->var.xoffset *
		(size_t)pixel_layout_bytes(&screen->layout);
}

void fbdev_screen_wait(const struct fbdev_screen *screen)
{
	uint32_t crtc = 0;

	if (screen->waits) {
		/* If it fails, this picture may tear. */
		(void)control(screen, FBIO_WAITFORVSYNC, &crtc);
	}
}

/* mx3fb, for one, waits a tenth of a second for the picture before. */
static bool is_temporary(int error)
{
	return error == ETIMEDOUT || error == EBUSY || error == EAGAIN;
}

int fbdev_screen_flip(struct fbdev_screen *screen)
{
	if (!pan(screen, next_page(screen))) {
		if (is_temporary(errno) && ++screen->missed < MISSED_MAX) {
			return 0;
		}
		return failed(screen, "it cannot show the next picture");
	}
	screen->missed = 0;
	screen->page = next_page(screen);
	fbdev_screen_wait(screen);
	return 0;
}

void fbdev_screen_leave(struct fbdev_screen *screen)
{
	restore(screen);
	screen->left = true;
}

int fbdev_screen_return(struct fbdev_screen *screen)
{
	const struct fbdev_screen was = *screen;
	struct fb_var_screeninfo var = screen->var;
	int error;

	screen->left = false;
	var.activate = FB_ACTIVATE_NOW;
	/* Whether it worked is judged by what the device says then. */
	(void)control(screen, FBIOPUT_VSCREENINFO, &var);
	(void)control(screen, FBIOBLANK, (void *)(uintptr_t)FB_BLANK_UNBLANK);
	error = read_all(screen);
	if (error) {
		return error;
	}
	if (!is_still_good(screen, &was) ||
		screen->stride_bytes != was.stride_bytes ||
		screen->fix.smem_len < was.fix.smem_len ||
		(screen->page_count > 1 &&
			(!has_pages(screen, screen->page_count) ||
				!pan(screen, screen->page)))) {
		return refused(screen,
			"another program has changed its mode while its console was shown");
	}
	return set_colors(screen);
}

double fbdev_screen_rate_hz(const struct fbdev_screen *screen)
{
	const struct fb_var_screeninfo *var = &screen->var;
	double columns = (double)var->left_margin + var->xres +
		var->right_margin + var->hsync_len;
	double rows = (double)var->upper_margin + var->yres +
		var->lower_margin + var->vsync_len;
	double rate_hz =
		var->pixclock ? 1e12 / (var->pixclock * columns * rows) : 0.0;

	/* Drivers of flat panels often report meaningless timings. */
	return rate_hz >= 20.0 && rate_hz <= 250.0 ? rate_hz : 60.0;
}

void fbdev_screen_close(struct fbdev_screen *screen)
{
	screen->calls->unmap(screen->map, screen->map_bytes);
	/* Another program may have set the device for itself. */
	if (!screen->left) {
		restore(screen);
	}
	screen->calls->close(screen->fd);
}
