/*
 * Expecting the colours that a formula gives, in pictures of either format.
 *
 * A colour is four doubles of 0..1; what is beyond is clamped, as GL does
 * before it writes. The tolerance is 2 of 255, and in RGB565 two steps of the
 * channel: the short cuts blend and modulate in steps of 1/32.
 */
#ifndef TESTS_SUPPORT_GL_GL_EXPECT_H
#define TESTS_SUPPORT_GL_GL_EXPECT_H

#include "tests/support/gl/gl_checks.h"

/* RGBA8888 and RGB565, for loops over both. */
extern const enum pixel_format gl_expect_formats[2];

/* The pixel as ReadPixels gives it; y from the top. */
void gl_expect_read(const struct stage *stage, int x, int y, uint8_t rgba[4]);

/* Fails with the case's name unless red, green and blue are near. */
void gl_expect_color(const struct stage *stage, const char *name, int x, int y,
	const double rgb[3]);

/* The same for alpha too, where the format has one. */
void gl_expect_color_alpha(const struct stage *stage, const char *name, int x,
	int y, const double rgba[4]);

/* 16.16 of a number, and of count of them. */
GLfixed gl_fixed(double value);
void gl_fixed_all(const double *values, int count, GLfixed *out);

/* Sets the current colour, the colour to clear with. */
void gl_set_color(struct gl *gl, const double rgba[4]);
void gl_clear_to(struct gl *gl, const double rgba[4]);

/*
 * Draws with soft and with osmesa into RGBA8888 and counts the pixels of either
 * picture whose colour the other has nowhere within reach, each channel within
 * tolerance. Skips the test on an ARM machine without osmesa. Neither dithers.
 */
int gl_count_differences(void (*draw)(struct gl *gl, const void *context),
	const void *context, int reach, int tolerance);

#endif
