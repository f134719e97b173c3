/* States and layers that play backwards, and to and fro. */
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>

static const double rate_hz = 50.0;

static void press_once(struct acting *acting, enum button button)
{
	acting_tap(acting, button, 1.0 / rate_hz, rate_hz);
}

/* Returns the sum of the events of the clip "walk", which takes 1.1 s. */
static double count_events(const char *format, const char *how, double time_s)
{
	struct acting acting;
	char text[512];
	double count;

	snprintf(text, sizeof(text), format, how);
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, text);
	acting_run_to(&acting, time_s, 37.0);
	count = acting_value(&acting, "steps");
	acting_end(&acting);
	return count;
}

static void test_events_run_once_a_round_backwards_and_to_and_fro(void **state)
{
	static const char states[] =
		"[parameter steps]\nrange = 0 999\n"
		"[state a]\nclip = walk\n%s\n"
		"[clip walk]\nevent = 0.2 add steps 1\nevent = 1.1 add steps 10\n"
		"event = 0 add steps 100\n";
	static const char layers[] =
		"[parameter steps]\nrange = 0 999\n[state a]\nclip = rest\n"
		"[layer b]\nclip = walk\n%s\n"
		"[clip walk]\nevent = 0.2 add steps 1\nevent = 1 add steps 10\n";

	(void)state;
	/* Five rounds of 1.1 s; one that begins at 0 begins at the end too. */
	assert_near(count_events(states, "rate = 1", 5.45), 545.0, 0.0);
	assert_near(count_events(states, "rate = -1", 5.45), 555.0, 0.0);
	/* Three ways there and two back. */
	assert_near(
		count_events(states, "repeat = ping-pong", 5.45), 325.0, 0.0);
	assert_near(count_events(states, "repeat = ping-pong\nrate = -1", 5.45),
		325.0, 0.0);
	assert_near(count_events(states, "repeat = once\nrate = -1", 5.45),
		111.0, 0.0);
	assert_near(count_events(layers, "rate = -1", 5.45), 55.0, 0.0);
}

/* How often a clip of 2 s shows a moment in frames after its first one. */
static int count_shown(double moment_s, const char *how, double rate, int frames)
{
	const double step_s = 0.25;
	bool turns = strcmp(how, "ping-pong") == 0;
	bool once = strcmp(how, "once") == 0;
	double round_s = turns ? 4.0 : 2.0;
	double first_s = turns || rate > 0 ? moment_s : 2.0 - moment_s;
	/* What plays once and backwards begins at its end. */
	int count = moment_s == 0 && !(once && rate < 0);

	for (int frame = 1; frame <= frames; frame++) {
		double to_s = frame * step_s * fabs(rate);
		double from_s = (frame - 1) * step_s * fabs(rate);
		bool shown = false;

		for (int round = 0; round * round_s <= to_s; round++) {
			double at_s = round * round_s + first_s;
			double back_s = round * round_s + 4.0 - moment_s;

			shown = shown ||
				(at_s > from_s && at_s <= to_s &&
					(round == 0 || !once)) ||
				(turns && back_s > from_s && back_s <= to_s);
		}
		count += shown;
	}
	return count;
}

/* Frames show some of the moments exactly, and pass the others. */
static void test_an_event_runs_whenever_its_moment_is_reached(void **state)
{
	static const double moments_s[] = {0, 0.25, 0.3, 1, 1.5, 1.75, 1.9};
	static const double rates[] = {1, -1, 0.5, 2, -2, 1.5, -1.5};
	static const char *const ways[] = {"loop", "ping-pong", "once"};

	(void)state;
	for (size_t i = 0; i < 7 * 7 * 3; i++) {
		double moment_s = moments_s[i % 7], rate = rates[i / 7 % 7];
		const char *how = ways[i / 49];
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[parameter n]\nrange = 0 99\n[state a]\nclip = slide\n"
			"repeat = %s\nrate = %g\n[clip slide]\nevent = %g add n 1\n",
			how, rate, moment_s);
		acting_begin(&acting, "tests/cli/slider.gltf");
		acting_expect(&acting, text);
		/* An event's actions run in the frame after it. */
		acting_run_to(&acting, 0.125, 4.0);
		for (int frame = 0; frame < 40; frame++) {
			acting_run_to(&acting, acting.now_s + 0.125, 4.0);
			assert_near(acting_value(&acting, "n"),
				count_shown(moment_s, how, rate, frame), 0.0);
		}
		acting_end(&acting);
	}
}

/*
 * Plays the clip "go" for a time: keys at 1/24, 1/2 and 1 s move a node from 0 to 1
 * and back. Returns where the node is, and in *want where it is expected to be.
 */
static float slide(double time_s, double *want, float *steps)
{
	const double lead_s = 1 / 24.0;
	struct acting acting;
	double at_s;
	float place[3];

	acting_begin(&acting, "tests/fixtures/gltf/clip/frame_one.gltf");
	acting_expect(&acting,
		"[parameter steps]\nrange = 0 999\n[state a]\nclip = go\n"
		"[clip go]\nevent = 0.5 add steps 1\n"
		"event = 0.02 add steps 10\nevent = 0 add steps 100\n");
	acting_run_to(&acting, time_s, 240.0);
	acting_place(&acting, "slider", place);
	*steps = acting_value(&acting, "steps");
	at_s = acting.character->machine.state[0].entry[0].time_s;
	acting_end(&acting);
	if (at_s >= 1) {
		at_s = lead_s + (at_s - floor(at_s)) * (1 - lead_s);
	}
	*want = at_s < lead_s ? 0
		: at_s < 0.5  ? (at_s - lead_s) / (0.5 - lead_s)
			      : 2 * (1 - at_s);
	return place[0];
}

/* A loop that stood still until its first key would be a jolt in each round. */
static void test_a_loop_of_blender_does_not_pause(void **state)
{
	static const double times_s[] = {
		0.025, 0.2, 0.8, 1.02, 1.2, 3.975, 4.025, 4.4};
	double want;
	float steps;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(times_s); i++) {
		float place = slide(times_s[i], &want, &steps);

		assert_near(place, want, 1e-4);
	}
	/* Five rounds begin, and four of them reach the middle. */
	assert_near(steps, 554, 0);
}

/* Two clips of the state are as far between the same two marks. */
static void expect_in_phase(const struct acting *acting)
{
	const struct character_state *move =
		&acting->character->machine.state[0];

	assert_true(move->entry[1].weight > 0.1f);
	assert_true(move->entry[2].weight > 0.1f);
	assert_int_equal(move->entry[0].of->mark_count, 0);
	assert_int_equal(move->entry[1].of->mark_count, 2);
	assert_int_equal(move->entry[2].of->mark_count, 2);
	for (int e = 1; e < 3; e++) {
		const struct character_clip *clip = move->entry[e].of;
		double phase = acting->character->machine.phase;
		double within = phase - 2.0 * floor(phase / 2.0);
		double first = (double)clip->mark[0];
		double second = (double)clip->mark[1];
		double end = first + (double)clip->clip->duration_s;
		double time = within < 1.0
			? first + within * (second - first)
			: second + (within - 1.0) * (end - second);
		double duration = (double)clip->clip->duration_s;

		time -= duration * floor(time / duration);
		assert_near(move->entry[e].shown_s, time, 1e-3);
	}
}

static void test_clips_with_marks_stay_in_phase_backwards(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state move]\nblend = 1.8, idle 0, walk 1.03, run 2.6\nrate = -1\n"
		"[motion]\nfeet = toe.L toe.R\n");
	for (int i = 1; i < 10; i++) {
		acting_run_to(&acting, 0.3 * i, rate_hz);
		assert_true(acting.character->machine.phase < 0);
		expect_in_phase(&acting);
	}
	acting_end(&acting);
}

/* A clip that plays once goes to its end, waits there and comes back. */
static void test_a_clip_that_plays_once_comes_back_with_its_rate(void **state)
{
	const struct character_entry *entry;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter way]\nrange = -1 1\nstart = -1\n"
		"[state a]\nclip = walk\nrepeat = once\nrate = way\n"
		"[state b]\nclip = idle\n[transition a b]\nexit = 1\n"
		"[buttons]\nUP = set way 1\nDOWN = set way -1\nF6 = go b\n");
	entry = &acting.character->machine.state[0].entry[0];
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(entry->shown_s, 0.6, 0.05);
	acting_run_to(&acting, 5.0, rate_hz);
	assert_near(entry->shown_s, 0.0, 0.0);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 5.5, rate_hz);
	assert_near(entry->shown_s, 0.5, 0.05);
	acting_run_to(&acting, 9.0, rate_hz);
	assert_near(entry->shown_s, 1.1, 1e-4);
	press_once(&acting, BUTTON_DOWN);
	press_once(&acting, BUTTON_F6);
	acting_run_to(&acting, 9.5, rate_hz);
	assert_near(entry->shown_s, 0.6, 0.05);
	assert_string_equal(acting_state(&acting), "a");
	acting_run_to(&acting, 10.3, rate_hz);
	assert_string_equal(acting_state(&acting), "b");
	acting_end(&acting);
}

/* From the clip's end to its start, and then on as after any end. */
static void test_a_state_that_ends_backwards_goes_on_with_the_next(void **state)
{
	struct acting acting;
	const struct character_entry *entry;
	float duration_s;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter first]\nrange = 0 99\n"
		"[state a]\nclip = jump\nrate = -1\nrepeat = once\nnext = b\n"
		"fade = 0.1\n[state b]\nclip = idle\nfade = 0.1\n"
		"[clip jump]\nevent = 0.4 add first 1\n"
		"[buttons]\nUP = go a\n");
	entry = acting.character->machine.state[0].entry;
	duration_s = entry->of->clip->duration_s;
	for (int round = 0; round < 2; round++) {
		double from_s = acting.now_s;

		acting_run_to(&acting, from_s + 0.3, rate_hz);
		assert_string_equal(acting_state(&acting), "a");
		assert_near(entry->shown_s, duration_s - 0.3f, 0.05);
		assert_near(acting_value(&acting, "first"), round, 0.0);
		acting_run_to(&acting, from_s + (double)duration_s, rate_hz);
		assert_string_equal(acting_state(&acting), "b");
		assert_near(acting_value(&acting, "first"), round + 1, 0.0);
		press_once(&acting, BUTTON_UP);
	}
	acting_end(&acting);
}

static void test_a_layer_that_plays_once_may_play_backwards(void **state)
{
	const struct character_layer *layer;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = rest\n[layer b]\nclip = wave\nplay = once\n"
		"rate = -1\nfade = 0.2\n[buttons]\nUP = play b\n");
	layer = &acting.character->layer[0];
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(layer->is.now, 1.0, 0.0);
	assert_near(layer->entry.shown_s,
		(double)layer->entry.of->clip->duration_s - 0.5, 0.05);
	acting_run_to(&acting, (double)layer->entry.of->clip->duration_s + 0.1,
		rate_hz);
	assert_false(layer->playing);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_an_event_runs_whenever_its_moment_is_reached),
		cmocka_unit_test(test_a_loop_of_blender_does_not_pause),
		cmocka_unit_test(
			test_events_run_once_a_round_backwards_and_to_and_fro),
		cmocka_unit_test(test_clips_with_marks_stay_in_phase_backwards),
		cmocka_unit_test(
			test_a_clip_that_plays_once_comes_back_with_its_rate),
		cmocka_unit_test(
			test_a_state_that_ends_backwards_goes_on_with_the_next),
		cmocka_unit_test(test_a_layer_that_plays_once_may_play_backwards),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
