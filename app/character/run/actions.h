/*
 * Running the pending actions of a frame.
 */
#ifndef APP_CHARACTER_RUN_ACTIONS_H
#define APP_CHARACTER_RUN_ACTIONS_H

#include "app/character/character_data.h"

/* Runs all pending actions, and those that they add, in their order. */
void character_actions_run(struct character *character);

#endif
