/*
 * Rigid parts on pivots (AN4044, section 2), and sequences of their steps.
 */
#ifndef APP_CHARACTER_PARTS_PARTS_H
#define APP_CHARACTER_PARTS_PARTS_H

#include "app/character/character_data.h"

/* Operations with a struct character_sequence and with NULL. */
void character_sequence_run(struct character *character, void *sequence);

/*
 * Sets the bones of all parts from their degrees of freedom. A part that was
 * moved by an action stops where its guarded line would come into the ground or
 * into another guarded part.
 */
void character_parts_run(struct character *character, void *unused);

/*
 * Starts a sequence at its first step, or ends it. It begins again after its
 * last step if repeats is true or its section says so.
 */
void character_sequence_start(struct character *character,
	struct character_sequence *sequence, bool repeats);
void character_sequence_stop(struct character_sequence *sequence);

#endif
