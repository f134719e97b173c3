/*
 * What a model looks like at rest, into a glTF file: shared by all bakes.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_LOOK_H
#define APP_COMPARE_EXPORT_EXPORT_LOOK_H

#include "app/compare/export/glb.h"
#include "app/model/model.h"

/* Materials, textures and pictures, numbered as in the model. */
void export_materials(struct glb *glb, const struct model *model);

#endif
