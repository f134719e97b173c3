/*
 * Capsules on a skeleton, with which hair and cloth collide.
 *
 * A capsule is the set of points within radius of a line segment. Each end of
 * the segment is fixed to a node. With equal ends it is a sphere.
 */
#ifndef APP_ANIM_PROCEDURAL_CAPSULE_H
#define APP_ANIM_PROCEDURAL_CAPSULE_H

#include "app/anim/pose.h"

struct capsule {
	int node_a, node_b;
	float offset_a[3], offset_b[3]; /* the ends, in the nodes' frames */
	float radius;                   /* in the world's unit */
};

/* A capsule of one frame, in the world. */
struct capsule_world {
	float a[3], b[3];
	float radius;
};

/* Transforms count capsules by the nodes' world matrices. */
void capsule_to_world(const struct capsule *capsule, int count,
	const mat4 *world, struct capsule_world *out);

/*
 * Pushes a point that is nearer to the segment than radius + margin straight
 * out to that distance. A point on the segment itself goes out in a fixed
 * direction. Returns true if the point moved.
 */
bool capsule_push(
	const struct capsule_world *capsule, float margin, float point[3]);

/*
 * The same for count capsules, one after the other. Returns true if any of them
 * moved the point.
 */
bool capsule_push_all(const struct capsule_world *capsule, int count,
	float margin, float point[3]);

#endif
