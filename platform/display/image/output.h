/*
 * A file that appears when it is complete.
 *
 * What is written goes to "PATH.part" and takes PATH's place at the end, so a
 * failure leaves neither half a file nor harms the one that was there.
 */
#ifndef PLATFORM_DISPLAY_IMAGE_OUTPUT_H
#define PLATFORM_DISPLAY_IMAGE_OUTPUT_H

#include <stdio.h>

#include "platform/base/log.h"

struct output {
	FILE *file; /* NULL: nothing is open */
	char *path;
	char *part;
	struct log log;
};

/* 0, or -errno after a sentence with nothing left behind. */
int output_open(struct output *output, const char *path, const struct log *log);

/*
 * Says that writing failed, for the reason in errno_value or, when that is 0,
 * one the writer gives. Returns -errno_value or -EIO.
 */
int output_failed(
	const struct output *output, int errno_value, const char *reason);

/* Moves the finished file into place. 0, or -errno after a sentence. */
int output_commit(struct output *output);

/* Removes what was not committed; does nothing when nothing is open. */
void output_discard(struct output *output);

#endif
