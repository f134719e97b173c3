/* Writes the picture that a benchmark drew, so that somebody can look at it. */
#ifndef TESTS_BENCH_BENCH_PICTURE_H
#define TESTS_BENCH_BENCH_PICTURE_H

#include "platform/display/pixels.h"

/*
 * Writes RGB565 or RGBA8888 pixels, whose rows follow each other without gaps,
 * as a PPM file. Ends the program with a sentence when that fails.
 */
void bench_picture_write(const char *path, const struct pixels *pixels);

#endif
