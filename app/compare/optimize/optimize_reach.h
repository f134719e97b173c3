/*
 * How far vertices move on the screen when a node moves.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_REACH_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_REACH_H

#include "app/compare/measure/screen_view.h"

/*
 * Pixels of the farthest vertex that follows a node, in the rest pose. A node
 * without vertices is taken to have one at a tenth of the model's size.
 */
struct optimize_reach_node {
	float move_px;  /* for a translation by 1 */
	float turn_px;  /* for a rotation by 1 radian */
	float scale_px; /* for a scale that changes by 1 */
	bool exact;     /* a camera follows it: its keys stay */
	int target_count;
	const float *target_px; /* [target_count], for a weight of 1 */
};

struct optimize_reach {
	struct arena arena;
	int node_count;
	struct optimize_reach_node *node; /* by the file's numbers */
};

/*
 * Measures the model in a view of px_per_unit pixels for a unit of the world.
 * Returns 0 or -ENOMEM; the caller calls optimize_reach_release() in either
 * case.
 */
int optimize_reach_find(struct optimize_reach *reach, const struct model *model,
	float px_per_unit);

void optimize_reach_release(struct optimize_reach *reach);

#endif
