/*
 * Reads sections by tables of their keys, takes words and numbers from lines,
 * and logs what is wrong with them.
 */
#include "app/anim/math/vec.h"
#include "app/character/build/build.h"
#include "platform/base/name_list.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

int character_fail(const struct character_words *words, const char *format, ...)
{
	const struct character_line *line = words->line;
	char sentence[768];
	va_list arguments;

	va_start(arguments, format);
	vsnprintf(sentence, sizeof(sentence), format, arguments);
	va_end(arguments);
	log_error(words->build->log, "%s:%d: [%s] %s: %s", line->file,
		line->number, line->section, line->key, sentence);
	return -EINVAL;
}

int character_fail_memory(const struct character_build *build)
{
	return memory_budget_fail(
		build->arena->budget, build->text->file[0], build->log);
}

int character_fail_section(struct character_build *build,
	const struct character_section *section, const char *format, ...)
{
	char sentence[768];
	va_list arguments;

	va_start(arguments, format);
	vsnprintf(sentence, sizeof(sentence), format, arguments);
	va_end(arguments);
	log_error(build->log, "%s:%d: [%s]: %s", section->file, section->number,
		section->heading, sentence);
	return -EINVAL;
}

int character_fail_missing(struct character_build *build,
	const struct character_section *section, const char *what)
{
	return character_fail_section(
		build, section, "a line is missing: add %s", what);
}

static int fail_key(
	struct character_words *words, const struct character_key *keys)
{
	struct name_list list = {""};

	for (; keys->name; keys++) {
		name_list_add(&list, keys->name);
	}
	return character_fail(words,
		"there is no such key in this section: use one of %s",
		list.text);
}

/* Returns true for keys whose lines add to each other. */
static bool may_repeat(const struct character_key *key)
{
	static const char *const names[] = {"body", "bone", "curve",
		"direction", "else", "enter", "event", "guard", "key", "leave",
		"mask", "step", "targets", "then", "top", "tour", "when"};

	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		if (strcmp(names[i], key->name) == 0) {
			return true;
		}
	}
	return false;
}

/*
 * Returns the earlier line of the same file that has the same key, or NULL. A
 * line of another file is no error: it replaces what the included file says.
 */
static const struct character_line *find_twin(
	const struct character_section *section,
	const struct character_line *line)
{
	for (const struct character_line *one = section->first; one != line;
		one = one->next) {
		if (strcmp(one->key, line->key) == 0 && one->file == line->file) {
			return one;
		}
	}
	return NULL;
}

int character_check_once(
	const struct character_section *section, struct character_words *words)
{
	const struct character_line *twin = find_twin(section, words->line);

	return twin ? character_fail(words,
			      "line %d says this already: remove one of both",
			      twin->number)
		    : 0;
}

static int read_line(const struct character_section *section,
	struct character_words *words, const struct character_key *keys,
	void *out)
{
	const struct character_key *key = keys;
	int error = 0;

	while (key->name && strcmp(key->name, words->line->key) != 0) {
		key++;
	}
	if (!key->name) {
		return fail_key(words, keys);
	}
	if (!may_repeat(key)) {
		error = character_check_once(section, words);
	}
	if (error) {
		return error;
	}
	if (words->line->word_count == 0) {
		return character_fail(
			words, "the value is missing: give %s", key->right);
	}
	error = key->read(words, key, (char *)out + key->member);
	if (!error && !character_at_end(words)) {
		return character_fail(words, "%s is too much: give %s",
			words->line->word[words->next].text, key->right);
	}
	return error;
}

int character_read_section(struct character_build *build,
	const struct character_section *section,
	const struct character_key *keys, void *out)
{
	int error = 0;

	for (const struct character_line *line = section->first; line && !error;
		line = line->next) {
		struct character_words words = {build, line, 0};

		error = read_line(section, &words, keys, out);
	}
	return error;
}

bool character_at_end(const struct character_words *words)
{
	return words->next >= words->line->word_count;
}

bool character_next_is(const struct character_words *words, const char *word)
{
	return !character_at_end(words) &&
		!words->line->word[words->next].quoted &&
		strcmp(words->line->word[words->next].text, word) == 0;
}

bool character_take(struct character_words *words, const char *word)
{
	bool is = character_next_is(words, word);

	words->next += is;
	return is;
}

const char *character_next_word(struct character_words *words)
{
	if (character_at_end(words) || character_next_is(words, ",")) {
		return NULL;
	}
	return words->line->word[words->next++].text;
}

bool character_take_number(struct character_words *words, float *out)
{
	const char *text;
	char *end;
	double value;

	if (character_at_end(words) || words->line->word[words->next].quoted) {
		return false;
	}
	text = words->line->word[words->next].text;
	value = strtod(text, &end);
	if (end == text || *end || !(value >= -1e9 && value <= 1e9)) {
		return false;
	}
	*out = (float)value;
	words->next++;
	return true;
}

bool character_take_within(
	struct character_words *words, float low, float high, float *out)
{
	if (!character_take_number(words, out)) {
		return false;
	}
	if (*out < low || *out > high) {
		words->next--;
		return false;
	}
	return true;
}

int character_fail_value(
	const struct character_words *words, const struct character_key *key)
{
	return character_fail(words, "%s%s: give %s",
		character_at_end(words) ? "a word is missing"
					: words->line->word[words->next].text,
		character_at_end(words) ? "" : " is not right here", key->right);
}

static int read_numbers(struct character_words *words,
	const struct character_key *key, int count, float *out)
{
	for (int i = 0; i < count; i++) {
		if (!character_take_number(words, &out[i])) {
			return character_fail_value(words, key);
		}
		if (key->low < key->high &&
			(out[i] < key->low || out[i] > key->high)) {
			words->next--;
			return character_fail_value(words, key);
		}
	}
	return 0;
}

int character_read_number(struct character_words *words,
	const struct character_key *key, void *member)
{
	return read_numbers(words, key, 1, member);
}

int character_read_numbers2(struct character_words *words,
	const struct character_key *key, void *member)
{
	return read_numbers(words, key, 2, member);
}

int character_read_numbers3(struct character_words *words,
	const struct character_key *key, void *member)
{
	return read_numbers(words, key, 3, member);
}

int character_read_angle(struct character_words *words,
	const struct character_key *key, void *member)
{
	float *angle = member;
	int error = read_numbers(words, key, 1, angle);

	*angle *= SCALAR_PI / 180;
	return error;
}

int character_read_direction(struct character_words *words,
	const struct character_key *key, void *member)
{
	int error = read_numbers(words, key, 3, member);

	if (!error && vec_normalize(member) == 0) {
		return character_fail(words,
			"a direction must not be 0 0 0: give %s", key->right);
	}
	return error;
}

int character_read_count(struct character_words *words,
	const struct character_key *key, void *member)
{
	float value = 0;
	int error = read_numbers(words, key, 1, &value);

	*(int *)member = (int)value;
	if (!error && (float)*(int *)member != value) {
		return character_fail(
			words, "%g is no whole number", (double)value);
	}
	return error;
}

int character_read_switch(struct character_words *words,
	const struct character_key *key, void *member)
{
	bool yes = character_take(words, "yes");

	*(bool *)member = yes;
	return yes || character_take(words, "no")
		? 0
		: character_fail_value(words, key);
}

/* label = yes or no; the member becomes true for no. */
int character_read_unlabelled(struct character_words *words,
	const struct character_key *key, void *member)
{
	bool labelled = true;
	int error = character_read_switch(words, key, &labelled);

	*(bool *)member = !labelled;
	return error;
}

int character_read_choice(struct character_words *words,
	const struct character_key *key, void *member)
{
	for (int i = 0; key->choice[i]; i++) {
		if (character_take(words, key->choice[i])) {
			*(int *)member = i;
			return 0;
		}
	}
	return character_fail_value(words, key);
}

int character_read_kind(struct character_build *build,
	const struct character_kind *kind, int *count, void *array)
{
	const struct character_section *section =
		character_text_find(build->text->first, kind->name);
	int sections = character_text_count(build->text, kind->name);
	char *one = arena_alloc(build->arena, (size_t)sections, kind->size);
	int error = 0;

	if (!one) {
		return character_fail_memory(build);
	}
	*count = sections;
	memcpy(array, &one, sizeof(one));
	for (; section && !error; one += kind->size) {
		error = kind->read(build, section, one);
		section = character_text_find(section->next, kind->name);
	}
	return error;
}
