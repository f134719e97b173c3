/*
 * Conditions of transitions and of buttons.
 */
#ifndef APP_CHARACTER_RUN_CONDITION_H
#define APP_CHARACTER_RUN_CONDITION_H

#include "app/character/character_data.h"

/* Whether all comparisons of a list hold; NULL holds. */
static inline bool character_condition_holds(
	const struct character_condition *condition)
{
	for (; condition; condition = condition->next) {
		float left = *condition->left, right = *condition->right;
		bool is = condition->is == CHARACTER_ABOVE ? left > right
			: condition->is == CHARACTER_BELOW ? left < right
							   : left == right;

		if (!is) {
			return false;
		}
	}
	return true;
}

#endif
