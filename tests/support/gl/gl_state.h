/*
 * Follows what is enabled while something draws into a recorder of GL's calls,
 * so that a test sees whether a drawing sets all state that it depends on. One
 * at a time, as the recorder.
 */
#ifndef TESTS_SUPPORT_GL_GL_STATE_H
#define TESTS_SUPPORT_GL_GL_STATE_H

#include "platform/gl/gl.h"

#include <stdbool.h>

enum {
	GL_STATE_DRAWS = 16,
	GL_STATE_VERTICES = 64,        /* that are kept of each */
	GL_STATE_DEPTH_WRITES = 0x0B72 /* GL's GL_DEPTH_WRITEMASK */
};

/* What a draw call found, and its first vertices if they are floats. */
struct gl_state_draw {
	GLenum mode;
	int count;
	float vertex[GL_STATE_VERTICES][3];
	double color[4]; /* the current one */
	uint32_t on;     /* a bit for each capability; see gl_state_has() */
};

/*
 * Makes a recorder (gl_recorder.h) follow the state. Everything is enabled at
 * the beginning, or nothing is.
 */
struct gl gl_state_begin(bool enabled);

/* A draw call, counted from 0, and the last one; there must have been one. */
const struct gl_state_draw *gl_state_drawn(int number);
const struct gl_state_draw *gl_state_last(void);

/*
 * Whether a capability, an array of the client or GL_STATE_DEPTH_WRITES was on
 * in the draw call; with NULL, whether it is on now.
 */
bool gl_state_has(const struct gl_state_draw *draw, GLenum capability);

/* Fail the test unless all of a list, which ends with 0, is on, or is off. */
void gl_state_expect_on(const struct gl_state_draw *draw, const GLenum *list);
void gl_state_expect_off(const struct gl_state_draw *draw, const GLenum *list);

#endif
