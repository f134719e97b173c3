/* How the ground moves below a model, in a character file. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_MOTION_H
#define APP_CHARACTER_SKETCH_SKETCH_MOTION_H

#include "app/model/model.h"

#include <stdio.h>

/*
 * Writes the section [motion] of a model with clips; nothing for other models.
 * If a clip carries all that is shown away over the ground, it suggests, in a
 * comment, the node that does so as the root. Returns 0 or -ENOMEM.
 */
int sketch_write_motion(const struct model *model, FILE *out);

#endif
