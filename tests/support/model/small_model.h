/*
 * Builds models in memory, for tests of what happens after loading.
 */
#ifndef TESTS_SUPPORT_MODEL_SMALL_MODEL_H
#define TESTS_SUPPORT_MODEL_SMALL_MODEL_H

#include "app/scene/instance/instance.h"

/*
 * A model of one node with one mesh: a grid of columns x rows quads in the
 * plane z = 0, from (0, 0) to (size, size), that faces +Z. The caller ends with
 * model_destroy().
 */
struct model *small_model_grid(
	int columns, int rows, float size, bool with_normals);

/*
 * Gives a grid with normals a normal map of one row of texels, which are
 * copied. Texture coordinates run from 0 to 1 along +X and from 1 to 0 along
 * +Y; the tangents point along +X.
 */
void small_model_add_normal_map(
	struct model *model, int width, const uint8_t (*rgba)[4]);

/* A normal map of one texel that leaves normals as they are. */
extern const uint8_t small_model_flat_map[1][4];

/* Creates an instance of the model that the float kernel updates. */
struct instance *small_model_instance(const struct model *model);

/* Moves a grid of size 1 over the whole picture of an identity camera. */
void small_model_fill_picture(struct instance *instance);

/* Sets the direction to the light of bump mapping and updates the instance. */
void small_model_light_from(
	struct instance *instance, float x, float y, float z);

#endif
