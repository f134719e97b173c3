/*
 * Decomposition of a matrix into translation, rotation and scale.
 */
#ifndef APP_MODEL_TRANSFORM_DECOMPOSE_H
#define APP_MODEL_TRANSFORM_DECOMPOSE_H

#include "app/model/model.h"

/*
 * Finds translation, rotation and scale of an affine matrix,
 * matrix[column][row], by Gram-Schmidt from its longest column. A mirroring
 * matrix gets a negative x scale. The rotation has unit length. Returns true if
 * T R S equals the matrix to 1e-5 of its largest element; false means that the
 * matrix shears.
 */
bool transform_decompose(const float matrix[4][4], struct transform *out);

#endif
