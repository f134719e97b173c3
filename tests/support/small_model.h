/*
 * Models made in memory, for tests of what comes after loading.
 */
#ifndef TESTS_SUPPORT_SMALL_MODEL_H
#define TESTS_SUPPORT_SMALL_MODEL_H

#include "app/scene/instance/instance.h"

/*
 * One node with one mesh: a grid of columns x rows quads in the plane z = 0,
 * from (0, 0) to (size, size), facing +Z. With normals or without. The caller
 * ends with model_destroy().
 */
struct model *small_model_grid(
	int columns, int rows, float size, bool with_normals);

/*
 * Gives a grid with normals a normal map of one row: texture coordinates run
 * from 0 to 1 along +X and from 1 to 0 along +Y, tangents along +X. The texels
 * are copied.
 */
void small_model_add_normal_map(
	struct model *model, int width, const uint8_t (*rgba)[4]);

/* A normal map of one texel that changes nothing. */
extern const uint8_t small_model_flat_map[1][4];

/* Its instance, computed in float. */
struct instance *small_model_instance(const struct model *model);

#endif
