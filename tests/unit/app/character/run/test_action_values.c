/* What actions do to states, morphs and parameters, in numbers. */
#include "app/character/run/actions.h"
#include "app/character/run/layers.h"
#include "tests/support/test.h"

#include <string.h>

/* Runs one action so many times over. */
static void run(struct character *character, struct character_action action,
	float times)
{
	character->pending[0].action = &action;
	character->pending[0].times = times;
	character->pending_count = 1;
	character_actions_run(character);
	assert_int_equal(character->pending_count, 0);
}

/* From the upper half of its range to the low end, else to the high one. */
static void test_a_toggle_goes_to_the_other_end(void **state)
{
	static const struct {
		float range[2], goal, wanted;
	} rows[] = {{{2, 6}, 2, 6}, {{2, 6}, 6, 2}, {{2, 6}, 4, 6},
		{{2, 6}, 4.1f, 2}, {{2, 6}, 3.9f, 6}, {{-6, -2}, -6, -2},
		{{-6, -2}, -3.9f, -6}, {{-3, 9}, 3.1f, -3}, {{-3, 9}, 2.9f, 9}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_parameter one = {
			.range = {rows[i].range[0], rows[i].range[1]},
			.goal = rows[i].goal};
		struct character character = {
			.parameter = &one, .parameter_count = 1};

		run(&character,
			(struct character_action){.verb = CHARACTER_TOGGLE}, 1);
		assert_near(one.goal, rows[i].wanted, 0);
	}
}

/* Of three, with steps over any number of rounds. */
static void test_choices_go_round(void **state)
{
	static const struct {
		float goal, step;
		int times;
		float wanted;
	} rows[] = {{0, 1, 1, 1}, {2, 1, 1, 0}, {0, -1, 1, 2}, {1, -1, 1, 0},
		{0, 1, 2, 2}, {2, 1, 3, 2}, {1, 4, 1, 2}, {0, -3, 1, 0},
		{1, -3, 1, 1}, {2, 3, 1, 2}, {0, 7, 1, 1}, {0, -7, 1, 2},
		{1, 30, 1, 1}, {1, 1000003, 1, 2}, {0, -100, 1, 2}};
	static const char *const names[3] = {"a", "b", "c"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_parameter one = {.range = {0, 2},
			.goal = rows[i].goal,
			.choice = names,
			.choice_count = 3};
		struct character character = {
			.parameter = &one, .parameter_count = 1};

		run(&character,
			(struct character_action){
				.verb = CHARACTER_ADD, .amount = rows[i].step},
			(float)rows[i].times);
		assert_near(one.goal, rows[i].wanted, 0);
	}
}

/* From the state that was asked for before, be it the first one. */
static void test_states_step_on_from_what_is_wanted(void **state)
{
	static const struct {
		int wanted, step, next;
	} rows[] = {{-1, 1, 3}, {-1, -1, 1}, {-1, 2, 0}, {-1, -3, 3}, {0, 1, 1},
		{0, -1, 3}, {1, 1, 2}, {3, 1, 0}, {3, -4, 3}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character character = {.machine = {.state_count = 4,
						      .current = 2,
						      .wanted = rows[i].wanted}};

		run(&character,
			(struct character_action){.verb = CHARACTER_NEXT,
				.amount = (float)rows[i].step},
			1);
		assert_int_equal(character.machine.wanted, rows[i].next);
	}
}

/* It begins with the present state, and ends with what plays then. */
static void test_a_row_begins_and_ends(void **state)
{
	const struct character_action row = {.verb = CHARACTER_ROW};
	struct character character = {.machine = {.current = 2, .wanted = 1}};

	(void)state;
	run(&character, row, 1);
	assert_true(character.machine.in_row);
	assert_int_equal(character.machine.wanted, 2);
	run(&character, row, 1);
	assert_false(character.machine.in_row);
	assert_true(character.machine.wanted < 0);
}

/* To the key that is named, or so many on; in the time of the last frame. */
static void test_a_morph_goes_to_a_key(void **state)
{
	static const struct {
		int detail;
		float amount;
		int wanted;
	} rows[] = {{0, 0, 0}, {1, 0, 1}, {2, 5, 2}, {-1, 1, 0}, {-1, -1, 1},
		{-1, -2, 0}, {-1, 2, 1}, {-1, -3, 2}};
	static const float position[1][3];
	struct morph_key key[3] = {{.position = position},
		{.position = position}, {.position = position}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_morph morph = {.key = key,
			.key_count = 3,
			.destiny = 2,
			.pace = 1,
			.duration_s = 4};
		struct arena arena = arena_empty();
		struct character character = {.morph = &morph,
			.morph_count = 1,
			.now_s = 8,
			.step_s = 0.5f};

		assert_int_equal(morph_init(&morph.morph, 1, key[2], &arena), 0);
		run(&character,
			(struct character_action){.verb = CHARACTER_MORPH,
				.detail = rows[i].detail,
				.amount = rows[i].amount},
			1);
		assert_int_equal(morph.destiny, rows[i].wanted);
		assert_int_equal(morph.before, 2);
		assert_near(morph.morph.end_ms, 11500, 1e-6);
		arena_release(&arena);
	}
}

/* From now on, and with its first line. */
static void test_a_tour_begins_anew(void **state)
{
	const struct character_action tour = {.verb = CHARACTER_TOUR};
	struct character_tour line = {.time_s = 1};
	struct character character = {.now_s = 8, .scene = {.tour = &line}};

	(void)state;
	run(&character, tour, 1);
	assert_true(character.touring);
	assert_near(character.tour_from_s, 8, 0);
	assert_ptr_equal(character.tour_next, &line);
	run(&character, tour, 1);
	assert_false(character.touring);
}

/* By its own speed, for as long as the button is held. */
static void test_a_part_moves_by_its_speed(void **state)
{
	struct character_part part = {0};
	struct character character = {.part = &part, .part_count = 1};

	(void)state;
	part.freedom[1].speed = 4;
	part.freedom[1].moved = 1;
	run(&character,
		(struct character_action){
			.verb = CHARACTER_MOVE, .detail = 1, .amount = -0.5f},
		0.25f);
	assert_near(part.freedom[1].moved, 0.5, 0);
	assert_near(part.freedom[0].moved, 0, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_toggle_goes_to_the_other_end),
		cmocka_unit_test(test_choices_go_round),
		cmocka_unit_test(test_states_step_on_from_what_is_wanted),
		cmocka_unit_test(test_a_row_begins_and_ends),
		cmocka_unit_test(test_a_morph_goes_to_a_key),
		cmocka_unit_test(test_a_tour_begins_anew),
		cmocka_unit_test(test_a_part_moves_by_its_speed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
