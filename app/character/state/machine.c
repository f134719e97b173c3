#include "app/character/state/machine.h"

#include "app/anim/clip_join.h"
#include "app/character/run/condition.h"
#include "app/character/run/pending.h"
#include "app/character/state/entry.h"
#include "platform/base/scalar.h"

/* Returns the transition from the present state, else one from any, or -1. */
static int find_transition(const struct character_machine *machine, int to)
{
	int any = -1;

	for (int i = 0; i < machine->transition_count; i++) {
		const struct character_transition *one = &machine->transition[i];

		if (one->to == to && one->from == machine->current) {
			return i;
		}
		if (one->to == to && one->from < 0 && any < 0) {
			any = i;
		}
	}
	return any;
}

/* Returns true if the transition under way lets another one begin. */
static bool may_begin(const struct character_machine *machine, int transition)
{
	const struct character_transition *running, *next;

	if (machine->running < 0 || !machine->inertia.running) {
		return true;
	}
	running = &machine->transition[machine->running];
	if (running->interrupt != CHARACTER_INTERRUPT_HIGHER) {
		return running->interrupt == CHARACTER_INTERRUPT_ALWAYS;
	}
	next = transition < 0 ? NULL : &machine->transition[transition];
	return next && next->priority > running->priority;
}

static bool is_late_enough(
	const struct character_machine *machine, int transition)
{
	return transition < 0 ||
		machine->done >= machine->transition[transition].exit ||
		machine->loops > 0;
}

static int find_condition(const struct character_machine *machine)
{
	for (int i = 0; i < machine->transition_count; i++) {
		const struct character_transition *one = &machine->transition[i];

		if (one->when && one->to != machine->current &&
			(one->from < 0 || one->from == machine->current) &&
			is_late_enough(machine, i) && may_begin(machine, i) &&
			character_condition_holds(one->when)) {
			return i;
		}
	}
	return -1;
}

static float fade_s(
	const struct character_fade *fade, const struct character_entry *entry)
{
	if (fade->frames <= 0) {
		return fade->duration_s;
	}
	return (float)fade->frames *
		(entry->of->clip ? clip_join_frame_s(entry->of->clip)
				 : 1.0f / 30);
}

/* Returns the fade of the transition, of a row, or of the state itself. */
static const struct character_fade *fade_to(
	const struct character_machine *machine, int to, int transition)
{
	static const struct character_fade in_row = {
		.frames = CLIP_JOIN_FRAMES, .curve = INERTIA_CUBIC};

	return transition >= 0    ? &machine->transition[transition].fade
		: machine->in_row ? &in_row
				  : &machine->state[to].fade;
}

/* Returns the state that follows at the end of the present one, or -1. */
static int state_after(const struct character_machine *machine)
{
	int next = machine->state[machine->current].next;

	return next < 0 && machine->in_row && machine->state_count > 1
		? (machine->current + 1) % machine->state_count
		: next;
}

/* Returns true if the end of the clip has been shown long enough. */
static bool has_paused(const struct character_machine *machine)
{
	const struct character_state *state = &machine->state[machine->current];

	return state->repeat != CLIP_ONCE || machine->held_s >= state->pause_s;
}

/* Returns true if so little of the clip is left that the next fade begins. */
static bool is_at_end(const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct character_entry *entry = character_machine_entry(character);
	float rate = scalar_abs(*machine->state[machine->current].rate);
	float duration_s = character_entry_duration_s(entry);
	int next = state_after(machine);
	float overlap_s;

	if (next < 0 || machine->fresh) {
		return false;
	}
	if (machine->loops > 0 || machine->state[machine->current].pause_s > 0) {
		return machine->loops > 0 && has_paused(machine);
	}
	/* Seconds of the clip pass at its rate, and those of the fade do not. */
	overlap_s = rate *
		fade_s(fade_to(machine, next, find_transition(machine, next)),
			entry);
	return duration_s * (1 - machine->done) <=
		scalar_min(overlap_s, 0.5f * duration_s);
}

static void choose_weights(const struct character_state *state)
{
	float at = *state->position;
	int upper = 0;

	for (int i = 0; i < state->entry_count; i++) {
		state->entry[i].weight = 0;
		state->entry[i].follows = false;
	}
	while (upper < state->entry_count && state->entry[upper].at < at) {
		upper++;
	}
	if (upper == 0 || upper == state->entry_count) {
		state->entry[upper ? upper - 1 : 0].weight = 1;
	} else {
		struct character_entry *low = &state->entry[upper - 1];

		state->entry[upper].weight =
			(at - low->at) / (state->entry[upper].at - low->at);
		low->weight = 1 - state->entry[upper].weight;
		low->follows = low->weight < 0.5f;
		state->entry[upper].follows = !low->follows;
	}
}

static void begin_state(struct character *character, int to, int transition)
{
	struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[to];

	character_pending_add(
		character, machine->state[machine->current].leave, 1);
	character_pending_add(character, state->enter, 1);
	machine->current = to;
	machine->running = transition;
	machine->wanted = -1;
	machine->held_s = 0;
	machine->fresh = true;
}

/* Returns true if the clips play once, from their ends to their starts. */
static bool plays_back_once(const struct character_state *state)
{
	return state->repeat == CLIP_ONCE && *state->rate < 0;
}

/* Begins the clips of a state at their start; played back once, at their end. */
static void begin_clips(struct character_state *state)
{
	for (int i = 0; i < state->entry_count; i++) {
		struct character_entry *entry = &state->entry[i];

		character_entry_begin(entry,
			plays_back_once(state)
				? (double)character_entry_duration_s(entry)
				: 0);
	}
}

/* A clip that plays once stays at its end, and may go back from there. */
static void stay_within(struct character_entry *entry)
{
	double duration_s = (double)character_entry_duration_s(entry);

	entry->time_s = entry->time_s < 0    ? 0
		: entry->time_s > duration_s ? duration_s
					     : entry->time_s;
}

/* All clips with marks move on by one phase, so that they stay in step. */
static void move_on(struct character *character)
{
	struct character_machine *machine = &character->machine;
	struct character_state *state = &machine->state[machine->current];
	double step_s = character->exact_s * (double)*state->rate;
	float speed = 0, weight = 0;

	if (machine->fresh) {
		step_s = 0;
		begin_clips(state);
	}
	for (int i = 0; i < state->entry_count; i++) {
		const struct character_entry *entry = &state->entry[i];

		if (entry->weight > 0 && entry->of->mark_count > 0) {
			speed += entry->weight *
				character_entry_marks_per_s(
					entry, machine->phase);
			weight += entry->weight;
		}
	}
	if (weight > 0) {
		machine->phase += step_s * (double)(speed / weight);
	}
	for (int i = 0; i < state->entry_count; i++) {
		character_entry_move(&state->entry[i], step_s,
			state->repeat == CLIP_LOOP ? &machine->phase : NULL);
		if (state->repeat == CLIP_ONCE) {
			stay_within(&state->entry[i]);
		}
	}
}

static void note_progress(struct character *character)
{
	struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	const struct character_entry *entry = character_machine_entry(character);
	float duration_s = character_entry_duration_s(entry);
	double turns = duration_s > 0 ? entry->time_s / (double)duration_s : 1;

	if (plays_back_once(state) && duration_s > 0) {
		turns = 1 - turns;
	}
	turns = turns < 0 ? -turns : turns;
	machine->loops = scalar_to_int(turns, 0, 1 << 30);
	machine->done = (float)(turns - (double)machine->loops);
	if (state->repeat == CLIP_ONCE && machine->loops > 0) {
		machine->done = 1;
		machine->held_s += character->step_s;
	}
}

/* Takes the cursors for a state, if another one has them. */
static void take_cursors(const struct character_state *state)
{
	for (int i = 0; i < state->entry_count; i++) {
		struct clip_cursor *cursor = state->entry[i].cursor;

		if (cursor->paths != state->paths) {
			cursor->paths = state->paths;
			cursor->begun = false;
		}
	}
}

/* One clip plays, or two whose weights add up to 1. */
static void sample(struct character *character, struct pose *pose)
{
	struct character_machine *machine = &character->machine;
	struct character_state *state = &machine->state[machine->current];
	bool begun = false;

	take_cursors(state);

	for (int i = 0; i < state->entry_count; i++) {
		struct character_entry *entry = &state->entry[i];

		if (entry->weight <= 0) {
			continue;
		}
		if (begun) {
			character_entry_mix(character, entry, state->repeat,
				entry->weight, pose);
		} else {
			character_entry_sample(
				character, entry, state->repeat, pose);
		}
		begun = true;
	}
}

const struct character_entry *character_machine_entry(
	const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	const struct character_entry *best = &state->entry[0];

	for (int i = 1; i < state->entry_count; i++) {
		best = state->entry[i].weight > best->weight ? &state->entry[i]
							     : best;
	}
	return best;
}

/* Changes the state if something asks for it; returns the fade's length. */
static const struct character_fade *change(
	struct character *character, float *duration_s)
{
	struct character_machine *machine = &character->machine;
	const struct character_entry *entry = character_machine_entry(character);
	int transition = find_condition(machine), to = -1;

	if (transition >= 0) {
		to = machine->transition[transition].to;
	} else if (machine->wanted >= 0) {
		transition = find_transition(machine, machine->wanted);
		if (is_late_enough(machine, transition) &&
			may_begin(machine, transition)) {
			to = machine->wanted;
		}
	}
	if (to < 0 && is_at_end(character)) {
		to = state_after(machine);
		transition = find_transition(machine, to);
	}
	if (to < 0) {
		return NULL;
	}
	*duration_s = fade_s(fade_to(machine, to, transition), entry);
	begin_state(character, to, transition);
	return fade_to(machine, to, transition);
}

void character_machine_update(struct character *character)
{
	struct character_machine *machine = &character->machine;
	struct pose *pose = &character->instance->pose;
	float duration_s = 0;
	const struct character_fade *fade = change(character, &duration_s);

	choose_weights(&machine->state[machine->current]);
	move_on(character);
	sample(character, pose);
	note_progress(character);
	if (fade) {
		inertia_begin(&machine->inertia, pose, duration_s, fade->curve);
	}
	inertia_apply(&machine->inertia, character->step_s, pose);
	inertia_keep(&machine->inertia, pose, character->step_s);
	machine->fresh = false;
}
