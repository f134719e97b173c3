/* Random textures and triangles, for tests that compare span functions. */
#ifndef TESTS_SUPPORT_SOFT_SPAN_RANDOM_H
#define TESTS_SUPPORT_SOFT_SPAN_RANDOM_H

#include "tests/support/soft/span_scene.h"

GLenum span_one_of(uint32_t *seed, const GLenum *values, int count);

/* The number of texel formats; 0 is RGB565, 1 is RGBA4444. */
enum {
	SPAN_TEXELS = 8
};

/*
 * Makes and enables a random texture of one of these formats. All its bytes are
 * XORed with flip, so that another flip gives other texels for the same seed.
 */
void span_give_texels(
	const struct gl *gl, uint32_t *seed, int format, uint32_t flip);

/* The same in a random format, with a flip of 0. */
void span_give_texture(const struct gl *gl, uint32_t *seed);

/* A random triangle, valid until the next call; w is 4, 3.6-4.4 or 3.2-4.8. */
const struct span_corner *span_make_triangle(uint32_t *seed);

/* span_scene_begin() with a perspective projection. */
struct span_scene *span_begin_in_perspective(
	enum pixel_format format, bool reference);

#endif
