#include "app/character/show/label_name.h"

#include <stdio.h>
#include <string.h>

/* As limber character calls a state whose clip has too long a name. */
static bool is_numbered(const struct character_state *state, int clip)
{
	char number[HUD_NAME_BYTES];

	snprintf(number, sizeof(number), "clip %d", clip);
	return strcmp(state->name, number) == 0;
}

const char *label_name_motion(const struct character *character,
	const struct model_clip *clip, char number[HUD_NAME_BYTES])
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	int index = clip ? (int)(clip - character->instance->model->clip) : -1;

	if (clip &&
		(state->entry_count > 1 || strcmp(state->name, clip->name) == 0 ||
			is_numbered(state, index))) {
		return hud_name(clip->name, "clip", index, number);
	}
	return hud_name(state->name, "state", machine->current + 1, number);
}

const char *label_name_key(const struct character_morph *morph, int key,
	char number[HUD_NAME_BYTES])
{
	return hud_name(morph->key_name[key], "key", key, number);
}

int label_name_rank(const struct character *character, int index)
{
	const char *kind = character->switches[index]->kind;
	int count = 1;

	for (int i = 0; i < index; i++) {
		count += strcmp(character->switches[i]->kind, kind) == 0;
	}
	return count;
}

const char *label_name_switch(const struct character *character, int index,
	char number[HUD_NAME_BYTES])
{
	const struct character_switch *is = character->switches[index];

	return hud_name(
		is->name, is->kind, label_name_rank(character, index), number);
}

const char *label_name_step(
	const struct character_sequence *sequence, char number[HUD_NAME_BYTES])
{
	int count = 1;

	for (const struct character_step *step = sequence->step;
		step != sequence->now; step = step->next) {
		count++;
	}
	return hud_name(sequence->now->name, "step", count, number);
}
