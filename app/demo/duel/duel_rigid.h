/*
 * A rigid candidate as a model that scenes show: a mesh below each joint.
 */
#ifndef APP_DEMO_DUEL_DUEL_RIGID_H
#define APP_DEMO_DUEL_DUEL_RIGID_H

#include "app/compare/candidate_rigid.h"

struct duel_rigid {
	struct model model; /* shares much of the reference's, owns nothing */
	const struct rigid_bake *rigid;
	int *part;  /* [rigid.part_count], by node, then by place in its mesh */
	int *first; /* [node_count]: into part */
};

/*
 * rigid's candidate must outlive it. Memory is the arena's. 0 or -ENOMEM.
 */
int duel_rigid_init(struct duel_rigid *shown, const struct rigid_bake *rigid,
	struct arena *arena);

/* The reference's vertex that a vertex of a drawable shows. */
int duel_rigid_source(const struct duel_rigid *shown,
	const struct drawable *drawable, int vertex);

#endif
