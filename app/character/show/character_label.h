/*
 * The labels of a model that behaves as its character file says.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_LABEL_H
#define APP_CHARACTER_SHOW_CHARACTER_LABEL_H

#include "app/character/character.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/stage/framing.h"

/* Returns how many rows of labels there usually are, and how many have bars. */
int character_label_count(const struct character *character, int *bars);

/* Returns the rows of the group in the corner below, as it is shown now. */
struct framing_below character_label_below(const struct character *character);

/*
 * Adds state, morphs, parameters, weights, steps of sequences, the part that
 * was moved last and, if they are asked for, what the buttons do.
 */
void character_label_all(
	const struct character *character, const char *title, struct hud *hud);

#endif
