/*
 * The duel's scoreboard: a column of figures below each contender.
 */
#ifndef APP_DEMO_DUEL_DUEL_BOARD_H
#define APP_DEMO_DUEL_DUEL_BOARD_H

#include "app/demo/duel/contender.h"

/*
 * Adds the time, memory and error of each contender; the best of a row is green.
 * full_px is the error that is painted red; with 0 no colour scale is shown.
 */
void duel_board_show(const struct contender contender[CONTENDER_KINDS],
	float full_px, struct hud *hud);

#endif
