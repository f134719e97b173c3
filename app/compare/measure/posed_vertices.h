/*
 * The posed vertices of an instance in world space, in the model's units: all
 * drawables in order, each with its primitive's vertices in the file's order.
 */
#ifndef APP_COMPARE_MEASURE_POSED_VERTICES_H
#define APP_COMPARE_MEASURE_POSED_VERTICES_H

#include "app/scene/instance/instance.h"

/* The number of vertices, or -1 when it exceeds an int. */
int posed_vertices_count(const struct instance *instance);

/* Writes [posed_vertices_count()] positions of the last instance_update(). */
void posed_vertices_positions(
	const struct instance *instance, float (*position)[3]);

/* Writes unit normals, and zeros for primitives without normals. */
void posed_vertices_normals(const struct instance *instance, float (*normal)[3]);

/*
 * The matrix that transforms normals of a node: the cofactors of its world
 * matrix, times the sign of its determinant, so that a mirrored surface still
 * faces outwards.
 */
void posed_vertices_normal_matrix(const vec4 *world, mat3 out);

#endif
