/* What of a drawable casts its shadow volume: triangles and their edges. */
#ifndef APP_SCENE_SHADOW_SHADOW_CASTER_H
#define APP_SCENE_SHADOW_SHADOW_CASTER_H

#include "app/scene/instance/instance.h"

/* Twice as many have indices of 16 bits. */
enum {
	SHADOW_CASTER_VERTICES_MAX = 32768
};

/* An edge and the triangles at it: one side goes a to b, the other b to a. */
struct shadow_edge {
	uint32_t a, b;
	int32_t left, right; /* right -1: an open border */
};

/* One drawable's volume, sized for the worst case at creation. */
struct shadow_caster {
	const struct drawable *drawable;
	/* Fewer triangles than are drawn; their outline is what counts. */
	uint16_t *corner;
	int corner_count; /* three a triangle */
	uint16_t *vertex; /* those that they need */
	int vertex_count;
	int edge_count;
	struct shadow_edge *edge;
	bool *lit;            /* [corner_count / 3], by the last update */
	float (*position)[3]; /* [2 * primitive's vertices]: as posed or moved down to
				 the ground, then moved away from the light */
	uint16_t *index; /* the far ends last */
	int index_count, back_cap_count;
	bool too_short; /* to reach the ground everywhere */
};

/*
 * Finds triangles and edges for a hull that is all 0, of a drawable of no more
 * than SHADOW_CASTER_VERTICES_MAX vertices: the model's own triangles for
 * shapes, else such as shadow_proxy.h makes, else all. Memory comes from the
 * arena; 0 or -ENOMEM.
 */
int shadow_caster_init(struct shadow_caster *caster,
	const struct drawable *drawable, struct arena *arena);

#endif
