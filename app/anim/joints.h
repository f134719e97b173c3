/*
 * The loops over joints: arm/ for ARM11 cores, portable/ for others; both
 * compute the same floats.
 */
#ifndef APP_ANIM_JOINTS_H
#define APP_ANIM_JOINTS_H

#include "app/model/model.h"

#include <stddef.h>

/* out[j] = local[j] as a matrix, as transform_to_matrix() makes it. */
void joints_to_matrices(const struct transform *local, int count, mat4 *out);

/*
 * out[j] = a[i] * b[j] for j from 0 to count - 1, where i is the int that lies
 * j * stride_bytes behind index. If i is below 0, out[j] is left alone. The
 * fourth row of all matrices is 0 0 0 1: it is written, and that of b is not
 * read. b may be out. a may overlap out, if each a[i] lies before its out[j]:
 * then later products use the results of earlier ones.
 */
void joints_multiply(const mat4 *a, const int *index, size_t stride_bytes,
	const mat4 *b, mat4 *out, int count);

#endif
