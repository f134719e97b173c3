/*
 * Draws the nodes of a figure: its skeleton, or its pivots with their axes.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_BONES_H
#define APP_SCENE_OVERLAY_OVERLAY_BONES_H

#include "app/scene/instance/instance.h"
#include "app/scene/overlay/overlay_sketch.h"

/* Which nodes are drawn, and how large. */
struct overlay_bones {
	const struct instance *instance; /* its world matrices are read */
	const uint8_t *is_bone;          /* [node_count], 0 or 1 */
	int chosen;                      /* a node in another colour, or -1 */
	float extent;                    /* of the figure, scene units */
};

/*
 * A bone from each node's nearest ancestor that is a bone to the node itself,
 * and an octahedron at each node. The sketch collects GL_TRIANGLES.
 */
void overlay_bones_skeleton(
	const struct overlay_bones *bones, struct overlay_sketch *sketch);

/*
 * Arrows along the axes of each node's frame: x is red, y green and z blue. The
 * sketch collects GL_TRIANGLES.
 */
void overlay_bones_axes(
	const struct overlay_bones *bones, struct overlay_sketch *sketch);

/* A line from each node to its parent. The sketch collects GL_LINES. */
void overlay_bones_links(
	const struct overlay_bones *bones, struct overlay_sketch *sketch);

#endif
