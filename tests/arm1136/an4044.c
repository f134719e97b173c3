#include "tests/arm1136/an4044.h"

typedef struct an4044_vec4 vec4;

static inline float row(const float m[4], const vec4 *v)
{
	return m[0] * v->x + m[1] * v->y + m[2] * v->z + m[3] * v->w;
}

static inline void multiply(
	vec4 *result, const struct an4044_joint_mat *m, const vec4 *v)
{
	result->x = row(&m->mat[0], v);
	result->y = row(&m->mat[4], v);
	result->z = row(&m->mat[8], v);
}

static inline void multiply_add(
	vec4 *result, const struct an4044_joint_mat *m, const vec4 *v)
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

void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const vec4 *base,
	const struct an4044_joint_weight *weight)
{
	for (int i = 0, j = 0; i < vertex_count; i++, j++) {
		vec4 v;

		multiply(&v, matrix(joint, weight[j].joint_mat_offset),
			&base[j]);
		while (weight[j].next_vertex_offset != (int32_t)sizeof(*weight)) {
			j++;
			multiply_add(&v,
				matrix(joint, weight[j].joint_mat_offset),
				&base[j]);
		}
		vertex[i].position.x = v.x;
		vertex[i].position.y = v.y;
		vertex[i].position.z = v.z;
	}
}
