/*
 * Random triangles of three kinds, drawn by the soft driver's fast paths and by
 * the reference, in pictures of soft_scene.h.
 */
#ifndef TESTS_SUPPORT_SOFT_FAST_SCENE_H
#define TESTS_SUPPORT_SOFT_FAST_SCENE_H

#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/soft_scene.h"

enum {
	FAST_SIDE = 32, /* of the texture, in texels */
};

enum fast_kind {
	FAST_PLAIN,    /* coloured, with a depth test */
	FAST_TEXTURED, /* a texture times gray, with a depth test */
	FAST_SHADOW,   /* one blended colour, once a pixel by the stencil */
	FAST_KINDS,
};

enum {
	FAST_TRIANGLES = 40,
	FAST_CORNERS = FAST_TRIANGLES * 3,
};

/* Opens a context with a cleared picture and a texture of noise. */
struct soft_scene *fast_scene_open(uint32_t seed);

/*
 * Makes FAST_TRIANGLES triangles in random places inside of the picture and
 * across its borders. In clip space the corners lie within size thousandths of
 * the place.
 */
void fast_scene_make_triangles(struct soft_corner *corner, uint32_t seed,
	enum fast_kind kind, int size);

/* Begins a frame and sets the state of a kind; long_way as in soft_scene_use(). */
void fast_scene_set_state(struct soft_scene *scene,
	const struct soft_corner *corner, enum fast_kind kind, bool long_way);

/* Does the same and draws the triangles. */
void fast_scene_draw(struct soft_scene *scene, const struct soft_corner *corner,
	enum fast_kind kind, bool long_way);

/* Fails unless coverage, depth and stencil agree, and colours within a step. */
void fast_scene_compare(const struct soft_scene *a, const struct soft_scene *b);

#endif
