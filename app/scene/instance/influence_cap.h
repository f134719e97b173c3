/*
 * The influence cap: the greatest number of joints that may move a vertex.
 *
 * AN4044 section 3.1 caps influences through the next-vertex offset and takes
 * the remaining weight as one; the kernels do the same with max_influences.
 * This module chooses the cap by the figure's height on the screen or by a
 * budget for the frame.
 */
#ifndef APP_SCENE_INSTANCE_INFLUENCE_CAP_H
#define APP_SCENE_INSTANCE_INFLUENCE_CAP_H

#include "app/scene/stage/camera.h"

enum influence_cap_kind {
	/* at most value influences a vertex; 0 means all */
	INFLUENCE_CAP_FIXED,
	INFLUENCE_CAP_DISTANCE, /* fewer for figures that appear small */
	/* at most value influences, summed over all vertices */
	INFLUENCE_CAP_BUDGET,
};

struct influence_cap {
	enum influence_cap_kind kind;
	int value;
};

/*
 * Parses "1".."8", "auto" (by distance) or "budget:N" (N from 1 to 100
 * million). Returns false for anything else.
 */
bool influence_cap_parse(const char *text, struct influence_cap *out);

/* Returns the cap for a figure of this height in pixels; 0 means all. */
int influence_cap_for_height(float height_px);

/*
 * Returns the number of influences of all visible vertices under a cap; 0 means
 * no cap.
 */
long influence_cap_cost(const struct instance *instance, int max_influences);

/*
 * Returns the value for instance.max_influences. extent is the figure's height
 * in scene units; extent, the camera and the picture's height are used only for
 * INFLUENCE_CAP_DISTANCE.
 */
int influence_cap_choose(const struct influence_cap *cap,
	const struct instance *instance, const struct camera *camera,
	float extent, int picture_height);

#endif
