/*
 * The file formats that the image display writes.
 */
#ifndef PLATFORM_DISPLAY_IMAGE_WRITER_H
#define PLATFORM_DISPLAY_IMAGE_WRITER_H

#include "platform/base/log.h"
#include "platform/display/pixels.h"

struct image_writer;

struct image_options {
	const char *path; /* must be valid during the call only */
	int width, height;
	int frame_count; /* 0 if not known */
	double rate_hz;  /* above 0 */
	const struct log *log;
};

struct image_writer_kind {
	const char *extension; /* with its dot, lower case */

	/* Returns 0, or -errno after logging an error, leaving no file. */
	int (*create)(
		const struct image_options *options, struct image_writer **out);

	/*
	 * Adds an RGBA8888 frame; alpha is ignored. Returns 0, or -errno after
	 * logging an error.
	 */
	int (*add)(struct image_writer *writer, const struct pixels *frame);

	/* Completes the file. Returns 0, or -errno after logging an error. */
	int (*finish)(struct image_writer *writer);

	/* Releases the writer and removes an incomplete file. NULL is fine. */
	void (*destroy)(struct image_writer *writer);
};

/* One PNG for each frame: PATH itself for one frame, else numbered files. */
extern const struct image_writer_kind image_writer_png;

/*
 * An animation that repeats for ever. GIF counts time in hundredths of a
 * second; frames are rounded to it without drift, and frames above 50 a second
 * are left out.
 */
extern const struct image_writer_kind image_writer_gif;

/* Uncompressed video: 4:2:0, BT.601, limited range. */
extern const struct image_writer_kind image_writer_y4m;

#endif
