/*
 * Matrix palette skinning as AN4044 describes it, data layout and loop: the
 * yardstick for the kernels of app/anim. Examples 1 to 6 of the document.
 */
#ifndef TESTS_ARM1136_AN4044_H
#define TESTS_ARM1136_AN4044_H

#include <stdint.h>

struct an4044_vec4 {
	float x, y, z, w;
};

/* Example 1. */
struct an4044_vertex {
	struct an4044_vec4 position;
	struct an4044_vec4 normal;
	struct an4044_vec4 tangent;
};

/* Example 3; offsets in bytes. */
struct an4044_joint_weight {
	float weight;
	int32_t joint_mat_offset;
	int32_t next_vertex_offset;
};

/* Three rows of four. */
struct an4044_joint_mat {
	float mat[12];
};

/*
 * Example 6. A base vector for each weight, already multiplied by it; the last
 * weight of a vertex has next_vertex_offset == sizeof(struct
 * an4044_joint_weight).
 */
void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const struct an4044_vec4 *base,
	const struct an4044_joint_weight *weight);

#endif
