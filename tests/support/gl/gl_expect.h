/*
 * Compares pixels with the colours that a formula gives, in both formats.
 *
 * A colour is four doubles of 0..1; values beyond are clamped, as GL clamps
 * before it writes. The tolerance is 2 of 255, and in RGB565 two steps of the
 * channel, because the soft driver blends and modulates 565 in steps of 1/32.
 */
#ifndef TESTS_SUPPORT_GL_GL_EXPECT_H
#define TESTS_SUPPORT_GL_GL_EXPECT_H

#include "tests/support/gl/gl_checks.h"

/* RGBA8888 and RGB565, for tests that loop over both. */
extern const enum pixel_format gl_expect_formats[2];

/* The pixel as ReadPixels returns it; y counts from the top row. */
void gl_expect_read(
	const struct gl_canvas *canvas, int x, int y, uint8_t rgba[4]);

/* Fails, with the name of the case, unless red, green and blue are near. */
void gl_expect_color(const struct gl_canvas *canvas, const char *name, int x,
	int y, const double rgb[3]);

/* The same for red, green, blue and, where the format has it, alpha. */
void gl_expect_color_alpha(const struct gl_canvas *canvas, const char *name,
	int x, int y, const double rgba[4]);

/* Converts a number, or count numbers, to 16.16 fixed point. */
GLfixed gl_fixed(double value);
void gl_fixed_all(const double *values, int count, GLfixed *out);

/* Sets the current colour; clears the picture to a colour. */
void gl_set_color(struct gl *gl, const double rgba[4]);
void gl_clear_to(struct gl *gl, const double rgba[4]);

/*
 * Draws with the drivers soft and osmesa into RGBA8888, without dithering.
 * Returns how many pixels have no counterpart in the other picture: a pixel
 * within reach, in x and y, whose channels differ by at most tolerance. Skips
 * the test on an ARM machine without osmesa.
 */
int gl_count_differences(void (*draw)(struct gl *gl, const void *context),
	const void *context, int reach, int tolerance);

#endif
