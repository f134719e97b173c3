/*
 * A struct gl that draws nothing and keeps count: of the model-view stack in
 * double precision, of each draw call with the matrix it was made under, and
 * of where vertices go, of floats or of 16 bits.
 */
#ifndef TESTS_SUPPORT_GL_GL_RECORDER_H
#define TESTS_SUPPORT_GL_GL_RECORDER_H

#include "platform/gl/gl.h"

enum {
	GL_RECORDER_DRAWS = 128
};

struct gl_recorded_draw {
	double matrix[16]; /* columns */
	int count;         /* vertices or indices */
	const void *position;
	GLenum front_face;
};

struct gl_recording {
	int draw_count;
	struct gl_recorded_draw draw[GL_RECORDER_DRAWS];
	int depth; /* of the model-view stack, 0 at the bottom */

	/* Of all vertices of three parts that were drawn, as often as drawn. */
	long vertex_count;
	double sum[3];        /* in eye space */
	uint64_t vertex_hash; /* FNV-1a of their bytes and of the matrices */
};

/* A table whose calls are recorded; one at a time, emptied by this. */
struct gl gl_recorder_begin(void);

/* Forgets the draw calls so far, for the next frame. */
void gl_recorder_clear(void);

const struct gl_recording *gl_recorder_result(void);

#endif
