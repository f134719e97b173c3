#include "app/demo/viewer/behaviour_label.h"

#include "app/character/run/layers.h"
#include "app/character/state/machine.h"

#include <stdio.h>

/* Whether labels name the state: not if there is nothing but one rest pose. */
static bool names_state(const struct character *character)
{
	return character_machine_entry(character)->of->clip ||
		character->machine.state_count > 1 ||
		character->morph_count + character->part_count == 0;
}

void behaviour_count_labels(
	const struct character *character, struct actor_framing *framing)
{
	int rows = names_state(character);

	framing->label_bars = rows ? 1 : character->morph_count;
	framing->label_rows = rows ? 1 : 3 * character->morph_count;
	for (int i = 0; i < character->parameter_count; i++) {
		int shown = character->parameter[i].source ==
			CHARACTER_SOURCE_ACTIONS;

		framing->label_rows += shown;
		framing->label_bars += shown;
	}
	if (character->scene.labels == CHARACTER_LABELS_NONE) {
		framing->label_rows = 0;
	}
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
	char pace[32];

	if (morph->by_frames) {
		snprintf(pace, sizeof(pace), "%d frames",
			(int)((float)morph->frame_count / morph->pace + 0.5f));
	} else {
		snprintf(pace, sizeof(pace), "%.0f ms",
			(double)(1000 * morph->duration_s / morph->pace));
	}
	hud_group_text(group, morph->curve[morph->chosen].name, pace);
}

static void label_motion(
	const struct character *character, struct hud_group *group)
{
	const struct character_entry *entry = character_machine_entry(character);
	const struct character_machine *machine = &character->machine;
	const struct model_clip *clip = entry->of->clip;

	if (clip) {
		hud_group_time(group, machine->state[machine->current].name,
			entry->shown_s, clip->duration_s, hud_color_blue);
	} else if (names_state(character)) {
		hud_group_text(group, machine->state[machine->current].name, "");
	}
	for (int i = 0; i < character->morph_count; i++) {
		const struct character_morph *morph = &character->morph[i];

		/* Beside a clip, a morph is shown while it runs. */
		if (names_state(character) && !morph->morph.running) {
			continue;
		}
		if (!names_state(character)) {
			hud_group_text(
				group, "from", morph->key_name[morph->before]);
		}
		hud_group_weight(group, morph->key_name[morph->destiny],
			character_morph_omega(morph, character->now_s),
			hud_color_rose);
		if (!names_state(character)) {
			label_pace(morph, group);
		}
	}
}

static void label_values(
	const struct character *character, struct hud_group *group)
{
	for (int i = 0; i < character->parameter_count; i++) {
		const struct character_parameter *one = &character->parameter[i];
		char value[32];

		if (one->source == CHARACTER_SOURCE_ACTIONS) {
			snprintf(value, sizeof(value), "%.2f",
				(double)one->value);
			hud_group_bar(group, one->name, value,
				(one->value - one->range[0]) /
					(one->range[1] - one->range[0]),
				*color_of(i));
		}
	}
	for (int i = 0; i < character->switch_count; i++) {
		const struct character_switch *is = character->switches[i];

		if (is->now > 0 && !(is->on && is->now >= 1)) {
			hud_group_weight(
				group, is->name, is->now, *color_of(i + 1));
		}
	}
	for (int i = 0; i < character->sequence_count; i++) {
		const struct character_sequence *one = &character->sequence[i];

		if (one->now) {
			hud_group_time(group, one->now->name, one->elapsed_s,
				one->now->duration_s, hud_color_amber);
		}
	}
}

/* The values of the part that was moved last. */
static void label_part(
	const struct character *character, struct hud_group *group)
{
	static const char *const names[CHARACTER_FREEDOMS] = {
		"heading", "pitch", "bank", "x", "y", "z"};
	const struct character_part *part;

	if (character->moved_part < 0) {
		return;
	}
	part = &character->part[character->moved_part];
	hud_group_text(group, "moving", part->name);
	for (int i = 0; i < CHARACTER_FREEDOMS; i++) {
		char value[32];

		if (part->freedom[i].given) {
			snprintf(value, sizeof(value),
				i < CHARACTER_X ? "%.0f\u00b0" : "%.2f m",
				(double)part->freedom[i].value);
			hud_group_text(group, names[i], value);
		}
	}
}

/* What the buttons do now. */
static void label_keys(const struct character *character, struct hud *hud)
{
	struct hud_group group =
		hud_group_begin_wide(hud, HUD_BOTTOM_LEFT, NULL);

	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		char name[48];

		if (character_button_acts(one)) {
			character_button_text(one, name, sizeof(name));
			hud_group_key(&group, name, one->label);
		}
	}
	hud_group_end(&group);
}

void behaviour_label_all(const struct character *character, const char *title,
	const struct actor *actor, struct hud *hud)
{
	struct hud_group group;

	if (character->labels_hidden ||
		character->scene.labels == CHARACTER_LABELS_NONE) {
		return;
	}
	group = hud_group_begin(hud,
		character->scene.labels == CHARACTER_LABELS_RIGHT ? HUD_TOP_RIGHT
								  : HUD_TOP_LEFT,
		title);
	label_motion(character, &group);
	label_values(character, &group);
	label_part(character, &group);
	actor_label_lod(actor, &group);
	if (character->paused) {
		hud_group_text(&group, "paused", "");
	}
	hud_group_end(&group);
	if (character->keys_shown) {
		label_keys(character, hud);
	}
}
