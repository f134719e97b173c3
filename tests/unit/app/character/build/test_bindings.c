/* What lines of [buttons] bind to buttons and gestures. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const char before[] =
	"[parameter v]\nstart = 0.25\n[layer l]\nclip = wave\n"
	"[layer m]\nclip = wave\non = no\n[buttons]\n";

static void read(struct acting *acting, const char *lines)
{
	char text[512];

	snprintf(text, sizeof(text), "%s%s\n", before, lines);
	acting_read(acting, text);
}

static void test_a_key_names_one_button_or_two_and_a_gesture(void **state)
{
	static const struct {
		const char *key;
		enum button button, second;
		enum character_gesture gesture;
	} cases[] = {{"UP", BUTTON_UP, BUTTON_COUNT, CHARACTER_PRESS},
		{"F10", BUTTON_F10, BUTTON_COUNT, CHARACTER_PRESS},
		{"DOWN release", BUTTON_DOWN, BUTTON_COUNT, CHARACTER_RELEASE},
		{"LEFT  hold", BUTTON_LEFT, BUTTON_COUNT, CHARACTER_HOLD},
		{"ENTER\tlong", BUTTON_ENTER, BUTTON_COUNT, CHARACTER_LONG},
		{"UP+F8", BUTTON_UP, BUTTON_F8, CHARACTER_TOGETHER}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_binding *binding;
		char line[64];

		snprintf(line, sizeof(line), "%s = add v 1", cases[i].key);
		read(&acting, line);
		assert_int_equal(acting.error, 0);
		binding = acting.character->binding;
		assert_int_equal(binding->button, cases[i].button);
		assert_int_equal(binding->second, cases[i].second);
		assert_int_equal(binding->gesture, cases[i].gesture);
	}
	acting_end(&acting);
}

static void test_a_word_that_names_no_button_may_be_long(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int length = 29; length < 70; length++) {
		char line[96];

		memset(line, 'U', sizeof(line));
		snprintf(line + length, sizeof(line) - (size_t)length,
			"%s = next", length % 2 ? " hold" : "+DOWN");
		read(&acting, line);
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(
			acting.logged.sentence[0], "this is no button: use UP");
	}
	acting_end(&acting);
}

static void test_lines_that_limber_refuses(void **state)
{
	static const struct {
		const char *lines, *error;
	} cases[] = {
		{"UP+F9 = pause", "limber uses F9 together with others"},
		{"F9+UP = pause", "limber uses F9 together with others"},
		{"F9 long = pause", "limber uses F9 while it is held"},
		{"UP+UPP = pause", "this is no button"},
		{"UP+UP = pause", "this is no button"},
		{"UP+DOWN = pause\nDOWN+UP = keys", "gives the same buttons"},
		{"label = no more\nUP = pause",
			"more is not right here: give yes or no"},
		{"when = v > 1 more\nUP = pause", "more is not right here"},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		read(&acting, cases[i].lines);
		if (acting.error != -EINVAL) {
			fail_msg("accepted: %s", cases[i].lines);
		}
		assert_contains(acting.logged.sentence[0], cases[i].error);
	}
	acting_end(&acting);
}

static void test_pairs_may_share_a_button(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	read(&acting,
		"UP+DOWN = pause\nLEFT+UP = keys\nDOWN+LEFT = labels\n"
		"UP+RIGHT = tour\nDOWN = next\nDOWN long = previous");
	assert_int_equal(acting.error, 0);
	for (int i = 0; i < BUTTON_COUNT; i++) {
		assert_int_equal(acting.character->button[i].joins,
			i == BUTTON_UP || i == BUTTON_DOWN ||
				i == BUTTON_LEFT || i == BUTTON_RIGHT);
		assert_int_equal(
			acting.character->button[i].has_long, i == BUTTON_DOWN);
	}
	acting_end(&acting);
}

/* The last one first. Others have nothing to undo. */
static void test_a_release_undoes_what_acts_while_a_button_is_held(void **state)
{
	static const struct {
		enum character_verb verb;
		int index;
		double amount;
	} wanted[] = {{CHARACTER_SWITCH, 1, 0}, {CHARACTER_SWITCH, 0, 1},
		{CHARACTER_SET, 0, 0.25}};
	const struct character_action *after;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	read(&acting, "UP hold = set v 1, off l, add v 1, on m");
	assert_int_equal(acting.error, 0);
	after = acting.character->binding->after;
	for (size_t i = 0; i < ARRAY_COUNT(wanted); i++) {
		assert_non_null(after);
		assert_int_equal(after->verb, wanted[i].verb);
		assert_int_equal(after->index, wanted[i].index);
		assert_near(after->amount, wanted[i].amount, 0);
		after = after->next;
	}
	assert_null(after);
	read(&acting, "UP = set v 1, off l");
	assert_null(acting.character->binding->after);
	acting_end(&acting);
}

/* Without a label of its own, the actions are what it does. */
static void test_a_label_has_the_words_of_the_actions(void **state)
{
	static const char *const cases[][2] = {
		{"set v 1,off l , pause", "set v 1, off l, pause"},
		{"pause \"stops all\"", "stops all"}, {"pause", "pause"}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char line[64];

		snprintf(line, sizeof(line), "UP = %s", cases[i][0]);
		read(&acting, line);
		assert_int_equal(acting.error, 0);
		assert_string_equal(
			acting.character->binding->label, cases[i][1]);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_key_names_one_button_or_two_and_a_gesture),
		cmocka_unit_test(test_a_word_that_names_no_button_may_be_long),
		cmocka_unit_test(test_lines_that_limber_refuses),
		cmocka_unit_test(test_pairs_may_share_a_button),
		cmocka_unit_test(
			test_a_release_undoes_what_acts_while_a_button_is_held),
		cmocka_unit_test(test_a_label_has_the_words_of_the_actions),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
