/*
 * A frame's joint matrices in 16 bits.
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_PALETTE_H
#define APP_ANIM_KERNEL_RUN_FIXED_PALETTE_H

#include "app/anim/kernel/layout/fixed_skin.h"

/*
 * Converts the float palette of the model's skin into
 * matrix[skin->joint_count], and says in placement what the loops' positions
 * mean: they are in the unit of the palette. The palette may be in any unit and
 * be multiplied by another matrix from the left, a model-view matrix for
 * example.
 *
 * 0, or -ERANGE if the palette has infinities or NaNs, or a scale that no
 * exponent brings into 16 bits; then the output may not be used.
 */
int fixed_palette_make(const struct fixed_skin *skin, const mat4 *palette,
	struct fixed_matrix *matrix, struct fixed_placement *placement);

/*
 * The same for normals that have matrices of their own (pose_normals.h), with
 * the placement of the positions.
 */
void fixed_palette_make_normals(const struct fixed_skin *skin,
	const struct fixed_placement *placement, const mat4 *palette,
	struct fixed_matrix *matrix);

#endif
