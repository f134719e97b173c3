/* What each action of a button changes. */
#include "app/character/character_open.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static void begin(struct acting *acting, const char *model, const char *text)
{
	acting_begin(acting, model);
	acting_expect(acting, text);
	acting_run_to(acting, 0.1, rate_hz);
}

/* Presses a button for two frames. */
static void tap(struct acting *acting, enum button button)
{
	acting_tap(acting, button, 0.04, rate_hz);
}

static void test_parameters_are_set_added_to_toggled_and_stepped(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[parameter p]\nrange = 2 10\n"
		"start = 5\nstops = 3 6 9\n[parameter c]\n"
		"choices = one two three\n[buttons]\nUP = add p 1.5\n"
		"DOWN = toggle p\nLEFT = step p 1\nRIGHT = step p -2\n"
		"ENTER = add c 1\nF6 = add c -1\nF8 = set c three\n");
	tap(&acting, BUTTON_UP);
	assert_near(acting_value(&acting, "p"), 6.5, 1e-6);
	tap(&acting, BUTTON_DOWN); /* from the upper half */
	assert_near(acting_value(&acting, "p"), 2, 0);
	tap(&acting, BUTTON_DOWN);
	assert_near(acting_value(&acting, "p"), 10, 0);
	tap(&acting, BUTTON_RIGHT);
	assert_near(acting_value(&acting, "p"), 6, 0);
	tap(&acting, BUTTON_LEFT);
	assert_near(acting_value(&acting, "p"), 9, 0);
	tap(&acting, BUTTON_LEFT); /* the last one */
	assert_near(acting_value(&acting, "p"), 9, 0);
	tap(&acting, BUTTON_F6);
	assert_near(acting_value(&acting, "c"), 2, 0);
	tap(&acting, BUTTON_ENTER);
	assert_near(acting_value(&acting, "c"), 0, 0);
	tap(&acting, BUTTON_F8);
	assert_near(acting_value(&acting, "c"), 2, 0);
	acting_end(&acting);
}

static void test_a_morph_changes_its_pace_curve_and_timing(void **state)
{
	const struct character_morph *morph;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\ntime = 1\n"
		"curve = linear\ncurve = bezier 0.4 0 0.2 1\n"
		"curve = sine 0.1\n[buttons]\nUP = pace m 3\nDOWN = curve m\n"
		"LEFT = timing m\nRIGHT = morph m next\n"
		"ENTER = morph m previous\nF6 = pace m 0.1\n");
	morph = acting.character->morph;
	for (int i = 1; i <= 4; i++) {
		tap(&acting, BUTTON_DOWN);
		assert_int_equal(morph->chosen, i % 3);
	}
	tap(&acting, BUTTON_UP);
	assert_near(morph->pace, 3, 0);
	tap(&acting, BUTTON_UP);
	assert_near(morph->pace, 8, 0);
	tap(&acting, BUTTON_F6);
	tap(&acting, BUTTON_F6);
	assert_near(morph->pace, 0.125, 0);
	assert_false(morph->by_frames);
	tap(&acting, BUTTON_LEFT);
	assert_true(morph->by_frames);
	tap(&acting, BUTTON_LEFT);
	assert_false(morph->by_frames);
	/* Round the base and the face's eight targets. */
	tap(&acting, BUTTON_ENTER);
	assert_int_equal(morph->destiny, 8);
	tap(&acting, BUTTON_RIGHT);
	assert_int_equal(morph->destiny, 0);
	tap(&acting, BUTTON_RIGHT);
	assert_int_equal(morph->destiny, 1);
	acting_end(&acting);
}

static void test_the_camera_moves_while_a_button_is_held(void **state)
{
	const struct character *character;
	struct acting acting;
	float turn = 0.0f, tilt = 0.0f, zoom = 0.0f;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[buttons]\n"
		"UP hold = camera turn 90, camera turn 90\n"
		"DOWN hold = camera tilt 30\nLEFT hold = camera zoom 25\n");
	character = acting.character;
	acting_press(&acting, BUTTON_UP);
	acting_press(&acting, BUTTON_DOWN);
	acting_press(&acting, BUTTON_LEFT);
	for (int i = 0; i < 100; i++) {
		acting_run_to(&acting, acting.now_s + 0.01, 100.0);
		turn += character->camera_turn;
		tilt += character->camera_tilt;
		zoom += character->camera_zoom;
	}
	assert_near(turn, 3.14159265, 0.05);
	assert_near(tilt, 3.14159265 / 6, 0.01);
	assert_near(zoom, 0.25, 0.005);
	assert_near(character->camera_turn, 3.14159265 * 0.01, 1e-5);
	assert_near(character->camera_tilt, 3.14159265 / 600, 1e-5);
	assert_near(character->camera_zoom, 0.0025, 1e-6);
	acting_release(&acting, BUTTON_UP);
	acting_release(&acting, BUTTON_DOWN);
	acting_release(&acting, BUTTON_LEFT);
	acting_run_to(&acting, acting.now_s + 0.1, rate_hz);
	assert_near(character->camera_turn, 0, 0);
	assert_near(character->camera_tilt, 0, 0);
	assert_near(character->camera_zoom, 0, 0);
	acting_end(&acting);
}

static void test_the_scene_is_switched_to_and_fro(void **state)
{
	const struct character *character;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[layer l]\nclip = wave\n"
		"[scene]\ntour = 1 on l\n[buttons]\nUP = pause\nDOWN = tour\n"
		"LEFT = labels\nRIGHT = keys\nENTER = toggle l\nF6 = on l\n"
		"F8 = off l\n");
	character = acting.character;
	for (int i = 1; i >= 0; i--) {
		tap(&acting, BUTTON_UP);
		assert_int_equal(character->paused, i);
		tap(&acting, BUTTON_LEFT);
		assert_int_equal(character->labels_hidden, i);
		tap(&acting, BUTTON_RIGHT);
		assert_int_equal(character->keys_shown, i);
		tap(&acting, BUTTON_ENTER);
		assert_int_equal(character->layer[0].is.is_on, !i);
	}
	for (int i = 0; i < 2; i++) {
		tap(&acting, BUTTON_F8);
		assert_false(character->layer[0].is.is_on);
	}
	for (int i = 0; i < 2; i++) {
		tap(&acting, BUTTON_F6);
		assert_true(character->layer[0].is.is_on);
	}
	assert_false(character->touring);
	tap(&acting, BUTTON_DOWN);
	assert_true(character->touring);
	assert_near(character->tour_from_s, character->now_s, 0.05);
	acting_end(&acting);
}

static void test_states_go_on_round_in_the_order_of_the_file(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = walk\n[state b]\nclip = run\n"
		"[state c]\nclip = wave\n"
		"[buttons]\nUP = next\nDOWN = previous\nLEFT = go c\n"
		"RIGHT = next, next\n");
	tap(&acting, BUTTON_DOWN);
	assert_string_equal(acting_state(&acting), "c");
	tap(&acting, BUTTON_UP);
	assert_string_equal(acting_state(&acting), "a");
	tap(&acting, BUTTON_UP);
	assert_string_equal(acting_state(&acting), "b");
	tap(&acting, BUTTON_RIGHT); /* from the state that is wanted */
	assert_string_equal(acting_state(&acting), "a");
	tap(&acting, BUTTON_LEFT);
	assert_string_equal(acting_state(&acting), "c");
	acting_end(&acting);
}

static void test_sequences_run_once_or_again_and_again(void **state)
{
	const struct character_sequence *sequence;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/arm.glb",
		"[part Arm]\npitch = 0 -60 60 45\n[sequence s]\n"
		"step = there 0.2, Arm pitch 20\nstep = back 0.2, Arm pitch 0\n"
		"[buttons]\nUP = run s\nDOWN = repeat s\nLEFT = stop s\n");
	sequence = acting.character->sequence;
	tap(&acting, BUTTON_UP);
	assert_non_null(sequence->now);
	acting_run_to(&acting, acting.now_s + 0.5, rate_hz);
	assert_null(sequence->now);
	tap(&acting, BUTTON_DOWN);
	acting_run_to(&acting, acting.now_s + 1.5, rate_hz);
	assert_non_null(sequence->now);
	tap(&acting, BUTTON_LEFT);
	assert_null(sequence->now);
	acting_end(&acting);
}

/* Where a file that was read anew goes on. */
static void test_a_character_goes_on_where_another_one_was(void **state)
{
	static const char text[] =
		"[state a]\nclip = walk\nenter = set entered 1\n"
		"[state b]\nclip = run\nenter = set entered 2\n"
		"[parameter entered]\nrange = 0 2\n"
		"[buttons]\nUP = go b\nDOWN = labels, keys, tour\nLEFT = pause\n";
	struct acting before, after;
	struct character_machine *machine;
	float shown_s;

	(void)state;
	begin(&before, "assets/walker.glb", text);
	tap(&before, BUTTON_UP);
	acting_run_to(&before, 1.0, rate_hz);
	tap(&before, BUTTON_LEFT);
	tap(&before, BUTTON_DOWN);
	before.character->machine.phase = 5.5;
	before.character->machine.in_row = true;
	acting_begin(&after, "assets/walker.glb");
	acting_expect(&after, text);
	character_go_on(after.character, before.character);
	assert_near(after.character->seen_s, before.character->seen_s, 0);
	assert_near(after.character->now_s, before.character->now_s, 0);
	assert_near(after.character->tour_from_s, before.character->now_s, 0);
	assert_true(after.character->paused);
	assert_true(after.character->touring);
	assert_true(after.character->labels_hidden);
	assert_true(after.character->keys_shown);
	machine = &after.character->machine;
	assert_string_equal(acting_state(&after), "b");
	assert_near(machine->phase, 5.5, 0);
	assert_true(machine->in_row);
	assert_false(machine->fresh);
	shown_s = before.character->machine.state[1].entry[0].shown_s;
	assert_true(shown_s > 0.1f);
	assert_near(machine->state[1].entry[0].shown_s, shown_s, 0);
	assert_near(machine->state[1].entry[0].time_s,
		before.character->machine.state[1].entry[0].time_s, 0);
	after.character->paused = machine->in_row = false;
	after.now_s = before.now_s;
	acting_run_to(&after, after.now_s + 0.05, rate_hz);
	assert_near(acting_value(&after, "entered"), 2, 0);
	/* A file without that state begins anew. */
	acting_expect(&after, "[state x]\nclip = idle\n");
	character_go_on(after.character, before.character);
	assert_string_equal(acting_state(&after), "x");
	assert_true(after.character->machine.fresh);
	acting_end(&after);
	acting_end(&before);
}

/* Also when a file changes that it includes. */
static void test_the_stamp_changes_with_each_of_its_files(void **state)
{
	static const char outer[] = "[character]\ninclude = b.character\n";
	static const char *const inner[] = {
		"[state a]\nclip = walk\n", "[state ab]\nclip = walk\n"};
	struct test_path folder = temp_dir_make();
	struct test_path a = path_join(&folder, "a.character");
	struct test_path b = path_join(&folder, "b.character");
	struct acting acting;
	uint64_t stamp;

	(void)state;
	file_write(a.text, outer, strlen(outer));
	file_write(b.text, inner[0], strlen(inner[0]));
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, a.text);
	assert_int_equal(acting.error, 0);
	stamp = character_stamp(acting.character);
	assert_true(stamp == character_stamp(acting.character));
	file_write(b.text, inner[1], strlen(inner[1]));
	assert_true(stamp != character_stamp(acting.character));
	stamp = character_stamp(acting.character);
	file_write(a.text, inner[1], strlen(inner[1]));
	assert_true(stamp != character_stamp(acting.character));
	acting_end(&acting);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_parameters_are_set_added_to_toggled_and_stepped),
		cmocka_unit_test(test_a_morph_changes_its_pace_curve_and_timing),
		cmocka_unit_test(test_the_camera_moves_while_a_button_is_held),
		cmocka_unit_test(test_the_scene_is_switched_to_and_fro),
		cmocka_unit_test(
			test_states_go_on_round_in_the_order_of_the_file),
		cmocka_unit_test(test_sequences_run_once_or_again_and_again),
		cmocka_unit_test(test_a_character_goes_on_where_another_one_was),
		cmocka_unit_test(test_the_stamp_changes_with_each_of_its_files),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
