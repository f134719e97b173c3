/*
 * Divides primitives into parts that the rest of limber can work with.
 *
 * OpenGL ES 1.1 draws with indices of 16 bits, and the fixed-point loops of
 * skins number their vertices in 16 bits, too. A primitive of a file may have
 * more vertices. Each loader therefore replaces such a primitive by parts of at
 * most SPLIT_VERTICES_MAX vertices, which are primitives of the same mesh with
 * the same material, joints and targets.
 *
 * Triangles that are near each other stay together. A vertex at a border is
 * repeated with the same numbers in each part that needs it, so that the parts
 * are posed, lit and simplified (levels/) without a visible seam.
 *
 * Some exporters let all primitives of a mesh share one array of vertices, of
 * which each primitive draws a few. Each would have memory for all of them,
 * pose them in each frame, and take them for vertices that it shares with the
 * others. Such a primitive becomes one part with the vertices that its
 * triangles use, and another one with the rest, which is dropped for drawing.
 */
#ifndef APP_MODEL_SPLIT_SPLIT_H
#define APP_MODEL_SPLIT_SPLIT_H

#include "app/model/model.h"

enum {
	SPLIT_VERTICES_MAX = 65535
};

/*
 * Divides primitives with many vertices, or with many that no triangle uses and
 * no levels of detail, of all meshes. The arena `integers` gets
 * displacements in integers, the model gets all other arrays. Levels of detail
 * of a divided primitive are dropped: levels_make() makes others for its parts.
 * Arrays are freed as soon as they are divided. Call this before targets are
 * stored as key frames. Returns 0 or -ENOMEM.
 */
int split_primitives(struct model *model, struct arena *integers);

/* Removes the parts that have no triangles, to draw the model. */
void split_drop_unused(struct model *model);

#endif
