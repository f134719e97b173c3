/*
 * From Direct3D's conventions to limber's.
 *
 * A .x file is left-handed (x right, y up, z away from the viewer) and its
 * matrices multiply row vectors: v' = v M. A model is right-handed (z towards
 * the viewer) with column vectors: v' = M v. With Z = diag(1, 1, -1):
 *
 *	points and normals     Z v
 *	matrices               Z transpose(M) Z
 *	triangles              corners in reverse order, since Z mirrors
 *
 * A rotation by an angle about an axis (x, y, z) turns into one by the same
 * angle about (-x, -y, z). Rotation keys hold w x y z of the conjugate: the
 * rotation that D3DXMatrixRotationY(a) gives has y = -sin(a / 2). Both changes
 * of sign together make x y z w of the model from w x y z of the file as
 * (x, y, -z, w).
 */
#ifndef APP_MODEL_XFILE_XFILE_CONVERT_H
#define APP_MODEL_XFILE_XFILE_CONVERT_H

#include "app/model/model.h"

/* A point, normal or translation; out may be in. */
void xfile_convert_vector(const float in[3], float out[3]);

/* Sixteen numbers in the file's order; the last column counts as 0 0 0 1. */
void xfile_convert_matrix(const float in[16], mat4 out);

/* A rotation key; the result has unit length, a zero key is no rotation. */
void xfile_convert_rotation(const float wxyz[4], float out[4]);

/*
 * transform_decompose() with room for the few decimals of text files: true
 * where T R S give the matrix to 1e-4 of its largest factor.
 */
bool xfile_decompose(const mat4 matrix, struct transform *out);

#endif
