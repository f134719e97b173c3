/*
 * A first character file for a model, made from what the model holds.
 */
#ifndef APP_CHARACTER_SKETCH_CHARACTER_SKETCH_H
#define APP_CHARACTER_SKETCH_CHARACTER_SKETCH_H

#include "app/model/model.h"

#include <stdio.h>

/*
 * Writes the text: clips become states, morph targets expressions and a morph;
 * pivots and chains of bones become suggestions in comments. Buttons use what
 * there is. character_read() accepts the text for this model.
 */
void character_sketch(const struct model *model, FILE *out);

#endif
