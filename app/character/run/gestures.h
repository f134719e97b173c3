/*
 * What people do with the buttons, and the tour that takes their place.
 */
#ifndef APP_CHARACTER_RUN_GESTURES_H
#define APP_CHARACTER_RUN_GESTURES_H

#include "app/character/character_data.h"

/* Takes a press or a release and adds the actions bound to it. */
void character_gestures_press(
	struct character *character, const struct button_event *event);

/* Adds the actions of held buttons, and of presses that waited. */
void character_gestures_update(struct character *character);

/* Adds the actions of the tour that are due. */
void character_tour_update(struct character *character);

#endif
