/*
 * A drawable as a shadow caster: its triangles, their edges, and the buffers of
 * the shadow volume that shadow_volume.c extrudes from them.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_CASTER_H
#define APP_SCENE_SHADOW_SHADOW_CASTER_H

#include "app/scene/instance/instance.h"

/* A volume has twice as many vertices, and 16-bit indices. */
enum {
	SHADOW_CASTER_VERTICES_MAX = 32768
};

/* An edge goes from a to b in triangle left and from b to a in right. */
struct shadow_edge {
	uint32_t a, b;
	int32_t left, right; /* right is -1 at an open border */
};

struct shadow_caster {
	const struct drawable *drawable;
	/* The primitive's vertices that the shadow proxy uses. */
	uint16_t *vertex;
	int vertex_count;
	/* The proxy's triangles; corners and edges number those vertices. */
	uint16_t *corner;
	int corner_count; /* three a triangle */
	int edge_count;
	struct shadow_edge *edge;

	/* The volume of the last update, allocated for the largest one. */
	bool *lit; /* [corner_count / 3]: the triangle faces the light */
	/*
	 * [2 * vertex_count]: where the volume begins and, in the second half,
	 * where it ends; scene units.
	 */
	float (*position)[3];
	uint16_t *index; /* front cap, sides, back cap */
	int index_count, back_cap_count;
	bool too_short; /* does not reach the ground everywhere */
};

/*
 * Finds triangles and edges for a zeroed caster. The drawable has at most
 * SHADOW_CASTER_VERTICES_MAX vertices. Memory comes from the arena. Returns 0
 * or -ENOMEM.
 */
int shadow_caster_init(struct shadow_caster *caster,
	const struct drawable *drawable, struct arena *arena);

#endif
