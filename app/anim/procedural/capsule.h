/*
 * Capsules on a skeleton: what hair and cloth may not enter.
 *
 * A capsule is all within radius of the line from one point to another, each
 * fixed to a node. With both points the same it is a sphere.
 */
#ifndef APP_ANIM_PROCEDURAL_CAPSULE_H
#define APP_ANIM_PROCEDURAL_CAPSULE_H

#include "app/anim/pose.h"

struct capsule {
	int node_a, node_b;
	float offset_a[3], offset_b[3]; /* in the nodes' own frames */
	float radius;                   /* in the world's unit */
};

/* Where it is in a frame. */
struct capsule_world {
	float a[3], b[3];
	float radius;
};

/* Puts count capsules at the nodes' places. */
void capsule_to_world(const struct capsule *capsule, int count,
	const mat4 *world, struct capsule_world *place);

/*
 * Pushes a point that is nearer than radius + margin straight out to that
 * distance. One on the line itself goes out in a fixed direction. True when
 * it moved.
 */
bool capsule_push(
	const struct capsule_world *place, float margin, float point[3]);

/* The same against count of them, one after the other. */
bool capsule_push_all(const struct capsule_world *place, int count,
	float margin, float point[3]);

#endif
