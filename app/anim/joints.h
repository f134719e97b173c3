/*
 * The loops over joints that a core may have in its own way: arm/joints.S,
 * else portable/joints.c (toolchain/sources.mk says which). Both compute the
 * same floats.
 */
#ifndef APP_ANIM_JOINTS_H
#define APP_ANIM_JOINTS_H

#include "app/model/model.h"

#include <stddef.h>

/* out[j] = the matrix of local[j], as transform_to_matrix() makes it. */
void joints_to_matrices(const struct transform *local, int count, mat4 *out);

/*
 * out[j] = a[index of j] * b[j] for count matrices whose fourth row is 0 0 0 1;
 * that row is written, and of b not read. An index below 0 leaves out[j] alone.
 * Indices are ints, stride_bytes apart. In order: a may be out, where later
 * ones want what became of earlier ones; b may be out.
 */
void joints_multiply(const mat4 *a, const int *index, size_t stride_bytes,
	const mat4 *b, mat4 *out, int count);

#endif
