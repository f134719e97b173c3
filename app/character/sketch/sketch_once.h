/* Clips of a model that are to be played once. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_ONCE_H
#define APP_CHARACTER_SKETCH_SKETCH_ONCE_H

#include "app/character/sketch/character_sketch.h"

struct sketch_once {
	bool clip[CHARACTER_SKETCH_CLIPS]; /* whether it plays once */
	bool any;
};

/*
 * Finds the clips that end in another shape than they begin with, as a door
 * that opens: their last pose is about the farthest from their first one. A
 * clip that carries the model away is none of them, nor is a short one, such as
 * a pose. Finds none if play says how clips repeat. Returns 0 or -ENOMEM.
 */
int sketch_find_once(const struct model *model,
	const struct character_sketch_play *play, struct sketch_once *once);

/*
 * Writes how such a clip repeats, in its state. Alone it begins again after a
 * pause; of several, buttons play it again.
 */
void sketch_write_once(const struct model *model, int clip, FILE *out);

#endif
