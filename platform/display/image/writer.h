/*
 * The kinds of file that the image display writes.
 */
#ifndef PLATFORM_DISPLAY_IMAGE_WRITER_H
#define PLATFORM_DISPLAY_IMAGE_WRITER_H

#include "platform/base/log.h"
#include "platform/display/pixels.h"

struct image_writer;

struct image_options {
	const char *path; /* borrowed for the call */
	int width, height;
	int frame_count; /* 0: not known */
	double rate_hz;  /* above 0 */
	const struct log *log;
};

struct image_writer_kind {
	const char *extension; /* with its dot, lower case */

	/* 0, or -errno after a sentence with nothing left behind. */
	int (*create)(
		const struct image_options *options, struct image_writer **out);

	/* Takes one more frame; alpha is ignored. 0, or -errno, told. */
	int (*add)(struct image_writer *writer, const struct pixels *frame);

	/* Completes the file. 0, or -errno after a sentence. */
	int (*finish)(struct image_writer *writer);

	/* Removes what is not complete. NULL is fine. */
	void (*destroy)(struct image_writer *writer);
};

/* One PNG a frame: PATH itself, or numbered when there may be several. */
extern const struct image_writer_kind image_writer_png;

/*
 * An animation without end. Its clock counts hundredths of a second; frames
 * are laid on it without drift, and those beyond 50 a second left out.
 */
extern const struct image_writer_kind image_writer_gif;

/* Raw video for ffmpeg and players: 4:2:0, BT.601, limited range. */
extern const struct image_writer_kind image_writer_y4m;

#endif
