/*
 * How the ground moves under a character that moves on the spot.
 */
#ifndef APP_CHARACTER_RUN_GROUND_H
#define APP_CHARACTER_RUN_GROUND_H

#include "app/character/character_data.h"

/*
 * Sets the motion's scroll and velocity of this frame. With feet, the ground
 * goes with the foot that stands on it, so that this foot does not skate. World
 * matrices must be those of the animated pose, before any effect that reads
 * them.
 */
void character_ground_update(struct character *character);

#endif
