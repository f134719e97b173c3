/*
 * The duel's scoreboard: a column of figures below each contender.
 */
#ifndef APP_DEMO_DUEL_DUEL_BOARD_H
#define APP_DEMO_DUEL_DUEL_BOARD_H

#include "app/demo/duel/contender.h"

/*
 * Adds the time, memory and error of each contender; the best of a row is
 * green. If full_px is above 0, a colour scale up to this error takes the place
 * of what the techniques play with.
 */
void duel_board_show(const struct contender contender[CONTENDER_KINDS],
	float full_px, struct hud *hud);

#endif
