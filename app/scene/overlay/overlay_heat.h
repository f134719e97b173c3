/*
 * Paints the vertices of an instance as a heat map in place of its materials.
 *
 * The instance stays lit and is drawn by the functions that always draw it:
 * while the heat map is switched on, its batches have the heat map's colours
 * and its materials are white. Of several heat maps of an instance the one that
 * was switched on last is switched off first.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_HEAT_H
#define APP_SCENE_OVERLAY_OVERLAY_HEAT_H

#include "app/scene/instance/instance.h"

struct overlay_heat {
	struct instance *instance; /* not owned */
	struct model plain;        /* the instance's model, materials white */
	int batch_count;           /* of all drawables together */
	uint8_t (**color)[4];      /* [batch_count][vertex_count] */

	/* While switched on: what the instance had before; else NULL. */
	const struct model *model;
	const uint8_t (**kept)[4]; /* [batch_count] */
	bool normal_mapping;
};

/*
 * Prepares a heat map that is blue everywhere, switched off. Returns 0 or
 * -ENOMEM; the arena owns the memory.
 */
int overlay_heat_init(struct overlay_heat *heat, struct instance *instance,
	struct arena *arena);

/*
 * Paints each vertex by the mean of its joints' values, weighted by its
 * influences, and a vertex without a skin by its node's value. value has one
 * number a node, 0 (blue) to 1 (red).
 */
void overlay_heat_paint_nodes(struct overlay_heat *heat, const float *value);

/*
 * Paints each vertex by how far the morph target of this number moves it,
 * compared with the vertex that it moves farthest.
 */
void overlay_heat_paint_target(struct overlay_heat *heat, int target);

/* Writes the colour of a vertex of a drawable's primitive. */
typedef void (*overlay_heat_color_fn)(
	void *user, int drawable, int vertex, uint8_t rgb[3]);

/*
 * Paints the vertices of all batches. It may ask several times for the colour
 * of a vertex that batches have several copies of.
 */
void overlay_heat_paint(
	struct overlay_heat *heat, overlay_heat_color_fn color, void *user);

/* Shows the heat map or the materials. */
void overlay_heat_switch(struct overlay_heat *heat, bool on);

/*
 * Returns the heat map's colour: from blue at 0 over green and yellow to red at
 * 1. The fraction is clamped.
 */
void overlay_heat_ramp(float fraction, uint8_t rgb[3]);

#endif
