/* Errors of collapses, as distances in fractions of the extent. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_ERROR_H
#define APP_MODEL_LEVELS_SIMPLIFY_ERROR_H

#include "app/model/levels/simplify_mesh.h"

/* Fills in quadric[] from the whole list's triangles and border edges. */
void simplify_error_begin(struct simplify *simplify);

/*
 * Returns the distance of the leader `to` from the planes in the quadric of
 * `from`: the root of their mean square.
 */
float simplify_error_of_shape(
	const struct simplify *simplify, uint32_t from, uint32_t to);

/* Adds the quadric of `from` to that of `to`. */
void simplify_error_collapse(
	struct simplify *simplify, uint32_t from, uint32_t to);

#endif
