/*
 * A struct gl that draws nothing and keeps count: of the model-view stack in
 * double precision, and of each draw call with the matrix it was made under.
 */
#ifndef TESTS_SUPPORT_GL_RECORDER_H
#define TESTS_SUPPORT_GL_RECORDER_H

#include "platform/gl/gl.h"

enum {
	GL_RECORDER_DRAWS = 64
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
	int deepest;
};

/* A table whose calls are recorded; one at a time, emptied by this. */
struct gl gl_recorder_begin(void);

const struct gl_recording *gl_recorder_result(void);

#endif
