/*
 * Points of a model's surface, placed without posing its vertices: each moves
 * with the two nodes that move its vertex most.
 */
#ifndef APP_CHARACTER_RUN_SOLE_H
#define APP_CHARACTER_RUN_SOLE_H

#include "app/scene/instance/instance.h"

struct character_sole {
	int node[2];
	float at[2][3]; /* the point in each node's frame */
	float weight[2];
};

/* Returns a point that moves with one node; at is in the node's frame. */
struct character_sole character_sole_on_node(int node, const float at[3]);

/*
 * Returns a vertex of a primitive that a node shows; at is where the vertex is
 * in the mesh: primitive->position[vertex], perhaps moved by morph targets.
 */
struct character_sole character_sole_of_vertex(const struct model *model,
	int node, const struct model_primitive *primitive, int vertex,
	const float at[3]);

/* Returns the node that moves such a vertex most. */
int character_sole_mover(const struct model *model, int node,
	const struct model_primitive *primitive, int vertex);

/* Computes the point's place in the world from the instance's nodes. */
void character_sole_place(const struct character_sole *sole,
	const struct instance *instance, float out[3]);

#endif
