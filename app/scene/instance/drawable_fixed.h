/*
 * Poses a drawable's vertices in fixed point: it prepares the input of the
 * fixed-point kernels and runs them.
 */
#ifndef APP_SCENE_INSTANCE_DRAWABLE_FIXED_H
#define APP_SCENE_INSTANCE_DRAWABLE_FIXED_H

#include "app/scene/instance/instance_data.h"

/*
 * Creates drawable->fixed. The drawable's members node, skin, morphed and
 * primitive must be set. A bump-mapped primitive gets tangents. in_tiers lets a
 * skin be posed as far as a level of detail needs it (fixed_skin.h). Returns 0,
 * -ENOMEM, or -ERANGE when 16 bits cannot represent the positions; the drawable
 * then needs float.
 */
int drawable_fixed_init(struct drawable *drawable, const struct model *model,
	const struct fixed_loops *loops, bool in_tiers, struct arena *arena);

/*
 * Computes the drawable's output from the instance's pose, world matrices and
 * palettes. Sets fixed->overflowed, and leaves the output as it was, when the
 * pose does not fit 16 bits.
 */
void drawable_fixed_pose(
	const struct instance *instance, struct drawable *drawable);

#endif
