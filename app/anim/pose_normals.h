/*
 * The matrices that transform the normals of skinned vertices.
 *
 * A joint with the same scale on all axes transforms normals as it transforms
 * positions, so the palette serves both. Below an uneven scale or a shear, a
 * normal needs the inverse transpose of the joint's matrix (GL ES 1.1
 * specification, 2.10.3) and the skin gets a second palette. Which it is
 * depends on the pose and is found anew for each.
 *
 * Skinning blends these matrices by the vertex's weights, as Khronos' sample
 * viewer does. That is exact for vertices with one influence. The inverse
 * transpose of a blend of matrices is not the blend of theirs, but nearly.
 */
#ifndef APP_ANIM_POSE_NORMALS_H
#define APP_ANIM_POSE_NORMALS_H

#include "app/anim/pose.h"

struct pose_normals {
	bool *uneven; /* [node_count]: in the last pose, or an ancestor is */
	bool *uneven_bind; /* [skin_count]: an inverse bind matrix is */
	bool always;       /* some skin has such a matrix */
	mat4 **palette;    /* [skin_count][joint_count] */
};

/* For poses of the model. The arena owns the arrays. 0 or -ENOMEM. */
int pose_normals_init(struct pose_normals *normals, const struct model *model,
	struct arena *arena);

/*
 * Finds the joints of the pose whose scale is uneven by more than 1 in 256, or
 * that have such an ancestor. Returns false if there are none in any skin, when
 * all palettes serve normals, too.
 */
bool pose_normals_find(struct pose_normals *normals, const struct pose *pose);

/*
 * After pose_normals_find() has returned true: returns the matrices for normals
 * for the skin's palette. That is the palette itself, or joint_count matrices
 * that the next call for the skin overwrites.
 */
const mat4 *pose_normals_palette(struct pose_normals *normals,
	const struct model *model, int skin, const mat4 *palette);

#endif
