/*
 * What labels call the parts of a character: by name or, where the font lacks
 * the name's letters, by number. Clips and nodes count from 0 as for --clip,
 * what a character file lists from 1.
 */
#ifndef APP_CHARACTER_SHOW_LABEL_NAME_H
#define APP_CHARACTER_SHOW_LABEL_NAME_H

#include "app/character/character_data.h"
#include "app/character/character_morph.h"
#include "app/character/character_part.h"
#include "app/scene/hud/hud_name.h"

/*
 * Names the state that plays; or the clip, which may be NULL, if the state
 * blends several or is called as its clip, by name or as in "clip 3".
 */
const char *label_name_motion(const struct character *character,
	const struct model_clip *clip, char number[HUD_NAME_BYTES]);

/* Names a key frame of a morph. */
const char *label_name_key(const struct character_morph *morph, int key,
	char number[HUD_NAME_BYTES]);

/* Returns the number of a switch among those of its kind. */
int label_name_rank(const struct character *character, int index);

/* Names a switch. */
const char *label_name_switch(const struct character *character, int index,
	char number[HUD_NAME_BYTES]);

/* Names the step of a sequence that runs. */
const char *label_name_step(
	const struct character_sequence *sequence, char number[HUD_NAME_BYTES]);

#endif
