/*
 * Reorders triangles so that a vertex cache has few misses.
 *
 * Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and
 * Reduced Overdraw (SIGGRAPH 2007).
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_TIPSIFY_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_TIPSIFY_H

#include <stdbool.h>
#include <stdint.h>

/* The misses of a first-in-first-out cache of 16 vertices, or -ENOMEM. */
int optimize_tipsify_misses(const uint32_t *index, int count, int vertex_count);

/*
 * Reorders a list of count / 3 triangles, whose vertices are all below
 * vertex_count. Repeats until a pass saves less than 2% of the misses; a list
 * that is in good order stays as it is. Returns 0 or -ENOMEM.
 */
int optimize_tipsify(uint32_t *index, int count, int vertex_count);

#endif
