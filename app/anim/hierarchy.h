/*
 * Hierarchical animation: rigid parts on pivots (AN4044, section 2).
 *
 * A pivot has a position in its parent's frame, three angles (heading, pitch
 * and bank) and a scale. The walk visits the tree as the document's robot arm
 * does: push, translate, rotate in the pivot's order, draw, children, pop. So a
 * renderer needs only matrix-stack calls, and no vertex is transformed.
 */
#ifndef APP_ANIM_HIERARCHY_H
#define APP_ANIM_HIERARCHY_H

#include "platform/base/arena.h"

#include <cglm/types.h>

/* The document rotates its parts in different orders, the first one named
   outermost. */
enum hierarchy_order {
	HIERARCHY_HEADING_PITCH_BANK, /* arm */
	HIERARCHY_PITCH_HEADING_BANK, /* forearm */
	HIERARCHY_PITCH_BANK_HEADING, /* hand */
};

struct hierarchy_pivot {
	int parent; /* less than the pivot's own index, or -1 */
	int part;   /* for the visitor's draw(); -1: nothing to draw */
	enum hierarchy_order order;
	float position[3];
	float heading_rad; /* about +Y */
	float pitch_rad;   /* about +X */
	float bank_rad;    /* about +Z */
	float scale[3];
};

struct hierarchy {
	int pivot_count;
	struct hierarchy_pivot *pivot; /* parents before children */
};

/* What a walk calls at each step; every function is mandatory. */
struct hierarchy_visitor {
	void *user;
	void (*push)(void *user);
	void (*translate)(void *user, const float offset[3]);
	void (*rotate)(void *user, float angle_rad, const float axis[3]);
	void (*scale)(void *user, const float factor[3]);
	void (*draw)(void *user, int part);
	void (*pop)(void *user);
};

/* A pivot at its parent's origin: no rotation, scale 1, no part. */
struct hierarchy_pivot hierarchy_pivot_default(void);

/*
 * Walks the tree depth first, to HIERARCHY_DEPTH levels at most, the size of GL
 * ES 1.1's matrix stack less one. Rotations by 0 and scales of 1 are left out.
 */
void hierarchy_walk(const struct hierarchy *hierarchy,
	const struct hierarchy_visitor *visitor);

enum {
	HIERARCHY_DEPTH = 15
};

/* 0, or -EINVAL if a parent follows its child or the tree is too deep. */
int hierarchy_check(const struct hierarchy *hierarchy);

/* The matrices that the walk makes, for collision, tests and export. */
void hierarchy_world(const struct hierarchy *hierarchy, mat4 *world);

#endif
