/*
 * The capsules that keep rigid parts away from each other and from the ground.
 */
#ifndef APP_CHARACTER_PARTS_GUARD_H
#define APP_CHARACTER_PARTS_GUARD_H

#include "app/character/character_data.h"

/*
 * Returns the sum of the depths, in metres, to which capsules of parts are
 * inside each other and inside the ground. Two capsules of one part, of parts
 * that share a joint, or of a part and its holder do not count. World matrices
 * must be up to date.
 */
float character_guard_depth(const struct character *character);

#endif
