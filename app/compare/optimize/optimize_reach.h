/*
 * Estimates how far vertices move on the screen when a node moves.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_REACH_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_REACH_H

#include "app/compare/measure/screen_view.h"
#include "app/compare/optimize/optimize.h"

/*
 * How many pixels the farthest vertex that follows a node moves, in the rest
 * pose. Its distance from the node counts as at least a tenth of the model's
 * size, also for nodes without vertices.
 */
struct optimize_reach_node {
	float move_px;  /* for a translation by one unit */
	float turn_px;  /* for a rotation by 1 radian */
	float scale_px; /* for a scale that changes by 1 */
	bool exact;     /* above a camera, or not loaded: keeps its keys */
	bool idle;      /* nothing that anyone sees or names depends on it */
	bool moved;     /* by a clip; set by optimize_reach_idle() */
	int target_count;
	const float *target_px; /* [target_count], for a weight of 1 */
};

struct optimize_reach {
	struct arena arena;
	int node_count;
	struct optimize_reach_node *node; /* [node_count], by index in the file */
};

/*
 * Measures the model in a view in which a unit of world space covers
 * px_per_unit pixels. Nodes that move no vertex are idle, unless they or nodes
 * below them are needed, [the file's nodes], which may be NULL. Returns 0 or
 * -ENOMEM; the caller calls optimize_reach_release() in either case.
 */
int optimize_reach_find(struct optimize_reach *reach, const struct model *model,
	float px_per_unit, const bool *needed);

/* Finds the idle nodes that clips of the model move. */
struct optimize_idle optimize_reach_idle(
	struct optimize_reach *reach, const struct model *model);

void optimize_reach_release(struct optimize_reach *reach);

#endif
