/* Gestures of buttons, events of clips, output lines, tours and pauses. */
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>

static const double rate_hz = 50.0;

static void press_once(struct acting *acting, enum button button)
{
	acting_tap(acting, button, 1.0 / rate_hz, rate_hz);
}

/* Two presses within a frame, and one that waits for a transition's time. */
static void test_each_press_of_next_steps_on(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = idle\n[state b]\nclip = walk\n"
		"[state c]\nclip = run\n"
		"[buttons]\nUP = next\nDOWN = previous\n");
	acting_run_to(&acting, 0.1, rate_hz);
	for (int i = 0; i < 2; i++) {
		acting_press(&acting, BUTTON_UP);
		acting_release(&acting, BUTTON_UP);
	}
	acting_run_to(&acting, 0.2, rate_hz);
	assert_string_equal(acting_state(&acting), "c");
	for (int i = 0; i < 2; i++) {
		acting_press(&acting, BUTTON_DOWN);
		acting_release(&acting, BUTTON_DOWN);
	}
	acting_run_to(&acting, 0.3, rate_hz);
	assert_string_equal(acting_state(&acting), "a");
	acting_end(&acting);
}

static void test_gestures_of_buttons(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter short]\nrange = 0 9\n[parameter long]\nrange = 0 9\n"
		"[parameter both]\nrange = 0 9\n[parameter held]\nrange = 0 9\n"
		"[parameter up]\nrange = 0 9\n"
		"[buttons]\nUP = add short 1\nUP long = add long 1\n"
		"LEFT = add short 1\nLEFT+RIGHT = add both 1\n"
		"F6 hold = set held 5\nF8 hold = add held 1\nF6 release = add up 1\n");
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 0.2, rate_hz);
	assert_near(acting_value(&acting, "short"), 1.0, 0.0);
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, 1.2, rate_hz);
	acting_release(&acting, BUTTON_UP);
	acting_run_to(&acting, 1.3, rate_hz);
	assert_near(acting_value(&acting, "short"), 1.0, 0.0);
	assert_near(acting_value(&acting, "long"), 1.0, 0.0);
	acting_press(&acting, BUTTON_LEFT);
	acting_run_to(&acting, 1.35, rate_hz);
	acting_press(&acting, BUTTON_RIGHT);
	acting_run_to(&acting, 1.6, rate_hz);
	acting_release(&acting, BUTTON_LEFT);
	acting_release(&acting, BUTTON_RIGHT);
	acting_run_to(&acting, 1.7, rate_hz);
	assert_near(acting_value(&acting, "short"), 1.0, 0.0);
	assert_near(acting_value(&acting, "both"), 1.0, 0.0);
	press_once(&acting, BUTTON_LEFT);
	acting_run_to(&acting, 2.0, rate_hz);
	assert_near(acting_value(&acting, "short"), 2.0, 0.0);
	acting_press(&acting, BUTTON_F6);
	acting_run_to(&acting, 2.5, rate_hz);
	assert_near(acting_value(&acting, "held"), 5.0, 0.0);
	acting_release(&acting, BUTTON_F6);
	acting_run_to(&acting, 2.6, rate_hz);
	assert_near(acting_value(&acting, "held"), 0.0, 0.0);
	assert_near(acting_value(&acting, "up"), 1.0, 0.0);
	acting_press(&acting, BUTTON_F8);
	acting_run_to(&acting, 4.6, rate_hz);
	assert_near(acting_value(&acting, "held"), 2.0, 0.05);
	acting_end(&acting);
}

static void test_a_release_takes_back_what_holding_has_set_and_no_more(
	void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 9\n[parameter w]\nrange = 0 9\n"
		"[parameter mode]\nrange = 0 1\n"
		"[buttons]\nUP = set mode 1\nDOWN = set w 3\n"
		"[buttons a]\nwhen = mode is 0\nF6 hold = set v 5\n"
		"[buttons b]\nwhen = mode is 1\nF8 hold = set w 7\n");
	press_once(&acting, BUTTON_DOWN);
	acting_press(&acting, BUTTON_F6);
	acting_press(&acting, BUTTON_F8);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(acting_value(&acting, "v"), 5.0, 0.0);
	assert_near(acting_value(&acting, "w"), 3.0, 0.0);
	press_once(&acting, BUTTON_UP);
	acting_release(&acting, BUTTON_F8); /* before "F8 hold" has run once */
	acting_run_to(&acting, 1.0, rate_hz);
	/* F6 would not begin now, but was held before. */
	assert_near(acting_value(&acting, "mode"), 1.0, 0.0);
	assert_near(acting_value(&acting, "v"), 5.0, 0.0);
	acting_release(&acting, BUTTON_F6);
	acting_run_to(&acting, 1.5, rate_hz);
	assert_near(acting_value(&acting, "v"), 0.0, 0.0);
	assert_near(acting_value(&acting, "w"), 3.0, 0.0);
	acting_end(&acting);
}

static void test_events_run_actions_once_a_round(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter steps]\nrange = 0 99\n[parameter begun]\nrange = 0 99\n"
		"[state a]\nclip = walk\nenter = add begun 1\n"
		"[state b]\nclip = idle\n"
		"[clip walk]\nevent = 0 add steps 1\nevent = 0.6 add steps 1\n"
		"[buttons]\nUP = go b\nDOWN = go a\n");
	acting_run_to(&acting, 5.49, 37.0); /* five rounds of 1.1 s */
	assert_near(acting_value(&acting, "steps"), 10.0, 0.0);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 7.0, 37.0);
	assert_near(acting_value(&acting, "steps"), 10.0, 0.0);
	press_once(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 7.2, 37.0);
	assert_near(acting_value(&acting, "steps"), 11.0, 0.0);
	assert_near(acting_value(&acting, "begun"), 2.0, 0.0);
	acting_end(&acting);
}

/* Also where the two clips of a blend have the same weight. */
static void test_one_clip_of_a_blend_causes_events(void **state)
{
	static const char *const values[] = {"0.2", "0.5", "0.8"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(values); i++) {
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[parameter steps]\nrange = 0 99\n"
			"[state a]\nblend = %s, walk 0, run 1\n"
			"[clip walk]\nmarks = 0\nevent = 0.3 add steps 1\n"
			"[clip run]\nmarks = 0\nevent = 0.3 add steps 10\n",
			values[i]);
		acting_begin(&acting, "assets/walker.glb");
		acting_expect(&acting, text);
		acting_run_to(&acting, 0.6, rate_hz);
		assert_near(acting_value(&acting, "steps"), i < 2 ? 1.0 : 10.0,
			0.0);
		acting_end(&acting);
	}
}

/* The clip wave ends between two frames, and so do both of its last events. */
static void test_a_layer_that_plays_once_causes_its_last_events(void **state)
{
	struct acting acting;
	char text[256];
	float wave_s;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	wave_s = acting.model->clip[model_find_clip(acting.model, "wave")]
			 .duration_s;
	snprintf(text, sizeof(text),
		"[parameter waves]\nrange = 0 999\n[state a]\nclip = idle\n"
		"[layer b]\nclip = wave\nplay = once\n"
		"[clip wave]\nevent = 0 add waves 1\n"
		"event = %.9g add waves 10\nevent = %.9g add waves 100\n"
		"[buttons]\nUP = play b\n",
		(double)wave_s - 0.001, (double)wave_s);
	acting_expect(&acting, text);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, (double)wave_s + 1.0, rate_hz);
	assert_near(acting_value(&acting, "waves"), 111.0, 0.0);
	acting_end(&acting);
}

/* What a board's output line would do. */
struct line {
	bool on;
	int changes;
};

static void drive(void *user, int output, bool on)
{
	struct line *line = user;

	assert_int_equal(output, 0);
	line->changes += line->on != on;
	line->on = on;
}

/* Begins a character whose output drives the line. */
static void begin_with_line(
	struct acting *acting, struct line *line, const char *text)
{
	acting_begin(acting, "assets/walker.glb");
	acting_expect(acting, text);
	acting->character->drive = drive;
	acting->character->drive_user = line;
}

static void test_events_give_pulses_to_output_lines(void **state)
{
	struct acting acting;
	struct line line = {0};

	(void)state;
	begin_with_line(&acting, &line,
		"[state a]\nclip = walk\n[output led]\nline = gpiochip0/18\n"
		"[clip walk]\nevent = 0.3 output led 100\n"
		"event = 0.8 output led 100\n"
		"[buttons]\nUP = output led on\nDOWN = output led off\n");
	acting_run_to(&acting, 0.36, rate_hz);
	assert_true(line.on);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_false(line.on);
	acting_run_to(&acting, 5.5, rate_hz); /* five rounds of 1.1 s */
	assert_int_equal(line.changes, 20);
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, 5.6, rate_hz);
	assert_true(line.on);
	acting_press(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 5.7, rate_hz);
	assert_false(line.on);
	acting_end(&acting);
}

/* What a line drives must not stay on because the figure stands still. */
static void test_a_pulse_ends_during_a_pause(void **state)
{
	struct acting acting;
	struct line line = {0};

	(void)state;
	begin_with_line(&acting, &line,
		"[state a]\nclip = walk\n[output led]\nline = gpiochip0/18\n"
		"[buttons]\nUP = output led 200\nDOWN = pause\n");
	acting_run_to(&acting, 0.5, rate_hz);
	press_once(&acting, BUTTON_UP);
	press_once(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 0.65, rate_hz);
	assert_true(line.on);
	acting_run_to(&acting, 0.8, rate_hz);
	assert_false(line.on);
	acting_end(&acting);
}

static void test_a_tour_presses_buttons_until_somebody_does(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 99\n[scene]\nperiod = 2\ntour = 0.5 UP\n"
		"tour = 1 add v 10\n[buttons]\nUP = add v 1\nDOWN = pause\n");
	acting.character->touring = true;
	acting.character->tour_next = acting.character->scene.tour;
	acting_run_to(&acting, 4.1, rate_hz);
	assert_near(acting_value(&acting, "v"), 22.0, 0.0);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 7.0, rate_hz);
	assert_near(acting_value(&acting, "v"), 23.0, 0.0);
	acting_end(&acting);
}

/* In any order of the lines, and up to the very end of the period. */
static void test_each_line_of_a_tour_acts_at_its_time(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 999\n[scene]\nperiod = 2\n"
		"tour = 1.99 add v 100\ntour = 0.5 add v 1\n"
		"tour = 1 add v 10\n");
	acting.character->touring = true;
	acting.character->tour_next = acting.character->scene.tour;
	acting_run_to(&acting, 0.7, rate_hz);
	assert_near(acting_value(&acting, "v"), 1.0, 0.0);
	acting_run_to(&acting, 1.5, rate_hz);
	assert_near(acting_value(&acting, "v"), 11.0, 0.0);
	acting_run_to(&acting, 6.2, rate_hz);
	assert_near(acting_value(&acting, "v"), 333.0, 0.0);
	acting_end(&acting);
}

static void test_a_pause_holds_the_pose(void **state)
{
	struct acting acting;
	float before[3], after[3];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(
		&acting, "[state a]\nclip = run\n[buttons]\nENTER = pause\n");
	acting_run_to(&acting, 1.0, rate_hz);
	press_once(&acting, BUTTON_ENTER);
	acting_place(&acting, "foot.L", before);
	acting_run_to(&acting, 3.3, rate_hz);
	acting_place(&acting, "foot.L", after);
	assert_all_near(after, before, 3, 0.0);
	press_once(&acting, BUTTON_ENTER);
	acting_run_to(&acting, 3.5, rate_hz);
	acting_place(&acting, "foot.L", after);
	assert_true(fabsf(after[2] - before[2]) > 0.01f);
	acting_end(&acting);
}

static void test_a_line_after_the_tours_period_is_reported(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[scene]\ntour = 3 go rest\ntour = 1 go rest\nperiod = 3\n"
		"[state rest]\nclip = rest\n");
	assert_int_equal(acting.logged.count, 0);
	acting_expect(&acting,
		"[scene]\ntour = 3.5 go rest\ntour = 1 go rest\nperiod = 3\n"
		"[state rest]\nclip = rest\n");
	assert_true(log_capture_has(&acting.logged, LOG_WARNING,
		"[scene] tour: the line at 3.5 s never acts"));
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_gestures_of_buttons),
		cmocka_unit_test(test_each_press_of_next_steps_on),
		cmocka_unit_test(
			test_a_release_takes_back_what_holding_has_set_and_no_more),
		cmocka_unit_test(test_events_run_actions_once_a_round),
		cmocka_unit_test(test_one_clip_of_a_blend_causes_events),
		cmocka_unit_test(
			test_a_layer_that_plays_once_causes_its_last_events),
		cmocka_unit_test(test_events_give_pulses_to_output_lines),
		cmocka_unit_test(test_a_pulse_ends_during_a_pause),
		cmocka_unit_test(test_a_tour_presses_buttons_until_somebody_does),
		cmocka_unit_test(test_each_line_of_a_tour_acts_at_its_time),
		cmocka_unit_test(test_a_line_after_the_tours_period_is_reported),
		cmocka_unit_test(test_a_pause_holds_the_pose),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
