/*
 * Actions that wait for the end of a step of the frame. Thus the modules that
 * cause actions (buttons, states, events) need not know those that run them.
 */
#ifndef APP_CHARACTER_RUN_PENDING_H
#define APP_CHARACTER_RUN_PENDING_H

#include "app/character/character_data.h"

/*
 * Adds a list of actions; NULL is allowed. times multiplies the amount of
 * actions that change something by an amount. Actions beyond
 * CHARACTER_PENDING_MAX are dropped.
 */
static inline void character_pending_add(struct character *character,
	const struct character_action *action, float times)
{
	for (; action && character->pending_count < CHARACTER_PENDING_MAX;
		action = action->next) {
		int at = character->pending_count++;

		character->pending[at].action = action;
		character->pending[at].times = times;
	}
}

#endif
