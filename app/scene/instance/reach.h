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
	int skin, number;  /* instance->palette[skin][number] */
	struct bounds box; /* in the mesh's units, as bound */
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
 * Returns the box after the last update along the axes of a view, an affine
 * matrix from scene units. Targets that push a vertex together may move it
 * beyond the box; hidden drawables without a skin do not count.
 */
struct bounds reach_now(const struct reach *reach,
	const struct instance *instance, const vec4 *view);

#endif
