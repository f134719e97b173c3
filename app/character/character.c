#include "app/character/character.h"

#include "app/character/run/actions.h"
#include "app/character/run/condition.h"
#include "app/character/run/effects.h"
#include "app/character/run/gestures.h"
#include "app/character/run/ground.h"
#include "app/character/run/layers.h"
#include "app/character/run/outputs.h"
#include "app/character/run/parameters.h"
#include "app/character/run/pending.h"
#include "app/character/run/triggers.h"
#include "app/character/state/machine.h"

#include "platform/base/file.h"

#include <stdlib.h>
#include <string.h>

void character_destroy(struct character *character)
{
	if (character) {
		arena_release(&character->arena);
		free(character);
	}
}

uint64_t character_stamp(const struct character *character)
{
	uint64_t stamp = 0;

	for (int i = 0; i < character->text.file_count; i++) {
		stamp = stamp * 31 + file_stamp(character->text.file[i]);
	}
	return stamp;
}

static void take_times(
	struct character_state *state, const struct character_state *from)
{
	for (int i = 0; i < state->entry_count && i < from->entry_count; i++) {
		state->entry[i].time_s = from->entry[i].time_s;
		state->entry[i].shown_s = from->entry[i].shown_s;
	}
}

void character_go_on(struct character *character, const struct character *before)
{
	struct character_machine *machine = &character->machine;
	const struct character_machine *old = &before->machine;
	const struct character_state *shown = &old->state[old->current];

	character->seen_s = before->seen_s;
	character->now_s = character->tour_from_s = before->now_s;
	character->paused = before->paused;
	character->touring = before->touring;
	character->labels_hidden = before->labels_hidden;
	character->keys_shown = before->keys_shown;
	for (int i = 0; i < machine->state_count; i++) {
		struct character_state *state = &machine->state[i];

		if (strcmp(state->name, shown->name) == 0) {
			machine->current = i;
			machine->phase = old->phase;
			machine->in_row = old->in_row;
			machine->fresh = old->fresh;
			take_times(state, shown);
			character->pending_count = 0;
			character_pending_add(character, state->enter, 1);
			return;
		}
	}
}

void character_press(
	struct character *character, const struct button_event *event)
{
	character_gestures_press(character, event);
}

/* Makes use of the pose before any effect that reads world matrices. */
static void use_animated(struct character *character)
{
	instance_update_nodes(character->instance);
	character_targets_update(character);
	character_ground_update(character);
}

static void run_ops(struct character *character)
{
	bool has_world = false;

	for (int i = 0; i < character->op_count; i++) {
		const struct character_op *op = &character->op[i];

		if (op->stage >= CHARACTER_STAGE_WORLD && !has_world) {
			use_animated(character);
			has_world = true;
		}
		op->run(character, op->what);
	}
	if (!has_world) {
		use_animated(character);
	}
}

void character_update(
	struct character *character, const struct character_frame *frame)
{
	double most_s = 10, step_s = frame->time_s - character->seen_s;

	character->seen_s = frame->time_s;
	step_s = step_s < 0 ? 0 : step_s > most_s ? most_s : step_s;
	character->real_s = (float)step_s;
	character->exact_s = character->paused ? 0 : step_s;
	character->step_s = (float)character->exact_s;
	character->now_s += character->exact_s;
	character->motion_level = frame->motion_level;
	memcpy(character->eye, frame->eye, sizeof(character->eye));
	character->camera_turn = character->camera_tilt = 0;
	character->camera_zoom = 0;
	character_tour_update(character);
	character_gestures_update(character);
	character_actions_run(character);
	character_parameters_update(character);
	character_switches_update(character);
	character_machine_update(character);
	run_ops(character);
	character_triggers_update(character);
	character_actions_run(character);
	character_outputs_update(character);
}

void character_bend(struct character *character)
{
	for (int i = 0; i < character->morph_count; i++) {
		character_morph_bend(&character->morph[i], character->now_s);
	}
}

static const char *gesture_name(const struct character_binding *one)
{
	static const char *const names[] = {
		[CHARACTER_PRESS] = "",
		[CHARACTER_RELEASE] = " released",
		[CHARACTER_HOLD] = "",
		[CHARACTER_LONG] = " held",
		[CHARACTER_TOGETHER] = "",
	};

	return names[one->gesture];
}

void character_button_text(
	const struct character_binding *binding, char *text, size_t size)
{
	bool both = binding->gesture == CHARACTER_TOGETHER;

	snprintf(text, size, "%s%s%s%s", button_name(binding->button),
		both ? "+" : "", both ? button_name(binding->second) : "",
		gesture_name(binding));
}

bool character_button_acts(const struct character_binding *binding)
{
	return character_condition_holds(binding->when);
}

/* Whether a line that was printed before says the same. */
static bool is_printed(const struct character *character,
	const struct character_binding *wanted, const char *name)
{
	for (const struct character_binding *one = character->binding;
		one != wanted; one = one->next) {
		char other[48];

		if (strcmp(one->label, wanted->label) != 0) {
			continue;
		}
		character_button_text(one, other, sizeof(other));
		if (strcmp(other, name) == 0) {
			return true;
		}
	}
	return false;
}

void character_print_buttons(const struct character *character, FILE *out)
{
	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		char name[48];

		character_button_text(one, name, sizeof(name));
		if (!is_printed(character, one, name)) {
			fprintf(out, "  %-6s %s\n", name, one->label);
		}
	}
}
