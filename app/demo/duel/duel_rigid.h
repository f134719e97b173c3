/*
 * Makes a model of a rigid candidate, in which each joint's node has a mesh.
 */
#ifndef APP_DEMO_DUEL_DUEL_RIGID_H
#define APP_DEMO_DUEL_DUEL_RIGID_H

#include "app/compare/candidate/candidate_rigid.h"

struct duel_rigid {
	struct model model; /* shares arrays with the reference's model */
	const struct rigid_bake *rigid;
	int *part;  /* [rigid.part_count], sorted by node and primitive */
	int *first; /* [node_count]: index of the node's first part in part */
};

/*
 * Makes the model. Memory comes from the arena; rigid's candidate must outlive
 * the model. Returns 0 or -ENOMEM.
 */
int duel_rigid_init(struct duel_rigid *shown, const struct rigid_bake *rigid,
	struct arena *arena);

/* Returns the reference's vertex that a drawable's vertex is a copy of. */
int duel_rigid_source(const struct duel_rigid *shown,
	const struct drawable *drawable, int vertex);

#endif
