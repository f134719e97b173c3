/*
 * Conversion from Direct3D's conventions to those of struct model.
 *
 * A .x file is left-handed (x right, y up, z away from the viewer) and its
 * matrices multiply row vectors: v' = v M. A model is right-handed (z towards
 * the viewer) with column vectors: v' = M v. With Z = diag(1, 1, -1):
 *
 *	points and normals     Z v
 *	matrices               Z transpose(M) Z
 *	triangles              corners in reverse order, because Z mirrors
 *
 * Below a frame that mirrors, triangles keep their order: glTF turns their
 * front sides there, and Direct3D does not.
 *
 * So a rotation about the axis (x, y, z) becomes one by the same angle about
 * (-x, -y, z). Rotation keys hold w x y z of the conjugate quaternion: the key
 * for D3DXMatrixRotationY(a) has y = -sin(a / 2). Both together, w x y z of the
 * file becomes (x, y, -z, w) of the model.
 */
#ifndef APP_MODEL_XFILE_XFILE_CONVERT_H
#define APP_MODEL_XFILE_XFILE_CONVERT_H

#include "app/model/model.h"

/* Converts a point, normal or translation. out may be in. */
void xfile_convert_vector(const float in[3], float out[3]);

/* Converts a row-major matrix; its last column is taken as 0 0 0 1. */
void xfile_convert_matrix(const float in[16], mat4 out);

/* Converts a rotation key to unit length; 0 becomes the identity. */
void xfile_convert_rotation(const float wxyz[4], float out[4]);

/*
 * Like transform_decompose(), with a tolerance for the six decimals of text
 * files: returns true if T R S equals the matrix to 1e-4 of its largest scale.
 */
bool xfile_decompose(const mat4 matrix, struct transform *out);

#endif
