/*
 * The influence cap: how many joints may move a vertex.
 *
 * AN4044 section 3.1 caps them through the next-vertex offset, and assumes a
 * weight of one for what is left; the kernels do that (max_influences). Here
 * is chosen how many, by how large the figure is on the screen or by what a
 * frame may cost.
 */
#ifndef APP_SCENE_INSTANCE_INFLUENCE_CAP_H
#define APP_SCENE_INSTANCE_INFLUENCE_CAP_H

#include "app/scene/stage/camera.h"

enum influence_cap_kind {
	INFLUENCE_CAP_FIXED,    /* value influences; 0: all */
	INFLUENCE_CAP_DISTANCE, /* fewer where the figure is small */
	INFLUENCE_CAP_BUDGET, /* at most value influences a frame, all vertices */
};

struct influence_cap {
	enum influence_cap_kind kind;
	int value;
};

/*
 * Reads "1".."8", "auto" (by distance) or "budget:N" (N from 1 to 100 million).
 * False for anything else.
 */
bool influence_cap_parse(const char *text, struct influence_cap *out);

/* The cap for a figure that many pixels high; 0: all influences. */
int influence_cap_for_height(float height_px);

/* Influences that a frame of this instance takes under a cap (0: none). */
long influence_cap_cost(const struct instance *instance, int max_influences);

/*
 * What instance.max_influences should be. extent is the figure's height, which
 * like camera and picture height only counts for INFLUENCE_CAP_DISTANCE.
 */
int influence_cap_choose(const struct influence_cap *cap,
	const struct instance *instance, const struct camera *camera,
	float extent, int picture_height);

#endif
