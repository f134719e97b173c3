#include "app/compare/measure/posed_vertices.h"

#include "platform/base/count.h"
#include "platform/base/scalar.h"

#include <string.h>

#include <cglm/cglm.h>

int posed_vertices_count(const struct instance *instance)
{
	int count = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		if (!count_add(count,
			    instance->drawable[i].primitive->vertex_count,
			    &count)) {
			return -1;
		}
	}
	return count;
}

/* Maps the drawable's posed positions to world space: side * x + origin. */
static void world_from_drawable(const struct instance *instance,
	const struct drawable *drawable, mat3 side, vec3 origin)
{
	const vec4 *world = instance->world[drawable->node];

	for (int column = 0; column < 3; column++) {
		for (int axis = 0; axis < 3; axis++) {
			side[column][axis] = drawable->skin < 0
				? world[column][axis] / drawable->vertex_scale
				: column == axis ? 1.0f / instance->unit_scale
						 : 0.0f;
		}
	}
	for (int axis = 0; axis < 3; axis++) {
		origin[axis] = drawable->skin < 0 ? world[3][axis] : 0.0f;
	}
}

static inline void transform(
	const mat3 side, const vec3 origin, const float from[3], float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = side[0][axis] * from[0] + side[1][axis] * from[1] +
			side[2][axis] * from[2] + origin[axis];
	}
}

static void write_fixed(const struct drawable_fixed *fixed, int count,
	mat3 side, vec3 origin, float (*position)[3])
{
	const struct fixed_placement *placement = &fixed->placement;
	vec3 moved;

	transform((const vec3 *)side, origin, placement->offset, moved);
	for (int column = 0; column < 3; column++) {
		glm_vec3_scale(side[column], placement->scale, side[column]);
	}
	for (int i = 0; i < count; i++) {
		const struct fixed_vector *v = &fixed->position[i];
		float from[3] = {v->x, v->y, v->z};

		transform((const vec3 *)side, moved, from,
			position[fixed->order ? fixed->order[i] : (uint32_t)i]);
	}
}

static void write_skinned(const struct drawable *drawable, int count,
	float scale, float (*position)[3])
{
	for (int v = 0; v < count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			position[v][axis] = scale * drawable->position[v][axis];
		}
	}
}

static void write_moved(const struct drawable *drawable, int count, mat3 side,
	vec3 origin, float (*position)[3])
{
	for (int v = 0; v < count; v++) {
		transform((const vec3 *)side, origin, drawable->position[v],
			position[v]);
	}
}

void posed_vertices_positions(
	const struct instance *instance, float (*position)[3])
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		int count = drawable->primitive->vertex_count;
		mat3 side;
		vec3 origin;

		world_from_drawable(instance, drawable, side, origin);
		if (drawable->fixed) {
			write_fixed(
				drawable->fixed, count, side, origin, position);
		} else if (drawable->skin >= 0) {
			write_skinned(drawable, count, side[0][0], position);
		} else {
			write_moved(drawable, count, side, origin, position);
		}
		position += count;
	}
}

static void normalize(float v[3])
{
	float length = scalar_sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
	float scale = length > 0.0f ? 1.0f / length : 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		v[axis] *= scale;
	}
}

/*
 * Reads a posed normal: in model space if skinned, else in the node's space.
 * Returns false if the drawable has no normals.
 */
static bool posed_normal(
	const struct drawable *drawable, int vertex, float out[3])
{
	const struct drawable_fixed *fixed = drawable->fixed;
	const struct fixed_vector *normal;

	if (!fixed) {
		if (drawable->normal) {
			memcpy(out, drawable->normal[vertex], sizeof(float[3]));
		}
		return drawable->normal != NULL;
	}
	if (!fixed->normal) {
		return false;
	}
	normal =
		&fixed->normal[fixed->inverse_order ? fixed->inverse_order[vertex]
						    : (uint32_t)vertex];
	out[0] = (float)normal->x;
	out[1] = (float)normal->y;
	out[2] = (float)normal->z;
	return true;
}

void posed_vertices_normal_matrix(const vec4 *world, mat3 out)
{
	glm_vec3_cross((float *)world[1], (float *)world[2], out[0]);
	glm_vec3_cross((float *)world[2], (float *)world[0], out[1]);
	glm_vec3_cross((float *)world[0], (float *)world[1], out[2]);
	if (glm_vec3_dot((float *)world[0], out[0]) < 0.0f) {
		glm_mat3_scale(out, -1.0f);
	}
}

static void write_skinned_normals(
	const struct drawable *drawable, int count, float (*normal)[3])
{
	memcpy(normal, drawable->normal, (size_t)count * sizeof(float[3]));
	for (int v = 0; v < count; v++) {
		normalize(normal[v]);
	}
}

static void write_normals(const struct instance *instance,
	const struct drawable *drawable, float (*normal)[3])
{
	int count = drawable->primitive->vertex_count;
	mat3 turn;

	if (drawable->skin >= 0 && !drawable->fixed && drawable->normal) {
		write_skinned_normals(drawable, count, normal);
		return;
	}
	posed_vertices_normal_matrix(instance->world[drawable->node], turn);
	for (int v = 0; v < count; v++) {
		float from[3];

		if (!posed_normal(drawable, v, from)) {
			memset(normal[v], 0, sizeof(float[3]));
			continue;
		}
		for (int axis = 0; axis < 3; axis++) {
			normal[v][axis] = drawable->skin >= 0
				? from[axis]
				: turn[0][axis] * from[0] +
					turn[1][axis] * from[1] +
					turn[2][axis] * from[2];
		}
		normalize(normal[v]);
	}
}

void posed_vertices_normals(const struct instance *instance, float (*normal)[3])
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		write_normals(instance, drawable, normal);
		normal += drawable->primitive->vertex_count;
	}
}
