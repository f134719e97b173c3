#define _DEFAULT_SOURCE /* mkdtemp() */

#include "tests/fuzz/fuzz_device_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/videodev2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum {
	DEVICE_FD = 1000,
	MAP_MAX = 1 << 22
};

static struct {
	const uint8_t *at, *end;
	int open_count, map_count, object_count;
	int64_t now_ms;
	uint32_t next_buffer;
} device;

void fuzz_device_begin(const uint8_t *data, size_t size)
{
	memset(&device, 0, sizeof(device));
	device.at = data;
	device.end = data + size;
}

unsigned int fuzz_device_byte(void)
{
	return device.at < device.end ? *device.at++ : 0;
}

void fuzz_device_end(void)
{
	if (device.open_count || device.map_count || device.object_count) {
		fprintf(stderr, "left open: %d files, %d maps, %d objects\n",
			device.open_count, device.map_count,
			device.object_count);
		abort();
	}
}

uint32_t fuzz_device_word(void)
{
	uint32_t value = 0;

	for (int i = 0; i < 4; i++) {
		value = value << 8 | fuzz_device_byte();
	}
	return value;
}

int fuzz_device_fault(void)
{
	static const int errors[] = {EIO, EBUSY, ENODEV, EINVAL, EACCES, EAGAIN,
		ENOTTY, ENOMEM, EPERM, ENOENT, ETIME, ENXIO, ENOSYS};
	unsigned int choice = fuzz_device_byte();

	return choice % 8 == 7
		? errors[choice / 8 % (sizeof(errors) / sizeof(errors[0]))]
		: 0;
}

void fuzz_device_spoil(void *answer, size_t size)
{
	unsigned int count = fuzz_device_byte() % 4;

	for (; size >= 4 && count > 0; count--) {
		size_t at = (fuzz_device_byte() << 8 | fuzz_device_byte()) %
			(size / 4);
		uint32_t value = fuzz_device_word();

		memcpy((char *)answer + 4 * at, &value, sizeof(value));
	}
}

static void *map(size_t size)
{
	void *data = size > 0 && size <= MAP_MAX ? malloc(size) : NULL;

	if (data) {
		memset(data, (int)fuzz_device_byte(), size);
		device.map_count++;
	}
	return data;
}

static void unmap(void *data)
{
	free(data);
	device.map_count--;
}

static int open_device(void)
{
	int error = fuzz_device_fault();

	device.open_count += !error;
	return error ? -error : DEVICE_FD;
}

static void answer_v4l2(unsigned long request, void *argument)
{
	if (request == VIDIOC_QUERYCAP) {
		struct v4l2_capability *capability = argument;

		capability->capabilities =
			V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
	} else if (request == VIDIOC_ENUM_FMT) {
		struct v4l2_fmtdesc *format = argument;

		format->pixelformat = format->index % 2 ? V4L2_PIX_FMT_MJPEG
							: V4L2_PIX_FMT_UYVY;
	} else if (request == VIDIOC_S_FMT || request == VIDIOC_G_FMT) {
		struct v4l2_pix_format *pix =
			&((struct v4l2_format *)argument)->fmt.pix;

		pix->bytesperline = 2 * pix->width;
		pix->sizeimage = pix->bytesperline * pix->height;
	} else if (request == VIDIOC_QUERYBUF) {
		((struct v4l2_buffer *)argument)->length = 640 * 480 * 3;
	} else if (request == VIDIOC_DQBUF) {
		((struct v4l2_buffer *)argument)->index =
			device.next_buffer++ % 3;
	}
}

static int v4l2_ioctl(void *user, int fd, unsigned long request, void *argument)
{
	int error = fuzz_device_fault();

	(void)user;
	(void)fd;
	if (error) {
		return -error;
	}
	answer_v4l2(request, argument);
	fuzz_device_spoil(argument, _IOC_SIZE(request));
	return 0;
}

static bool v4l2_exists(void *user, const char *path)
{
	(void)user;
	(void)path;
	return fuzz_device_byte() % 2;
}

static int v4l2_open(void *user, const char *path)
{
	(void)user;
	(void)path;
	return open_device();
}

static void v4l2_close(void *user, int fd)
{
	(void)user;
	(void)fd;
	device.open_count--;
}

static void *v4l2_map(void *user, int fd, size_t length, uint32_t offset)
{
	(void)user;
	(void)fd;
	(void)offset;
	return map(length);
}

static void v4l2_unmap(void *user, void *address, size_t length)
{
	(void)user;
	(void)length;
	unmap(address);
}

static int v4l2_wait(void *user, int fd, int timeout_ms)
{
	int error = fuzz_device_fault();

	(void)user;
	(void)fd;
	device.now_ms += timeout_ms;
	return error ? -error : fuzz_device_byte() % 4 != 3;
}

static int64_t v4l2_now_ms(void *user)
{
	(void)user;
	return device.now_ms += fuzz_device_byte();
}

const struct v4l2_calls fuzz_device_v4l2 = {
	.exists = v4l2_exists,
	.open = v4l2_open,
	.close = v4l2_close,
	.ioctl = v4l2_ioctl,
	.map = v4l2_map,
	.unmap = v4l2_unmap,
	.wait = v4l2_wait,
	.now_ms = v4l2_now_ms,
};

static int file_open(const char *path, int flags)
{
	int fd = open_device();

	(void)path;
	(void)flags;
	errno = fd < 0 ? -fd : errno;
	return fd < 0 ? -1 : fd;
}

static int file_close(int fd)
{
	(void)fd;
	device.open_count--;
	return 0;
}

int fuzz_device_failing(void)
{
	int error = fuzz_device_fault();

	errno = error ? error : errno;
	return error ? -1 : 0;
}

static ssize_t file_write(int fd, const void *data, size_t size)
{
	(void)fd;
	(void)data;
	return fuzz_device_failing()
		? -1
		: (ssize_t)(fuzz_device_byte() % (size + 1));
}

static void answer_fb(unsigned long request, void *argument)
{
	if (request == FBIOGET_VSCREENINFO) {
		*(struct fb_var_screeninfo *)argument =
			(struct fb_var_screeninfo){
				.xres = 48,
				.yres = 32,
				.xres_virtual = 48,
				.yres_virtual = 64,
				.bits_per_pixel = 16,
				.red = {11, 5, 0},
				.green = {5, 6, 0},
				.blue = {0, 5, 0},
			};
	} else if (request == FBIOGET_FSCREENINFO) {
		*(struct fb_fix_screeninfo *)argument =
			(struct fb_fix_screeninfo){
				.visual = FB_VISUAL_TRUECOLOR,
				.line_length = 96,
				.smem_len = 96 * 64,
				.ypanstep = 1,
			};
	}
}

/* Requests of before _IOR() carry no size. */
static int file_ioctl(int fd, unsigned long request, void *argument)
{
	size_t size = _IOC_SIZE(request);

	(void)fd;
	if (fuzz_device_failing()) {
		return -1;
	}
	answer_fb(request, argument);
	if (request == FBIOGET_VSCREENINFO || request == FBIOPUT_VSCREENINFO) {
		size = sizeof(struct fb_var_screeninfo);
	} else if (request == FBIOGET_FSCREENINFO) {
		size = sizeof(struct fb_fix_screeninfo);
	}
	if (size > 0 || request == FBIOGET_FSCREENINFO) {
		fuzz_device_spoil(argument, size);
	}
	return 0;
}

static void *file_map(int fd, size_t size, off_t offset)
{
	void *data = fuzz_device_failing() ? NULL : map(size);

	(void)fd;
	(void)offset;
	return data ? data : MAP_FAILED;
}

static int file_unmap(void *address, size_t size)
{
	(void)size;
	unmap(address);
	return 0;
}

const struct device_calls fuzz_device_file = {
	.open = file_open,
	.close = file_close,
	.write = file_write,
	.ioctl = file_ioctl,
	.map = file_map,
	.unmap = file_unmap,
};

void *fuzz_device_object(size_t size)
{
	fuzz_device_count_objects(1);
	return calloc(1, size);
}

void fuzz_device_release(void *object)
{
	fuzz_device_count_objects(object ? -1 : 0);
	free(object);
}

void fuzz_device_count_objects(int change)
{
	device.object_count += change;
}
