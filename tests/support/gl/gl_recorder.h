/*
 * A struct gl that draws nothing. It records each draw call together with the
 * current model-view matrix, in double precision, and sums up the vertices,
 * whether they are floats or 16-bit integers.
 */
#ifndef TESTS_SUPPORT_GL_GL_RECORDER_H
#define TESTS_SUPPORT_GL_GL_RECORDER_H

#include "platform/gl/gl.h"

enum {
	GL_RECORDER_DRAWS = 1024
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

	/* Over the vertices with x, y and z, each as often as it was drawn. */
	long vertex_count;
	double sum[3];        /* in eye space */
	uint64_t vertex_hash; /* FNV-1a of their bytes and of the matrices */
};

/* Empties the recording and returns a table that records; one at a time. */
struct gl gl_recorder_begin(void);

/* Empties the recording for the next frame; the matrix stack stays. */
void gl_recorder_clear(void);

const struct gl_recording *gl_recorder_result(void);

#endif
