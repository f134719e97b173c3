/*
 * Parts that are attached to nodes, fall, and lie on what is below them.
 */
#ifndef APP_CHARACTER_PARTS_HELD_H
#define APP_CHARACTER_PARTS_HELD_H

#include "app/character/character_data.h"

/* An operation: lets parts fall and moves attached ones with their holders. */
void character_held_run(struct character *character, void *unused);

/* Only moves them; world matrices are up to date before and after. */
void character_held_place(struct character *character);

/*
 * Attaches a part to a node, or lets it go back to its place in the model: an
 * action of CHARACTER_ATTACH. A part that is near a place of the node is pulled
 * to it; else it stays where it is now, in the node's frame.
 */
void character_part_attach(struct character *character,
	struct character_part *part, const struct character_action *action);

/*
 * Lets a part fall, upright, onto the triangles of a node that are below it or,
 * where there are none or with node -1, onto the ground.
 */
void character_part_drop(
	struct character *character, struct character_part *part, int node);

#endif
