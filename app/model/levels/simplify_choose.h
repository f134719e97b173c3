/* Which neighbour a vertex of a simplification collapses to. */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_CHOOSE_H
#define APP_MODEL_LEVELS_SIMPLIFY_CHOOSE_H

#include "app/model/levels/simplify.h"

/*
 * Fills best and known of a leader. A collapse keeps the surface a surface, the
 * border where it is, and turns no triangle over. Attributes are looked at only
 * if the shape's error is at most the limit.
 */
void simplify_choose(struct simplify *simplify, uint32_t from, float limit);

/*
 * Whether a collapse that was chosen is allowed still, since neighbours may
 * have changed. Sets where the vertices of leader from go if it is.
 */
bool simplify_choose_again(
	struct simplify *simplify, uint32_t from, uint32_t to);

#endif
