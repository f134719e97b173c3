/*
 * Batches: a primitive's vertices as GL ES 1.1 can draw them.
 *
 * GL ES 1.1 indexes with 16 bits and interpolates one normal a vertex. A
 * primitive without normals is therefore drawn as facets (facets.h), by flat
 * shading, from vertices that are copied from the posed ones once a frame
 * ("gathered"). Flat shading takes colours from one corner as well: where the
 * corners of some triangle have different vertex colours, each triangle of the
 * primitive gets three vertices of its own and no index, in batches that are
 * small enough. Coarser lists have further vertices in the same arrays, whose
 * normals are those of triangles of the full list. Primitives of more
 * than 65,536 vertices, which loaders divide (app/model/split/split.h), and
 * facets that would have as many, are drawn in the same way.
 */
#ifndef APP_SCENE_INSTANCE_BATCH_H
#define APP_SCENE_INSTANCE_BATCH_H

#include "app/scene/instance/instance_data.h"

/*
 * Makes the batches of a drawable whose output arrays are set. Vertex colours
 * are multiplied by base_color (linear RGBA). Returns 0 or -ENOMEM.
 */
int batch_make(struct drawable *drawable, const float base_color[4],
	struct arena *arena);

/* Returns the number, within the primitive, of the batch's vertex v. */
int batch_vertex(
	const struct drawable *drawable, const struct batch *batch, int v);

/* Changes the sRGB-encoded colour of one of the primitive's vertices. */
typedef void batch_dye(void *user, int vertex, uint8_t color[4]);

/*
 * Changes the drawable's vertex colours, if it has any. The model and its other
 * instances keep theirs. Returns 0 or -ENOMEM.
 */
int batch_recolor(struct drawable *drawable, batch_dye *dye, void *user,
	struct arena *arena);

/*
 * Multiplies the drawable's vertex colours and its material's colour by an
 * sRGB-encoded factor from 0 to 1 a channel. The model and its other instances
 * keep their colours. Returns 0 or -ENOMEM.
 */
int batch_tint(
	struct drawable *drawable, const float factor[3], struct arena *arena);

/*
 * Adds to the drawable's vertex colours what dark ones mirror (color_mirror()).
 * Takes no memory if none is dark. Returns 0 or -ENOMEM.
 */
int batch_add_mirrored(struct drawable *drawable, struct arena *arena);

/*
 * Gives a gathered batch, whose source is set, the coarser lists of its
 * drawable's primitive and those for shadows: adds their vertices to source,
 * which it replaces. A list of more than 65,536 vertices is left out. Called
 * before the other arrays are allocated. Returns 0 or -ENOMEM.
 */
int batch_add_levels(struct batch *batch, const struct drawable *drawable,
	struct arena *arena);

/*
 * Copies posed vertices into the arrays of gathered batches and finds normals
 * where the primitive has none, for the lists that draw the surface and the
 * shadow; called once a frame, and when other lists are chosen.
 */
void batch_gather(struct drawable *drawable);

/* The same for all lists, for vertices that never change. */
void batch_gather_all(struct drawable *drawable);

#endif
