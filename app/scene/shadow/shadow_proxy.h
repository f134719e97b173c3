/*
 * A mesh of fewer triangles with nearly the same outline, for shadows: the
 * model's own level for shapes, or else one that is made here.
 *
 * For that, vertices that lie in one cell of a grid, face the same octant and
 * follow the same joint become one of them; triangles that lose a corner go.
 * The vertices stay where they are, so posing them costs nothing more.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_PROXY_H
#define APP_SCENE_SHADOW_SHADOW_PROXY_H

#include "app/model/model.h"
#include "platform/base/arena.h"

#include <stdint.h>

/*
 * Lists the triangles of a primitive of at most 65,536 vertices with normals,
 * in the arena. Place says where each vertex is drawn from, NULL: where the
 * primitive has it. 0 or -ENOMEM.
 */
int shadow_proxy_make(const struct model_primitive *primitive,
	const uint32_t *place, struct arena *arena, uint16_t **index,
	int *index_count);

#endif
