/* The time of a clip that a state plays, and the events on its way. */
#include "app/character/state/entry.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	EVENTS = 5,
	ALL = 31
};

/* A clip with an event in each quarter of it, the last one at its end. */
struct fixture {
	struct model_clip clip;
	struct character_clip of;
	struct character_action action[EVENTS];
	struct character_event event[EVENTS];
	struct character_entry entry;
	struct character character;
};

static void begin_of(struct fixture *f, float duration_s)
{
	memset(f, 0, sizeof(*f));
	f->clip.duration_s = duration_s;
	f->of.clip = &f->clip;
	f->of.event = f->event;
	for (int i = 0; i < EVENTS; i++) {
		f->action[i].index = i;
		f->event[i] = (struct character_event){
			.time_s = duration_s * 0.25f * (float)i,
			.action = &f->action[i],
			.next = i + 1 < EVENTS ? &f->event[i + 1] : NULL};
	}
	f->entry.of = &f->of;
}

/* The same of 2 s. */
static void begin(struct fixture *f)
{
	begin_of(f, 2);
}

/* Shows the clip. Returns bits: the events that it causes, each of them once. */
static unsigned show(struct fixture *f, enum clip_repeat repeat)
{
	unsigned seen = 0;

	f->character.pending_count = 0;
	character_entry_show(&f->character, &f->entry, repeat);
	for (int i = 0; i < f->character.pending_count; i++) {
		unsigned bit = 1U << f->character.pending[i].action->index;

		assert_false(seen & bit);
		assert_near(f->character.pending[i].times, 1, 0);
		seen |= bit;
	}
	return seen;
}

/* Times of a clip of 2 s. */
struct way {
	double from_s, step_s;
	float shown_s;
	unsigned events;
};

/* The same holds for times of a clip of half a second. */
static void expect(enum clip_repeat repeat, const struct way *way, size_t count)
{
	for (size_t i = 0; i < 2 * count; i++) {
		double scale = i < count ? 1 : 0.25;
		const struct way *one = &way[i % count];
		struct fixture f;

		begin_of(&f, (float)(2 * scale));
		character_entry_begin(&f.entry, scale * one->from_s);
		show(&f, repeat);
		character_entry_move(&f.entry, scale * one->step_s, NULL);
		assert_int_equal(show(&f, repeat), one->events);
		assert_near(f.entry.shown_s, scale * (double)one->shown_s, 0);
		assert_near(f.entry.before_s, scale * one->from_s, 0);
		assert_near(
			f.entry.time_s, scale * (one->from_s + one->step_s), 0);
	}
}

/* An event at the start of a step was on the way before. */
static void test_a_clip_that_plays_once_passes_what_is_on_its_way(void **state)
{
	static const struct way rows[] = {
		{0.25, 0.25, 0.5f, 2},
		{0.5, 0.25, 0.75f, 0},
		{0.25, 0, 0.25f, 0},
		{0.5, 0, 0.5f, 0},
		{1.5, 1, 2, 16},
		{2.5, 1, 2, 0},
		{0.25, 5, 2, 2 | 4 | 8 | 16},
		{0.75, -0.25, 0.5f, 2},
		{0.5, -0.25, 0.25f, 0},
		{1, -5, 0, 1 | 2},
		{-1, -1, 0, 0},
	};

	(void)state;
	expect(CLIP_ONCE, rows, ARRAY_COUNT(rows));
}

/* Its end and its start are one moment, with the events of both. */
static void test_a_clip_that_loops_passes_its_end_and_start(void **state)
{
	static const struct way rows[] = {
		{0.25, 0.25, 0.5f, 2},
		{0.5, 0.25, 0.75f, 0},
		{0.5, 0, 0.5f, 0},
		{1.5, 0.75, 0.25f, 16 | 1},
		{1.75, 0.75, 0.5f, 16 | 1 | 2},
		{0.5, 1.75, 0.25f, ALL - 2},
		{0.5, 2, 0.5f, ALL},
		{0.5, 2.25, 0.75f, ALL},
		{0.25, -0.25, 0, 1},
		{0.5, -0.25, 0.25f, 0},
		{0.75, -0.25, 0.5f, 2},
		{0.25, -0.75, 1.5f, 1 | 8 | 16},
		{0.5, -1.75, 0.75f, ALL - 2},
		{0.5, -2, 0.5f, ALL},
		{0.5, -2.25, 0.25f, ALL},
		{2.25, 0.25, 0.5f, 2},
		{-0.25, -0.25, 1.5f, 8},
		{-0.25, 0.5, 0.25f, 16 | 1},
	};

	(void)state;
	expect(CLIP_LOOP, rows, ARRAY_COUNT(rows));
}

static void test_a_clip_that_turns_passes_the_end_at_which_it_does(void **state)
{
	/* Legs of the way to and fro: 0..2, 2..4, -2..0, and so on. */
	static const struct way rows[] = {
		{0.25, 0.25, 0.5f, 2},
		{1.75, 0.5, 1.75f, 16},
		{1.25, 1.25, 1.5f, 8 | 16},
		{1.75, 1, 1.25f, 16 | 8},
		{1.5, 0.5, 2, 16},
		{2, 0.25, 1.75f, 0},
		{2.25, 0.5, 1.25f, 8},
		{3.75, 0.5, 0.25f, 1},
		{3.25, 1, 0.25f, 2 | 1},
		{3.75, 1, 0.75f, 1 | 2},
		{4.25, 0.25, 0.5f, 2},
		{4.25, -0.5, 0.25f, 1},
		{2.25, -0.5, 1.75f, 16},
		{2.75, -0.5, 1.75f, 8},
		{0.25, -0.5, 0.25f, 1},
		{-0.25, -0.5, 0.75f, 2},
		{-0.25, 0.5, 0.25f, 1},
		{-1.75, -0.5, 1.75f, 16},
		{-2.25, 0.5, 1.75f, 16},
		{1, 0, 1, 0},
		{0.25, 1.75, 2, 2 | 4 | 8 | 16},
		{0.25, 2, 1.75f, ALL},
		{0.25, -2, 1.75f, ALL},
		/* After fifty years. */
		{1610612736 - 0.25, 0.5, 0.25f, 1},
	};

	(void)state;
	expect(CLIP_PING_PONG, rows, ARRAY_COUNT(rows));
}

/* Wherever it begins. */
static void test_a_clip_that_begins_passes_its_first_moment(void **state)
{
	struct fixture f;

	(void)state;
	for (int repeat = CLIP_ONCE; repeat <= CLIP_PING_PONG; repeat++) {
		begin(&f);
		character_entry_begin(&f.entry, 0.5);
		assert_int_equal(show(&f, repeat), 2);
		assert_int_equal(show(&f, repeat), 0);
		character_entry_begin(&f.entry, 0.5);
		assert_near(f.entry.shown_s, -1, 0);
		character_entry_move(&f.entry, 0.5, NULL);
		assert_int_equal(show(&f, repeat), 2 | 4);
		/* One without a length is only ever there. */
		f.clip.duration_s = 0;
		character_entry_begin(&f.entry, 0);
		assert_int_equal(show(&f, repeat), 1);
		character_entry_move(&f.entry, 0.5, NULL);
		assert_int_equal(show(&f, repeat), 0);
	}
}

static void test_a_clip_that_follows_another_one_causes_no_events(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.entry.follows = true;
	character_entry_begin(&f.entry, 0.5);
	assert_int_equal(show(&f, CLIP_LOOP), 0);
	assert_near(f.entry.shown_s, 0.5, 0);
	character_entry_move(&f.entry, 0.5, NULL);
	f.entry.follows = false;
	assert_int_equal(show(&f, CLIP_LOOP), 4);
}

/* From mark to mark take 1, 0.25 and, over the clip's end, 0.75 s. */
static void mark(struct fixture *f)
{
	begin(f);
	f->of.mark_count = 3;
	f->of.mark[0] = 0.25f;
	f->of.mark[1] = 1.25f;
	f->of.mark[2] = 1.5f;
}

static void test_a_phase_is_a_time_between_marks(void **state)
{
	static const struct {
		double phase, time_s, marks_per_s;
	} rows[] = {{0, 0.25, 1}, {0.5, 0.75, 1}, {1, 1.25, 4}, {1.5, 1.375, 4},
		{2, 1.5, 4.0 / 3}, {2.5, 1.875, 4.0 / 3}, {3, 2.25, 1},
		{4.5, 3.375, 4}, {6.25, 4.5, 1}, {-1, -0.5, 4.0 / 3},
		{-0.5, -0.125, 4.0 / 3}, {-2.5, -1.25, 1}, {-3, -1.75, 1},
		{-3.5, -2.125, 4.0 / 3},
		/* A little before a round, which rounding makes its start. */
		{-1e-20, 0.25, 4.0 / 3}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;

		mark(&f);
		character_entry_begin(&f.entry, 0);
		character_entry_move(&f.entry, 9, &rows[i].phase);
		assert_near(f.entry.time_s, rows[i].time_s, 0);
		assert_near(character_entry_marks_per_s(&f.entry, rows[i].phase),
			rows[i].marks_per_s, 1e-6);
	}
}

/* It may begin anywhere, and has come no way then. */
static void test_a_clip_in_phase_begins_where_that_is(void **state)
{
	struct fixture f;
	double phase = 1;

	(void)state;
	mark(&f);
	character_entry_begin(&f.entry, 0);
	character_entry_move(&f.entry, 9, &phase);
	assert_near(f.entry.before_s, 1.25, 0);
	assert_int_equal(show(&f, CLIP_LOOP), 0);
	phase = 2;
	character_entry_move(&f.entry, 9, &phase);
	assert_near(f.entry.before_s, 1.25, 0);
	assert_int_equal(show(&f, CLIP_LOOP), 8);
	/* At its start the clip is shown, too. */
	f.entry.shown_s = 0;
	phase = 3;
	character_entry_move(&f.entry, 9, &phase);
	assert_near(f.entry.before_s, 1.5, 0);
}

static void test_without_marks_or_a_phase_a_clip_has_its_own_time(void **state)
{
	struct fixture f;
	const double phase = 1;

	(void)state;
	mark(&f);
	character_entry_begin(&f.entry, 0.5);
	character_entry_move(&f.entry, 0.25, NULL);
	assert_near(f.entry.time_s, 0.75, 0);
	f.of.mark_count = 0;
	character_entry_move(&f.entry, -0.5, &phase);
	assert_near(f.entry.time_s, 0.25, 0);
	assert_near(f.entry.before_s, 0.75, 0);
	f.of.mark_count = 1;
	character_entry_move(&f.entry, 9, &phase);
	assert_near(f.entry.time_s, 2.25, 0);
}

/* Between 48 of them, the last of which leads to the first. */
static void test_the_height_of_a_sole_is_that_at_the_time_shown(void **state)
{
	static float height_m[2][CHARACTER_SAMPLES];
	static const struct {
		float shown_s, height_m;
	} rows[] = {{0, 5}, {0.5f, 144 + 5}, {0.5f + 0.5f / 24, 156.5f + 5},
		{0.5f + 0.25f / 24, 150.25f + 5}, {2 - 1.0f / 24, 2209 + 5},
		{2 - 0.25f / 24, 552.25f + 5}, {2, 5}, {-1, 5}};
	struct fixture f;

	(void)state;
	begin(&f);
	f.of.sole_m = height_m;
	for (int i = 0; i < CHARACTER_SAMPLES; i++) {
		height_m[1][i] = (float)(i * i) + 5;
		height_m[0][i] = -1;
	}
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		f.entry.shown_s = rows[i].shown_s;
		assert_near(character_entry_sole_m(&f.entry, 1),
			rows[i].height_m, 1e-2);
		assert_near(character_entry_sole_m(&f.entry, 0), -1, 1e-6);
	}
	f.clip.duration_s = 0.5f;
	f.entry.shown_s = 0.125f;
	assert_near(character_entry_sole_m(&f.entry, 1), 144 + 5, 0);
	f.clip.duration_s = 0;
	f.entry.shown_s = 0.5f;
	assert_near(character_entry_sole_m(&f.entry, 1), 5, 0);
	f.of.clip = NULL;
	assert_near(character_entry_duration_s(&f.entry), 0, 0);
	assert_near(character_entry_sole_m(&f.entry, 1), 5, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_clip_that_plays_once_passes_what_is_on_its_way),
		cmocka_unit_test(test_a_clip_that_loops_passes_its_end_and_start),
		cmocka_unit_test(
			test_a_clip_that_turns_passes_the_end_at_which_it_does),
		cmocka_unit_test(test_a_clip_that_begins_passes_its_first_moment),
		cmocka_unit_test(
			test_a_clip_that_follows_another_one_causes_no_events),
		cmocka_unit_test(test_a_phase_is_a_time_between_marks),
		cmocka_unit_test(test_a_clip_in_phase_begins_where_that_is),
		cmocka_unit_test(
			test_without_marks_or_a_phase_a_clip_has_its_own_time),
		cmocka_unit_test(
			test_the_height_of_a_sole_is_that_at_the_time_shown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
