/*
 * Draws instances through GL ES 1.1.
 *
 * The caller has loaded the model-view matrix (the camera's, or a parent's) and
 * the lights. Each call sets the client arrays and the material state that it
 * needs and does not restore them.
 */
#ifndef APP_SCENE_DRAW_DRAW_H
#define APP_SCENE_DRAW_DRAW_H

#include "app/scene/draw/texture.h"
#include "app/scene/instance/instance.h"

/* The alpha of shadows, 0..1: how much of what lies below they hide. */
#define DRAW_SHADOW_ALPHA 0.375f

enum draw_pass {
	DRAW_SHADED, /* with materials, textures and light */
	DRAW_SHADOW, /* the list for shadows in the current colour, which is
			that of draw_set_shadow_color(DRAW_SHADOW_ALPHA) */
	DRAW_EDGES,  /* the shaded triangles' edges in the current colour */
};

/*
 * Draws every drawable that is not hidden, first the opaque ones, then the
 * blended ones in the order of instance.blended (see alpha.h). Normal maps
 * are drawn where both instance.normal_mapping and texture_set.normal_mapping
 * are true. Their light is computed in world space, so they need the camera's
 * own model-view matrix. Surfaces with normal maps and those whose emission
 * takes a pass of its own leave the depth function at GL_LESS.
 */
void draw_instance(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, enum draw_pass pass);

/* Sets the current colour to that of shadows, with this alpha. */
void draw_set_shadow_color(const struct gl *gl, float strength);

/* Draws one drawable of an instance, hidden or not. */
void draw_instance_part(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass);

#endif
