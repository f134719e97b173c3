/* What collapses change in attributes, as distances in fractions of the extent. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_ATTRIBUTES_H
#define APP_MODEL_LEVELS_SIMPLIFY_ATTRIBUTES_H

#include "app/model/levels/simplify_mesh.h"

/*
 * Returns the change of attributes if the leader `from` collapses to the leader
 * `to`, as a distance. simplify->to says which vertex each vertex of `from`
 * collapses to.
 */
float simplify_error_of_attributes(
	const struct simplify *simplify, uint32_t from, uint32_t to);

/*
 * Returns the square of the change if corners move from a vertex to another one
 * at its position.
 */
float simplify_square_of_merge(
	const struct simplify *simplify, uint32_t from, uint32_t to);

#endif
