/*
 * Cameras: where live pictures come from.
 *
 * A source hands out its newest picture and never waits for one; older pictures
 * are dropped. When it loses its device it delivers no pictures until the
 * device is back. (The camera of a scene is app/scene/stage/camera.h.)
 */
#ifndef PLATFORM_CAMERA_CAMERA_H
#define PLATFORM_CAMERA_CAMERA_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"

enum {
	CAMERA_SIDE_MAX = 2048, /* the largest width and height, in pixels */
	CAMERA_PLANES = 3
};

/*
 * The memory layout of a pixel. YCbCr is BT.601 in limited range: luma 16 to
 * 235, chroma 16 to 240 around 128.
 */
enum camera_format {
	CAMERA_RGB565, /* two bytes a pixel, little-endian */
	CAMERA_UYVY,   /* Cb Y Cr Y for two pixels */
	CAMERA_YUYV,   /* Y Cb Y Cr for two pixels */
	CAMERA_NV12,   /* a plane of Y, one of Cb Cr for each 2 x 2 pixels */
	CAMERA_YUV420, /* planes of Y, Cb and Cr; chroma for each 2 x 2 pixels */
	CAMERA_RGB24,  /* bytes R G B */
	CAMERA_BGR24,  /* bytes B G R */
	CAMERA_FORMATS,
};

/* A picture in its source's memory. */
struct camera_image {
	enum camera_format format;
	int width, height; /* 1..CAMERA_SIDE_MAX */
	const uint8_t *plane[CAMERA_PLANES];
	int stride_bytes[CAMERA_PLANES]; /* from row to row of the plane */
};

/* The sizes in bytes of a picture whose planes follow one another. */
struct camera_layout {
	int stride_bytes[CAMERA_PLANES];
	int offset[CAMERA_PLANES]; /* of each plane */
	int size;                  /* of all planes */
};

/*
 * Computes the layout of a picture. A row takes at least least_stride_bytes (0
 * to 65536); the strides of chroma planes follow from that of luma. Width and
 * height are within 1..CAMERA_SIDE_MAX.
 */
struct camera_layout camera_layout_of(enum camera_format format, int width,
	int height, int least_stride_bytes);

/* Returns the picture with that layout at data. */
struct camera_image camera_image_at(enum camera_format format, int width,
	int height, const struct camera_layout *layout, const uint8_t *data);

/* What to open. Strings must be valid during the call only; *log is copied. */
struct camera_options {
	const char *argument; /* what follows "NAME:", or NULL */
	int width, height;    /* wanted size; the device may choose another */
	const char *format;   /* such as "uyvy", or NULL to choose one */
	const struct log *log;
};

/* The result of camera_driver.take(). */
enum camera_status {
	CAMERA_NONE, /* there is no picture: none came yet, or an outage */
	CAMERA_SAME, /* there is no newer picture than the last one taken */
	CAMERA_NEW,  /* a new picture was taken */
};

/* An open camera; each driver defines its own. */
struct camera_source;

struct camera_driver {
	const char *name;
	const char *summary; /* one line for the help text */

	/*
	 * Creates a source without waiting for its device. Returns 0, or
	 * -errno after logging an error, with nothing left open: the argument
	 * is wrong, or memory is short. A missing device is no failure,
	 * because it may be plugged in later. Mandatory.
	 */
	int (*create)(const struct camera_options *options,
		struct camera_source **out);

	/*
	 * Takes the newest picture, for a frame at the time now_ms. After
	 * CAMERA_NEW *out is valid until give_back(), which must be called
	 * soon, and before the next take() or destroy(). Never blocks and never
	 * allocates. Logs when the device has failed or is back. Mandatory.
	 */
	enum camera_status (*take)(struct camera_source *source, int64_t now_ms,
		struct camera_image *out);

	/* Returns the picture that was taken. Mandatory. */
	void (*give_back)(struct camera_source *source);

	/*
	 * Waits up to timeout_ms for the first picture. Optional: NULL when
	 * the driver has a picture at once.
	 */
	void (*await)(struct camera_source *source, int timeout_ms);

	/* Destroys the source. NULL is fine. Mandatory. */
	void (*destroy)(struct camera_source *source);

	/*
	 * Reports the devices and their formats, or that there are none. Sets
	 * no format, starts no device and waits less than a second for each.
	 * Optional.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers, NULL at the end. */
extern const struct camera_driver *const camera_registry[];

/* The format of a name such as "uyvy", or CAMERA_FORMATS. */
enum camera_format camera_format_find(const char *name);

/* An open camera and its driver. */
struct camera_feed {
	const struct camera_driver *driver; /* NULL when no camera is open */
	struct camera_source *source;
};

/*
 * Opens the camera that spec names: a device such as /dev/video0, "auto" for
 * the first device that captures video, or a driver's "NAME" or
 * "NAME:ARGUMENT". ",WxH" and ",FORMAT" may follow. Returns 0, or -errno after
 * logging an error; -EINVAL when spec is wrong.
 */
int camera_feed_open(
	const char *spec, const struct log *log, struct camera_feed *out);

/*
 * Checks the syntax of such a spec, but not its format, and opens nothing.
 * Returns 0, or -EINVAL after logging an error.
 */
int camera_feed_check(const char *spec, const struct log *log);

/* Closes the camera. A feed that is not open is fine. */
void camera_feed_close(struct camera_feed *feed);

#endif
