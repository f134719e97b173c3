/*
 * The states of a character: which one plays, and its pose.
 */
#ifndef APP_CHARACTER_STATE_MACHINE_H
#define APP_CHARACTER_STATE_MACHINE_H

#include "app/character/character_data.h"

/*
 * Chooses the state of this frame, moves its clips on by the frame's step and
 * writes its pose, with what is left of a transition, into the instance's. Adds
 * the actions of states and of passed events to the pending ones.
 */
void character_machine_update(struct character *character);

/* Returns the clip of the present state that has the largest weight. */
const struct character_entry *character_machine_entry(
	const struct character *character);

#endif
