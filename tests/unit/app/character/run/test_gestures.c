/* What presses of buttons cause, to the millisecond, and what tours do. */
#include "app/character/run/gestures.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	ACTIONS = 12
};

struct fixture {
	struct character_binding binding[ACTIONS];
	struct character_action action[ACTIONS], after[ACTIONS];
	struct character_tour tour[3];
	struct character character;
	int count;
};

static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
}

/* Binds the action of this number; one that undoes it has the number + 100. */
static void bind(struct fixture *f, enum character_gesture gesture,
	enum button button, enum button second)
{
	int i = f->count++;
	struct character_button *buttons = f->character.button;

	f->action[i].index = i;
	f->after[i].index = 100 + i;
	f->binding[i] = (struct character_binding){.button = button,
		.second = second,
		.gesture = gesture,
		.action = &f->action[i],
		.after = &f->after[i]};
	if (i > 0) {
		f->binding[i - 1].next = &f->binding[i];
	}
	f->character.binding = f->binding;
	if (gesture == CHARACTER_TOGETHER) {
		buttons[button].joins = buttons[second].joins = true;
	}
	if (gesture == CHARACTER_LONG) {
		buttons[button].has_long = true;
	}
}

static void send(struct fixture *f, enum button button, bool down)
{
	const struct button_event event = {.button = button, .down = down};

	character_gestures_press(&f->character, &event);
}

/* A frame at time_s. */
static void update(struct fixture *f, double time_s)
{
	f->character.real_s = (float)(time_s - f->character.seen_s);
	f->character.seen_s = time_s;
	character_gestures_update(&f->character);
}

/* Expects the numbers of all actions since the last call, which ends by -1. */
static void expect(struct fixture *f, const int *wanted)
{
	struct character *character = &f->character;
	int i = 0;

	for (; wanted[i] >= 0; i++) {
		assert_true(i < character->pending_count);
		assert_int_equal(character->pending[i].action->index, wanted[i]);
	}
	assert_int_equal(character->pending_count, i);
	character->pending_count = 0;
}

#define EXPECT(f, ...) expect((f), (const int[]){__VA_ARGS__, -1})
#define EXPECT_NONE(f) expect((f), (const int[]){-1})

/* A press of each of them, and what holds it, is none then. */
static void test_two_buttons_together_are_no_single_ones(void **state)
{
	(void)state;
	for (int first = 0; first < 2; first++) {
		enum button one = first ? BUTTON_DOWN : BUTTON_UP;
		enum button two = first ? BUTTON_UP : BUTTON_DOWN;
		struct fixture f;

		begin(&f);
		bind(&f, CHARACTER_TOGETHER, BUTTON_UP, BUTTON_DOWN);
		for (int i = 0; i < 2; i++) {
			enum button button = i ? BUTTON_DOWN : BUTTON_UP;

			bind(&f, CHARACTER_PRESS, button, 0);
			bind(&f, CHARACTER_RELEASE, button, 0);
			bind(&f, CHARACTER_HOLD, button, 0);
			bind(&f, CHARACTER_LONG, button, 0);
		}
		send(&f, one, true);
		EXPECT_NONE(&f);
		send(&f, two, true);
		assert_near(f.character.pending[0].times, 1, 0);
		EXPECT(&f, 0);
		update(&f, 1);
		EXPECT_NONE(&f);
		send(&f, one, false);
		send(&f, two, false);
		EXPECT_NONE(&f);
		/* One after the other they are single ones again. */
		send(&f, BUTTON_UP, true);
		send(&f, BUTTON_UP, false);
		EXPECT(&f, 1, 2);
		send(&f, BUTTON_DOWN, true);
		send(&f, BUTTON_DOWN, false);
		EXPECT(&f, 5, 6);
	}
}

/* Within 120 ms, while no long press is asked for. */
static void test_a_press_waits_for_another_button(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bind(&f, CHARACTER_TOGETHER, BUTTON_UP, BUTTON_DOWN);
	bind(&f, CHARACTER_PRESS, BUTTON_UP, 0);
	bind(&f, CHARACTER_PRESS, BUTTON_DOWN, 0);
	send(&f, BUTTON_UP, true);
	update(&f, 0.1199);
	EXPECT_NONE(&f);
	update(&f, 0.12);
	assert_near(f.character.pending[0].times, 1, 0);
	EXPECT(&f, 1);
	update(&f, 0.13);
	EXPECT_NONE(&f);
	/* It is too late for both now. */
	send(&f, BUTTON_DOWN, true);
	EXPECT_NONE(&f);
	send(&f, BUTTON_UP, false);
	EXPECT_NONE(&f);
	send(&f, BUTTON_DOWN, false);
	EXPECT(&f, 2);
}

static void test_a_press_of_seven_tenths_of_a_second_is_long(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bind(&f, CHARACTER_LONG, BUTTON_UP, 0);
	bind(&f, CHARACTER_PRESS, BUTTON_UP, 0);
	bind(&f, CHARACTER_RELEASE, BUTTON_UP, 0);
	send(&f, BUTTON_UP, true);
	update(&f, 0.6995);
	EXPECT_NONE(&f);
	update(&f, 0.7);
	assert_near(f.character.pending[0].times, 1, 0);
	EXPECT(&f, 0);
	update(&f, 0.9);
	EXPECT_NONE(&f);
	send(&f, BUTTON_UP, false);
	EXPECT_NONE(&f);
	/* A shorter one is a press, when it ends. */
	send(&f, BUTTON_UP, true);
	update(&f, 1.5);
	EXPECT_NONE(&f);
	send(&f, BUTTON_UP, false);
	assert_near(f.character.pending[0].times, 1, 0);
	assert_near(f.character.pending[1].times, 1, 0);
	EXPECT(&f, 1, 2);
	send(&f, BUTTON_UP, false);
	EXPECT_NONE(&f);
}

/* As long as it is held, and once what undoes it. */
static void test_a_held_button_acts_in_each_frame(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bind(&f, CHARACTER_HOLD, BUTTON_UP, 0);
	bind(&f, CHARACTER_HOLD, BUTTON_DOWN, 0);
	send(&f, BUTTON_UP, true);
	update(&f, 0.25);
	assert_near(f.character.pending[0].times, 0.25, 0);
	EXPECT(&f, 0);
	update(&f, 0.75);
	assert_near(f.character.pending[0].times, 0.5, 0);
	EXPECT(&f, 0);
	send(&f, BUTTON_DOWN, true);
	send(&f, BUTTON_DOWN, false);
	EXPECT_NONE(&f);
	send(&f, BUTTON_UP, false);
	assert_near(f.character.pending[0].times, 1, 0);
	EXPECT(&f, 100);
	update(&f, 1);
	EXPECT_NONE(&f);
	/* Nothing was done that has to be undone. */
	send(&f, BUTTON_UP, true);
	send(&f, BUTTON_UP, false);
	EXPECT_NONE(&f);
}

/* No button and a release do not end a tour. */
static void test_a_press_ends_a_tour(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	bind(&f, CHARACTER_PRESS, BUTTON_UP, 0);
	f.character.touring = true;
	send(&f, BUTTON_COUNT, true);
	send(&f, BUTTON_UP, false);
	assert_true(f.character.touring);
	EXPECT_NONE(&f);
	send(&f, BUTTON_UP, true);
	assert_false(f.character.touring);
	assert_near(f.character.pending[0].times, 1, 0);
	EXPECT(&f, 0);
}

/* Lines at 0, at a quarter of the period and at its end; the first presses. */
static void begin_tour(struct fixture *f, double period_s)
{
	begin(f);
	bind(f, CHARACTER_PRESS, BUTTON_UP, 0);
	for (int i = 0; i < 3; i++) {
		f->action[1 + i].index = 1 + i;
		f->tour[i] = (struct character_tour){
			.button = i == 0 ? BUTTON_UP : BUTTON_COUNT,
			.action = &f->action[1 + i],
			.next = i < 2 ? &f->tour[i + 1] : NULL};
	}
	f->tour[1].time_s = 0.25 * period_s;
	f->tour[2].time_s = period_s;
	f->character.scene.tour = f->tour;
	f->character.scene.tour_s = period_s;
	f->character.tour_next = f->tour;
	f->character.tour_from_s = 8;
	f->character.touring = true;
}

static void tour(struct fixture *f, double time_s)
{
	f->character.now_s = time_s;
	character_tour_update(&f->character);
}

static void test_each_line_of_a_tour_is_due_at_its_moment(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		const double period_s = i ? 0.5 : 4;
		struct fixture f;

		begin_tour(&f, period_s);
		tour(&f, 8);
		assert_near(f.character.pending[0].times, 1, 0);
		assert_near(f.character.pending[1].times, 1, 0);
		EXPECT(&f, 1, 0);
		tour(&f, 8 + 0.2499 * period_s);
		EXPECT_NONE(&f);
		tour(&f, 8 + 0.25 * period_s);
		EXPECT(&f, 2);
		tour(&f, 8 + 0.9999 * period_s);
		EXPECT_NONE(&f);
		/* Its end is the start of the next round. */
		tour(&f, 8 + period_s);
		EXPECT(&f, 3, 1, 0);
		assert_near(f.character.tour_from_s, 8 + period_s, 0);
		tour(&f, 8 + 1.5 * period_s);
		EXPECT(&f, 2);
		/* A frame that leaves out the rest. */
		tour(&f, 8 + 2.25 * period_s);
		EXPECT(&f, 3, 1, 0, 2);
	}
}

static void test_without_a_period_there_is_no_tour(void **state)
{
	struct fixture f;

	(void)state;
	begin_tour(&f, 0);
	tour(&f, 8);
	EXPECT_NONE(&f);
	begin_tour(&f, 4);
	f.character.touring = false;
	tour(&f, 8);
	EXPECT_NONE(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_two_buttons_together_are_no_single_ones),
		cmocka_unit_test(test_a_press_waits_for_another_button),
		cmocka_unit_test(
			test_a_press_of_seven_tenths_of_a_second_is_long),
		cmocka_unit_test(test_a_held_button_acts_in_each_frame),
		cmocka_unit_test(test_a_press_ends_a_tour),
		cmocka_unit_test(test_each_line_of_a_tour_is_due_at_its_moment),
		cmocka_unit_test(test_without_a_period_there_is_no_tour),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
