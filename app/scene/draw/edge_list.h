/*
 * Draws the edges of indexed triangles. GL ES 1.1 has no glPolygonMode(), so
 * the edges are drawn as GL_LINES. An edge that two triangles share is drawn
 * once where they are near each other in the list.
 */
#ifndef APP_SCENE_DRAW_EDGE_LIST_H
#define APP_SCENE_DRAW_EDGE_LIST_H

#include "platform/gl/gl.h"

#include <stdint.h>

/*
 * Draws the edges of count / 3 triangles of the current vertex array. If index
 * is NULL, every three vertices are a triangle, and vertices from number 65535
 * on are left out.
 */
void edge_list_draw(const struct gl *gl, const uint16_t *index, int count);

#endif
