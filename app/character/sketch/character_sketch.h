/*
 * A first character file for a model, made from what the model holds.
 */
#ifndef APP_CHARACTER_SKETCH_CHARACTER_SKETCH_H
#define APP_CHARACTER_SKETCH_CHARACTER_SKETCH_H

#include "app/anim/clip.h"

#include <stdio.h>

/* With more clips, the text would exceed CHARACTER_LINES_MAX. */
enum {
	CHARACTER_SKETCH_CLIPS = 1000
};

/* How the clips of a sketch play. */
struct character_sketch_play {
	int clip; /* the first one; others follow in the model's order */
	float rate;
	enum clip_repeat repeat;
	/* with CLIP_LOOP: also those that sketch_find_once() finds */
	bool all_loop;
};

/*
 * Writes the text: clips, but no more than CHARACTER_SKETCH_CLIPS, become
 * states, morph targets expressions and a morph; pivots, legs and chains of
 * bones become suggestions in comments. Buttons use what there is: where
 * neither clips nor shapes move the model, they turn parts that hang on each
 * other, or joints. character_read() accepts the text for this model. play
 * NULL: the first clip begins, at its own rate. Clips that end in another shape
 * than they begin with play once, all others repeat. 0, or -ENOMEM
 * with a part of the text.
 */
int character_sketch(const struct model *model,
	const struct character_sketch_play *play, FILE *out);

#endif
