/* Random textures and triangles, for tests that compare span functions. */
#ifndef TESTS_SUPPORT_SOFT_SPAN_RANDOM_H
#define TESTS_SUPPORT_SOFT_SPAN_RANDOM_H

#include "tests/support/soft/span_scene.h"

GLenum span_one_of(uint32_t *seed, const GLenum *values, int count);

/* Formats of texels: RGB565, RGBA4444, and others. */
enum {
	SPAN_TEXELS = 8
};

/*
 * Enables a texture of one of these formats; the seed tells all else, but bytes
 * are others if flip is not 0.
 */
void span_give_texels(
	const struct gl *gl, uint32_t *seed, int format, uint32_t flip);

/* The same, of any format. */
void span_give_texture(const struct gl *gl, uint32_t *seed);

/* Three corners at depths around 4: w differs by up to half, hardly, or not. */
const struct span_corner *span_make_triangle(uint32_t *seed);

struct span_scene *span_begin_in_perspective(
	enum pixel_format format, bool reference);

#endif
