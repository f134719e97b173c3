/* Clips of a model that may play at the same time. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_LAYERS_H
#define APP_CHARACTER_SKETCH_SKETCH_LAYERS_H

#include "app/model/model.h"

#include <stdio.h>

/*
 * Writes a section [layer], in comments, for each clip that moves only nodes
 * which the first clip and the layers before it leave alone. Programs that
 * export a clip for each object write such clips, and only all of them together
 * show a machine at work. Returns 0 or -ENOMEM.
 */
int sketch_write_layers(const struct model *model, int first, FILE *out);

#endif
