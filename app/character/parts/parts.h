/*
 * Rigid parts on pivots (AN4044, section 2), and sequences of their steps.
 */
#ifndef APP_CHARACTER_PARTS_PARTS_H
#define APP_CHARACTER_PARTS_PARTS_H

#include "app/character/character_data.h"

/* An operation (struct character_op) of a struct character_sequence. */
void character_sequence_run(struct character *character, void *sequence);

/*
 * An operation that sets the bones of all parts from their degrees of freedom.
 * A part that an action moves stops where its capsules (struct character_guard)
 * would enter the ground or those of another part.
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
