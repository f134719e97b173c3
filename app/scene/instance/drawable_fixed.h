/*
 * A drawable's vertices in fixed point: between the instance and the kernels.
 */
#ifndef APP_SCENE_INSTANCE_DRAWABLE_FIXED_H
#define APP_SCENE_INSTANCE_DRAWABLE_FIXED_H

#include "app/scene/instance/instance.h"

/*
 * Makes a drawable that has its skin, morphed and primitive fixed, with
 * tangents where it has relief. 0; -ENOMEM; -ERANGE for what 16 bits cannot
 * hold: it wants float.
 */
int drawable_fixed_init(struct drawable *drawable, const struct model *model,
	const struct fixed_loops *loops, struct arena *arena);

/* The output for the instance's pose, whose matrices are there. */
void drawable_fixed_pose(
	const struct instance *instance, struct drawable *drawable);

#endif
