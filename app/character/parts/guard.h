/*
 * The capsules that keep rigid parts away from each other and from the ground.
 */
#ifndef APP_CHARACTER_PARTS_GUARD_H
#define APP_CHARACTER_PARTS_GUARD_H

#include "app/character/character_data.h"

/*
 * How far the capsules of all parts are inside each other and the ground, in
 * metres. Those of a part, of parts that share a joint, and of a part and its
 * holder do not count. World matrices are up to date.
 */
float character_guard_depth(const struct character *character);

#endif
