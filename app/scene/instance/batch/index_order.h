/*
 * The order of a list's triangles.
 *
 * A driver that transforms vertices by program keeps some hundreds of them, so
 * triangles with common vertices should be near each other in their list. A
 * skin's vertices are stored by influences and joints (fixed_skin.h), in
 * another order than the file's, which may scatter a list that was good.
 */
#ifndef APP_SCENE_INSTANCE_INDEX_ORDER_H
#define APP_SCENE_INSTANCE_INDEX_ORDER_H

#include <stdint.h>

enum {
	/* vertices in the cache, one for each value of an index's low bits */
	INDEX_ORDER_CACHE = 512
};

/* Counts the vertices that a list transforms with such a cache. */
int index_order_misses(const uint16_t *index, int count);

/*
 * Sorts a list's triangles by their lowest vertex if that makes a driver
 * transform fewer vertices. Otherwise, and if memory is short, the list stays
 * as it is. Triangles keep their corners' order.
 */
void index_order_improve(uint16_t *index, int count);

#endif
