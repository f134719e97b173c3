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

/* Starts a layer that plays once; one that plays already starts again. */
void character_layer_play(struct character_layer *layer);

/* Begins a morph to a new Destiny, a key; a morph may be under way. */
void character_morph_go(struct character_morph *morph, int key, double now_s);

/* Returns the morph's Omega, 0 at the start and 1 at the end. */
float character_morph_omega(const struct character_morph *morph, double now_s);

/*
 * Returns the part of the way that a struct character_curve goes up to omega.
 */
float character_morph_curve(const void *curve, float omega);

/* Uses the curve of this number from now on. */
void character_morph_use_curve(struct character_morph *morph, int curve);

/* If the morph bends vertices, bends those that instance_update() posed. */
void character_morph_bend(struct character_morph *morph, double now_s);

#endif
