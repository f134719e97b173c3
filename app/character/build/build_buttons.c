/*
 * Sections [buttons]: each line binds actions to a gesture of one or two
 * buttons.
 */
#include "app/character/build/build.h"

#include "app/scene/hud/hud_name.h"

#include <errno.h>
#include <string.h>

/* "UP", "UP long", "UP+DOWN" as libinih gives it: the key without "=". */
static int read_buttons(struct character_words *words,
	struct character_binding *binding, const char **gesture)
{
	char name[32];
	const char *key = words->line->key;
	const char *behind = key + strcspn(key, " \t+");
	bool together = *behind == '+';

	snprintf(name, sizeof(name), "%.*s", (int)(behind - key), key);
	binding->button = button_from_name(name);
	binding->second = BUTTON_COUNT;
	*gesture = behind + strspn(behind, " \t");
	if (together) {
		binding->second = button_from_name(behind + 1);
		binding->gesture = CHARACTER_TOGETHER;
	}
	if (binding->button == BUTTON_COUNT ||
		(together &&
			(binding->second == BUTTON_COUNT ||
				binding->second == binding->button))) {
		return character_fail(words,
			"this is no button: use UP, DOWN, LEFT, RIGHT, ENTER, F6, F8, F9 or F10, perhaps with \" hold\", \" long\" or \" release\" behind it, or two such as UP+DOWN");
	}
	return 0;
}

/* limber itself uses F9 while it is held. */
static int check_f9(
	struct character_words *words, const struct character_binding *binding)
{
	return binding->gesture != CHARACTER_PRESS && binding->button == BUTTON_F9
		? character_fail(words,
			  "limber uses F9 while it is held: choose another button")
		: 0;
}

static int read_gesture(struct character_words *words,
	struct character_binding *binding, const char *gesture)
{
	static const char *const names[] = {
		[CHARACTER_PRESS] = "",
		[CHARACTER_RELEASE] = "release",
		[CHARACTER_HOLD] = "hold",
		[CHARACTER_LONG] = "long",
		NULL,
	};

	for (int i = 0; names[i]; i++) {
		if (strcmp(gesture, names[i]) == 0) {
			binding->gesture = (enum character_gesture)i;
			return 0;
		}
	}
	return character_fail(
		words, "%s is not one of hold, long and release", gesture);
}

static int check_together(
	struct character_words *words, const struct character_binding *binding)
{
	return binding->button == BUTTON_F9 || binding->second == BUTTON_F9
		? character_fail(words,
			  "limber uses F9 together with others: choose another button")
		: 0;
}

/* Adds the action that undoes one which lasts while a button is held. */
static int add_after(struct character_words *words,
	const struct character_action *action, struct character_action **after)
{
	struct character *character = words->build->character;
	struct character_action *one;

	if (action->verb != CHARACTER_SET && action->verb != CHARACTER_SWITCH) {
		return 0;
	}
	one = ARENA_NEW(words->build->arena, struct character_action);
	if (!one) {
		return character_fail_memory(words->build);
	}
	*one = *action;
	one->amount = action->verb == CHARACTER_SET
		? character->parameter[action->index].start
		: action->amount > 0 ? 0
				     : 1;
	one->next = *after;
	*after = one;
	return 0;
}

/* The first words of the line as the file has them, for people. */
static const char *make_label(struct character_words *words, int count)
{
	char text[256] = "";
	size_t used = 0;

	for (int i = 0; i < count; i++) {
		const char *word = words->line->word[i].text;
		int length = snprintf(text + used, sizeof(text) - used, "%s%s",
			used && *word != ',' ? " " : "", word);

		if (length < 0 || (size_t)length >= sizeof(text) - used) {
			break;
		}
		used += (size_t)length;
	}
	return arena_strdup(words->build->arena, text);
}

/*
 * Finds what pictures show of the label, and says so of the first one that they
 * cannot show.
 */
static int find_shown(struct character_words *words,
	struct character_binding *binding, int action_words)
{
	const struct character_build *build = words->build;
	const struct character_binding *one = build->character->binding;
	char number[HUD_NAME_BYTES];
	const char *label = binding->label;
	bool first = true;
	int count = 1;

	for (; one; one = one->next) {
		first = first && one->shown == one->label;
		count++;
	}
	binding->shown = label;
	if (hud_is_readable(label)) {
		return 0;
	}
	label = make_label(words, action_words);
	binding->shown = label
		? arena_strdup(build->arena,
			  hud_name(label, "action", count, number))
		: NULL;
	if (!binding->shown) {
		return character_fail_memory(build);
	}
	if (first && build->text->is_file) {
		log_warning(build->log,
			"%s:%d: the font of pictures has no letters for \"%s\", so labels show \"%s\": write it in Latin letters",
			words->line->file, words->line->number, binding->label,
			binding->shown);
	}
	return 0;
}

/* Returns true if an action moves something as long as the button is down. */
static bool moves(const struct character_action *action)
{
	while (action && action->verb != CHARACTER_MOVE &&
		action->verb != CHARACTER_TURN &&
		action->verb != CHARACTER_TILT &&
		action->verb != CHARACTER_ZOOM) {
		action = action->next;
	}
	return action;
}

/* What moves something acts as long as the button is held, as do others then. */
static int check_hold(struct character_words *words,
	struct character_binding *binding,
	const struct character_action *action, bool all_held)
{
	if (binding->gesture == CHARACTER_PRESS && moves(action)) {
		binding->gesture = CHARACTER_HOLD;
	}
	if (binding->gesture == CHARACTER_HOLD && !all_held) {
		return character_fail(words,
			"an action here would run in every frame while the button is held: with hold, move or camera give only set, add, on, off, stop, move and camera");
	}
	return check_f9(words, binding);
}

/*
 * Adds actions with commas between; *all_held becomes false if one of them may
 * not be held.
 */
static int read_actions(struct character_words *words,
	struct character_action **action, bool *all_held)
{
	int error;

	do {
		bool is_held = false;

		error = character_read_action(words, action, &is_held);
		*all_held = *all_held && is_held;
	} while (!error && character_take(words, ","));
	return error;
}

/* Takes the label from the end of the line, or makes one of the actions. */
static int read_label(
	struct character_words *words, struct character_binding *binding)
{
	int action_words = words->next, error;

	if (!character_at_end(words) && words->line->word[words->next].quoted) {
		binding->label = character_next_word(words);
	} else {
		binding->label = make_label(words, words->line->word_count);
	}
	if (!binding->label) {
		return character_fail_memory(words->build);
	}
	error = find_shown(words, binding, action_words);
	if (!error && !character_at_end(words)) {
		error = character_fail(words,
			"%s is too much: give actions with commas between and what they do in quotes",
			words->line->word[words->next].text);
	}
	return error;
}

/* BUTTON = ACTION, ACTION ... ["what it does"] */
static int read_binding(
	struct character_words *words, struct character_binding *binding)
{
	struct character_action *action = NULL, *after = NULL;
	const char *gesture;
	bool all_held = true;
	int error = read_buttons(words, binding, &gesture);

	if (!error) {
		error = binding->gesture == CHARACTER_TOGETHER
			? check_together(words, binding)
			: read_gesture(words, binding, gesture);
	}
	if (!error) {
		error = read_actions(words, &action, &all_held);
	}
	if (!error) {
		error = read_label(words, binding);
	}
	if (!error) {
		error = check_hold(words, binding, action, all_held);
	}
	if (error) {
		return error;
	}
	binding->action = action;
	for (; action && binding->gesture == CHARACTER_HOLD && !error;
		action = action->next) {
		error = add_after(words, action, &after);
	}
	binding->after = after;
	return error;
}

static void note(
	struct character *character, const struct character_binding *binding)
{
	struct character_button *button = &character->button[binding->button];

	button->has_long |= binding->gesture == CHARACTER_LONG;
	if (binding->gesture == CHARACTER_TOGETHER) {
		button->joins = true;
		character->button[binding->second].joins = true;
	}
}

/* What a section says about all of its buttons. */
struct common {
	struct character_condition *when;
	bool unlabelled;
};

static const struct character_key common_keys[] = {
	{"when", character_read_condition, offsetof(struct common, when),
		.right = "a comparison: chosen is 1, speed > 2 or speed < 1"},
	{"label", character_read_unlabelled,
		offsetof(struct common, unlabelled), .right = "yes or no"},
	{0},
};

static const struct character_key *find_common(const struct character_line *line)
{
	const struct character_key *key = common_keys;

	while (key->name && strcmp(line->key, key->name) != 0) {
		key++;
	}
	return key->name ? key : NULL;
}

static int read_common(struct character_build *build,
	const struct character_section *section, struct common *common)
{
	int error = 0;

	for (const struct character_line *line = section->first; line && !error;
		line = line->next) {
		struct character_words words = {build, line, 0};
		const struct character_key *key = find_common(line);

		if (key) {
			error = key->read(
				&words, key, (char *)common + key->member);
			if (!error && !character_at_end(&words)) {
				error = character_fail_value(&words, key);
			}
		}
	}
	return error;
}

/* Returns true if a later line of an including file has the same key. */
static bool is_replaced(const struct character_line *line)
{
	const struct character_line *later = line->next;

	while (later && strcmp(later->key, line->key) != 0) {
		later = later->next;
	}
	return later;
}

static bool is_same_gesture(
	const struct character_binding *a, const struct character_binding *b)
{
	bool same = a->button == b->button && a->second == b->second;
	bool crossed = a->button == b->second && a->second == b->button;

	return a->gesture == b->gesture && (same || crossed);
}

/*
 * Refuses a second line for a gesture: where neither depends on a condition,
 * both would act, which nobody wants to say in two places.
 */
static int check_gesture(
	struct character_words *words, const struct character_binding *binding)
{
	const struct character_binding *one = words->build->character->binding;

	while (one &&
		(one->when || binding->when || !is_same_gesture(one, binding))) {
		one = one->next;
	}
	return one
		? character_fail(words,
			  "%s:%d gives the same buttons something to do: write both actions in one line, or give a section a line when",
			  one->line->file, one->line->number)
		: 0;
}

static int build_section(struct character_build *build,
	const struct character_section *section,
	struct character_binding ***last)
{
	struct common common = {0};
	int error = read_common(build, section, &common);

	for (const struct character_line *line = section->first; line && !error;
		line = line->next) {
		struct character_words words = {build, line, 0};
		struct character_binding *binding;

		if (find_common(line)) {
			continue;
		}
		error = character_check_once(section, &words);
		if (error || is_replaced(line)) {
			continue;
		}
		binding = ARENA_NEW(build->arena, struct character_binding);
		if (!binding) {
			return character_fail_memory(build);
		}
		error = read_binding(&words, binding);
		if (!error) {
			binding->when = common.when;
			binding->unlabelled = common.unlabelled;
			binding->line = line;
			error = check_gesture(&words, binding);
		}
		if (!error) {
			note(build->character, binding);
			**last = binding;
			*last = &binding->next;
		}
	}
	return error;
}

int character_build_buttons(struct character_build *build)
{
	const struct character_section *section =
		character_text_find(build->text->first, "buttons");
	struct character_binding **last = &build->character->binding;
	int error = 0;

	while (section && !error) {
		error = build_section(build, section, &last);
		section = character_text_find(section->next, "buttons");
	}
	return error;
}
