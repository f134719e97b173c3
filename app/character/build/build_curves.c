/*
 * Lines "curve" and "direction" of a section [morph].
 */
#include "app/anim/math/vec.h"
#include "app/character/build/build.h"

#include <errno.h>
#include <string.h>

/* METRES [X Y Z DELAY]: the wave runs along x y z. */
static int read_sine(struct character_words *words,
	const struct character_key *key, struct morph_wave *wave)
{
	float axis[3] = {0, 1, 0};

	if (!character_take_within(
		    words, 0.0f, CHARACTER_LENGTH_MAX, &wave->amplitude)) {
		return character_fail_value(words, key);
	}
	if (character_take_number(words, &axis[0])) {
		for (int i = 1; i < 3; i++) {
			if (!character_take_number(words, &axis[i])) {
				return character_fail_value(words, key);
			}
		}
		if (!character_take_within(words, 0.0f, 100.0f, &wave->delay)) {
			return character_fail_value(words, key);
		}
	}
	if (vec_normalize(axis) == 0) {
		return character_fail(words,
			"the wave's axis must not be 0 0 0: give %s",
			key->right);
	}
	memcpy(wave->axis, axis, sizeof(axis));
	return 0;
}

static int check_table(const struct character_words *words,
	const struct character_curve *curve, bool bezier)
{
	const float *table = curve->table;
	int count = curve->table_count;

	if (bezier &&
		(count != 4 || table[0] < 0 || table[0] > 1 || table[2] < 0 ||
			table[2] > 1)) {
		return character_fail(words,
			"a Bezier curve has four numbers x1 y1 x2 y2, with x1 and x2 from 0 to 1");
	}
	if (!bezier && (count < 2 || table[0] != 0 || table[count - 1] != 1)) {
		return character_fail(words,
			"a table has 2 to 32 numbers that begin with 0 and end with 1");
	}
	return 0;
}

static int read_curve_kind(struct character_words *words,
	const struct character_key *key, struct character_curve *curve)
{
	if (character_take(words, "linear")) {
		return 0;
	}
	if (character_take(words, "sine")) {
		curve->kind = CHARACTER_CURVE_SINE;
		curve->name = "sinusoidal";
		return read_sine(words, key, &curve->wave);
	}
	if (character_take(words, "bezier")) {
		curve->kind = CHARACTER_CURVE_BEZIER;
		curve->name = "Bezier";
	} else if (character_take(words, "table")) {
		curve->kind = CHARACTER_CURVE_TABLE;
		curve->name = "table";
	} else {
		return character_fail_value(words, key);
	}
	while (curve->table_count < CHARACTER_TABLE_MAX &&
		character_take_number(words, &curve->table[curve->table_count])) {
		curve->table_count++;
	}
	return check_table(words, curve, curve->kind == CHARACTER_CURVE_BEZIER);
}

/* Each line adds a curve; the first one is used at the start. */
int character_read_curve(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_morph *morph = member;
	struct character_curve *curve = &morph->curve[morph->curve_count];
	int error;

	if (morph->curve_count == CHARACTER_CURVES_MAX) {
		return character_fail(words, "a morph has at most %d curves",
			CHARACTER_CURVES_MAX);
	}
	/* A new curve has the direction of the first one. */
	if (morph->curve_count > 0) {
		memcpy(curve->wave.direction, morph->curve[0].wave.direction,
			sizeof(curve->wave.direction));
	}
	morph->curve_count++;
	curve->name = "linear";
	error = read_curve_kind(words, key, curve);
	if (!error && !character_at_end(words) &&
		words->line->word[words->next].quoted) {
		curve->name = character_next_word(words);
	}
	return error;
}

/* The direction of the sine in the line above. */
int character_read_curve_direction(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_morph *morph = member;
	int last = morph->curve_count > 0 ? morph->curve_count - 1 : 0;

	return character_read_direction(
		words, key, morph->curve[last].wave.direction);
}
