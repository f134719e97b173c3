/*
 * The matrices that transform the normals of skinned vertices.
 *
 * A joint with the same scale on all axes transforms normals as it transforms
 * positions, so the palette serves both. If the joint or an ancestor has an
 * uneven scale or a shear, normals need the inverse transpose of the joint's
 * matrix (GL ES 1.1 specification, 2.10.3), and the skin gets a second palette.
 * This depends on the pose, so each pose is searched.
 *
 * Skinning blends these matrices by the vertex's weights, as Khronos' sample
 * viewer does. That is exact for vertices with one influence. The inverse
 * transpose of a blend of matrices is not the blend of theirs, but nearly.
 */
#ifndef APP_ANIM_POSE_NORMALS_H
#define APP_ANIM_POSE_NORMALS_H

#include "app/anim/pose.h"

struct pose_normals {
	bool *uneven;      /* [node_count]: whether the node or an ancestor has
			      uneven scale or shear in the last pose */
	bool *uneven_bind; /* [skin_count]: whether a joint's inverse bind
			      matrix has uneven scale or shear */
	bool always;       /* whether uneven_bind is true for any skin */
	mat4 **palette;    /* [skin_count][joint_count] */
};

/* Makes arrays for poses of the model, in the arena. Returns 0 or -ENOMEM. */
int pose_normals_init(struct pose_normals *normals, const struct model *model,
	struct arena *arena);

/*
 * Finds the nodes of the pose that are sheared or whose scale is uneven by more
 * than about 1 in 256, and their descendants. Returns false if there are none
 * and no inverse bind matrix is uneven: then all palettes serve normals too.
 */
bool pose_normals_find(struct pose_normals *normals, const struct pose *pose);

/*
 * Returns the matrices that transform the skin's normals, after
 * pose_normals_find() has returned true. They are the palette itself, or
 * joint_count matrices that the next call for the same skin overwrites.
 */
const mat4 *pose_normals_palette(struct pose_normals *normals,
	const struct model *model, int skin, const mat4 *palette);

#endif
