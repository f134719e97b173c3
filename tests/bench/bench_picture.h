/* The view of a benchmark's picture, and the file that somebody can look at. */
#ifndef TESTS_BENCH_BENCH_PICTURE_H
#define TESTS_BENCH_BENCH_PICTURE_H

#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

/*
 * Sets the projection of a picture three wide and four high, between depths of
 * 1 and 10, and leaves an identity in the model-view matrix.
 */
void bench_picture_project(const struct gl *gl);

/*
 * Writes RGB565 or RGBA8888 pixels, whose rows follow each other without gaps,
 * as a PPM file. Ends the program with a sentence when that fails.
 */
void bench_picture_write(const char *path, const struct pixels *pixels);

#endif
