/*
 * The labels of a model that behaves as its character file says.
 */
#ifndef APP_DEMO_VIEWER_BEHAVIOUR_LABEL_H
#define APP_DEMO_VIEWER_BEHAVIOUR_LABEL_H

#include "app/character/character.h"
#include "app/demo/actor.h"

/* Sets how many rows of labels there usually are, and how many have bars. */
void behaviour_count_labels(
	const struct character *character, struct actor_framing *framing);

/*
 * Adds state, morphs, parameters, weights, steps of sequences, the part that
 * was moved last and, if they are asked for, what the buttons do.
 */
void behaviour_label_all(const struct character *character, const char *title,
	const struct actor *actor, struct hud *hud);

#endif
