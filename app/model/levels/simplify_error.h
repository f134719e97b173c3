/* What a collapse changes, as distances. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_ERROR_H
#define APP_MODEL_LEVELS_SIMPLIFY_ERROR_H

#include "app/model/levels/simplify_mesh.h"

/* Fills quadric from the triangles and the border edges of the whole list. */
void simplify_error_begin(struct simplify *simplify);

/* The distance of leader to from the planes that leader from stands for. */
float simplify_error_of_shape(
	const struct simplify *simplify, uint32_t from, uint32_t to);

/*
 * The distance that stands for the change of attributes when leader from
 * collapses to leader to; at says to which vertex each of its vertices goes.
 */
float simplify_error_of_attributes(
	const struct simplify *simplify, uint32_t from, uint32_t to);

/* What leader from stands for is added to leader to. */
void simplify_error_collapse(
	struct simplify *simplify, uint32_t from, uint32_t to);

#endif
