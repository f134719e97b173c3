/* Conversion of a frame's joint matrices to 16 bits. */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_PALETTE_H
#define APP_ANIM_KERNEL_RUN_FIXED_PALETTE_H

#include "app/anim/kernel/layout/fixed_skin.h"

/*
 * Converts the float palette of the model's skin into
 * matrix[skin->joint_count], and sets placement, which converts the loops'
 * positions to floats in the unit of the palette. The palette may be in any
 * unit and be multiplied by another matrix from the left, a model-view matrix
 * for example.
 *
 * Returns 0, or -ERANGE if the palette has infinities or NaNs or too large a
 * scale; then the output must not be used.
 */
int fixed_palette_make(const struct fixed_skin *skin, const mat4 *palette,
	struct fixed_matrix *matrix, struct fixed_placement *placement);

/*
 * Converts the matrices for normals (pose_normals.h) after fixed_palette_make()
 * has set placement for the positions.
 */
void fixed_palette_make_normals(const struct fixed_skin *skin,
	const struct fixed_placement *placement, const mat4 *palette,
	struct fixed_matrix *matrix);

#endif
