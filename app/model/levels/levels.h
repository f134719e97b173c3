/*
 * Levels of detail for primitives whose file has none.
 *
 * A level is a coarser triangle list over the vertices of its primitive
 * (struct model_lod), so that posing and attributes stay as they are. Lists for
 * shadows keep only the shape.
 */
#ifndef APP_MODEL_LEVELS_LEVELS_H
#define APP_MODEL_LEVELS_LEVELS_H

#include "app/model/model.h"

/*
 * Adds levels to the primitives of a loaded model that have none, and coarser
 * lists for shadows to all. It takes some 20,000 ARM instructions a triangle.
 * Primitives without normals or of few triangles stay as they are. Memory comes
 * from the model's budget; levels are left out when less than half of it is
 * left, or when they do not fit. 0, or -ENOMEM, with some levels, when the
 * machine has no memory.
 */
int levels_make(struct model *model);

#endif
