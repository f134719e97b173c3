/* What a character does from frame to frame. */
#include "app/anim/clip_join.h"
#include "app/anim/math/quat.h"
#include "app/character/run/feet.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static const char gaits[] =
	"[parameter speed]\nrange = 0 2.6\nease = 0.3\n"
	"[state move]\nblend = speed, idle 0, walk 1.03, run 2.6\n"
	"[motion]\nfeet = toe.L toe.R\n"
	"[state jump]\nclip = jump\nrepeat = once\nnext = move\nfade = 0.2\n"
	"[layer wave]\nclip = wave\nmask = shoulder.R\nplay = once\nfade = 0.3\n"
	"[buttons]\nUP = set speed 1.03\nF6 = set speed 2.6\nDOWN = set speed 0\n"
	"LEFT = play wave\nRIGHT = go jump\n";

static void press_once(struct acting *acting, enum button button)
{
	acting_tap(acting, button, 1.0 / rate_hz, rate_hz);
}

/* The largest angle that a bone turns from frame to frame, degrees. */
static double largest_turn(const struct pose *a, const struct pose *b)
{
	double largest = 0.0;

	for (int i = 0; i < a->node_count; i++) {
		float back[4], turn[4];
		double angle;

		quat_conjugate(a->local[i].rotation, back);
		quat_multiply(back, b->local[i].rotation, turn);
		angle = (double)quat_angle(turn) * 180.0 / 3.14159265;
		largest = angle > largest ? angle : largest;
	}
	return largest;
}

static void copy_pose(const struct acting *acting, struct pose *copy)
{
	pose_copy(copy, &acting->instance->pose);
}

/* Runs to a time and returns the largest turn of a bone in one frame. */
static double turn_until(
	struct acting *acting, double time_s, struct pose *before)
{
	double largest = 0.0;

	while (acting->now_s < time_s) {
		double turn;

		copy_pose(acting, before);
		acting_run_to(acting, acting->now_s + 1.0 / rate_hz, rate_hz);
		turn = largest_turn(before, &acting->instance->pose);
		largest = turn > largest ? turn : largest;
	}
	return largest;
}

/* From any moment, and with another transition under way. */
static void test_no_transition_makes_a_bone_jump(void **state)
{
	struct acting acting;
	struct arena arena = arena_empty();
	struct pose before;
	double usual;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	assert_int_equal(pose_init(&before, acting.model, &arena), 0);
	acting_expect(&acting, gaits);
	press_once(&acting, BUTTON_F6);
	acting_run_to(&acting, 2.0, rate_hz);
	usual = turn_until(&acting, 4.0, &before);
	for (int i = 0; i < 40; i++) {
		double turn;

		acting_expect(&acting, gaits);
		press_once(&acting, BUTTON_F6);
		acting_run_to(&acting, 1.0 + 0.02 * i, rate_hz);
		copy_pose(&acting, &before);
		press_once(&acting, BUTTON_RIGHT);
		turn = largest_turn(&before, &acting.instance->pose);
		assert_true(turn < 2.0 * usual);
		turn = turn_until(&acting, 1.1 + 0.02 * i, &before);
		press_once(&acting, BUTTON_RIGHT); /* during the transition */
		turn = turn_until(&acting, 1.6 + 0.02 * i, &before);
		assert_true(turn < 2.0 * usual);
	}
	arena_release(&arena);
	acting_end(&acting);
}

/*
 * The foot that stands on the ground stays where it is on the ground, also
 * while the gait changes.
 */
static void test_planted_feet_do_not_skate(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int i = 0; i < 40; i++) {
		float ground[2] = {0}, at[3], from[2] = {0};
		int planted = -1;

		acting_expect(&acting, gaits);
		press_once(&acting, i % 2 ? BUTTON_UP : BUTTON_F6);
		acting_run_to(&acting, 1.0 + 0.03 * i, rate_hz);
		acting_press(&acting, i % 3 ? BUTTON_DOWN : BUTTON_F6);
		while (acting.now_s < 2.5 + 0.03 * i) {
			const struct character_motion *motion =
				&acting.character->motion;

			acting_run_to(
				&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
			ground[0] += motion->scroll[0];
			ground[1] += motion->scroll[1];
			if (motion->planted < 0) {
				planted = -1;
				continue;
			}
			acting_place(&acting,
				motion->planted ? "toe.R" : "toe.L", at);
			at[0] += ground[0];
			at[2] += ground[1];
			if (planted != motion->planted) {
				planted = motion->planted;
				from[0] = at[0];
				from[1] = at[2];
			}
			assert_near(hypotf(at[0] - from[0], at[2] - from[1]),
				0.0, 0.01);
		}
	}
	acting_end(&acting);
}

/*
 * Returns how far the feet are held from their animated places at most, in a
 * walk from 3 to 5 s after its start, with the effect switched off for a time
 * before if it pauses.
 */
static double held_most(bool pauses)
{
	struct acting acting;
	double most = 0.0;

	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = walk\n[motion]\nfeet = toe.L toe.R\n"
		"[feet f]\nhips = hips\nleft = thigh.L shin.L foot.L\n"
		"right = thigh.R shin.R foot.R\nfade = 0.1\n"
		"[buttons]\nUP = toggle f\n");
	acting_run_to(&acting, 1.0, rate_hz);
	if (pauses) {
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		acting_run_to(&acting, 2.7, rate_hz);
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	}
	while (acting.now_s < 5.0) {
		acting_run_to(&acting, acting.now_s + 0.02, rate_hz);
		for (int side = 0; side < 2; side++) {
			const float *offset =
				acting.character->feet->foot[side].hold.offset;

			most = acting.now_s < 3.0
				? most
				: fmax(most,
					  hypot((double)offset[0],
						  (double)offset[1]));
		}
	}
	acting_end(&acting);
	return most;
}

/* Not where they stood when the effect was switched off. */
static void test_feet_are_held_anew_when_they_are_switched_on(void **state)
{
	(void)state;
	assert_near(held_most(true), held_most(false), 0.01);
}

static void test_the_ground_runs_as_fast_as_the_clips(void **state)
{
	static const struct {
		enum button button;
		double speed;
	} gait[] = {{BUTTON_DOWN, 0.0}, {BUTTON_UP, 1.03}, {BUTTON_F6, 2.6}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(gait); i++) {
		double sum = 0.0;

		acting_expect(&acting, gaits);
		press_once(&acting, gait[i].button);
		acting_run_to(&acting, 2.0, 100.0);
		while (acting.now_s < 5.0) {
			acting_run_to(&acting, acting.now_s + 0.01, 100.0);
			sum += (double)acting.character->motion.scroll[1];
		}
		assert_near(
			sum / 3.0, gait[i].speed, 0.05 + 0.15 * gait[i].speed);
	}
	acting_end(&acting);
}

static void test_clips_with_marks_stay_in_phase(void **state)
{
	struct acting acting;
	const struct character_state *move;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, gaits);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 2.0, rate_hz);
	acting_press(&acting, BUTTON_F6);
	acting_run_to(&acting, 2.15, rate_hz);
	move = &acting.character->machine.state[0];
	assert_true(move->entry[1].weight > 0.1f);
	assert_true(move->entry[2].weight > 0.1f);
	assert_int_equal(move->entry[0].of->mark_count, 0);
	assert_int_equal(move->entry[1].of->mark_count, 2);
	assert_int_equal(move->entry[2].of->mark_count, 2);
	/* Both are as far between the same two marks. */
	for (int e = 1; e < 3; e++) {
		const struct character_clip *clip = move->entry[e].of;
		double phase = acting.character->machine.phase;
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
	acting_end(&acting);
}

static void test_a_state_that_ends_goes_on_with_the_next(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, gaits);
	press_once(&acting, BUTTON_RIGHT);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_string_equal(acting_state(&acting), "jump");
	acting_run_to(&acting, 1.6, rate_hz);
	assert_string_equal(acting_state(&acting), "move");
	acting_end(&acting);
}

/* Whatever its rate: the fade is as long as at the rate 1. */
static void test_a_state_ends_early_by_the_length_of_the_fade(void **state)
{
	static const double rates[] = {1.0, 0.5, 2.0, -0.5};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rates); i++) {
		struct acting acting;
		char text[256];
		double jump_s;

		snprintf(text, sizeof(text),
			"[state a]\nclip = jump\nrepeat = once\nnext = b\n"
			"rate = %g\n[state b]\nclip = idle\nfade = 0.2\n",
			rates[i]);
		acting_begin(&acting, "assets/walker.glb");
		acting_expect(&acting, text);
		jump_s = (double)acting.model
				 ->clip[model_find_clip(acting.model, "jump")]
				 .duration_s;
		while (acting_state(&acting)[0] == 'a') {
			acting_run_to(&acting, acting.now_s + 0.01, 100.0);
		}
		assert_near(acting.now_s, jump_s / fabs(rates[i]) - 0.2, 0.025);
		acting_end(&acting);
	}
}

static void test_steps_add_up_to_the_time(void **state)
{
	const struct character_entry *entry;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "tests/cli/slider.gltf");
	acting_expect(&acting, "[state a]\nclip = 0\n");
	entry = &acting.character->machine.state[0].entry[0];
	acting_run_to(&acting, 1000.0, 60.0);
	/* The first frame is the clip's start. */
	assert_near(entry->time_s, acting.now_s - 1.0 / 60.0, 1e-8);
	acting_end(&acting);
}

static void test_without_a_state_the_first_clip_or_the_rest_pose_plays(
	void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "[parameter a]\n");
	assert_string_equal(acting_state(&acting), acting.model->clip[0].name);
	acting_end(&acting);
	acting_begin(&acting, "assets/arm.glb");
	acting_expect(&acting, "[parameter a]\n");
	assert_string_equal(acting_state(&acting), "rest");
	acting_end(&acting);
}

/* Each clip ends four frames before its end, in those of its own rate. */
static void test_a_row_plays_the_states_in_the_order_of_the_file(void **state)
{
	struct acting acting;
	float walk_s, overlap_s;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = walk\n[state b]\nclip = jump\n[state c]\nclip = run\n"
		"[buttons]\nUP = row\n");
	walk_s =
		acting.character->machine.state[0].entry[0].of->clip->duration_s;
	overlap_s = 4 *
		clip_join_frame_s(
			acting.character->machine.state[0].entry[0].of->clip);
	acting_run_to(&acting, 1.5 * (double)walk_s, rate_hz);
	assert_string_equal(acting_state(&acting), "a");
	/* The row begins with the present clip from its start. */
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 2.5 * (double)walk_s - (double)overlap_s - 0.1,
		rate_hz);
	assert_string_equal(acting_state(&acting), "a");
	acting_run_to(&acting, 2.5 * (double)walk_s - (double)overlap_s + 0.1,
		rate_hz);
	assert_string_equal(acting_state(&acting), "b");
	assert_true(acting.character->machine.inertia.running);
	acting_run_to(&acting, 3.2 * (double)walk_s + 1.5, rate_hz);
	press_once(&acting, BUTTON_UP);
	acting_run_to(&acting, 30.0, rate_hz);
	assert_false(acting.character->machine.in_row);
	acting_end(&acting);
}

static void test_conditions_exit_times_and_priorities(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\n[state a]\nclip = walk\n[state b]\nclip = run\n"
		"[state c]\nclip = idle\n"
		"[transition a b]\nwhen = v > 0.5\nexit = 0.9\n"
		"[transition b c]\nwhen = v > 0.5\npriority = 1\nexit = 0.1\n"
		"[transition b a]\nwhen = v > 0.5\npriority = 2\nexit = 0.5\n"
		"[buttons]\nUP = set v 1\n");
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, 0.9, rate_hz);
	assert_string_equal(acting_state(&acting), "a");
	acting_run_to(&acting, 1.05, rate_hz);
	assert_string_equal(acting_state(&acting), "b");
	acting_run_to(&acting, 1.3, rate_hz);
	assert_string_equal(acting_state(&acting), "c");
	acting_end(&acting);
}

static void test_a_transition_may_refuse_interruption(void **state)
{
	static const char format[] =
		"[state a]\nclip = walk\n[state b]\nclip = run\n"
		"[state c]\nclip = idle\n"
		"[transition a b]\nfade = 1\ninterrupt = %s\n"
		"[transition b c]\npriority = 1\n"
		"[buttons]\nUP = go b\nDOWN = go c\n";
	static const struct {
		const char *rule, *state;
	} cases[] = {{"always", "c"}, {"higher", "c"}, {"never", "b"}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[512];

		snprintf(text, sizeof(text), format, cases[i].rule);
		acting_expect(&acting, text);
		acting_run_to(&acting, 0.5, rate_hz);
		press_once(&acting, BUTTON_UP);
		press_once(&acting, BUTTON_DOWN);
		acting_run_to(&acting, 0.8, rate_hz);
		assert_string_equal(acting_state(&acting), cases[i].state);
		acting_run_to(&acting, 2.0, rate_hz);
		assert_string_equal(acting_state(&acting), "c");
	}
	acting_end(&acting);
}

static void test_a_layer_moves_its_mask_alone_and_fades(void **state)
{
	struct acting acting;
	struct arena arena = arena_empty();
	struct pose plain;
	int arm, leg;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	assert_int_equal(pose_init(&plain, acting.model, &arena), 0);
	arm = model_find_node(acting.model, "upper_arm.R");
	leg = model_find_node(acting.model, "thigh.L");
	acting_expect(&acting, gaits);
	acting_run_to(&acting, 1.22, rate_hz);
	copy_pose(&acting, &plain);
	acting_expect(&acting, gaits);
	press_once(&acting, BUTTON_LEFT);
	acting_run_to(&acting, 1.22, rate_hz);
	assert_near(acting.character->layer[0].is.now, 1.0, 1e-3);
	assert_all_near(acting.instance->pose.local[leg].rotation,
		plain.local[leg].rotation, 4, 1e-6);
	assert_true(fabsf(acting.instance->pose.local[arm].rotation[0] -
			    plain.local[arm].rotation[0]) +
			fabsf(acting.instance->pose.local[arm].rotation[2] -
				plain.local[arm].rotation[2]) >
		0.05f);
	acting_run_to(&acting, 3.0, rate_hz);
	assert_near(acting.character->layer[0].is.now, 0.0, 0.0);
	arena_release(&arena);
	acting_end(&acting);
}

static void test_an_additive_layer_adds_to_the_state(void **state)
{
	struct acting acting;
	float with[3], without[3];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "[state a]\nclip = rest\n");
	acting_run_to(&acting, 0.5, rate_hz);
	acting_place(&acting, "hand.R", without);
	acting_expect(&acting,
		"[state a]\nclip = rest\n[layer b]\nclip = wave\nmode = additive\n");
	acting_run_to(&acting, 1.0, rate_hz);
	acting_place(&acting, "hand.R", with);
	assert_true(fabsf(with[1] - without[1]) > 0.1f);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_no_transition_makes_a_bone_jump),
		cmocka_unit_test(test_planted_feet_do_not_skate),
		cmocka_unit_test(
			test_feet_are_held_anew_when_they_are_switched_on),
		cmocka_unit_test(test_the_ground_runs_as_fast_as_the_clips),
		cmocka_unit_test(test_clips_with_marks_stay_in_phase),
		cmocka_unit_test(test_a_state_that_ends_goes_on_with_the_next),
		cmocka_unit_test(
			test_a_state_ends_early_by_the_length_of_the_fade),
		cmocka_unit_test(test_steps_add_up_to_the_time),
		cmocka_unit_test(
			test_without_a_state_the_first_clip_or_the_rest_pose_plays),
		cmocka_unit_test(
			test_a_row_plays_the_states_in_the_order_of_the_file),
		cmocka_unit_test(test_conditions_exit_times_and_priorities),
		cmocka_unit_test(test_a_transition_may_refuse_interruption),
		cmocka_unit_test(test_a_layer_moves_its_mask_alone_and_fades),
		cmocka_unit_test(test_an_additive_layer_adds_to_the_state),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
