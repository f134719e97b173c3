/*
 * Parts that are attached to nodes, fall, and lie on what is below them.
 */
#ifndef APP_CHARACTER_PARTS_HELD_H
#define APP_CHARACTER_PARTS_HELD_H

#include "app/character/character_data.h"

/* Notes how a part lies in the rest pose, whose world matrices are needed. */
void character_held_init(
	const struct instance *instance, struct character_part *part);

/* An operation: lets parts fall and moves attached ones with their holders. */
void character_held_run(struct character *character, void *unused);

/*
 * Only moves attached parts with their holders. World matrices must be up to
 * date, and they are so afterwards.
 */
void character_held_place(struct character *character);

/*
 * Runs an action CHARACTER_ATTACH: attaches a part to a node, or lets it go
 * back to its place in the model. If the action has a place, the part is pulled
 * there; else it keeps its present place in the node's frame.
 */
void character_part_attach(struct character *character,
	struct character_part *part, const struct character_action *action);

/*
 * Lets a part fall onto the triangles of a node that are below it or, where
 * there are none or with node -1, onto the ground. It keeps its bearing and is
 * upright as it is in the model.
 */
void character_part_drop(
	struct character *character, struct character_part *part, int node);

#endif
