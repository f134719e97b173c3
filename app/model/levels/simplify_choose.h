/* Chooses the neighbour that a vertex of a simplification collapses to. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_CHOOSE_H
#define APP_MODEL_LEVELS_SIMPLIFY_CHOOSE_H

#include "app/model/levels/simplify.h"

/*
 * Fills in best[from] and known[from]. A collapse is allowed if the surface
 * stays a surface, borders stay where they are, and no triangle turns over.
 * Attributes are compared only if the error of the shape is at most limit.
 */
void simplify_choose(struct simplify *simplify, uint32_t from, float limit);

/*
 * Whether a chosen collapse is still allowed, since neighbours may have
 * changed. If so, sets simplify->to of all vertices of the leader `from`.
 */
bool simplify_choose_again(
	struct simplify *simplify, uint32_t from, uint32_t to);

#endif
