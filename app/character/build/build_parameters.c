/*
 * Sections [parameter].
 */
#include "app/character/build/build.h"

#include <errno.h>

static const float not_given = 1e30f;

/* Reads what the parameter follows: a part's freedom or another parameter. */
static int read_other(
	struct character_words *words, struct character_parameter *parameter)
{
	struct character *character = words->build->character;
	int part = 0, index;

	parameter->source = CHARACTER_SOURCE_PARAMETER;
	if (character_take(words, "part")) {
		index = character_read_freedom(words, &part);
		parameter->other = index < 0
			? NULL
			: &character->part[part].freedom[index].value;
	} else {
		index = character_name_section(words, "parameter");
		parameter->other =
			index < 0 ? NULL : &character->parameter[index].value;
	}
	return parameter->other ? 0 : -EINVAL;
}

static int read_sine(struct character_words *words,
	const struct character_key *key, struct character_parameter *parameter)
{
	parameter->source = CHARACTER_SOURCE_SINE;
	if (!character_take_number(words, &parameter->scale) ||
		parameter->scale < 0.01f) {
		return character_fail(words,
			"sine needs a period in seconds, at least 0.01: give %s",
			key->right);
	}
	character_take_number(words, &parameter->offset);
	return 0;
}

static int read_source(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_parameter *parameter = member;
	int error = 0;

	parameter->scale = 1;
	parameter->offset = 0;
	if (character_take(words, "buttons")) {
		parameter->source = CHARACTER_SOURCE_ACTIONS;
		return 0;
	}
	if (character_take(words, "motion")) {
		parameter->source = CHARACTER_SOURCE_MOTION;
		return 0;
	}
	if (character_take(words, "sine")) {
		return read_sine(words, key, parameter);
	}
	if (character_take(words, "time")) {
		parameter->source = CHARACTER_SOURCE_TIME;
	} else {
		error = read_other(words, parameter);
	}
	if (!error) {
		character_take_number(words, &parameter->scale);
		character_take_number(words, &parameter->offset);
	}
	return error;
}

/* choices = NAME NAME ...: the values 0, 1 and so on. */
static int read_choices(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_parameter *parameter = member;
	int count = words->line->word_count;
	const char **name =
		ARENA_ARRAY(words->build->arena, const char *, (size_t)count);

	if (!name) {
		return character_fail_memory(words->build);
	}
	parameter->choice_count = 0;
	while (!character_at_end(words)) {
		const char *word = character_next_word(words);

		if (!word) {
			return character_fail_value(words, key);
		}
		name[parameter->choice_count++] = word;
		character_take(words, ",");
	}
	if (parameter->choice_count < 2) {
		return character_fail(
			words, "one name is no choice: give %s", key->right);
	}
	parameter->choice = name;
	parameter->range[0] = 0;
	parameter->range[1] = (float)(parameter->choice_count - 1);
	return 0;
}

static int read_stops(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_parameter *parameter = member;

	parameter->stop_count = 0;
	while (!character_at_end(words)) {
		float *stop = &parameter->stop[parameter->stop_count];

		if (parameter->stop_count == CHARACTER_STOPS_MAX ||
			!character_take_number(words, stop) ||
			(parameter->stop_count > 0 && *stop <= stop[-1])) {
			return character_fail(words,
				"give at most %d increasing numbers, such as %s",
				CHARACTER_STOPS_MAX, key->right);
		}
		parameter->stop_count++;
	}
	return 0;
}

static const struct character_key keys[] = {
	{"choices", read_choices,
		.right = "two or more names, such as arm forearm hand"},
	{"range", character_read_numbers2,
		offsetof(struct character_parameter, range),
		.right = "the lowest and the highest value, such as 0 2.6"},
	{"start", character_read_number,
		offsetof(struct character_parameter, start),
		.right = "a number in the range"},
	{"ease", character_read_number,
		offsetof(struct character_parameter, ease_s), 0, 60,
		.right = "seconds from 0 to 60"},
	{"stops", read_stops, .right = "0 1.03 2.6"},
	{"label", character_read_unlabelled,
		offsetof(struct character_parameter, unlabelled),
		.right = "yes or no"},
	{"source", read_source,
		.right = "buttons, motion, time [SCALE [OFFSET]], sine PERIOD [PHASE], PARAMETER [SCALE [OFFSET]] or part PART FREEDOM [SCALE [OFFSET]]"},
	{0},
};

/* The range of choices is that of their numbers. */
static bool has_other_range(const struct character_parameter *parameter)
{
	return parameter->choice &&
		(parameter->range[0] != 0 ||
			parameter->range[1] !=
				(float)(parameter->choice_count - 1));
}

static int read_one(struct character_build *build,
	const struct character_section *section,
	struct character_parameter *parameter)
{
	int error = character_read_section(build, section, keys, parameter);

	if (!error && !(parameter->range[0] < parameter->range[1])) {
		return character_fail_section(build, section,
			"range: the second number has to be larger than the first");
	}
	if (!error && has_other_range(parameter)) {
		return character_fail_section(build, section,
			"range: choices have a range of their own: remove the range");
	}
	if (parameter->start == not_given) {
		parameter->start = scalar_clamp(
			0, parameter->range[0], parameter->range[1]);
	}
	if (!error &&
		(parameter->start < parameter->range[0] ||
			parameter->start > parameter->range[1])) {
		return character_fail_section(build, section,
			"start: %g is outside the range %g to %g",
			(double)parameter->start, (double)parameter->range[0],
			(double)parameter->range[1]);
	}
	for (int i = 0; !error && i < parameter->stop_count; i++) {
		if (parameter->stop[i] < parameter->range[0] ||
			parameter->stop[i] > parameter->range[1]) {
			return character_fail_section(build, section,
				"stops: %g is outside the range %g to %g",
				(double)parameter->stop[i],
				(double)parameter->range[0],
				(double)parameter->range[1]);
		}
	}
	parameter->value = parameter->goal = parameter->from = parameter->start;
	parameter->last_goal = parameter->start;
	return error;
}

int character_build_parameters(struct character_build *build)
{
	struct character *character = build->character;
	const struct character_section *section;
	int error = 0, count = 0;

	character->parameter_count =
		character_text_count(build->text, "parameter");
	character->parameter = ARENA_ARRAY(build->arena,
		struct character_parameter, (size_t)character->parameter_count);
	if (!character->parameter) {
		return character_fail_memory(build);
	}
	section = character_text_find(build->text->first, "parameter");
	for (const struct character_section *one = section; one;
		one = character_text_find(one->next, "parameter")) {
		character->parameter[count++] = (struct character_parameter){
			.name = one->name,
			.range = {0, 1},
			.start = not_given,
		};
	}
	for (int i = 0; section && !error; i++) {
		error = read_one(build, section, &character->parameter[i]);
		section = character_text_find(section->next, "parameter");
	}
	return error;
}
