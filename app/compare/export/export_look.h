/*
 * Writes a model's materials into a glTF file.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_LOOK_H
#define APP_COMPARE_EXPORT_EXPORT_LOOK_H

#include "app/compare/export/glb.h"
#include "app/model/model.h"

/* Adds materials, textures and images, with the numbers that the model uses. */
void export_materials(struct glb *glb, const struct model *model);

#endif
