/*
 * The vertex loops and the data layout of AN4044 (Freescale, "3D Animation
 * Techniques on the i.MX31 PDK"), which the other kernels are compared with.
 *
 * They call no function of the C library. an4044_kernel.c makes a kernel of
 * them.
 */
#ifndef APP_ANIM_KERNEL_AN4044_H
#define APP_ANIM_KERNEL_AN4044_H

#include "app/anim/skin.h"

struct an4044_vec4 {
	float x, y, z, w;
};

/* struct Vertex of AN4044's Example 1. */
struct an4044_vertex {
	struct an4044_vec4 position;
	struct an4044_vec4 normal;
	struct an4044_vec4 tangent;
};

/*
 * The first three rows of a joint's matrix, row after row.
 * joint_weight.joint_offset is the matrix's offset in bytes.
 */
struct an4044_joint_mat {
	float mat[12];
};

/*
 * Skins positions as Example 6 does, with the streams of skin.h. A vertex's
 * last influence is recognised by next_vertex_offset == sizeof(struct
 * joint_weight).
 */
void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const struct joint_weight *weight);

/*
 * The same with normals, and with normals and tangents. Their base vectors have
 * w = 0. The results are not normalised.
 */
void an4044_transform_normals(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const struct joint_weight *weight);
void an4044_transform_tangents(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const float (*tangent)[4],
	const struct joint_weight *weight);

/* The position or normal of a vertex (AN4044, section 1). */
typedef float an4044_vec3[3];

/* 1.2.1: temporal = destiny * omega + source * (1 - omega). */
void an4044_over_time(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, float omega, an4044_vec3 *temporal);

/* 1.2.5: temporal += height, where height is the offset of the sinusoid. */
void an4044_add(int count, const float height[3], an4044_vec3 *temporal);

/* 1.2.2: temporal += (destiny - source) / frames, divided anew in each call. */
void an4044_by_frames(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, int frames, an4044_vec3 *temporal);

/*
 * Two weighted targets, which the document does not show:
 * temporal = base + delta0 * weight0 + delta1 * weight1.
 */
void an4044_two_targets(int count, const an4044_vec3 *base,
	const an4044_vec3 *delta0, float weight0, const an4044_vec3 *delta1,
	float weight1, an4044_vec3 *temporal);

#endif
