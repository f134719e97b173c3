/*
 * Shadow proxies: fewer triangles with nearly the same silhouette.
 *
 * They are for models without lists of triangles for shadows. A proxy is made
 * by vertex clustering: vertices in the same cell of a grid whose normals are
 * in the same octant and that follow the same joint are merged, and triangles
 * that degenerate are dropped. Vertices at the same place count as one, with the
 * sum of their normals. The remaining vertices keep their positions, so
 * a proxy needs no additional posing.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_PROXY_H
#define APP_SCENE_SHADOW_SHADOW_PROXY_H

#include "app/model/model.h"
#include "platform/base/arena.h"

#include <stdint.h>

/*
 * Makes the proxy of a primitive of at most 65,536 vertices and allocates its
 * index in the arena. A primitive without normals keeps all its triangles.
 * inverse_order gives the index at which each vertex is stored; NULL means the
 * primitive's order. Returns 0 or -ENOMEM.
 */
int shadow_proxy_make(const struct model_primitive *primitive,
	const uint32_t *inverse_order, struct arena *arena, uint16_t **index,
	int *index_count);

#endif
