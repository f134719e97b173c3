/*
 * Merges vertices at one position whose attributes hardly differ.
 *
 * Where each triangle has vertices of its own, as in a mesh that was exported
 * with flat normals, no vertex has a counterpart at the other end of an edge,
 * so none may collapse. Once the vertices of a position are one, they may. The
 * normals of a position tell how much its triangles differ in brightness: the
 * smaller the triangles, the less of that difference is seen.
 */
#ifndef APP_MODEL_LEVELS_SIMPLIFY_MERGE_H
#define APP_MODEL_LEVELS_SIMPLIFY_MERGE_H

#include "app/model/levels/simplify.h"

/*
 * Whether positions have more than two vertices on average. Only then are they
 * merged: elsewhere few vertices are at seams, which have counterparts.
 */
bool simplify_merge_is_wanted(struct simplify *simplify);

/*
 * Moves corners to another vertex at their position where the error, in
 * fractions of the extent, is at most limit, if
 * simplify->divided is set. The triangles stay, and so does
 * what simplify_mesh_link() has found.
 */
void simplify_merge(struct simplify *simplify, float limit);

#endif
