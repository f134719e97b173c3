/* What labels call what a character has. */
#include "app/character/show/label_name.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>

#define RUN "\u8dd1" /* letters that the font lacks */
#define SIT "\u5750"

/* The name of the state that plays, or of its clip. */
static void expect_motion(
	const char *text, bool with_clip, const char *clip, const char *wanted)
{
	const struct character_machine *machine;
	struct acting acting;
	char number[HUD_NAME_BYTES];

	acting_begin(&acting, "assets/walker.glb");
	if (clip) {
		acting.model->clip[2].name = clip;
	}
	acting_expect(&acting, text);
	machine = &acting.character->machine;
	acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
	assert_string_equal(
		label_name_motion(acting.character,
			with_clip
				? machine->state[machine->current].entry[0].of->clip
				: NULL,
			number),
		wanted);
	acting_end(&acting);
}

static void test_a_state_has_a_name_or_a_number(void **state)
{
	static const char blend[] = "[parameter v]\n[state a]\n"
				    "blend = v, run 0, jump 1\n",
			  last[] = "[state a]\nclip = walk\n[state " RUN
				   "]\nclip = 2\n[buttons]\nUP = go " RUN "\n";

	(void)state;
	expect_motion(blend, true, NULL, "run");
	expect_motion(blend, false, NULL, "a");
	expect_motion("[state a]\nclip = run\n", true, NULL, "a");
	expect_motion("[parameter v]\n", true, NULL, "idle");
	expect_motion("[parameter v]\n", false, NULL, "idle");
	/* Another name, the clip's name, and the clip's number. */
	expect_motion(last, true, SIT, "state 2");
	expect_motion(last, true, RUN, "clip 2");
	expect_motion(last, false, RUN, "state 2");
	expect_motion("[state \"clip 2\"]\nclip = 2\n", true, SIT, "clip 2");
	expect_motion("[state \"clip 2\"]\nclip = 2\n", true, "sits", "sits");
}

/* They are counted among those of their kind. */
static void test_a_switch_has_a_number_of_its_kind(void **state)
{
	static const char *const names[] = {
		"layer 1", "layer 2", "look 1", "breath 1", "look 2", "plain"};
	static const int ranks[] = {1, 2, 1, 1, 2, 2};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[target t]\nplace = 0 1 2\n[layer \u4e00]\nclip = wave\n"
		"[layer \u4e8c]\nclip = wave\n"
		"[look \u4e09]\nbone = head\ntarget = t\n"
		"[breath \u56db]\nbone = chest\n"
		"[look \u4e94]\nbone = head\ntarget = t\n"
		"[breath plain]\nbone = chest\n");
	assert_int_equal(acting.character->switch_count, ARRAY_COUNT(names));
	for (int i = 0; i < acting.character->switch_count; i++) {
		char number[HUD_NAME_BYTES];

		assert_int_equal(label_name_rank(acting.character, i), ranks[i]);
		assert_string_equal(
			label_name_switch(acting.character, i, number),
			names[i]);
	}
	acting_end(&acting);
}

static void test_a_step_has_a_number_in_its_sequence(void **state)
{
	struct character_step step[3] = {
		{.name = RUN, .next = &step[1]},
		{.name = SIT, .next = &step[2]},
		{.name = "last"},
	};
	static const char *const names[] = {"step 1", "step 2", "last"};

	(void)state;
	for (int i = 0; i < 3; i++) {
		const struct character_sequence sequence = {
			.step = step, .now = &step[i]};
		char number[HUD_NAME_BYTES];

		assert_string_equal(
			label_name_step(&sequence, number), names[i]);
	}
}

static void test_a_key_frame_has_a_name_or_a_number(void **state)
{
	static const char *const names[] = {"calm", RUN, SIT};
	const struct character_morph morph = {.key_name = (const char **)names};
	char number[HUD_NAME_BYTES];

	(void)state;
	assert_string_equal(label_name_key(&morph, 0, number), "calm");
	assert_string_equal(label_name_key(&morph, 1, number), "key 1");
	assert_string_equal(label_name_key(&morph, 2, number), "key 2");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_state_has_a_name_or_a_number),
		cmocka_unit_test(test_a_switch_has_a_number_of_its_kind),
		cmocka_unit_test(test_a_step_has_a_number_in_its_sequence),
		cmocka_unit_test(test_a_key_frame_has_a_name_or_a_number),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
