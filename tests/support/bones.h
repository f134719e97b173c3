/*
 * Skeletons made in memory, posed and measured, for tests of what moves bones.
 */
#ifndef TESTS_SUPPORT_BONES_H
#define TESTS_SUPPORT_BONES_H

#include "app/anim/pose.h"

enum {
	BONES_MAX = 20
};

/* A model of nothing but nodes, with a pose and its world matrices. */
struct bones {
	struct model model;
	struct model_node node[BONES_MAX];
	struct model_mesh mesh[1];
	float rest_weights[4];
	struct pose pose;
	mat4 world[BONES_MAX];
};

/*
 * Begins a skeleton without nodes. Everything lives in the model's arena,
 * which bones_end() releases.
 */
void bones_begin(struct bones *bones);
void bones_end(struct bones *bones);

/* Adds a node at an offset from its parent (-1: none); returns its index. */
int bones_add(struct bones *bones, int parent, float x, float y, float z);

/* Makes the pose of the nodes that were added, and its world matrices. */
void bones_pose(struct bones *bones);

/* World matrices of the pose as it is now. */
void bones_update(struct bones *bones);

/* A node's place in the world, after the last update. */
void bones_place(const struct bones *bones, int node, float out[3]);

/* The distance between a node and a point. */
double bones_distance(const struct bones *bones, int node, const float point[3]);

/* Fails unless all of the pose and the world matrices is finite. */
void bones_assert_finite(const struct bones *bones);

#endif
