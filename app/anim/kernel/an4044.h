/*
 * The vertex loops and the data layout of AN4044 (Freescale, "3D Animation
 * Techniques on the i.MX31 PDK"), which the other kernels are compared with.
 *
 * They need no C library. an4044_kernel.c makes a kernel of them.
 */
#ifndef APP_ANIM_KERNEL_AN4044_H
#define APP_ANIM_KERNEL_AN4044_H

#include "app/anim/skin.h"

struct an4044_vec4 {
	float x, y, z, w;
};

/* Example 1. */
struct an4044_vertex {
	struct an4044_vec4 position;
	struct an4044_vec4 normal;
	struct an4044_vec4 tangent;
};

/* Three rows of four. struct joint_weight has the offsets of matrices. */
struct an4044_joint_mat {
	float mat[12];
};

/*
 * Example 6, on the streams of skin.h. The last influence of a vertex has
 * next_vertex_offset == sizeof(struct joint_weight).
 */
void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const struct joint_weight *weight);

/*
 * The same with normals, and with normals and tangents, whose base vectors have
 * w = 0. They are not normalised.
 */
void an4044_transform_normals(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const struct joint_weight *weight);
void an4044_transform_tangents(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const float (*tangent)[4],
	const struct joint_weight *weight);

/* A vector of a three-dimensional object (section 1). */
typedef float an4044_vec3[3];

/* 1.2.1: temporal = destiny * omega + source * (1 - omega). */
void an4044_over_time(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, float omega, an4044_vec3 *temporal);

/* 1.2.5: temporal += height, the offset of the sinusoid. */
void an4044_add(int count, const float height[3], an4044_vec3 *temporal);

/* 1.2.2: temporal += (destiny - source) / frames, with the division. */
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
