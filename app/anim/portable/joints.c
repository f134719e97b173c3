#include "app/anim/joints.h"

#include "app/anim/math/transform_inline.h"

void joints_to_matrices(const struct transform *local, int count, mat4 *out)
{
	for (int j = 0; j < count; j++) {
		inline_transform_to_matrix(&local[j], out[j]);
	}
}

void joints_multiply(const mat4 *a, const int *index, size_t stride_bytes,
	const mat4 *b, mat4 *out, int count)
{
	const char *at = (const char *)index;

	for (int j = 0; j < count; j++, at += stride_bytes) {
		int i = *(const int *)at;

		if (i >= 0) {
			inline_matrix_multiply(
				((mat4 *)a)[i], ((mat4 *)b)[j], out[j]);
		}
	}
}
