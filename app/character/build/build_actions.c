/*
 * Reads actions, such as "add speed 0.5", by a table of their verbs.
 */
#include "app/character/build/build.h"

#include "app/character/run/effects.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* How the words after a verb are read. */
struct verb {
	const char *name;
	enum character_verb verb;
	int (*read)(struct character_words *words,
		struct character_action *action, const struct verb *verb);
	const char *kind; /* of the section that the action is about */
	bool held;        /* may run in each frame while a button is held */
	const char *right;
};

static int fail_action(struct character_words *words, const struct verb *verb)
{
	return character_fail(words, "%s: write %s", verb->name, verb->right);
}

static int read_plain(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	(void)words;
	(void)action;
	(void)verb;
	return 0;
}

static int read_name(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	if (character_at_end(words)) {
		return fail_action(words, verb);
	}
	action->index = character_name_section(words, verb->kind);
	return action->index < 0 ? -EINVAL : 0;
}

static int read_name_and_number(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);

	if (!error && !character_take_number(words, &action->amount)) {
		return fail_action(words, verb);
	}
	return error;
}

/* "set PARAMETER NUMBER", or the name of a choice, whose range is 0 and up. */
static int read_set(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);
	const struct character_parameter *parameter;

	if (error) {
		return error;
	}
	parameter = &words->build->character->parameter[action->index];
	if (character_take_choice(words, parameter, &action->amount)) {
		return 0;
	}
	if (!character_take_number(words, &action->amount)) {
		return fail_action(words, verb);
	}
	if (action->amount < parameter->range[0] ||
		action->amount > parameter->range[1]) {
		return character_fail(words,
			"set: %g is outside the range %g to %g of %s",
			(double)action->amount, (double)parameter->range[0],
			(double)parameter->range[1], parameter->name);
	}
	return 0;
}

static int read_stops(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name_and_number(words, action, verb);
	const struct character *character = words->build->character;

	if (!error &&
		(action->amount != (float)(int)action->amount ||
			character->parameter[action->index].stop_count == 0)) {
		return fail_action(words, verb);
	}
	return error;
}

/* "toggle NAME" is about a parameter, or about a layer or effect. */
static int read_toggle(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	const struct character_build *build = words->build;
	const char *name;
	int found;

	if (character_at_end(words)) {
		return fail_action(words, verb);
	}
	name = words->line->word[words->next].text;
	found = character_find_switch(build, name);
	if (found < 0) {
		return read_name(words, action, verb);
	}
	words->next++;
	action->verb = CHARACTER_SWITCH;
	action->index = found;
	action->amount = -1;
	return 0;
}

static int read_switch(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	const char *name = character_next_word(words);

	action->index = name ? character_find_switch(words->build, name) : -1;
	action->amount = verb->name[1] == 'n' ? 1 : 0;
	if (action->index < 0) {
		return character_fail(words,
			"there is no layer, expression or effect named %s: write %s",
			name ? name : "\"\"", verb->right);
	}
	return 0;
}

static int read_step(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	(void)words;
	action->amount = verb->name[0] == 'n' ? 1 : -1;
	return 0;
}

static int read_morph(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);
	const struct character_morph *morph;
	const char *key;

	if (error) {
		return error;
	}
	action->detail = -1;
	morph = &words->build->character->morph[action->index];
	if (character_take(words, "next") || character_take(words, "previous")) {
		action->amount =
			words->line->word[words->next - 1].text[0] == 'n' ? 1
									  : -1;
		return 0;
	}
	key = character_next_word(words);
	for (int i = 0; key && i < morph->key_count; i++) {
		if (strcmp(morph->key_name[i], key) == 0) {
			action->detail = i;
			return 0;
		}
	}
	return character_fail(words,
		"%s is no key frame of the morph %s: write %s",
		key ? key : "\"\"", morph->name, verb->right);
}

/* Presets of the file that the shake's section names. */
static int read_preset(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);
	const struct character_shake *shake;
	const char *name;

	if (error) {
		return error;
	}
	shake = words->build->character->shake[action->index];
	action->detail = -1;
	action->amount = character_take(words, "next") ? 1
		: character_take(words, "previous")    ? -1
						       : 0;
	if (action->amount != 0) {
		return shake->preset_count > 0 ? 0 : fail_action(words, verb);
	}
	name = character_next_word(words);
	action->detail = !name ? -1
			       : procedural_preset_find(shake->preset,
					 shake->preset_count, name);
	return action->detail >= 0
		? 0
		: character_fail(words,
			  "%s is no preset of the shake %s: write %s",
			  name ? name : "\"\"", shake->is.name, verb->right);
}

static const char *const freedom_names[CHARACTER_FREEDOMS] = {
	"heading", "pitch", "bank", "x", "y", "z"};

static int read_move(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);
	const char *freedom = error ? NULL : character_next_word(words);

	for (int i = 0; freedom && i < CHARACTER_FREEDOMS; i++) {
		if (strcmp(freedom, freedom_names[i]) == 0) {
			action->detail = i;
			if (!words->build->character->part[action->index]
					.freedom[i]
					.given) {
				return character_fail(words,
					"the part has no %s: give its section a line \"%s = START LOW HIGH SPEED\"",
					freedom, freedom);
			}
			return character_take_number(words, &action->amount)
				? 0
				: fail_action(words, verb);
		}
	}
	return error ? error : fail_action(words, verb);
}

/* The node that is to hold a part, which must not move with the part itself. */
static int read_holder(
	struct character_words *words, struct character_action *action)
{
	const struct character_build *build = words->build;
	const struct character_part *part =
		&build->character->part[action->index];

	action->detail = character_name_node(words);
	if (action->detail < 0) {
		return -EINVAL;
	}
	return model_is_below(build->model, action->detail, part->node)
		? character_fail(words,
			  "%s moves with the part %s: name another node",
			  build->model->node[action->detail].name, part->name)
		: 0;
}

static int read_attach(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);

	if (error) {
		return error;
	}
	action->detail = -1;
	if (verb->name[0] == 'a') {
		error = read_holder(words, action);
		if (error) {
			return error;
		}
		if (character_take_number(words, &action->amount) &&
			character_take_number(words, &action->place[0])) {
			action->has_place = true;
			return character_take_number(words, &action->place[1]) &&
					character_take_number(
						words, &action->place[2])
				? 0
				: fail_action(words, verb);
		}
	}
	return 0;
}

/* drop PART [NODE] */
static int read_drop(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);

	action->detail = -1;
	if (!error && !character_at_end(words) &&
		!character_next_is(words, ",") &&
		!words->line->word[words->next].quoted) {
		error = read_holder(words, action);
	}
	return error;
}

static int read_line(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	action->text = character_next_word(words);
	return action->text ? 0 : fail_action(words, verb);
}

static int read_output(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	int error = read_name(words, action, verb);

	if (error) {
		return error;
	}
	if (character_take(words, "on") || character_take(words, "off")) {
		action->amount =
			words->line->word[words->next - 1].text[1] == 'n' ? -1
									  : 0;
		return 0;
	}
	return character_take_number(words, &action->amount) && action->amount > 0
		? 0
		: fail_action(words, verb);
}

static int read_camera(struct character_words *words,
	struct character_action *action, const struct verb *verb)
{
	static const struct {
		const char *name;
		enum character_verb verb;
		float factor;
	} moves[] = {
		{"turn", CHARACTER_TURN, SCALAR_PI / 180},
		{"tilt", CHARACTER_TILT, SCALAR_PI / 180},
		{"zoom", CHARACTER_ZOOM, 0.01f},
	};

	for (size_t i = 0; i < ARRAY_COUNT(moves); i++) {
		if (character_take(words, moves[i].name) &&
			character_take_number(words, &action->amount)) {
			action->verb = moves[i].verb;
			action->amount *= moves[i].factor;
			return 0;
		}
	}
	return fail_action(words, verb);
}

static const struct verb verbs[] = {
	{"set", CHARACTER_SET, read_set, "parameter", true,
		"set PARAMETER NUMBER"},
	{"add", CHARACTER_ADD, read_name_and_number, "parameter", true,
		"add PARAMETER NUMBER"},
	{"step", CHARACTER_STEP, read_stops, "parameter", false,
		"step PARAMETER COUNT, and give the parameter stops"},
	{"toggle", CHARACTER_TOGGLE, read_toggle, "parameter", false,
		"toggle NAME, with the name of a parameter, a layer or an effect"},
	{"on", CHARACTER_SWITCH, read_switch, NULL, true, "on NAME"},
	{"off", CHARACTER_SWITCH, read_switch, NULL, true, "off NAME"},
	{"go", CHARACTER_GO, read_name, "state", false, "go STATE"},
	{"next", CHARACTER_NEXT, read_step, NULL, false, "next"},
	{"previous", CHARACTER_NEXT, read_step, NULL, false, "previous"},
	{"row", CHARACTER_ROW, read_plain, NULL, false, "row"},
	{"play", CHARACTER_PLAY, read_name, "layer", false, "play LAYER"},
	{"morph", CHARACTER_MORPH, read_morph, "morph", false,
		"morph NAME KEY, morph NAME next or morph NAME previous"},
	{"pace", CHARACTER_PACE, read_name_and_number, "morph", false,
		"pace MORPH FACTOR"},
	{"curve", CHARACTER_CURVE, read_name, "morph", false, "curve MORPH"},
	{"timing", CHARACTER_TIMING, read_name, "morph", false, "timing MORPH"},
	{"preset", CHARACTER_PRESET, read_preset, "shake", false,
		"preset SHAKE NAME, preset SHAKE next or preset SHAKE previous"},
	{"move", CHARACTER_MOVE, read_move, "part", true,
		"move PART heading|pitch|bank|x|y|z FACTOR, such as move Arm pitch -1"},
	{"run", CHARACTER_RUN, read_name, "sequence", false, "run SEQUENCE"},
	{"repeat", CHARACTER_REPEAT, read_name, "sequence", false,
		"repeat SEQUENCE"},
	{"stop", CHARACTER_STOP, read_name, "sequence", true, "stop SEQUENCE"},
	{"attach", CHARACTER_ATTACH, read_attach, "part", false,
		"attach PART NODE, or attach PART NODE METRES [X Y Z] for a part that is near"},
	{"detach", CHARACTER_ATTACH, read_attach, "part", false, "detach PART"},
	{"drop", CHARACTER_DROP, read_drop, "part", false,
		"drop PART, or drop PART NODE to let it lie on that too"},
	{"line", CHARACTER_LINE, read_line, NULL, false, "line TEXT"},
	{"output", CHARACTER_OUTPUT, read_output, "output", false,
		"output NAME on, output NAME off or output NAME MILLISECONDS"},
	{"camera", CHARACTER_TURN, read_camera, NULL, true,
		"camera turn|tilt|zoom NUMBER, in degrees or percent a second"},
	{"pause", CHARACTER_PAUSE, read_plain, NULL, false, "pause"},
	{"tour", CHARACTER_TOUR, read_plain, NULL, false, "tour"},
	{"keys", CHARACTER_KEYS, read_plain, NULL, false, "keys"},
	{"labels", CHARACTER_LABELS, read_plain, NULL, false, "labels"},
};

static const struct verb *find_verb(const char *name)
{
	for (size_t i = 0; name && i < ARRAY_COUNT(verbs); i++) {
		if (strcmp(verbs[i].name, name) == 0) {
			return &verbs[i];
		}
	}
	return NULL;
}

static int append(struct character_words *words, struct character_action **list,
	const struct character_action *action)
{
	while (*list) {
		list = &(*list)->next;
	}
	*list = ARENA_NEW(words->build->arena, struct character_action);
	if (!*list) {
		return character_fail_memory(words->build);
	}
	**list = *action;
	return 0;
}

int character_read_action(struct character_words *words,
	struct character_action **list, bool *is_held)
{
	const char *name = character_next_word(words);
	const struct verb *verb = find_verb(name);
	struct character_action action = {0};
	int error;

	if (!verb) {
		return character_fail(words,
			"%s is no action: use set, add, step, toggle, on, off, go, next, previous, row, play, morph, pace, curve, timing, preset, move, run, repeat, stop, attach, detach, drop, line, output, camera, pause, tour, keys or labels",
			name ? name : "\"\"");
	}
	action.verb = verb->verb;
	if (is_held) {
		*is_held = verb->held;
	}
	error = verb->read(words, &action, verb);
	return error ? error : append(words, list, &action);
}

int character_read_actions(struct character_words *words,
	const struct character_key *key, void *member)
{
	int error;

	(void)key;
	do {
		error = character_read_action(words, member, NULL);
	} while (!error && character_take(words, ","));
	return error;
}
