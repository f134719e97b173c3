/* Which transition leads to a state, when it begins and how long it takes. */
#include "app/anim/clip_join.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static void begin(struct acting *acting, const char *text)
{
	acting_begin(acting, "assets/walker.glb");
	acting_expect(acting, text);
	acting_run_to(acting, 0.1, rate_hz);
}

static void tap(struct acting *acting, enum button button)
{
	acting_tap(acting, button, 0.04, rate_hz);
}

/* How long the fade takes that a press begins. */
static double fade_of(struct acting *acting, enum button button)
{
	tap(acting, button);
	assert_true(acting->character->machine.inertia.running);
	return acting->character->machine.inertia.duration_s;
}

/* Else that from any state, else the state's own. */
static void test_a_transition_from_the_state_itself_comes_first(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting,
		"[state a]\nclip = walk\n[state b]\nclip = run\nfade = 0.9\n"
		"[state c]\nclip = idle\nfade = 0.8\n[state d]\nclip = wave\n"
		"fade = 0.7\n[transition * d]\npriority = 5\nfade = 0.6\n"
		"[transition * b]\nfade = 0.2\n[transition c d]\nfade = 0.3\n"
		"[transition a b]\nfade = 0.5\n"
		"[buttons]\nUP = go b\nDOWN = go c\nLEFT = go d\nRIGHT = go a\n");
	assert_near(fade_of(&acting, BUTTON_UP), 0.5, 1e-6); /* a to b */
	acting_run_to(&acting, 1.0, rate_hz);
	assert_near(fade_of(&acting, BUTTON_LEFT), 0.6, 1e-6); /* b to d */
	acting_run_to(&acting, 2.0, rate_hz);
	assert_near(fade_of(&acting, BUTTON_UP), 0.2, 1e-6); /* d to b */
	acting_run_to(&acting, 3.0, rate_hz);
	assert_near(fade_of(&acting, BUTTON_DOWN), 0.8, 1e-6); /* b to c */
	acting_run_to(&acting, 4.0, rate_hz);
	assert_near(fade_of(&acting, BUTTON_LEFT), 0.3, 1e-6); /* c to d */
	acting_run_to(&acting, 5.0, rate_hz);
	assert_near(fade_of(&acting, BUTTON_RIGHT), 0.3, 1e-6); /* default */
	acting_end(&acting);
}

/* Those of the clip before, or of 30 a second in the rest pose. */
static void test_a_fade_may_be_counted_in_frames(void **state)
{
	struct acting acting;
	double frame_s;

	(void)state;
	begin(&acting,
		"[state a]\nclip = walk\n[state b]\nclip = rest\n"
		"fade = 6 frames\n[state c]\nclip = run\nfade = 1 frames\n"
		"[buttons]\nUP = go b\nDOWN = go c\n");
	frame_s = clip_join_frame_s(
		acting.character->machine.state[0].entry[0].of->clip);
	assert_near(fade_of(&acting, BUTTON_UP), 6 * frame_s, 1e-6);
	acting_run_to(&acting, 1.0, rate_hz);
	acting_tap(&acting, BUTTON_DOWN, 0.02, rate_hz);
	assert_near(
		acting.character->machine.inertia.duration_s, 1.0 / 30, 1e-6);
	acting_end(&acting);
}

static void test_a_fade_has_the_curve_that_the_file_names(void **state)
{
	static const struct {
		const char *fade;
		enum inertia_curve curve;
	} cases[] = {{"0.5", INERTIA_SMOOTH}, {"0.5 smooth", INERTIA_SMOOTH},
		{"0.5 linear", INERTIA_LINEAR}, {"0.5 cubic", INERTIA_CUBIC},
		{"9 frames linear", INERTIA_LINEAR}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[state a]\nclip = walk\n[state b]\nclip = run\n"
			"fade = %s\n[buttons]\nUP = go b\n",
			cases[i].fade);
		begin(&acting, text);
		tap(&acting, BUTTON_UP);
		assert_true(acting.character->machine.inertia.running);
		assert_int_equal(acting.character->machine.inertia.curve,
			cases[i].curve);
		acting_end(&acting);
	}
}

/*
 * From a to b within 2 s; c is asked for after half a second, and then after
 * the fade.
 */
static void test_a_transition_says_what_may_interrupt_it(void **state)
{
	static const struct {
		const char *running, *next;
		bool interrupts;
	} cases[] = {
		{"interrupt = always\n", "", true},
		{"interrupt = never\n", "priority = 9\n", false},
		{"interrupt = higher\npriority = 2\n", "priority = 3\n", true},
		{"interrupt = higher\npriority = 2\n", "priority = 2\n", false},
		{"interrupt = higher\npriority = 2\n", "priority = 1\n", false},
		{"", "", true},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct acting acting;
		char text[512];

		snprintf(text, sizeof(text),
			"[state a]\nclip = walk\n[state b]\nclip = run\n"
			"[state c]\nclip = idle\n[transition a b]\nfade = 2\n%s"
			"[transition b c]\n%s"
			"[buttons]\nUP = go b\nDOWN = go c\n",
			cases[i].running, cases[i].next);
		begin(&acting, text);
		tap(&acting, BUTTON_UP);
		acting_run_to(&acting, 0.6, rate_hz);
		tap(&acting, BUTTON_DOWN);
		assert_string_equal(
			acting_state(&acting), cases[i].interrupts ? "c" : "b");
		acting_run_to(&acting, 3.0, rate_hz);
		assert_string_equal(acting_state(&acting), "c");
		acting_end(&acting);
	}
}

/* When does it leave the first state, which takes so long? */
static double left_after(const char *keys)
{
	struct acting acting;
	char text[512];
	double at_s;

	snprintf(text, sizeof(text),
		"[state a]\nclip = wave\nnext = b\n%s[state b]\nclip = run\n",
		keys);
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, text);
	do {
		acting_run_to(&acting, acting.now_s + 0.005, 200.0);
	} while (strcmp(acting_state(&acting), "a") == 0 && acting.now_s < 9);
	at_s = acting.now_s;
	acting_end(&acting);
	return at_s;
}

/* The clip takes 2.4 s; but a fade takes at most half of it. */
static void test_a_state_ends_early_by_the_fade_or_half_of_its_clip(void **state)
{
	(void)state;
	assert_near(left_after("[transition a b]\nfade = 0.5\n"), 1.9, 0.02);
	assert_near(left_after("[transition a b]\nfade = 1\n"), 1.4, 0.02);
	assert_near(left_after("[transition a b]\nfade = 2\n"), 1.2, 0.02);
	assert_near(left_after("rate = 2\n[transition a b]\nfade = 0.5\n"), 0.7,
		0.02);
	assert_near(left_after("rate = 0.5\n[transition a b]\nfade = 1\n"), 3.8,
		0.02);
	assert_near(left_after("repeat = once\n[transition a b]\nfade = 0\n"),
		2.4, 0.02);
	assert_near(left_after("repeat = once\nrate = -1\n"
			       "[transition a b]\nfade = 0.5\n"),
		1.9, 0.02);
}

/* A comparison that holds waits for this part of the clip. */
static void test_a_transition_waits_for_its_exit(void **state)
{
	static const struct {
		const char *exit;
		double at_s;
	} cases[] = {{"0", 0}, {"0.5", 1.2}, {"0.9", 2.16}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		for (int once = 0; once < 2; once++) {
			char keys[256];
			struct acting acting;
			double at_s;

			snprintf(keys, sizeof(keys),
				"[parameter p]\nstart = 1\n[state a]\n"
				"clip = wave\n%s[state b]\nclip = run\n"
				"[transition a b]\nwhen = p > 0.5\nexit = %s\n",
				once ? "repeat = once\n" : "", cases[i].exit);
			acting_begin(&acting, "assets/walker.glb");
			acting_expect(&acting, keys);
			do {
				acting_run_to(
					&acting, acting.now_s + 0.005, 200.0);
			} while (strcmp(acting_state(&acting), "a") == 0 &&
				acting.now_s < 9);
			at_s = acting.now_s;
			assert_near(at_s, cases[i].at_s, 0.02);
			acting_end(&acting);
		}
	}
}

/* A clip that plays once has no second round, but an end. */
static void test_the_end_of_a_clip_that_plays_once_is_its_last_exit(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting,
		"[parameter p]\n[state a]\nclip = wave\nrepeat = once\n"
		"[state b]\nclip = run\n[transition a b]\nwhen = p > 0.5\n"
		"exit = 1\n[buttons]\nUP = set p 1\n");
	acting_run_to(&acting, 5.0, rate_hz);
	assert_near(acting.character->machine.done, 1, 0);
	tap(&acting, BUTTON_UP);
	assert_string_equal(acting_state(&acting), "b");
	acting_end(&acting);
}

/* Of clips at 0, 1 and 3. */
static void test_a_blend_has_the_two_clips_around_its_value(void **state)
{
	static const struct {
		float value, weight[3];
		int follows; /* the one that does not cause events, or -1 */
	} cases[] = {{-1, {1, 0, 0}, -1}, {0, {1, 0, 0}, -1},
		{0.25f, {0.75f, 0.25f, 0}, 1}, {0.75f, {0.25f, 0.75f, 0}, 0},
		{1, {0, 1, 0}, 0}, {2.5f, {0, 0.25f, 0.75f}, 1},
		{3, {0, 0, 1}, 1}, {4, {0, 0, 1}, -1}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const struct character_entry *entry;
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[parameter v]\nrange = -2 5\nstart = %g\n[state a]\n"
			"blend = v, idle 0, walk 1, run 3\n",
			(double)cases[i].value);
		begin(&acting, text);
		entry = acting.character->machine.state[0].entry;
		for (int k = 0; k < 3; k++) {
			assert_near(entry[k].weight, cases[i].weight[k], 1e-6);
			assert_int_equal(
				entry[k].follows, k == cases[i].follows);
		}
		acting_end(&acting);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_transition_from_the_state_itself_comes_first),
		cmocka_unit_test(test_a_fade_may_be_counted_in_frames),
		cmocka_unit_test(test_a_fade_has_the_curve_that_the_file_names),
		cmocka_unit_test(test_a_transition_says_what_may_interrupt_it),
		cmocka_unit_test(
			test_a_state_ends_early_by_the_fade_or_half_of_its_clip),
		cmocka_unit_test(test_a_transition_waits_for_its_exit),
		cmocka_unit_test(
			test_the_end_of_a_clip_that_plays_once_is_its_last_exit),
		cmocka_unit_test(test_a_blend_has_the_two_clips_around_its_value),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
