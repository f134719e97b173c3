/*
 * Drives a camera, a screen, keys or a watchdog whose kernel driver answers
 * anything (fuzz_device_calls.h). Pictures are read and drawn to their last
 * byte, and everything that was opened must be closed.
 */
#define _DEFAULT_SOURCE /* mkdtemp() */

#include "platform/buttons/evdev/system.h"
#include "platform/buttons/gpio_output.h"
#include "platform/buttons/gpiod/gpiod_survey.h"
#include "platform/camera/convert.h"
#include "platform/camera/motion.h"
#include "platform/camera/v4l2/session.h"
#include "platform/camera/v4l2/v4l2.h"
#include "platform/display/fbdev/fbdev.h"
#include "platform/watchdog/watchdog.h"
#include "tests/fuzz/fuzz_device_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
	STEPS = 24,
	SIDE = 40
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

extern const struct display_driver display_driver_fbdev, display_driver_kms;
extern const struct button_driver button_driver_evdev, button_driver_gpiod;

static void drop_finding(void *user, const struct survey_finding *finding)
{
	(void)user;
	(void)finding;
}

static const struct survey nobody = {.take = drop_finding, .system = "/sys"};

static void read_picture(const struct camera_image *image)
{
	static struct camera_scaler scaler;
	static struct camera_motion motion;
	uint16_t out[SIDE * SIDE];
	struct camera_part part = camera_part_cut(image->width, image->height,
		1, (int)(1 + fuzz_device_byte() % 3));

	camera_motion_feed(&motion, image);
	camera_convert(&scaler, image, &part, SIDE, SIDE, out, SIDE);
	part = (struct camera_part){0, 0, image->width, image->height};
	camera_convert(&scaler, image, &part, SIDE, SIDE, out, SIDE);
}

static void play_camera(void)
{
	static const uint32_t formats[] = {0, V4L2_PIX_FMT_UYVY,
		V4L2_PIX_FMT_NV12, V4L2_PIX_FMT_RGB565, V4L2_PIX_FMT_MJPEG};
	struct v4l2_request request = {
		.path = "/dev/video0",
		.width = 8 << fuzz_device_byte() % 7,
		.height = 6 << fuzz_device_byte() % 7,
		.fourcc = formats[fuzz_device_byte() % 5],
	};
	struct v4l2_session session;

	if (fuzz_device_byte() % 4 == 3) {
		request.path[0] = '\0';
	}
	v4l2_session_init(&session, &fuzz_device_v4l2, &request);
	for (int i = 0; i < STEPS; i++) {
		int index = -1;

		if (session.state == V4L2_CLOSED) {
			(void)v4l2_session_open(&session);
		} else if (session.state != V4L2_FAILED) {
			index = v4l2_session_dequeue(&session, 100);
		}
		if (index >= 0) {
			struct camera_image image =
				v4l2_device_image(&session.device, index);

			read_picture(&image);
			v4l2_session_queue(&session, index);
		}
		if (session.state == V4L2_FAILED) {
			v4l2_session_close(&session);
		}
	}
	v4l2_device_close(&session.device);
}

static void draw_rows(const struct pixels *picture)
{
	size_t row = (size_t)picture->width *
		(picture->format == PIXELS_RGB565 ? 2 : 4);

	for (int y = 0; y < picture->height; y++) {
		memset((char *)picture->data +
				(ptrdiff_t)y * picture->stride_bytes,
			y, row);
	}
}

static void show_pictures(const struct display_driver *driver,
	int (*create)(const struct display_options *, struct display **))
{
	struct log log = log_to_nowhere();
	const struct display_options options = {
		.width = 1 + (int)fuzz_device_byte(),
		.height = 1 + (int)fuzz_device_byte(),
		.size_given = fuzz_device_byte() % 2,
		.format = fuzz_device_byte() % 2 ? PIXELS_RGB565
						 : PIXELS_RGBA8888,
		.format_given = fuzz_device_byte() % 2,
		.log = &log,
	};
	struct display *display;

	if (create(&options, &display) != 0) {
		return;
	}
	for (int i = 0; i < 4; i++) {
		struct pixels picture;

		if (driver->begin_frame(display, &picture) != 0) {
			break;
		}
		draw_rows(&picture);
		if (driver->end_frame(display) != 0) {
			break;
		}
	}
	driver->destroy(display);
}

static int create_fbdev(
	const struct display_options *options, struct display **out)
{
	return fbdev_create_on(&fuzz_device_file, options, out);
}

static int create_kms(
	const struct display_options *options, struct display **out)
{
	return kms_create_on(&fuzz_device_kms, options, out);
}

/* The descriptor is real, because the driver polls it: it is always readable. */
static int keys_open(const char *path)
{
	int error = fuzz_device_fault();

	(void)path;
	return error ? -error : open("/dev/zero", O_RDONLY | O_CLOEXEC);
}

static int keys_describe(int fd, struct evdev_description *out)
{
	int error = fuzz_device_fault();

	(void)fd;
	memset(out, (int)fuzz_device_byte(), sizeof(*out));
	fuzz_device_spoil(out, sizeof(*out));
	out->name[sizeof(out->name) - 1] = '\0';
	return -error;
}

static int keys_down(int fd, uint8_t bits[EVDEV_KEY_BYTES])
{
	(void)fd;
	memset(bits, (int)fuzz_device_byte(), EVDEV_KEY_BYTES);
	return -fuzz_device_fault();
}

static ssize_t keys_read(int fd, void *bytes, size_t size)
{
	int error = fuzz_device_fault();
	size_t count = fuzz_device_byte() * 24 + fuzz_device_byte() % 24;

	(void)fd;
	if (error) {
		return -error;
	}
	count = count < size ? count : size;
	for (size_t i = 0; i < count; i++) {
		((uint8_t *)bytes)[i] = (uint8_t)fuzz_device_byte();
	}
	return (ssize_t)count;
}

static char keys_folder[] = "/tmp/limber-fuzz-keys-XXXXXX";

static void keys_remove(void)
{
	char path[64];

	for (int i = 0; i < 3; i++) {
		snprintf(path, sizeof(path), "%s/event%d", keys_folder, i);
		unlink(path);
	}
	rmdir(keys_folder);
}

static const struct evdev_system *keys_system(void)
{
	static struct evdev_system system = {.open = keys_open,
		.describe = keys_describe,
		.keys_down = keys_down,
		.read = keys_read};
	char path[64];

	if (!system.directory && mkdtemp(keys_folder)) {
		system.directory = keys_folder;
		atexit(keys_remove);
		for (int i = 0; i < 3; i++) {
			snprintf(path, sizeof(path), "%s/event%d", keys_folder,
				i);
			close(open(path, O_CREAT | O_WRONLY, 0600));
		}
	}
	return system.directory ? &system : NULL;
}

/* Polls for some seconds, then destroys the source. */
static void press_buttons(
	const struct button_driver *driver, struct button_source *source)
{
	struct button_queue queue = {0};
	struct button_event event;

	for (int64_t now_ms = 0; now_ms < 4000; now_ms += 500) {
		driver->poll(source, now_ms, &queue);
		while (button_queue_pop(&queue, &event)) {
			if (event.button >= BUTTON_COUNT ||
				event.time_ms > now_ms) {
				abort();
			}
		}
	}
	driver->destroy(source);
}

static void press_keys(void)
{
	const struct evdev_system *system = keys_system();
	struct log log = log_to_nowhere();
	struct button_source *source;

	if (system && evdev_create_on(system, NULL, &log, &source) == 0) {
		press_buttons(&button_driver_evdev, source);
		evdev_survey_on(system, &nobody);
	}
}

static void use_gpio_lines(void)
{
	static const char lines[] =
		"UP=chip0/3,DOWN=chip1/31/active-low,LEFT=row,F6=gpiochip2/row";
	struct log log = log_to_nowhere();
	struct button_source *source;
	struct gpio_output *output =
		gpio_output_open("output led", "led", "chip1/4", &log);

	gpio_output_set(output, true);
	gpio_output_check_all(&output, 1);
	if (button_driver_gpiod.create(lines, &log, &source) == 0) {
		press_buttons(&button_driver_gpiod, source);
	}
	gpio_output_close(output);
	gpiod_survey(&nobody);
}

static void feed_watchdog(void)
{
	struct log log = log_to_nowhere();
	struct watchdog watchdog;

	if (watchdog_open(
		    &watchdog, "/dev/watchdog", &fuzz_device_file, &log) == 0) {
		for (int64_t now_ms = 0; now_ms < 5000; now_ms += 400) {
			watchdog_feed(&watchdog, now_ms);
		}
		watchdog_close(&watchdog);
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	fuzz_device_begin(data, size);
	switch (fuzz_device_byte() % 9) {
	case 0:
	case 1:
		play_camera();
		break;
	case 2:
		show_pictures(&display_driver_fbdev, create_fbdev);
		break;
	case 3:
	case 4:
		show_pictures(&display_driver_kms, create_kms);
		break;
	case 5:
		press_keys();
		break;
	case 6:
		feed_watchdog();
		break;
	case 8:
		use_gpio_lines();
		break;
	default:
		fbdev_survey_on(&fuzz_device_file, &nobody);
		kms_survey_on(&fuzz_device_kms, &nobody);
		break;
	}
	fuzz_device_end();
	return 0;
}
