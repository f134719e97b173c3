/*
 * Actions that run when conditions begin or cease to hold.
 */
#ifndef APP_CHARACTER_RUN_TRIGGERS_H
#define APP_CHARACTER_RUN_TRIGGERS_H

#include "app/character/character_data.h"

/*
 * Compares the triggers' conditions and adds actions to the pending ones. The
 * first frame only compares.
 */
void character_triggers_update(struct character *character);

#endif
