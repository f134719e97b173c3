/*
 * Writes index arrays for GL_TRIANGLES.
 */
#ifndef APP_SCENE_DRAW_TRIANGLE_LIST_H
#define APP_SCENE_DRAW_TRIANGLE_LIST_H

#include <stdint.h>

/* Writes one triangle and returns the address of the next one. */
static inline uint16_t *triangle_list_add(
	uint16_t *next, uint32_t a, uint32_t b, uint32_t c)
{
	next[0] = (uint16_t)a;
	next[1] = (uint16_t)b;
	next[2] = (uint16_t)c;
	return next + 3;
}

#endif
