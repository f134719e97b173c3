/*
 * A model's clips as limber play shows them: a figure that walks away stays in
 * its place, and the ground moves instead.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_IN_PLACE_H
#define APP_CHARACTER_SHOW_CHARACTER_IN_PLACE_H

#include "app/character/character_data.h"

/*
 * Copies a model whose clips carry the root of the character's motion away, and
 * takes that way out of them: as much of it at each key as of the clip has
 * passed. *out shares all but these clips with the model, which must outlive
 * it; the copies are in the arena. way_m, [clip_count], gets how far each clip
 * goes over the ground, in metres, or 0. A root that moves in steps
 * (MODEL_STEP) is left as it is. Returns 0, or -ENOMEM without a message.
 */
int character_in_place(const struct character *character,
	const struct model *model, struct arena *arena, struct model *out,
	float *way_m);

#endif
