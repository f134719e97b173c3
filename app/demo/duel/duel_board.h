/*
 * The duel's figures, a column below each contender.
 */
#ifndef APP_DEMO_DUEL_DUEL_BOARD_H
#define APP_DEMO_DUEL_DUEL_BOARD_H

#include "app/demo/duel/contender.h"

/*
 * Time, memory and error of each, the least of a row in green. full_px: the
 * error that is painted red, or 0 where nothing is painted.
 */
void duel_board_show(const struct contender contender[CONTENDER_KINDS],
	float full_px, struct hud *hud);

#endif
