/*
 * Operations of layers, expressions and AN4044's morphs.
 */
#ifndef APP_CHARACTER_RUN_LAYERS_H
#define APP_CHARACTER_RUN_LAYERS_H

#include "app/character/character_data.h"

/* Operations (struct character_op) with the struct that each one takes. */
void character_layer_run(struct character *character, void *layer);
void character_expression_run(struct character *character, void *expression);
void character_morph_run(struct character *character, void *morph);

/* Starts a layer that plays once, also while it plays. */
void character_layer_play(struct character_layer *layer);

/* Makes another key frame the Destiny, also during a morph. */
void character_morph_go(struct character_morph *morph, int key);

/* The morph's Omega after its curve, 0 at the start and 1 at the end. */
float character_morph_omega(const struct character_morph *morph);

/* The curve of a table or of a Bezier at u, 0..1. */
float character_morph_curve(const struct character_morph *morph, float u);

#endif
