#include "app/anim/kernel/an4044.h"

typedef struct an4044_vec4 vector;

static inline float row(const float m[4], const float v[4])
{
	return m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3] * v[3];
}

static inline void multiply(
	vector *result, const struct an4044_joint_mat *m, const float v[4])
{
	result->x = row(&m->mat[0], v);
	result->y = row(&m->mat[4], v);
	result->z = row(&m->mat[8], v);
}

static inline void multiply_add(
	vector *result, const struct an4044_joint_mat *m, const float v[4])
{
	result->x += row(&m->mat[0], v);
	result->y += row(&m->mat[4], v);
	result->z += row(&m->mat[8], v);
}

static inline const struct an4044_joint_mat *matrix(
	const struct an4044_joint_mat *joint, int32_t offset)
{
	return (const struct an4044_joint_mat *)((const char *)joint + offset);
}

static inline void store(vector *to, const vector *from)
{
	to->x = from->x;
	to->y = from->y;
	to->z = from->z;
}

/*
 * attributes is a constant in each caller, so that the compiler makes a loop
 * for each number of them: 1 position, 2 and normal, 3 and tangent.
 */
static inline void transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*const base[3])[4],
	const struct joint_weight *weight, int attributes)
{
	for (int i = 0, j = 0; i < vertex_count; i++, j++) {
		const struct an4044_joint_mat *m =
			matrix(joint, weight[j].joint_offset);
		vector v[3];

		for (int k = 0; k < attributes; k++) {
			multiply(&v[k], m, base[k][j]);
		}
		while (weight[j].next_vertex_offset != (int32_t)sizeof(*weight)) {
			j++;
			m = matrix(joint, weight[j].joint_offset);
			for (int k = 0; k < attributes; k++) {
				multiply_add(&v[k], m, base[k][j]);
			}
		}
		store(&vertex[i].position, &v[0]);
		if (attributes > 1) {
			store(&vertex[i].normal, &v[1]);
		}
		if (attributes > 2) {
			store(&vertex[i].tangent, &v[2]);
		}
	}
}

void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const struct joint_weight *weight)
{
	const float(*const bases[3])[4] = {base};

	transform(vertex, vertex_count, joint, bases, weight, 1);
}

void an4044_transform_normals(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const struct joint_weight *weight)
{
	const float(*const bases[3])[4] = {base, normal};

	transform(vertex, vertex_count, joint, bases, weight, 2);
}

void an4044_transform_tangents(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const float (*tangent)[4],
	const struct joint_weight *weight)
{
	const float(*const bases[3])[4] = {base, normal, tangent};

	transform(vertex, vertex_count, joint, bases, weight, 3);
}

void an4044_over_time(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, float omega, an4044_vec3 *temporal)
{
	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			temporal[i][k] = destiny[i][k] * omega +
				source[i][k] * (1 - omega);
		}
	}
}

void an4044_add(int count, const float height[3], an4044_vec3 *temporal)
{
	for (int i = 0; i < count; i++) {
		temporal[i][0] += height[0];
		temporal[i][1] += height[1];
		temporal[i][2] += height[2];
	}
}

void an4044_by_frames(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, int frames, an4044_vec3 *temporal)
{
	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			temporal[i][k] +=
				(destiny[i][k] - source[i][k]) / (float)frames;
		}
	}
}

void an4044_two_targets(int count, const an4044_vec3 *base,
	const an4044_vec3 *delta0, float weight0, const an4044_vec3 *delta1,
	float weight1, an4044_vec3 *temporal)
{
	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			temporal[i][k] = base[i][k] + delta0[i][k] * weight0 +
				delta1[i][k] * weight1;
		}
	}
}
