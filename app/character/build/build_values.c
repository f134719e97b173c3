/*
 * Readers of values that several kinds of sections have: parameters or numbers,
 * fades, nodes, states, choices and capsules.
 */
#include "app/character/build/build.h"

#include <errno.h>
#include <string.h>

int character_read_value(struct character_words *words,
	const struct character_key *key, void *member)
{
	const float **value = member;
	struct character *character = words->build->character;
	float number;
	int index;

	if (character_take_number(words, &number)) {
		float *kept = ARENA_NEW(words->build->arena, float);

		if (!kept) {
			return character_fail_memory(words->build);
		}
		if (key->low < key->high &&
			(number < key->low || number > key->high)) {
			words->next--;
			return character_fail_value(words, key);
		}
		*kept = number;
		*value = kept;
		return 0;
	}
	if (character_at_end(words) || character_next_is(words, ",")) {
		return character_fail_value(words, key);
	}
	index = character_name_section(words, "parameter");
	if (index < 0) {
		return -EINVAL;
	}
	*value = &character->parameter[index].value;
	return 0;
}

int character_read_fade(struct character_words *words,
	const struct character_key *key, void *member)
{
	static const char *const curves[] = {"smooth", "linear", "cubic", NULL};
	struct character_fade *fade = member;
	float amount;

	if (!character_take_within(words, 0.0f, 60.0f, &amount)) {
		return character_fail_value(words, key);
	}
	*fade = (struct character_fade){.duration_s = amount};
	if (character_take(words, "frames")) {
		fade->frames = (int)amount;
		fade->duration_s = 0;
	} else {
		character_take(words, "s");
	}
	for (int i = 0; curves[i]; i++) {
		if (character_take(words, curves[i])) {
			fade->curve = (enum inertia_curve)i;
			break;
		}
	}
	return 0;
}

int character_read_node(struct character_words *words,
	const struct character_key *key, void *member)
{
	int node;

	if (character_at_end(words) || character_next_is(words, ",")) {
		return character_fail_value(words, key);
	}
	node = character_name_node(words);
	*(int *)member = node;
	return node < 0 ? -EINVAL : 0;
}

int character_read_state(struct character_words *words,
	const struct character_key *key, void *member)
{
	int state;

	(void)key;
	state = character_name_section(words, "state");
	*(int *)member = state;
	return state < 0 ? -EINVAL : 0;
}

bool character_take_choice(struct character_words *words,
	const struct character_parameter *parameter, float *out)
{
	const char *word = character_at_end(words)
		? ""
		: words->line->word[words->next].text;

	/* In quotes too. */
	for (int i = 0; i < parameter->choice_count; i++) {
		if (strcmp(word, parameter->choice[i]) == 0) {
			words->next++;
			*out = (float)i;
			return true;
		}
	}
	return false;
}

int character_read_capsule(struct character_words *words,
	const struct character_key *key, struct capsule *capsule)
{
	int error = character_read_node(words, key, &capsule->node_a);

	if (!error) {
		error = character_read_node(words, key, &capsule->node_b);
	}
	if (error) {
		return error;
	}
	if (!character_take_number(words, &capsule->radius) ||
		capsule->radius <= 0) {
		return character_fail(words,
			"the radius is a number above 0: give %s", key->right);
	}
	if (character_at_end(words)) {
		return 0;
	}
	error = character_read_numbers3(words, key, capsule->offset_a);
	memcpy(capsule->offset_b, capsule->offset_a, sizeof(capsule->offset_b));
	return error;
}
