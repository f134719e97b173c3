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
 * Adds levels to the primitives of a loaded model that have none, and lists for
 * shadows to all primitives. This takes some 20,000 ARM instructions a
 * triangle. Primitives of few triangles get neither. Those without normals are
 * divided into triangles for this, each with vertices of its own. Memory comes
 * from the model's budget; levels are left out if less than half of it is free
 * or if they do not fit. Returns 0, or -ENOMEM if the machine has no memory;
 * then some primitives may have levels.
 */
int levels_make(struct model *model);

/*
 * The same for levels that are kept: uses all of the budget, and fails with
 * -ENOMEM and budget->exceeded if levels do not fit.
 */
int levels_make_all(struct model *model);

#endif
