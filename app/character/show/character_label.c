#include "app/character/show/character_label.h"

#include "app/character/run/effects.h"
#include "app/character/run/layers.h"
#include "app/character/show/label_name.h"
#include "app/character/state/machine.h"

#include <stdio.h>

enum {
	VALUES_MAX = 4, /* rows of values of parts, at most */
	SWITCHES_TOGETHER = 6
};

/*
 * Returns true if labels name the state: always, except for a model with morphs
 * or parts that has nothing but one rest pose.
 */
static bool names_state(const struct character *character)
{
	return character_machine_entry(character)->of->clip ||
		character->machine.state_count > 1 ||
		character->morph_count + character->part_count == 0;
}

static bool shows_parameter(const struct character_parameter *parameter)
{
	return parameter->source == CHARACTER_SOURCE_ACTIONS &&
		!parameter->unlabelled;
}

/* Guesses how many of the switches that begin off are on together. */
static int count_switches(const struct character *character)
{
	int count = 0;

	for (int i = 0; i < character->switch_count; i++) {
		count += !character->switches[i]->on &&
			!character->switches[i]->unlabelled;
	}
	return count < SWITCHES_TOGETHER ? count : SWITCHES_TOGETHER;
}

static int has_presets(const struct character *character)
{
	for (int i = 0; i < character->shake_count; i++) {
		if (character->shake[i]->preset_count > 0) {
			return 1;
		}
	}
	return 0;
}

int character_label_count(const struct character *character, int *bars)
{
	int state = names_state(character), choices = 0;
	/* A sequence's step has two rows, and its choices are hidden. */
	int steps = character->sequence_count > 0 ? 2 : 0;
	int rows = state ? 1 : 3 * character->morph_count;
	int switches = count_switches(character) +
		(character->machine.state_count > 1);

	*bars = (state ? 1 : character->morph_count) + (steps > 0) + switches;
	for (int i = 0; i < character->parameter_count; i++) {
		const struct character_parameter *one = &character->parameter[i];
		bool shown = shows_parameter(one);

		choices += shown && one->choice;
		rows += shown && !one->choice;
		*bars += shown && !one->choice;
	}
	rows += choices > steps ? choices : steps;
	rows += character->part_count > 0 ? VALUES_MAX : 0;
	rows += switches + has_presets(character);
	if (character->scene.labels == CHARACTER_LABELS_NONE) {
		return 0;
	}
	/* A model that only plays has a row for "paused" as well. */
	return rows == 1 ? 2 : rows;
}

static const struct hud_color *color_of(int number)
{
	static const struct hud_color *const colors[] = {
		&hud_color_green,
		&hud_color_amber,
		&hud_color_violet,
		&hud_color_rose,
	};

	return colors[(size_t)number % ARRAY_COUNT(colors)];
}

static void label_pace(
	const struct character_morph *morph, struct hud_group *group)
{
	char pace[32], number[HUD_NAME_BYTES];

	if (morph->by_frames) {
		snprintf(pace, sizeof(pace), "%d frames",
			(int)((float)morph->frame_count / morph->pace + 0.5f));
	} else {
		snprintf(pace, sizeof(pace), "%.0f ms",
			(double)(1000 * morph->duration_s / morph->pace));
	}
	hud_group_text(group,
		hud_name(morph->curve[morph->chosen].name, "curve",
			morph->chosen + 1, number),
		pace);
}

static void label_motion(
	const struct character *character, struct hud_group *group)
{
	const struct character_entry *entry = character_machine_entry(character);
	const struct character_machine *machine = &character->machine;
	const struct model_clip *clip = entry->of->clip;
	char number[HUD_NAME_BYTES];

	if (clip) {
		hud_group_time(group, label_name_motion(character, clip, number),
			entry->shown_s, clip->duration_s, hud_color_blue);
	} else if (names_state(character)) {
		hud_group_text(
			group, label_name_motion(character, NULL, number), "");
	}
	if (machine->inertia.running) {
		hud_group_weight(group, "fade",
			machine->inertia.elapsed_s / machine->inertia.duration_s,
			hud_color_blue);
	}
	for (int i = 0; i < character->morph_count; i++) {
		const struct character_morph *morph = &character->morph[i];

		/* Beside a clip, a morph is shown while it runs. */
		if (names_state(character) && !morph->morph.running) {
			continue;
		}
		if (!names_state(character)) {
			hud_group_text(group, "from",
				label_name_key(morph, morph->before, number));
		}
		hud_group_weight(group,
			label_name_key(morph, morph->destiny, number),
			character_morph_omega(morph, character->now_s),
			hud_color_rose);
		if (!names_state(character)) {
			label_pace(morph, group);
		}
	}
}

static bool runs_sequence(const struct character *character)
{
	for (int i = 0; i < character->sequence_count; i++) {
		if (character->sequence[i].now) {
			return true;
		}
	}
	return false;
}

static void label_parameter(
	const struct character *character, int index, struct hud_group *group)
{
	const struct character_parameter *one = &character->parameter[index];
	char number[HUD_NAME_BYTES], value[HUD_NAME_BYTES];
	const char *name = hud_name(one->name, "parameter", index + 1, number);
	int choice = (int)(one->value + 0.5f);

	if (!one->choice) {
		snprintf(value, sizeof(value), "%.2f", (double)one->value);
		hud_group_bar(group, name, value,
			(one->value - one->range[0]) /
				(one->range[1] - one->range[0]),
			*color_of(index));
	} else if (!runs_sequence(character)) {
		hud_group_text(group, name,
			hud_name(one->choice[choice], "choice", choice + 1,
				value));
	}
}

static void label_values(
	const struct character *character, struct hud_group *group)
{
	for (int i = 0; i < character->parameter_count; i++) {
		if (shows_parameter(&character->parameter[i])) {
			label_parameter(character, i, group);
		}
	}
	for (int i = 0; i < character->switch_count; i++) {
		const struct character_switch *is = character->switches[i];
		char number[HUD_NAME_BYTES];

		if (is->now > 0 && !is->unlabelled && !(is->on && is->now >= 1)) {
			hud_group_weight(group,
				label_name_switch(character, i, number),
				is->now, *color_of(i + 1));
		}
	}
}

static const char *const freedom_names[CHARACTER_FREEDOMS] = {
	"heading", "pitch", "bank", "x", "y", "z"};

/* Adds a degree of freedom and its value. */
static void label_freedom(const struct character *character, int index,
	int freedom, struct hud_group *group)
{
	const struct character_part *part = &character->part[index];
	char name[64], number[HUD_NAME_BYTES], value[32];

	snprintf(name, sizeof(name), "%s %s",
		hud_name(part->name, "part", index + 1, number),
		freedom_names[freedom]);
	snprintf(value, sizeof(value),
		freedom < CHARACTER_X ? "%.0f\u00b0" : "%.2f m",
		(double)part->freedom[freedom].value);
	hud_group_text(group, name, value);
}

/* The degrees of freedom that have a row already. */
struct shown {
	int count;
	struct {
		int part, freedom;
	} at[VALUES_MAX];
};

static void label_once(const struct character *character, int part, int freedom,
	struct shown *shown, struct hud_group *group)
{
	for (int i = 0; i < shown->count; i++) {
		if (shown->at[i].part == part &&
			shown->at[i].freedom == freedom) {
			return;
		}
	}
	if (shown->count < VALUES_MAX) {
		shown->at[shown->count].part = part;
		shown->at[shown->count++].freedom = freedom;
		label_freedom(character, part, freedom, group);
	}
}

/* Adds the values that buttons move now. */
static void label_moves(
	const struct character *character, struct hud_group *group)
{
	struct shown shown = {0};

	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		const struct character_action *action =
			character_button_acts(one) ? one->action : NULL;

		for (; action; action = action->next) {
			if (action->verb == CHARACTER_MOVE) {
				label_once(character, action->index,
					action->detail, &shown, group);
			}
		}
	}
}

/* Adds a sequence's step and the first values that the sequence moves. */
static void label_sequence(const struct character *character,
	const struct character_sequence *sequence, struct hud_group *group)
{
	const struct character_step *now = sequence->now;
	char number[HUD_NAME_BYTES];
	struct shown shown = {0};

	hud_group_text(group, label_name_step(sequence, number), "");
	hud_group_time(group, "", sequence->elapsed_s, now->duration_s,
		hud_color_amber);
	for (const struct character_step *step = sequence->step; step;
		step = step->next) {
		for (const struct character_goal *goal = step->goal; goal;
			goal = goal->next) {
			label_once(character, goal->part, goal->freedom, &shown,
				group);
		}
	}
}

/* Adds what sequences move or, if none runs, what buttons move. */
static void label_parts(
	const struct character *character, struct hud_group *group)
{
	for (int i = 0; i < character->sequence_count; i++) {
		if (character->sequence[i].now) {
			label_sequence(
				character, &character->sequence[i], group);
		}
	}
	if (!runs_sequence(character)) {
		label_moves(character, group);
	}
}

/* Adds the presets of shakes that are switched on. */
static void label_presets(
	const struct character *character, struct hud_group *group)
{
	for (int i = 0; i < character->shake_count; i++) {
		const struct character_shake *shake = character->shake[i];
		char number[HUD_NAME_BYTES];

		if (shake->is.is_on && !shake->is.unlabelled &&
			shake->preset_count > 0) {
			hud_group_text(group, "preset",
				hud_name(shake->preset[shake->chosen].name,
					"preset", shake->chosen + 1, number));
		}
	}
}

/*
 * Returns true if an action switches something, and tells whether that is on.
 */
static bool find_switched(const struct character *character,
	const struct character_action *action, bool *on)
{
	const struct character_parameter *parameter;

	if (action->verb == CHARACTER_SWITCH && action->amount < 0) {
		*on = character->switches[action->index]->is_on;
		return true;
	}
	if (action->verb != CHARACTER_TOGGLE) {
		return false;
	}
	parameter = &character->parameter[action->index];
	*on = parameter->goal >
		0.5f * (parameter->range[0] + parameter->range[1]);
	return true;
}

/*
 * Returns the next binding from this one on that depends on a condition which
 * holds now, and that labels show; or NULL.
 */
static const struct character_binding *find_changing(
	const struct character_binding *one)
{
	while (one &&
		(!one->when || one->unlabelled || !character_button_acts(one) ||
			one->gesture != CHARACTER_PRESS)) {
		one = one->next;
	}
	return one;
}

/* Adds what the buttons with conditions do now. */
static void label_changing(const struct character *character, struct hud *hud)
{
	const struct character_binding *first =
		find_changing(character->binding);
	const struct character_binding *one;
	struct hud_group group;
	char name[48];

	if (!first) {
		return;
	}
	group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
	for (one = first; one; one = find_changing(one->next)) {
		character_button_text(one, name, sizeof(name));
		hud_group_widen(&group, name, one->shown);
	}
	for (one = first; one; one = find_changing(one->next)) {
		bool on;

		character_button_text(one, name, sizeof(name));
		if (find_switched(character, one->action, &on)) {
			hud_group_switch(
				&group, name, one->shown, on, hud_color_green);
		} else {
			hud_group_key(&group, name, one->shown);
		}
	}
	hud_group_end(&group);
}

struct framing_below character_label_below(const struct character *character)
{
	struct framing_below below = {0};
	const struct character_binding *one = character->binding;

	if (character->labels_hidden) {
		return below;
	}
	if (character->keys_shown) {
		for (; one; one = one->next) {
			below.keys += character_button_acts(one);
		}
	} else if (!character->touring) {
		while ((one = find_changing(one))) {
			below.switches++;
			one = one->next;
		}
	}
	return below;
}

static bool labels_right(const struct character *character)
{
	return character->scene.labels == CHARACTER_LABELS_RIGHT;
}

/* Adds the list of what all buttons do now. */
static void label_keys(const struct character *character, struct hud *hud)
{
	struct hud_group group = hud_group_begin_wide(hud,
		labels_right(character) ? HUD_BOTTOM_RIGHT : HUD_BOTTOM_LEFT,
		NULL);

	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		char name[48];

		if (character_button_acts(one)) {
			character_button_text(one, name, sizeof(name));
			hud_group_key(&group, name, one->shown);
		}
	}
	hud_group_end(&group);
}

static void label_cap(const struct instance *instance, struct hud_group *group)
{
	char value[32];

	if (instance->max_influences > 0) {
		snprintf(value, sizeof(value), "at most %d",
			instance->max_influences);
		hud_group_text(group, "influences", value);
	}
}

static void label_state(
	const struct character *character, const char *title, struct hud *hud)
{
	struct hud_group group = hud_group_begin(hud,
		labels_right(character) ? HUD_TOP_RIGHT : HUD_TOP_LEFT, title);

	label_motion(character, &group);
	label_values(character, &group);
	label_parts(character, &group);
	label_presets(character, &group);
	label_cap(character->instance, &group);
	if (character->paused) {
		hud_group_text(&group, "paused", "");
	}
	hud_group_end(&group);
}

void character_label_all(
	const struct character *character, const char *title, struct hud *hud)
{
	struct hud_mark before = hud_mark(hud);
	bool alone = character->keys_shown &&
		hud_group_list_is_alone(hud->width, hud->height);

	if (character->labels_hidden ||
		character->scene.labels == CHARACTER_LABELS_NONE) {
		return;
	}
	if (!alone) {
		label_state(character, title, hud);
	}
	if (character->keys_shown) {
		label_keys(character, hud);
	} else if (!character->touring) {
		label_changing(character, hud);
	}
	if (character->keys_shown && hud_groups_overlap(hud)) {
		/* In a small picture the keys take the place of the labels. */
		hud_go_back(hud, &before);
		label_keys(character, hud);
	}
}
