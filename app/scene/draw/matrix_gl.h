/*
 * Passes float matrices to GL ES 1.1 in 16.16 fixed point.
 */
#ifndef APP_SCENE_DRAW_MATRIX_GL_H
#define APP_SCENE_DRAW_MATRIX_GL_H

#include "platform/gl/gl.h"

#include <cglm/types.h>

/*
 * Call LoadMatrixx() and MultMatrixx() with a matrix of four columns, whose
 * elements have to be between -32768 and 32768.
 */
void matrix_gl_load(const struct gl *gl, const vec4 *matrix);
void matrix_gl_multiply(const struct gl *gl, const vec4 *matrix);

#endif
