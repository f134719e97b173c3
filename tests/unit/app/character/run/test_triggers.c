/* Actions of comparisons that begin and cease to hold, and pulses of outputs. */
#include "app/character/run/outputs.h"
#include "app/character/run/triggers.h"
#include "tests/support/test.h"

/* Two triggers: whether a value is above 1, and whether it is below 3. */
static void test_triggers_act_when_comparisons_change(void **state)
{
	static const struct {
		float value;
		int count, action[2];
	} rows[] = {{2, 0, {0}}, {2, 0, {0}}, {1, 1, {11}}, {1, 0, {0}},
		{4, 2, {10, 21}}, {4, 0, {0}}, {2, 1, {20}}, {0, 1, {11}}};
	const float one = 1, three = 3;
	float value = 0;
	struct character_condition when[2] = {
		{.left = &value, .right = &one, .is = CHARACTER_ABOVE},
		{.left = &value, .right = &three, .is = CHARACTER_BELOW}};
	const struct character_action then[2] = {{.index = 10}, {.index = 20}};
	const struct character_action otherwise[2] = {
		{.index = 11}, {.index = 21}};
	struct character_trigger trigger[2];
	struct character character = {.trigger = trigger, .trigger_count = 2};

	(void)state;
	for (int i = 0; i < 2; i++) {
		trigger[i] = (struct character_trigger){.when = &when[i],
			.then = &then[i],
			.otherwise = &otherwise[i]};
	}
	/* The first frame begins nothing. */
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		value = rows[i].value;
		character.pending_count = 0;
		character_triggers_update(&character);
		assert_int_equal(character.pending_count, rows[i].count);
		for (int k = 0; k < rows[i].count; k++) {
			assert_int_equal(character.pending[k].action->index,
				rows[i].action[k]);
			assert_near(character.pending[k].times, 1, 0);
		}
	}
}

enum {
	UNDRIVEN = -1
};

/* What was last driven, as ten times the output and 1 for on. */
static void note(void *user, int output, bool on)
{
	*(int *)user = 10 * output + on;
}

/* To the millisecond; 0 ms are none, and less is on for good. */
static void test_a_pulse_takes_its_milliseconds(void **state)
{
	int driven = UNDRIVEN;
	struct character character = {.output_count = 2,
		.seen_s = 8,
		.drive = note,
		.drive_user = &driven};
	struct character_output *output = character.output;

	(void)state;
	character_output_drive(&character, 1, 500);
	assert_int_equal(driven, 11);
	assert_true(output[1].on);
	assert_near(output[1].until_s, 8.5, 0);
	driven = UNDRIVEN;
	character.seen_s = 8.4999;
	character_outputs_update(&character);
	assert_int_equal(driven, UNDRIVEN);
	character.seen_s = 8.5;
	character_outputs_update(&character);
	assert_int_equal(driven, 10);
	assert_false(output[1].on);
	character_output_drive(&character, 0, -1);
	assert_int_equal(driven, 1);
	driven = UNDRIVEN;
	character.seen_s = 1e6;
	character_outputs_update(&character);
	assert_int_equal(driven, UNDRIVEN);
	assert_true(output[0].on);
	character_output_drive(&character, 0, 0);
	assert_int_equal(driven, 0);
	assert_false(output[0].on);
	/* What began at time 0 may end there. */
	character.seen_s = 0;
	output[1].on = true;
	output[1].until_s = 0;
	character_outputs_update(&character);
	assert_int_equal(driven, 10);
	/* No other output is looked at, and none is needed. */
	output[2].on = true;
	character.drive = NULL;
	character_output_drive(&character, 0, 0.5f);
	assert_near(output[0].until_s, 0.0005, 1e-9);
	character.seen_s = 1;
	character_outputs_update(&character);
	assert_false(output[0].on);
	assert_true(output[2].on);
}

static void test_lines_are_looked_at_once_a_second(void **state)
{
	struct character_outputs outputs = {.next_s = 5};

	(void)state;
	character_outputs_check(&outputs, 4.9);
	assert_near(outputs.next_s, 5, 0);
	character_outputs_check(&outputs, 5);
	assert_near(outputs.next_s, 6, 0);
	character_outputs_check(&outputs, 7.5);
	assert_near(outputs.next_s, 8.5, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_triggers_act_when_comparisons_change),
		cmocka_unit_test(test_a_pulse_takes_its_milliseconds),
		cmocka_unit_test(test_lines_are_looked_at_once_a_second),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
