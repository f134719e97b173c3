/* How states follow one another, frame by frame. */
#include "tests/unit/app/character/state/states.h"

enum {
	FRAMES_MAX = 40
};

/* Returns the first frame in which another state plays, or 0 if none does. */
static int leave(struct states *f)
{
	int first = f->character.machine.current;

	for (int frame = 1; frame <= FRAMES_MAX; frame++) {
		states_run(f, 1);
		if (f->character.machine.current != first) {
			return frame;
		}
	}
	return 0;
}

/*
 * The first frame shows the start, and each other one 0.25 s more. The fade is
 * that of the next state, or of the transition to it.
 */
static void test_a_state_ends_when_so_much_is_left_as_the_fade_takes(
	void **state)
{
	static const struct {
		float fade_s, rate;
		enum clip_repeat repeat;
		int frame;
	} rows[] = {
		{0.5f, 1, CLIP_LOOP, 8},
		{0.499f, 1, CLIP_LOOP, 9},
		{0, 1, CLIP_LOOP, 10},
		{0.75f, 1, CLIP_LOOP, 7},
		{1, 1, CLIP_LOOP, 6},
		/* At least half of the clip is shown. */
		{1.5f, 1, CLIP_LOOP, 6},
		{0.25f, 2, CLIP_LOOP, 5},
		{1, 0.5f, CLIP_LOOP, 14},
		{0.5f, -1, CLIP_LOOP, 8},
		{0.25f, -2, CLIP_LOOP, 5},
		{0.5f, 1, CLIP_ONCE, 8},
		{0.5f, -1, CLIP_ONCE, 8},
		{0, 1, CLIP_ONCE, 10},
		{0.5f, 1, CLIP_PING_PONG, 8},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;

		states_begin(&f);
		f.state[0].next = 2;
		f.state[0].repeat = rows[i].repeat;
		f.state[2].fade.duration_s = rows[i].fade_s;
		f.rate[0] = rows[i].rate;
		if (i % 2) {
			f.character.machine.transition_count = 2;
			f.transition[1].to = 2;
			f.transition[1].fade = f.state[2].fade;
			f.state[2].fade.duration_s = 9;
		}
		assert_int_equal(leave(&f), rows[i].frame);
		assert_int_equal(f.character.machine.current, 2);
		assert_int_equal(f.character.machine.running, i % 2 ? 1 : -1);
		states_end(&f);
	}
}

/* A clip that plays once is shown at its end; others have no such moment. */
static void test_a_pause_follows_the_end_of_a_clip(void **state)
{
	static const struct {
		enum clip_repeat repeat;
		float pause_s, duration_s, rate;
		int frame;
	} rows[] = {
		{CLIP_ONCE, 0.5f, 2, 1, 11},
		{CLIP_ONCE, 0.625f, 2, 1, 12},
		{CLIP_ONCE, 0.25f, 2, 1, 10},
		{CLIP_ONCE, 0.5f, 0.5f, 1, 5},
		{CLIP_ONCE, 0.5f, 0.5f, -1, 5},
		{CLIP_LOOP, 0.5f, 2, 1, 10},
		{CLIP_LOOP, 0.5f, 0.5f, 1, 4},
		{CLIP_PING_PONG, 0.5f, 2, 1, 10},
		/* The rest pose lasts no time. */
		{CLIP_ONCE, 0.5f, 0, 1, 3},
		{CLIP_ONCE, 0.5f, 0, -1, 3},
		{CLIP_ONCE, 0, 0, 1, 2},
		{CLIP_LOOP, 0, 0, 1, 2},
		{CLIP_LOOP, 0.5f, 0, 1, 2},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;

		states_begin(&f);
		f.state[0].next = 1;
		f.state[0].repeat = rows[i].repeat;
		f.state[0].pause_s = rows[i].pause_s;
		/* A pause leaves no time for a fade within the clip. */
		f.state[1].fade.duration_s = 0.5f;
		f.rate[0] = rows[i].rate;
		states_shorten(&f, 0, rows[i].duration_s);
		assert_int_equal(leave(&f), rows[i].frame);
		assert_int_equal(f.character.machine.current, 1);
		/* The next state that pauses counts anew. */
		assert_near(f.character.machine.held_s, 0, 0);
		states_end(&f);
	}
}

static void test_a_state_without_a_next_one_plays_on(void **state)
{
	static const struct {
		int states, current, next, follows;
	} rows[] = {{4, 0, -1, 1}, {4, 3, -1, 0}, {2, 1, -1, 0}, {4, 1, 3, 3},
		{4, 1, 0, 0}, {1, 0, -1, -1}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		bool in_row = i % 2;
		int next = rows[i / 2].next, follows;
		struct states f;

		states_begin(&f);
		f.character.machine.state_count = rows[i / 2].states;
		f.character.machine.current = rows[i / 2].current;
		f.character.machine.in_row = in_row;
		f.state[rows[i / 2].current].next = next;
		follows = in_row ? rows[i / 2].follows : next;
		assert_int_equal(leave(&f), follows >= 0 ? 10 : 0);
		assert_int_equal(f.character.machine.current,
			follows >= 0 ? follows : rows[i / 2].current);
		if (follows < 0) {
			assert_near(f.entry[rows[i / 2].current][0].time_s,
				step_s * (FRAMES_MAX - 1), 0);
		}
		states_end(&f);
	}
}

/* First those of the state that is left. */
static void test_a_change_runs_what_leaves_and_enters(void **state)
{
	struct states f;
	struct character_machine *machine = &f.character.machine;

	(void)state;
	states_begin(&f);
	f.state[0].repeat = CLIP_ONCE;
	states_run(&f, 20);
	assert_int_equal(f.character.pending_count, 0);
	assert_int_equal(machine->loops, 1);
	assert_near(machine->held_s, 12 * step_s, 1e-6);
	machine->wanted = 2;
	assert_near(states_run(&f, 1), 20, 1e-5);
	assert_int_equal(f.character.pending_count, 2);
	assert_int_equal(f.character.pending[0].action->index, 10);
	assert_int_equal(f.character.pending[1].action->index, 2);
	assert_near(f.character.pending[0].times, 1, 0);
	assert_near(f.character.pending[1].times, 1, 0);
	assert_int_equal(machine->current, 2);
	assert_int_equal(machine->wanted, -1);
	assert_int_equal(machine->loops, 0);
	assert_near(machine->done, 0, 0);
	assert_near(machine->held_s, 0, 0);
	assert_near(states_run(&f, 1), 20.25, 1e-5);
	assert_int_equal(f.character.pending_count, 0);
	/* A state that begins again shows its start. */
	machine->wanted = 2;
	assert_near(states_run(&f, 1), 20, 1e-5);
	states_end(&f);
}

/* It waits for a part of the clip, or for the clip's end. */
static void test_a_transition_leads_to_another_state(void **state)
{
	struct states f;
	struct character_machine *machine = &f.character.machine;
	static const float one = 1, two = 2;
	struct character_condition when = {
		.left = &one, .right = &two, .is = CHARACTER_BELOW};

	(void)state;
	for (int i = 0; i < 2 * (STATES + 1) * STATES; i++) {
		int from = i / 2 / STATES - 1, to = i / 2 % STATES, frame;
		bool leads = (from < 0 || from == 1) && to != 1;

		states_begin(&f);
		machine->current = 1;
		machine->transition_count = 2;
		f.transition[1] = (struct character_transition){.from = from,
			.to = to,
			.when = &when,
			.exit = i % 2 ? 0.5f : 1};
		/* That of another state, and one that does not count. */
		f.transition[0] = (struct character_transition){
			.from = 2, .to = 3, .when = &when};
		f.transition[2] = (struct character_transition){
			.from = -1, .to = 3, .when = &when};
		frame = i % 2 ? 6 : 10;
		assert_int_equal(leave(&f), leads ? frame : 0);
		assert_int_equal(machine->current, leads ? to : 1);
		assert_int_equal(machine->running, leads ? 1 : -1);
		states_end(&f);
	}
}

/* The first one from the state itself, or from any. */
static void test_a_change_finds_its_transition(void **state)
{
	static const struct {
		int count, from[4], to[4], running;
	} rows[] = {
		{2, {-1, -1}, {2, 2}, 0},
		{3, {1, -1, -1}, {3, 2, 2}, 1},
		{3, {-1, 1, 1}, {2, 2, 2}, 1},
		{2, {0, 2}, {2, 2}, -1},
		{1, {0, -1}, {2, 2}, -1},
		{1, {0, 1}, {2, 2}, -1},
		{3, {0, -1, 1}, {2, 2, 3}, 1},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;
		struct character_machine *machine = &f.character.machine;

		states_begin(&f);
		machine->current = 1;
		machine->transition_count = rows[i].count;
		for (int k = 0; k < 4; k++) {
			f.transition[k].from = rows[i].from[k];
			f.transition[k].to = rows[i].to[k];
		}
		machine->wanted = 2;
		states_run(&f, 1);
		assert_int_equal(machine->current, 2);
		assert_int_equal(machine->running, rows[i].running);
		states_end(&f);
	}
}

/* The transition that runs from 0 to 1 has the priority 2. */
static void test_a_transition_of_higher_priority_interrupts(void **state)
{
	static const struct {
		float priority;
		int to, shown;
	} rows[] = {{3, 2, 2}, {2, 2, 1}, {3, 3, 1}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;
		struct character_machine *machine = &f.character.machine;

		states_begin(&f);
		machine->transition_count = 3;
		f.transition[0] = (struct character_transition){
			.from = 3, .to = 0, .priority = 9};
		f.transition[1] = (struct character_transition){
			.from = 1, .to = 2, .priority = rows[i].priority};
		f.transition[2] = (struct character_transition){.from = 0,
			.to = 1,
			.priority = 2,
			.interrupt = CHARACTER_INTERRUPT_HIGHER,
			.fade = {.duration_s = 1}};
		states_run(&f, 1);
		machine->wanted = 1;
		states_run(&f, 1);
		assert_int_equal(machine->running, 2);
		machine->wanted = rows[i].to;
		states_run(&f, 1);
		assert_int_equal(machine->current, rows[i].shown);
		/* What was asked for comes after the fade. */
		states_run(&f, 5);
		assert_int_equal(machine->current, rows[i].to);
		states_end(&f);
	}
}

/* Where a state ends at the same moment. */
static void test_what_is_asked_for_comes_before_the_next_state(void **state)
{
	(void)state;
	for (int wanted = 0; wanted < STATES; wanted++) {
		struct states f;

		states_begin(&f);
		f.character.machine.current = 1;
		f.state[1].next = 2;
		states_run(&f, 9);
		f.character.machine.wanted = wanted;
		states_run(&f, 1);
		assert_int_equal(f.character.machine.current, wanted);
		states_end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_state_ends_when_so_much_is_left_as_the_fade_takes),
		cmocka_unit_test(test_a_pause_follows_the_end_of_a_clip),
		cmocka_unit_test(test_a_state_without_a_next_one_plays_on),
		cmocka_unit_test(test_a_change_runs_what_leaves_and_enters),
		cmocka_unit_test(test_a_transition_leads_to_another_state),
		cmocka_unit_test(test_a_change_finds_its_transition),
		cmocka_unit_test(test_a_transition_of_higher_priority_interrupts),
		cmocka_unit_test(
			test_what_is_asked_for_comes_before_the_next_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
