/*
 * Cameras: where live pictures come from.
 *
 * A source hands out its newest picture and never waits for one: what nobody
 * took in time is dropped. It may lose its device and find it again; all that
 * is seen of that here is that there is no picture for a while. (What looks at
 * a scene is another camera: app/scene/stage/camera.h.)
 */
#ifndef PLATFORM_CAMERA_CAMERA_H
#define PLATFORM_CAMERA_CAMERA_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"

enum {
	CAMERA_SIDE_MAX = 2048, /* of a picture, in pixels */
	CAMERA_PLANES = 3
};

/*
 * How the bytes of a picture lie. YCbCr is BT.601 in limited range: luma 16 to
 * 235, chroma 16 to 240 around 128.
 */
enum camera_format {
	CAMERA_RGB565, /* two bytes a pixel, the lower one first */
	CAMERA_UYVY,   /* Cb Y Cr Y for two pixels */
	CAMERA_YUYV,   /* Y Cb Y Cr */
	CAMERA_NV12,   /* a plane of Y, one of Cb Cr for each 2 x 2 pixels */
	CAMERA_YUV420, /* planes of Y, Cb and Cr, the latter 2 x 2 */
	CAMERA_RGB24,  /* bytes R G B */
	CAMERA_BGR24,  /* bytes B G R */
	CAMERA_FORMATS,
};

/* A picture where its source has it. */
struct camera_image {
	enum camera_format format;
	int width, height; /* 1..CAMERA_SIDE_MAX */
	const uint8_t *plane[CAMERA_PLANES];
	int stride_bytes[CAMERA_PLANES]; /* from row to row of the plane */
};

/* The bytes that a picture takes. */
struct camera_layout {
	int stride_bytes[CAMERA_PLANES];
	int offset[CAMERA_PLANES]; /* of the planes, one after another */
	int size;
};

/*
 * How a picture without gaps between its planes lies in memory. Chroma planes
 * take their strides from luma's; 0 for least_stride_bytes means no gap
 * between rows either. Sides within 1..CAMERA_SIDE_MAX, least_stride_bytes up
 * to 65536.
 */
struct camera_layout camera_layout_of(enum camera_format format, int width,
	int height, int least_stride_bytes);

/* The picture that lies so at data. */
struct camera_image camera_image_at(enum camera_format format, int width,
	int height, const struct camera_layout *layout, const uint8_t *data);

/* What a camera is asked for; strings are borrowed for the call only. */
struct camera_options {
	const char *argument;  /* what follows "NAME:", or NULL */
	int width, height;     /* about this size */
	const char *format;    /* "uyvy" and so on, or NULL to choose */
	const struct log *log; /* copied */
};

/* What take() found. */
enum camera_status {
	CAMERA_NONE, /* no picture, or none any more */
	CAMERA_SAME, /* the one taken last is still the newest */
	CAMERA_NEW,
};

struct camera_source;

struct camera_driver {
	const char *name;
	const char *summary;

	/*
	 * 0, or -errno after a sentence with nothing left open: for a wrong
	 * argument, or want of memory. A device that is missing is no error:
	 * it may come. Never waits for a device. Mandatory.
	 */
	int (*create)(const struct camera_options *options,
		struct camera_source **out);

	/*
	 * The newest picture, for the frame of time now_ms. After CAMERA_NEW
	 * *out stays valid until give_back(), which has to come before the
	 * next take() or destroy() and better soon. Never blocks and never
	 * allocates; says here what happened to the device. Mandatory.
	 */
	enum camera_status (*take)(struct camera_source *source, int64_t now_ms,
		struct camera_image *out);

	/* Mandatory. */
	void (*give_back)(struct camera_source *source);

	/*
	 * Waits up to timeout_ms for a first picture; for the time before the
	 * first frame. Optional: NULL where there is one at once.
	 */
	void (*await)(struct camera_source *source, int timeout_ms);

	/* NULL is fine. Mandatory. */
	void (*destroy)(struct camera_source *source);

	/*
	 * Says which devices there are and what they deliver, or that there
	 * are none; sets no format, starts nothing and waits for no device
	 * longer than a fraction of a second. Optional.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers, NULL at the end. */
extern const struct camera_driver *const camera_registry[];

/* "uyvy" and so on; CAMERA_FORMATS for what is none, NULL for that. */
enum camera_format camera_format_find(const char *name);
const char *camera_format_name(enum camera_format format);

/* An open camera. */
struct camera_feed {
	const struct camera_driver *driver; /* NULL: none is open */
	struct camera_source *source;
};

/*
 * Opens what SPEC says: a device such as /dev/video0, "auto" for the first
 * that captures, or a driver's "NAME" or "NAME:ARGUMENT", each with ",WxH"
 * and ",FORMAT" after it if wanted. 0, or -errno after a sentence; -EINVAL
 * when SPEC is wrong.
 */
int camera_feed_open(
	const char *spec, const struct log *log, struct camera_feed *out);

/* A feed that is not open is fine. */
void camera_feed_close(struct camera_feed *feed);

#endif
