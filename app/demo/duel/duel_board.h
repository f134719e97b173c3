/*
 * The duel's scoreboard: a column of numbers below each contender.
 */
#ifndef APP_DEMO_DUEL_DUEL_BOARD_H
#define APP_DEMO_DUEL_DUEL_BOARD_H

#include "app/demo/duel/contender.h"

/*
 * Adds the time, memory and error of each contender; the best of a row is
 * green. In a narrow picture figures have fewer digits and shorter units,
 * rather than being cut. A further line says what each technique plays (such as
 * "9 keys") or, if full_px is above 0, shows the colours of errors up to
 * full_px.
 */
void duel_board_show(const struct contender contender[CONTENDER_KINDS],
	float full_px, struct hud *hud);

#endif
