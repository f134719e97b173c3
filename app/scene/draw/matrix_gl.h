/*
 * Float matrices into GL's 16.16.
 */
#ifndef APP_SCENE_DRAW_MATRIX_GL_H
#define APP_SCENE_DRAW_MATRIX_GL_H

#include "platform/gl/gl.h"

#include <cglm/types.h>

/* LoadMatrix and MultMatrix of four columns; elements within +-32768. */
void matrix_gl_load(const struct gl *gl, const vec4 *matrix);
void matrix_gl_multiply(const struct gl *gl, const vec4 *matrix);

/* True when the matrix mirrors, so that triangles turn the other way. */
int matrix_gl_mirrors(const vec4 *matrix);

#endif
