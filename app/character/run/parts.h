/*
 * Rigid parts on pivots (AN4044, section 2), and sequences of their steps.
 */
#ifndef APP_CHARACTER_RUN_PARTS_H
#define APP_CHARACTER_RUN_PARTS_H

#include "app/character/character_data.h"

/* Operations with a struct character_sequence and with NULL. */
void character_sequence_run(struct character *character, void *sequence);

/*
 * Sets the bones of all parts from their degrees of freedom. A part that was
 * moved by an action stops where its guarded line would come into the ground or
 * into another guarded part.
 */
void character_parts_run(struct character *character, void *unused);

/* Moves attached parts with their holders; world matrices are up to date. */
void character_attached_run(struct character *character, void *unused);

/*
 * Attaches a part to a node where it is now if it is at most within_m away; -1
 * lets it go back to its place in the model.
 */
void character_part_attach(struct character *character,
	struct character_part *part, int holder, float within_m);

/* Lets a part down from where it is to its height in the model. */
void character_part_drop(
	struct character *character, struct character_part *part);

/*
 * Starts a sequence at its first step, or ends it. It begins again after its
 * last step if repeats is true or its section says so.
 */
void character_sequence_start(struct character *character,
	struct character_sequence *sequence, bool repeats);
void character_sequence_stop(struct character_sequence *sequence);

#endif
