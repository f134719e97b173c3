/*
 * A matrix as translation, rotation and scale.
 */
#ifndef APP_MODEL_TRANSFORM_DECOMPOSE_H
#define APP_MODEL_TRANSFORM_DECOMPOSE_H

#include "app/model/model.h"

/*
 * The T R S whose product comes nearest to an affine matrix of four columns;
 * a mirrored one gets a negative x scale, the rotation always has unit length.
 * Returns whether the product is the matrix, to 1e-5 of its largest factor;
 * false means that the matrix shears.
 */
bool transform_decompose(const float matrix[4][4], struct transform *out);

#endif
