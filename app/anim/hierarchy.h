/*
 * Hierarchical animation: rigid parts on pivots (AN4044, section 2).
 *
 * A pivot is a few variables: a position in its parent's frame, heading,
 * pitch and bank, a scale. The walk visits the tree as the document's robot
 * arm does (push, translate, rotate in the part's own order, draw, children,
 * pop), so that a renderer needs only matrix-stack calls and the technique
 * costs no vertex work at all.
 */
#ifndef APP_ANIM_HIERARCHY_H
#define APP_ANIM_HIERARCHY_H

#include "platform/base/arena.h"

#include <cglm/types.h>

/* The document turns its parts in different orders. First letter first. */
enum hierarchy_order {
	HIERARCHY_HEADING_PITCH_BANK, /* arm */
	HIERARCHY_PITCH_HEADING_BANK, /* forearm */
	HIERARCHY_PITCH_BANK_HEADING, /* hand */
};

struct hierarchy_pivot {
	int parent; /* below the pivot's own index, or -1 */
	int part;   /* what the visitor draws here; -1: nothing */
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

/* What a walk does at each step; every member is mandatory. */
struct hierarchy_visitor {
	void *user;
	void (*push)(void *user);
	void (*translate)(void *user, const float offset[3]);
	void (*rotate)(void *user, float angle_rad, const float axis[3]);
	void (*scale)(void *user, const float factor[3]);
	void (*draw)(void *user, int part);
	void (*pop)(void *user);
};

/* A pivot at its parent's origin: no turn, scale 1, no part. */
struct hierarchy_pivot hierarchy_pivot_default(void);

/*
 * Walks the tree depth first. Rotations by 0 and scales of 1 are left out.
 * At most HIERARCHY_DEPTH levels, the matrix stack that GL ES 1.1 grants.
 */
void hierarchy_walk(const struct hierarchy *hierarchy,
	const struct hierarchy_visitor *visitor);

enum {
	HIERARCHY_DEPTH = 15
};

/* 0, or -EINVAL when a parent does not come first or the tree is too deep. */
int hierarchy_check(const struct hierarchy *hierarchy);

/* The matrices that the walk amounts to, for collision, tests and export. */
void hierarchy_world(const struct hierarchy *hierarchy, mat4 *world);

#endif
