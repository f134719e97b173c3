/*
 * Instances into GL calls.
 *
 * The model-view matrix is the camera's (or a parent's) when these are called;
 * lights are set. Client arrays and material state are left as they come, so
 * each call sets all it needs.
 */
#ifndef APP_SCENE_DRAW_DRAW_H
#define APP_SCENE_DRAW_DRAW_H

#include "app/anim/hierarchy.h"
#include "app/scene/draw/texture.h"
#include "app/scene/instance/instance.h"

enum draw_pass {
	DRAW_SHADED, /* materials, textures, light */
	DRAW_SHADOW, /* positions only, in the current colour */
};

/*
 * All drawables that are not hidden: opaque ones, then blended ones. Normal
 * maps show where instance.normal_mapping and texture_set.normal_mapping say
 * so; they are lit in world space, so the model-view matrix has to be the
 * camera's for them. Surfaces with relief leave the depth function at GL_LESS.
 */
void draw_instance(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, enum draw_pass pass);

/*
 * What one node shows, in the current model-view matrix as it is; without
 * relief, as is draw_hierarchy().
 */
void draw_node(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, int node, enum draw_pass pass);

/*
 * Walks the pivots with matrix-stack calls, as AN4044 section 2 does. A
 * pivot's part is a node of the instance.
 */
void draw_hierarchy(const struct gl *gl, const struct hierarchy *hierarchy,
	const struct instance *instance, const struct texture_set *textures,
	enum draw_pass pass);

#endif
