#include "app/character/run/actions.h"

#include "app/character/parts/held.h"
#include "app/character/parts/parts.h"
#include "app/character/run/effects.h"
#include "app/character/run/layers.h"
#include "app/character/run/outputs.h"
#include "app/character/run/parameters.h"

#include <stdio.h>

static void toggle(struct character_parameter *parameter)
{
	float middle = 0.5f * (parameter->range[0] + parameter->range[1]);

	character_parameter_set(
		parameter, parameter->range[parameter->goal > middle ? 0 : 1]);
}

/* Steps on from the state that an earlier action asked for, if it waits. */
static void go_on(struct character_machine *machine, int step)
{
	int count = machine->state_count;
	int from = machine->wanted >= 0 ? machine->wanted : machine->current;

	machine->wanted = ((from + step) % count + count) % count;
}

/* A row begins with the present state, from its start. */
static void toggle_row(struct character_machine *machine)
{
	machine->in_row = !machine->in_row;
	machine->wanted = machine->in_row ? machine->current : -1;
}

static void go_morph(struct character_morph *morph,
	const struct character_action *action, double now_s)
{
	int count = morph->key_count;
	int key = action->detail >= 0 ? action->detail
				      : morph->destiny + (int)action->amount;

	character_morph_go(morph, (key % count + count) % count, now_s);
}

static void run_morph(
	struct character *character, const struct character_action *action)
{
	struct character_morph *morph = &character->morph[action->index];

	switch (action->verb) {
	case CHARACTER_PACE:
		morph->pace =
			scalar_clamp(morph->pace * action->amount, 0.125f, 8);
		break;
	case CHARACTER_CURVE:
		character_morph_use_curve(
			morph, (morph->chosen + 1) % morph->curve_count);
		break;
	case CHARACTER_TIMING:
		morph->by_frames = !morph->by_frames;
		break;
	default:
		/*
		 * Buttons were pressed after the last frame, so the morph
		 * begins at that frame's time.
		 */
		go_morph(morph, action,
			character->now_s - (double)character->step_s);
	}
}

static void run_state(
	struct character *character, const struct character_action *action)
{
	struct character_machine *machine = &character->machine;

	if (action->verb == CHARACTER_GO) {
		machine->wanted = action->index;
	} else if (action->verb == CHARACTER_NEXT) {
		go_on(machine, (int)action->amount);
	} else {
		toggle_row(machine);
	}
}

static void run_sequence(
	struct character *character, const struct character_action *action)
{
	struct character_sequence *sequence =
		&character->sequence[action->index];

	if (action->verb == CHARACTER_STOP) {
		character_sequence_stop(sequence);
	} else {
		character_sequence_start(
			character, sequence, action->verb == CHARACTER_REPEAT);
	}
}

static void run_switch(struct character_switch *is, float amount)
{
	is->is_on = amount < 0 ? !is->is_on : amount > 0;
}

static void write_line(const char *text)
{
	puts(text);
	fflush(stdout);
}

static void start_tour(struct character *character)
{
	character->touring = !character->touring;
	character->tour_from_s = character->now_s;
	character->tour_next = character->scene.tour;
}

static void run_scene(struct character *character,
	const struct character_action *action, float amount)
{
	switch (action->verb) {
	case CHARACTER_LINE:
		write_line(action->text);
		break;
	case CHARACTER_OUTPUT:
		character_output_drive(character, action->index, action->amount);
		break;
	case CHARACTER_TURN:
		character->camera_turn += amount;
		break;
	case CHARACTER_TILT:
		character->camera_tilt += amount;
		break;
	case CHARACTER_ZOOM:
		character->camera_zoom += amount;
		break;
	case CHARACTER_PAUSE:
		character->paused = !character->paused;
		break;
	case CHARACTER_TOUR:
		start_tour(character);
		break;
	case CHARACTER_KEYS:
		character->keys_shown = !character->keys_shown;
		break;
	case CHARACTER_LABELS:
		character->labels_hidden = !character->labels_hidden;
		break;
	default:
		break;
	}
}

static void run_part(struct character *character,
	const struct character_action *action, float times)
{
	struct character_part *part = &character->part[action->index];

	if (action->verb == CHARACTER_MOVE) {
		struct character_freedom *freedom =
			&part->freedom[action->detail];

		freedom->moved += action->amount * freedom->speed * times;
	} else if (action->verb == CHARACTER_DROP) {
		character_part_drop(character, part, action->detail);
	} else {
		character_part_attach(character, part, action);
	}
}

/* After the last choice comes the first one, in any number of rounds. */
static void step_choice(struct character_parameter *parameter, float step)
{
	const int most = 1 << 24; /* a float counts no further */
	int count = parameter->choice_count;
	int choice =
		scalar_to_int((double)(parameter->goal + step), -most, most);

	character_parameter_set(
		parameter, (float)((choice % count + count) % count));
}

static void run_parameter(struct character_parameter *parameter,
	const struct character_action *action, float amount)
{
	if (action->verb == CHARACTER_TOGGLE) {
		toggle(parameter);
	} else if (parameter->choice && action->verb == CHARACTER_ADD) {
		step_choice(parameter, amount);
	} else if (action->verb == CHARACTER_STEP) {
		character_parameter_step(parameter, (int)action->amount);
	} else {
		character_parameter_set(parameter,
			action->verb == CHARACTER_ADD ? parameter->goal + amount
						      : action->amount);
	}
}

static void run(struct character *character,
	const struct character_action *action, float times)
{
	float amount = action->amount * times;

	switch (action->verb) {
	case CHARACTER_SET:
	case CHARACTER_ADD:
	case CHARACTER_STEP:
	case CHARACTER_TOGGLE:
		run_parameter(
			&character->parameter[action->index], action, amount);
		break;
	case CHARACTER_SWITCH:
		run_switch(character->switches[action->index], action->amount);
		break;
	case CHARACTER_GO:
	case CHARACTER_NEXT:
	case CHARACTER_ROW:
		run_state(character, action);
		break;
	case CHARACTER_PLAY:
		character_layer_play(&character->layer[action->index]);
		break;
	case CHARACTER_MORPH:
	case CHARACTER_PACE:
	case CHARACTER_CURVE:
	case CHARACTER_TIMING:
		run_morph(character, action);
		break;
	case CHARACTER_PRESET:
		character_shake_use(character, action);
		break;
	case CHARACTER_MOVE:
	case CHARACTER_ATTACH:
	case CHARACTER_DROP:
		run_part(character, action, times);
		break;
	case CHARACTER_RUN:
	case CHARACTER_REPEAT:
	case CHARACTER_STOP:
		run_sequence(character, action);
		break;
	default:
		run_scene(character, action, amount);
	}
}

void character_actions_run(struct character *character)
{
	/* Actions may add others; what does not fit into the list is dropped. */
	for (int i = 0; i < character->pending_count; i++) {
		run(character, character->pending[i].action,
			character->pending[i].times);
	}
	character->pending_count = 0;
}
