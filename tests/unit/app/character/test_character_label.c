/* How much room a character asks for, for its labels. */
#include "app/character/show/character_label.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>

/* The walker with so many parameters of each kind. */
static void begin(struct acting *acting, int shown, int hidden)
{
	char text[1024] = "";
	size_t length = 0;

	for (int i = 0; i < shown + hidden; i++) {
		length += (size_t)snprintf(text + length, sizeof(text) - length,
			"[parameter p%d]\nrange = 0 1\n%s", i,
			i < shown ? "" : "source = sine 1\n");
		assert_true(length < sizeof(text));
	}
	acting_begin(acting, "assets/walker.glb");
	acting_expect(acting, text);
}

/* The clip that plays has a row with a bar, and so has each parameter. */
static void test_each_parameter_that_buttons_move_has_a_bar(void **state)
{
	(void)state;
	for (int shown = 0; shown <= 4; shown++) {
		for (int hidden = 0; hidden <= 2; hidden++) {
			struct acting acting;
			int bars = -1, rows;

			begin(&acting, shown, hidden);
			rows = character_label_count(acting.character, &bars);
			/* Without any there is a row for "paused". */
			assert_int_equal(rows, shown == 0 ? 2 : 1 + shown);
			assert_int_equal(bars, 1 + shown);
			acting_end(&acting);
		}
	}
}

/* The time of the clip and, between two states, the blend. */
static void test_a_fade_has_a_bar(void **state)
{
	struct acting acting;
	int bars = -1;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = walk\n[state b]\nclip = run\n"
		"[buttons]\nUP = go b\n");
	assert_int_equal(character_label_count(acting.character, &bars), 2);
	assert_int_equal(bars, 2);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_parameter_that_buttons_move_has_a_bar),
		cmocka_unit_test(test_a_fade_has_a_bar),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
