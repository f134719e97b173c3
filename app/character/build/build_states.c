/*
 * Sections [state] and [transition], and the comparisons of "when".
 */
#include "app/character/build/build.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	ENTRIES_MAX = 16
};

void character_init_entry(const struct character_build *build, int clip,
	struct character_entry *entry)
{
	const struct character *character = build->character;

	*entry = (struct character_entry){
		.of = &character->clip[clip < 0 ? character->clip_count - 1 : clip],
		.shown_s = -1,
	};
}

struct clip_cursor *character_make_cursors(
	struct character_build *build, int count)
{
	struct clip_cursor *cursor =
		ARENA_ARRAY(build->arena, struct clip_cursor, (size_t)count);
	int error = cursor ? 0 : -ENOMEM;

	for (int i = 0; i < count && !error; i++) {
		error = clip_cursor_init(&cursor[i], build->model, build->arena);
	}
	if (error) {
		character_fail_memory(build);
		return NULL;
	}
	return cursor;
}

static int read_clip(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_state *state = member;
	int clip = character_name_clip(words);

	(void)key;
	if (clip == -1) {
		return -EINVAL;
	}
	state->entry_count = 1;
	state->entry = ARENA_NEW(words->build->arena, struct character_entry);
	if (!state->entry) {
		return character_fail_memory(words->build);
	}
	character_init_entry(words->build, clip, state->entry);
	return 0;
}

/* Inserts an entry behind those at lower values. */
static int add_entry(struct character_words *words,
	struct character_state *state, int clip, float at)
{
	int index = state->entry_count++;

	for (; index > 0 && state->entry[index - 1].at > at; index--) {
		state->entry[index] = state->entry[index - 1];
	}
	if (index > 0 && state->entry[index - 1].at == at) {
		return character_fail(words,
			"two clips are at %g: give each clip a value of its own",
			(double)at);
	}
	character_init_entry(words->build, clip, &state->entry[index]);
	state->entry[index].at = at;
	return 0;
}

/* blend = PARAMETER, CLIP AT, CLIP AT ... */
static int read_blend(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_state *state = member;
	int error = character_read_value(words, key, &state->position);

	state->entry_count = 0;
	state->entry = ARENA_ARRAY(words->build->arena, struct character_entry,
		(size_t)ENTRIES_MAX);
	if (!state->entry) {
		return character_fail_memory(words->build);
	}
	while (!error && character_take(words, ",")) {
		int clip = character_name_clip(words);
		float at;

		if (clip == -1) {
			return -EINVAL;
		}
		if (!character_take_number(words, &at)) {
			return character_fail(words,
				"each clip has the value at which it plays: give %s",
				key->right);
		}
		if (state->entry_count == ENTRIES_MAX) {
			return character_fail(words,
				"a blend has at most %d clips", ENTRIES_MAX);
		}
		error = add_entry(words, state, clip, at);
	}
	if (!error && state->entry_count < 2) {
		return character_fail(words,
			"a blend has at least two clips: give %s", key->right);
	}
	return error;
}

static const char *const repeats[] = {"once", "loop", "ping-pong", NULL};

static const struct character_key keys[] = {
	{"clip", read_clip, .right = "the name of a clip"},
	{"blend", read_blend,
		.right = "PARAMETER, CLIP VALUE, CLIP VALUE, such as speed, idle 0, walk 1.03"},
	{"rate", character_read_value, offsetof(struct character_state, rate),
		-100, 100, .right = "a number from -100 to 100, or a parameter"},
	{"repeat", character_read_choice,
		offsetof(struct character_state, repeat), .choice = repeats,
		.right = "loop, once or ping-pong"},
	{"next", character_read_state, offsetof(struct character_state, next),
		.right = "the name of a state"},
	{"pause", character_read_number,
		offsetof(struct character_state, pause_s), 0, 3600,
		.right = "seconds from 0 to 3600, before the next state"},
	{"fade", character_read_fade, offsetof(struct character_state, fade),
		.right = "0.3 or 4 frames, and smooth, linear or cubic"},
	{"enter", character_read_actions, offsetof(struct character_state, enter),
		.right = "actions, such as line hello"},
	{"leave", character_read_actions, offsetof(struct character_state, leave),
		.right = "actions, such as line bye"},
	{0},
};

/* An index in repeats[] is stored in character_state.repeat. */
_Static_assert(CLIP_ONCE == 0 && CLIP_LOOP == 1 && CLIP_PING_PONG == 2,
	"repeats[] has the order of enum clip_repeat");

/* A parameter with choices may be compared with the name of one. */
static int read_right_side(struct character_words *words,
	const struct character_key *key, struct character_condition *one)
{
	const struct character *character = words->build->character;
	float *kept = ARENA_NEW(words->build->arena, float);

	if (!kept) {
		return character_fail_memory(words->build);
	}
	one->right = kept;
	for (int i = 0; i < character->parameter_count; i++) {
		if (one->left == &character->parameter[i].value &&
			character_take_choice(
				words, &character->parameter[i], kept)) {
			return 0;
		}
	}
	return character_read_value(words, key, &one->right);
}

int character_read_condition(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_condition **list = member;
	struct character_condition *one =
		ARENA_NEW(words->build->arena, struct character_condition);
	int error;

	if (!one) {
		return character_fail_memory(words->build);
	}
	error = character_read_value(words, key, &one->left);
	if (error) {
		return error;
	}
	if (character_take(words, ">")) {
		one->is = CHARACTER_ABOVE;
	} else if (character_take(words, "<")) {
		one->is = CHARACTER_BELOW;
	} else if (character_take(words, "is")) {
		one->is = CHARACTER_EQUAL;
	} else {
		return character_fail(
			words, "a comparison is missing: give %s", key->right);
	}
	error = read_right_side(words, key, one);
	one->next = *list;
	*list = one;
	return error;
}

static const char *const interrupts[] = {"always", "higher", "never", NULL};

static const struct character_key transition_keys[] = {
	{"when", character_read_condition,
		offsetof(struct character_transition, when),
		.right = "a comparison: speed > 2, speed < 1 or armed is 1"},
	{"exit", character_read_number,
		offsetof(struct character_transition, exit), 0, 1,
		.right = "a fraction of the clip from 0 to 1"},
	{"priority", character_read_number,
		offsetof(struct character_transition, priority),
		.right = "a number; the transition with the largest one wins"},
	{"interrupt", character_read_choice,
		offsetof(struct character_transition, interrupt),
		.choice = interrupts, .right = "always, higher or never"},
	{"fade", character_read_fade, offsetof(struct character_transition, fade),
		.right = "0.3 or 4 frames, and smooth, linear or cubic"},
	{0},
};

static int find_state(struct character_build *build,
	const struct character_section *section, const char *name, int *out)
{
	*out = character_name_in_heading(
		build, section, "transition", name, character_name_state);
	return *out < 0 ? -EINVAL : 0;
}

static int read_transition(struct character_build *build,
	const struct character_section *section,
	struct character_transition *transition)
{
	const struct character_machine *machine = &build->character->machine;
	int error = find_state(build, section, section->other, &transition->to);

	transition->from = -1;
	if (!error && strcmp(section->name, "*") != 0) {
		error = find_state(
			build, section, section->name, &transition->from);
	}
	if (!error) {
		transition->fade = machine->state[transition->to].fade;
		error = character_read_section(
			build, section, transition_keys, transition);
	}
	return error;
}

/*
 * Sorts transitions by falling priority; equal ones keep the order of the file.
 */
static int build_transitions(struct character_build *build)
{
	struct character_machine *machine = &build->character->machine;
	int count = character_text_count(build->text, "transition");
	int error = 0;

	machine->transition = ARENA_ARRAY(
		build->arena, struct character_transition, (size_t)count);
	if (!machine->transition) {
		return character_fail_memory(build);
	}
	for (const struct character_section *section =
			character_text_find(build->text->first, "transition");
		section && !error;
		section = character_text_find(section->next, "transition")) {
		struct character_transition one = {0};
		int at = machine->transition_count++;

		error = read_transition(build, section, &one);
		for (; at > 0 &&
			machine->transition[at - 1].priority < one.priority;
			at--) {
			machine->transition[at] = machine->transition[at - 1];
		}
		machine->transition[at] = one;
	}
	return error;
}

/* Without a [state], the model's first clip plays, or the rest pose. */
static int add_default_state(struct character_build *build)
{
	struct character_machine *machine = &build->character->machine;
	struct character_state *state = &machine->state[0];
	int clip = build->model->clip_count > 0 ? 0 : -2;

	state->name = clip < 0 ? "rest" : build->model->clip[0].name;
	state->entry = ARENA_NEW(build->arena, struct character_entry);
	state->entry_count = 1;
	if (!state->entry) {
		return character_fail_memory(build);
	}
	character_init_entry(build, clip, state->entry);
	return 0;
}

static int build_state(struct character_build *build,
	const struct character_section *section, struct character_state *state)
{
	int error;

	error = character_read_section(build, section, keys, state);
	if (!error && state->entry_count == 0) {
		return character_fail_section(build, section,
			"a state plays something: add clip = NAME or blend = PARAMETER, CLIP VALUE, CLIP VALUE");
	}
	return error;
}

/* Finds what the clips of a state change: only that has to be mixed. */
static int find_paths(
	struct character_build *build, struct character_state *state)
{
	state->paths = ARENA_ARRAY(
		build->arena, uint8_t, (size_t)build->model->node_count);
	if (!state->paths) {
		return character_fail_memory(build);
	}
	for (int i = 0; i < state->entry_count; i++) {
		clip_add_paths(
			state->entry[i].of->clip, build->model, state->paths);
	}
	return 0;
}

/*
 * Makes as many cursors as the state of most clips needs. One state plays at a
 * time, so they are enough for all.
 */
static int share_cursors(struct character_build *build)
{
	struct character_machine *machine = &build->character->machine;
	int most = 0;

	for (int i = 0; i < machine->state_count; i++) {
		int count = machine->state[i].entry_count;

		most = count > most ? count : most;
	}
	machine->cursor = character_make_cursors(build, most);
	if (!machine->cursor) {
		return -ENOMEM;
	}
	for (int i = 0; i < machine->state_count; i++) {
		struct character_state *state = &machine->state[i];

		for (int k = 0; k < state->entry_count; k++) {
			state->entry[k].cursor = &machine->cursor[k];
		}
	}
	return 0;
}

int character_build_states(struct character_build *build)
{
	static const float zero = 0, one = 1;
	struct character_machine *machine = &build->character->machine;
	const struct character_section *section =
		character_text_find(build->text->first, "state");
	int count = character_text_count(build->text, "state");
	int error;

	machine->state_count = count > 0 ? count : 1;
	machine->state = ARENA_ARRAY(build->arena, struct character_state,
		(size_t)machine->state_count);
	if (!machine->state) {
		return character_fail_memory(build);
	}
	for (int i = 0; i < machine->state_count; i++) {
		machine->state[i] = (struct character_state){
			.position = &zero,
			.rate = &one,
			.repeat = CLIP_LOOP,
			.next = -1,
			.fade.duration_s = 0.3f,
		};
	}
	error = count > 0 ? 0 : add_default_state(build);
	for (int i = 0; section && !error; i++) {
		machine->state[i].name = section->name;
		error = build_state(build, section, &machine->state[i]);
		section = character_text_find(section->next, "state");
	}
	for (int i = 0; i < machine->state_count && !error; i++) {
		error = find_paths(build, &machine->state[i]);
	}
	error = error ? error : share_cursors(build);
	if (!error) {
		error = build_transitions(build);
	}
	if (!error &&
		inertia_init(&machine->inertia, build->model, build->arena)) {
		return character_fail_memory(build);
	}
	machine->wanted = machine->running = -1;
	machine->fresh = true;
	return error;
}
