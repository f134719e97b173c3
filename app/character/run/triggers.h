/*
 * Actions that run when conditions begin or cease to hold.
 */
#ifndef APP_CHARACTER_RUN_TRIGGERS_H
#define APP_CHARACTER_RUN_TRIGGERS_H

#include "app/character/character_data.h"

/* Compares, and adds actions to the pending ones; the first frame adds none. */
void character_triggers_update(struct character *character);

#endif
