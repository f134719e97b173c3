/*
 * From a model's primitive to what GL ES 1.1 can draw.
 *
 * GL ES 1.1 indexes with 16 bits and interpolates one normal a vertex. So a
 * primitive with more than 65,536 vertices is cut into batches that have few
 * enough, and one without normals is unshared, three vertices a triangle, to
 * be drawn with flat normals computed from the posed triangles (glTF 2.0,
 * 3.7.2.1). Either way the posed vertices are gathered once a frame.
 */
#ifndef APP_SCENE_INSTANCE_BATCH_H
#define APP_SCENE_INSTANCE_BATCH_H

#include "app/scene/instance/instance.h"

/*
 * Makes the batches of a drawable whose arrays are set. base_color tints the
 * vertex colours. 0 or -ENOMEM.
 */
int batch_make(struct drawable *drawable, const float base_color[4],
	struct arena *arena);

/* Fills the gathered arrays from the drawable's output; part of a frame. */
void batch_gather(struct drawable *drawable);

#endif
