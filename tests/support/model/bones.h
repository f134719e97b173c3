/*
 * Builds skeletons in memory, poses them and measures them, for tests of code
 * that moves bones.
 */
#ifndef TESTS_SUPPORT_MODEL_BONES_H
#define TESTS_SUPPORT_MODEL_BONES_H

#include "app/anim/pose.h"

enum {
	BONES_MAX = 20
};

/* A model that consists of nodes alone, with a pose and its world matrices. */
struct bones {
	struct model model;
	struct model_node node[BONES_MAX];
	struct model_mesh mesh[1];
	float rest_weights[4];
	struct pose pose;
	mat4 world[BONES_MAX];
};

/*
 * Begins a skeleton without nodes. bones_end() releases the model's arena, from
 * which the pose is allocated.
 */
void bones_begin(struct bones *bones);
void bones_end(struct bones *bones);

/*
 * Adds a node at an offset from its parent and returns its index; parent is -1
 * for a root.
 */
int bones_add(struct bones *bones, int parent, float x, float y, float z);

/* Makes the rest pose of the nodes that were added, and its world matrices. */
void bones_pose(struct bones *bones);

/* Computes the world matrices of the current pose. */
void bones_update(struct bones *bones);

/* The position of a node in world space, as of the last update. */
void bones_place(const struct bones *bones, int node, float out[3]);

/* The distance between a node and a point in world space. */
double bones_distance(const struct bones *bones, int node, const float point[3]);

/* The distance between two nodes in world space. */
double bones_length(const struct bones *bones, int a, int b);

/* The point at a distance from a node in a direction of world space. */
void bones_point(const struct bones *bones, int node, const float direction[3],
	float distance, float out[3]);

/* Fails the test unless the pose and the world matrices are finite. */
void bones_assert_finite(const struct bones *bones);

#endif
