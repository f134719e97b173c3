/* Which numbers lines of a parameter may have, and what they make of it. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>

static void test_lines_of_a_parameter_fit_each_other(void **state)
{
	static const struct {
		const char *lines, *error; /* or NULL */
	} rows[] = {
		{"range = -1 -0.5", NULL},
		{"range = 1 1", "range: the second number has to be larger"},
		{"range = 1 0.9", "range: the second number has to be larger"},
		{"range = 2 3.5\nstart = 2", NULL},
		{"range = 2 3.5\nstart = 3.5", NULL},
		{"range = 2 3.5\nstart = 1.75",
			"start: 1.75 is outside the range 2 to 3.5"},
		{"range = 2 3.5\nstart = 3.75",
			"start: 3.75 is outside the range 2 to 3.5"},
		{"range = 2 3.5\nstops = 2 3.5", NULL},
		{"range = 2 3.5\nstops = 2", NULL},
		{"range = 2 3.5\nstops = 1.5 3",
			"stops: 1.5 is outside the range 2 to 3.5"},
		{"range = 2 3.5\nstops = 2 4",
			"stops: 4 is outside the range 2 to 3.5"},
		{"range = 2 3.5\nstops = 3 3", "increasing numbers"},
		{"range = 2 3.5\nstops = 3 2.5", "increasing numbers"},
		{"source = sine 0.01", NULL},
		{"source = sine 0.0099", "at least 0.01"},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[128];

		snprintf(text, sizeof(text), "[parameter p]\n%s\n",
			rows[i].lines);
		acting_read(&acting, text);
		assert_int_equal(acting.error, rows[i].error ? -EINVAL : 0);
		if (rows[i].error) {
			assert_contains(
				acting.logged.sentence[0], rows[i].error);
		}
	}
	acting_end(&acting);
}

/* Without a start, the number of the range that is nearest to 0. */
static void test_a_parameter_starts_near_0(void **state)
{
	static const struct {
		const char *lines;
		double start;
	} rows[] = {{"range = -1 1", 0}, {"range = 2 3", 2},
		{"range = -3 -2", -2}, {"range = -3 3\nstart = 1.5", 1.5}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_parameter *parameter;
		char text[128];

		snprintf(text, sizeof(text), "[parameter p]\n%s\n",
			rows[i].lines);
		acting_expect(&acting, text);
		parameter = acting.character->parameter;
		assert_near(parameter->start, rows[i].start, 0);
		assert_near(parameter->value, rows[i].start, 0);
	}
	acting_end(&acting);
}

static void test_a_source_has_a_scale_and_an_offset(void **state)
{
	static const struct {
		const char *source;
		enum character_source is;
		double scale, offset;
	} rows[] = {{"buttons", CHARACTER_SOURCE_ACTIONS, 1, 0},
		{"motion", CHARACTER_SOURCE_MOTION, 1, 0},
		{"time", CHARACTER_SOURCE_TIME, 1, 0},
		{"time 2", CHARACTER_SOURCE_TIME, 2, 0},
		{"time -2 0.5", CHARACTER_SOURCE_TIME, -2, 0.5},
		{"sine 4", CHARACTER_SOURCE_SINE, 4, 0},
		{"sine 4 0.25", CHARACTER_SOURCE_SINE, 4, 0.25},
		{"q", CHARACTER_SOURCE_PARAMETER, 1, 0},
		{"q 3 -1", CHARACTER_SOURCE_PARAMETER, 3, -1}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_parameter *parameter;
		char text[128];

		snprintf(text, sizeof(text),
			"[parameter p]\nsource = %s\n[parameter q]\n",
			rows[i].source);
		acting_expect(&acting, text);
		parameter = acting.character->parameter;
		assert_int_equal(parameter->source, rows[i].is);
		assert_near(parameter->scale, rows[i].scale, 0);
		assert_near(parameter->offset, rows[i].offset, 0);
	}
	acting_end(&acting);
}

/* From above the middle of the range to its lower end, else to the upper one. */
static void test_a_toggle_goes_to_the_farther_end(void **state)
{
	static const struct {
		const char *start;
		double end;
	} rows[] = {{"-4", 2}, {"-1.5", 2}, {"-1", 2}, {"-0.5", -4}, {"2", -4}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[128];

		snprintf(text, sizeof(text),
			"[parameter p]\nrange = -4 2\nstart = %s\n"
			"[buttons]\nUP = toggle p\n",
			rows[i].start);
		acting_expect(&acting, text);
		acting_run_to(&acting, acting.now_s + 0.1, 50.0);
		acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
		assert_near(acting_value(&acting, "p"), rows[i].end, 0);
		acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
		assert_near(acting_value(&acting, "p"), -2 - rows[i].end, 0);
	}
	acting_end(&acting);
}

static void test_a_parameter_may_follow_each_freedom_of_a_part(void **state)
{
	static const char *const freedoms[] = {
		"heading", "pitch", "bank", "x", "y", "z"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (int i = 0; i < CHARACTER_FREEDOMS; i++) {
		const struct character *character;
		char text[128];

		snprintf(text, sizeof(text),
			"[part Base]\n[part Arm]\n[parameter p]\n"
			"source = part Arm %s 2 3\n",
			freedoms[i]);
		acting_expect(&acting, text);
		character = acting.character;
		assert_ptr_equal(character->parameter[0].other,
			&character->part[1].freedom[i].value);
		assert_near(character->parameter[0].scale, 2, 0);
		assert_near(character->parameter[0].offset, 3, 0);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lines_of_a_parameter_fit_each_other),
		cmocka_unit_test(test_a_parameter_starts_near_0),
		cmocka_unit_test(
			test_a_parameter_may_follow_each_freedom_of_a_part),
		cmocka_unit_test(test_a_toggle_goes_to_the_farther_end),
		cmocka_unit_test(test_a_source_has_a_scale_and_an_offset),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
