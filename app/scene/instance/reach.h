/*
 * A box around an instance as it is posed, found without its vertices.
 *
 * When it is made, each joint gets a box around the vertices that it influences.
 * A posed vertex is a mean of where its joints take it, so the boxes that the
 * joints have moved contain it. A frame costs about 200 instructions a joint.
 */
#ifndef APP_SCENE_INSTANCE_REACH_H
#define APP_SCENE_INSTANCE_REACH_H

#include "app/scene/instance/bounds.h"

struct reach_joint {
	int skin, number; /* instance->palette[skin][number] */
	/* around the joint's vertices in the mesh, in its units */
	struct bounds box;
};

struct reach {
	int joint_count;
	struct reach_joint *joint; /* in the instance's arena */
};

/*
 * Measures the skinned drawables, with and without each morph target at its
 * full weight. Returns 0 or -ENOMEM.
 */
int reach_init(struct reach *reach, struct instance *instance);

/*
 * Returns the box around the instance's last update along the axes of a view,
 * an affine matrix from scene units to that view. Several morph targets that
 * push a vertex the same way may move it beyond the box. Hidden drawables
 * without a skin are left out.
 */
struct bounds reach_now(const struct reach *reach,
	const struct instance *instance, const vec4 *view);

#endif
