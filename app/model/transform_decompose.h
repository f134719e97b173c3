/*
 * Decomposition of a matrix into translation, rotation and scale.
 */
#ifndef APP_MODEL_TRANSFORM_DECOMPOSE_H
#define APP_MODEL_TRANSFORM_DECOMPOSE_H

#include "app/model/model.h"

/*
 * Finds T R S for an affine matrix of four columns, by Gram-Schmidt from its
 * longest column. A mirroring matrix gets a negative x scale; the rotation has
 * unit length. Returns whether T R S equals the matrix to 1e-5 of its largest
 * element; false means that the matrix shears.
 */
bool transform_decompose(const float matrix[4][4], struct transform *out);

#endif
