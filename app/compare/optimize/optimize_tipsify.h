/*
 * The order of triangles that a vertex cache serves best.
 *
 * Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and
 * Reduced Overdraw (SIGGRAPH 2007).
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_TIPSIFY_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_TIPSIFY_H

#include <stdbool.h>
#include <stdint.h>

/* The vertices that a first-in-first-out cache of 16 has to fetch. */
int optimize_tipsify_misses(const uint32_t *index, int count, int vertex_count);

/*
 * Reorders a list of count / 3 triangles, whose vertices are all below
 * vertex_count. Passes end when one saves less than 2% of the
 * vertices to fetch; an ordered list stays as it is. Returns 0 or -ENOMEM.
 */
int optimize_tipsify(uint32_t *index, int count, int vertex_count);

#endif
