/* What the clips of states show, frame by frame. */
#include "tests/unit/app/character/state/states.h"

#include <math.h>

/* Rounds, and the part of the present one, both ways. */
static void test_progress_is_counted_from_where_a_clip_begins(void **state)
{
	static const struct {
		enum clip_repeat repeat;
		float rate;
		int frames, loops;
		float done, shown, held_s;
	} rows[] = {
		{CLIP_LOOP, 1, 1, 0, 0, 0, 0},
		{CLIP_LOOP, 1, 4, 0, 0.375f, 0.75f, 0},
		{CLIP_LOOP, 1, 11, 1, 0.25f, 0.5f, 0},
		{CLIP_LOOP, 2, 11, 2, 0.5f, 1, 0},
		{CLIP_LOOP, -1, 4, 0, 0.375f, 1.25f, 0},
		{CLIP_LOOP, -1, 11, 1, 0.25f, 1.5f, 0},
		{CLIP_PING_PONG, 1, 11, 1, 0.25f, 1.5f, 0},
		{CLIP_ONCE, 1, 4, 0, 0.375f, 0.75f, 0},
		{CLIP_ONCE, 1, 8, 0, 0.875f, 1.75f, 0},
		{CLIP_ONCE, 1, 9, 1, 1, 2, 0.25f},
		{CLIP_ONCE, 1, 12, 1, 1, 2, 1},
		{CLIP_ONCE, -1, 1, 0, 0, 2, 0},
		{CLIP_ONCE, -1, 4, 0, 0.375f, 1.25f, 0},
		{CLIP_ONCE, -1, 12, 1, 1, 0, 1},
		{CLIP_ONCE, 0, 12, 0, 0, 0, 0},
	};
	struct states rest;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;
		const struct character_machine *machine = &f.character.machine;

		states_begin(&f);
		f.state[0].repeat = rows[i].repeat;
		f.rate[0] = rows[i].rate;
		assert_near(states_run(&f, rows[i].frames), rows[i].shown, 1e-5);
		assert_int_equal(machine->loops, rows[i].loops);
		assert_near(machine->done, rows[i].done, 1e-6);
		assert_near(machine->held_s, rows[i].held_s, 1e-6);
		assert_false(machine->fresh);
		states_end(&f);
	}
	/* The rest pose is at its end at once. */
	states_begin(&rest);
	states_shorten(&rest, 0, 0);
	assert_near(states_run(&rest, 1), 100, 1e-5);
	assert_int_equal(rest.character.machine.loops, 1);
	assert_near(rest.character.machine.done, 0, 0);
	states_end(&rest);
}

/* From its end, and again from its start, without the time beyond. */
static void test_a_clip_that_plays_once_goes_back_at_once(void **state)
{
	struct states f;

	(void)state;
	states_begin(&f);
	f.state[0].repeat = CLIP_ONCE;
	assert_near(states_run(&f, 20), 2, 1e-5);
	f.rate[0] = -1;
	assert_near(states_run(&f, 1), 1.75, 1e-5);
	assert_near(states_run(&f, 20), 0, 1e-5);
	f.rate[0] = 1;
	assert_near(states_run(&f, 1), 0.25, 1e-5);
	states_end(&f);
}

/*
 * Two clips with marks at 0.5 and 1.5 s, and at 0 and 0.5 s, and one without,
 * after a second. A mark takes a second in the first, and 0.5 or 1.5 s in the
 * second. The phase goes as fast as the clips that play do in the mean.
 */
static void test_clips_with_marks_keep_in_step(void **state)
{
	static const struct {
		float position, rate;
		double phase, time_s[3];
	} rows[] = {
		{0, 1, 1, {1.5, 0.5, 1}},
		{0, 2, 2, {2.5, 2, 2}},
		{1, 1, 4.0 / 3, {0.5 + 4.0 / 3, 1, 1}},
		{0.25f, 1, 1.25, {1.75, 0.875, 1}},
		/* Where one has no marks, the other alone counts. */
		{1.75f, 1, 4.0 / 3, {0.5 + 4.0 / 3, 1, 1}},
		{2, 1, 0, {0.5, 0, 1}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct states f;

		states_begin(&f);
		f.state[0].entry_count = 3;
		f.of[0].mark_count = f.of[1].mark_count = 2;
		f.of[0].mark[0] = 0.5f;
		f.of[0].mark[1] = 1.5f;
		f.of[1].mark[1] = 0.5f;
		for (int k = 0; k < 3; k++) {
			f.entry[0][k].of = &f.of[k];
		}
		f.position[0] = rows[i].position;
		f.rate[0] = rows[i].rate;
		states_run(&f, 5);
		assert_near(f.character.machine.phase, rows[i].phase, 1e-6);
		for (int k = 0; k < 3; k++) {
			assert_near(
				f.entry[0][k].time_s, rows[i].time_s[k], 1e-6);
		}
		/* A clip that plays once has its own time. */
		f.state[0].repeat = CLIP_ONCE;
		states_run(&f, 1);
		assert_near(f.entry[0][0].time_s,
			fmin(rows[i].time_s[0] + 0.25 * (double)rows[i].rate, 2),
			1e-6);
		states_end(&f);
	}
}

/* It is passed once a round of 2 s. */
static void test_a_clip_may_have_one_mark(void **state)
{
	struct states f;

	(void)state;
	states_begin(&f);
	f.of[0].mark_count = 1;
	states_run(&f, 5);
	assert_near(f.character.machine.phase, 0.5, 1e-6);
	assert_near(f.entry[0][0].time_s, 1, 1e-6);
	states_end(&f);
}

/* Of clips at 0, 1 and 2, which show 0, 10 and 20; one of two causes events. */
static void test_a_blend_shows_its_clips_by_their_weights(void **state)
{
	static const struct {
		float position, shown;
		int best, follows;
	} rows[] = {{-1, 0, 0, -1}, {0, 0, 0, -1}, {0.25f, 2.5f, 0, 1},
		{0.5f, 5, 0, 1}, {0.75f, 7.5f, 1, 0}, {1, 10, 1, -1},
		{1.5f, 15, 1, 2}, {1.75f, 17.5f, 2, 1}, {2, 20, 2, -1},
		{3, 20, 2, -1}, {0, 0, 0, -1}};
	struct states f;

	(void)state;
	states_begin(&f);
	f.state[0].entry_count = 3;
	f.paths[0][0] = 1 << MODEL_WEIGHTS;
	f.rate[0] = 0;
	for (int k = 0; k < 3; k++) {
		f.entry[0][k].of = &f.of[k];
	}
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		f.position[0] = rows[i].position;
		for (int k = 0; k < 3; k++) {
			f.entry[0][k].shown_s = -1;
		}
		assert_near(states_run(&f, 1), rows[i].shown, 1e-5);
		assert_ptr_equal(character_machine_entry(&f.character),
			&f.entry[0][rows[i].best]);
		for (int k = 0; k < 3; k++) {
			bool plays = k == rows[i].best || k == rows[i].follows;

			assert_near(f.entry[0][k].shown_s, plays ? 0 : -1, 0);
			assert_int_equal(plays && f.entry[0][k].follows,
				k == rows[i].follows);
		}
	}
	states_end(&f);
}

/* Cursors that another state has used serve the next one, by its own paths. */
static void test_states_take_the_cursors_of_each_other(void **state)
{
	struct states f;

	(void)state;
	states_begin(&f);
	for (int s = 0; s < 2; s++) {
		f.state[s].entry_count = 3;
		for (int k = 0; k < 3; k++) {
			f.entry[s][k].of = &f.of[k];
		}
		f.position[s] = 0.5f;
	}
	f.paths[1][0] = 1 << MODEL_WEIGHTS;
	/* The first state mixes no weights. */
	assert_near(states_run(&f, 1), 0, 1e-5);
	f.character.machine.wanted = 1;
	assert_near(states_run(&f, 1), 5, 1e-5);
	f.character.machine.wanted = 0;
	assert_near(states_run(&f, 1), 0, 1e-5);
	states_end(&f);
}

/* A change of 20 within half a second, after a frame as long as the others. */
static void test_a_fade_leads_to_the_state(void **state)
{
	struct states f;

	(void)state;
	states_begin(&f);
	f.state[2].fade = (struct character_fade){
		.duration_s = 0.5f, .curve = INERTIA_LINEAR};
	assert_near(states_run(&f, 3), 0.5, 1e-5);
	f.character.machine.wanted = 2;
	assert_near(states_run(&f, 1), 20 - 9.75, 1e-4);
	assert_near(states_run(&f, 1), 20.25, 1e-4);
	states_end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_progress_is_counted_from_where_a_clip_begins),
		cmocka_unit_test(test_a_clip_that_plays_once_goes_back_at_once),
		cmocka_unit_test(test_clips_with_marks_keep_in_step),
		cmocka_unit_test(test_a_clip_may_have_one_mark),
		cmocka_unit_test(test_a_blend_shows_its_clips_by_their_weights),
		cmocka_unit_test(test_states_take_the_cursors_of_each_other),
		cmocka_unit_test(test_a_fade_leads_to_the_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
