/*
 * Draws the triangles of one batch with the arrays that a pass needs.
 */
#ifndef APP_SCENE_DRAW_DRAW_BATCH_H
#define APP_SCENE_DRAW_DRAW_BATCH_H

#include "app/scene/instance/batch/batch.h"
#include "platform/gl/gl.h"

/* What one pass draws besides positions; the pointers may be NULL. */
struct draw_arrays {
	bool lit;        /* pass the batch's normals */
	bool both_units; /* pass texcoord to the second unit, too */
	const float (*texcoord)[2];
	const uint8_t (*color)[4];
	bool edges;                   /* draw the triangles' edges */
	const struct batch_lod *list; /* NULL: all triangles */
};

void draw_batch(const struct gl *gl, const struct batch *batch,
	const struct draw_arrays *arrays);

#endif
