/* The rows of the labels of a character. */
#include "app/character/show/character_label.h"
#include "tests/support/hud_read.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static struct hud hud;

/* Begins with the first frame, at 0.02 s. */
static void begin(struct acting *acting, const char *model, const char *text)
{
	acting_begin(acting, model);
	acting_expect(acting, text);
	acting_run_to(acting, 1.0 / rate_hz, rate_hz);
}

static const char *rows_in(const struct acting *acting, int width, int height)
{
	static char text[2048];

	hud_read_begin(&hud, width, height);
	character_label_all(acting->character, "", &hud);
	hud_read_text(&hud, text, sizeof(text));
	return text;
}

static const char *rows(const struct acting *acting)
{
	return rows_in(acting, 1024, 1200);
}

static void expect_rows(const struct acting *acting, const char *wanted)
{
	assert_string_equal(rows(acting), wanted);
}

static void test_a_clip_has_its_time(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = walk\n[state b]\nclip = rest\n[state c]\n"
		"clip = run\nfade = 1 linear\n[buttons]\nUP = go b\nDOWN = go c\n"
		"ENTER = pause\n");
	acting_run_to(&acting, 0.52, rate_hz);
	expect_rows(&acting, "0.50 / 1.10 s|a");
	acting_tap(&acting, BUTTON_UP, 2.0, rate_hz);
	expect_rows(&acting, "b");
	acting_tap(&acting, BUTTON_DOWN, 0.5, rate_hz);
	expect_rows(&acting, "0.48 / 0.70 s|c\n50%|fade");
	acting_tap(&acting, BUTTON_ENTER, 0.2, rate_hz);
	expect_rows(&acting, "0.50 / 0.70 s|c\n52%|fade\npaused");
	acting_end(&acting);
}

static void test_a_morph_has_its_key_frames_and_its_pace(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\ntime = 0.8\ncurve = linear\n"
		"curve = bezier 0.4 0 0.2 1 \"soft\"\n"
		"frames = 24\n[buttons]\nUP = morph m smile\n"
		"DOWN = pace m 2\nLEFT = timing m\nRIGHT = curve m\n");
	expect_rows(&acting, "neutral|from\n100%|neutral\n800 ms|linear");
	acting_tap(&acting, BUTTON_LEFT, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_UP, 0.2, rate_hz);
	expect_rows(&acting, "neutral|from\n42%|smile\n24 frames|linear");
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_RIGHT, 0.1, rate_hz);
	expect_rows(&acting, "neutral|from\n83%|smile\n12 frames|soft");
	acting_end(&acting);
}

static void test_beside_a_clip_a_morph_is_shown_while_it_runs(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[state b]\nclip = walk\n"
		"[morph m]\nnode = walker_head\ntime = 1\n"
		"[buttons]\nUP = morph m smile\n");
	expect_rows(&acting, "a");
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	expect_rows(&acting, "a\n50%|smile");
	acting_run_to(&acting, 2.0, rate_hz);
	expect_rows(&acting, "a");
	acting_end(&acting);
}

/* Bars of the first four parameters differ in their colours. */
static void test_parameters_have_bars_and_choices_names(void **state)
{
	struct acting acting;
	int whole;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[parameter v]\nrange = -2 6\nstart = 0\n"
		"[parameter w]\nchoices = one two three\nstart = 1\n"
		"[parameter x]\nstart = 1\n[parameter hidden]\nlabel = no\n"
		"[parameter y]\n[parameter clock]\nsource = time\n"
		"[buttons]\nUP = set v 6\n");
	expect_rows(
		&acting, "0.00 / 3.20 s|idle\n0.00|v\ntwo|w\n1.00|x\n0.00|y");
	whole = hud_read_width(&hud, hud_color_violet);
	assert_true(whole > 100);
	assert_near(hud_read_width(&hud, hud_color_green), 0.25 * whole, 2);
	assert_int_equal(hud_read_width(&hud, hud_color_amber), 0);
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	expect_rows(
		&acting, "0.50 / 3.20 s|idle\n6.00|v\ntwo|w\n1.00|x\n0.00|y");
	assert_int_equal(hud_read_width(&hud, hud_color_green), whole);
	acting_end(&acting);
}

/* Not those that are on from the start, unless they fade. */
static void test_switches_are_shown_with_their_weights(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[layer l]\nclip = wave\nfade = 1\n"
		"[look k]\nbone = head\ntarget = t\nfade = 1\non = no\n"
		"[look h]\nbone = head\ntarget = t\non = no\nlabel = no\n"
		"[target t]\nplace = 0 1 2\n"
		"[buttons]\nUP = toggle l\nDOWN = toggle k, toggle h\n");
	expect_rows(&acting, "a");
	acting_tap(&acting, BUTTON_DOWN, 0.5, rate_hz);
	expect_rows(&acting, "a\n50%|k");
	acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
	expect_rows(&acting, "a\n0%|l\n100%|k");
	acting_end(&acting);
}

static const char moves_text[] =
	"[part Arm]\nheading = 0 -90 90 45\npitch = 10 -90 90 45\n"
	"[part truck]\nnode = Car\nz = 0.1 -0.4 0.6 2\n"
	"[part Hand]\nbank = 20 -90 90 45\n"
	"[parameter p]\nchoices = some all\n"
	"[sequence s]\nstep = over 2, Arm pitch 30, Hand bank 60\n"
	"step = back 1, Arm pitch 10, truck z 0.5\n"
	"[buttons]\nUP hold = move Arm pitch 1, move truck z 1\n"
	"DOWN hold = move Arm pitch -1\nENTER = run s\n"
	"LEFT = set p 1\n"
	"[buttons more]\nwhen = p is all\nRIGHT hold = move Hand bank 1\n"
	"F6 hold = move Arm heading 1\nF8 = pause \"wait\"\n";

static void test_parts_have_the_values_that_buttons_move(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/arm.glb", moves_text);
	expect_rows(&acting, "some|p\n10\u00b0|Arm pitch\n0.10 m|truck z");
	acting_tap(&acting, BUTTON_LEFT, 0.1, rate_hz);
	expect_rows(&acting,
		"all|p\n10\u00b0|Arm pitch\n0.10 m|truck z\n"
		"20\u00b0|Hand bank\n0\u00b0|Arm heading\nF8|wait");
	acting_end(&acting);
}

static void test_a_sequence_has_its_step_and_the_values_it_moves(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/arm.glb", moves_text);
	acting_tap(&acting, BUTTON_ENTER, 1.0, rate_hz);
	expect_rows(&acting,
		"over\n1.00 / 2.00 s\n20\u00b0|Arm pitch\n"
		"40\u00b0|Hand bank\n0.10 m|truck z");
	acting_run_to(&acting, 2.52, rate_hz);
	expect_rows(&acting,
		"back\n0.50 / 1.00 s\n20\u00b0|Arm pitch\n"
		"60\u00b0|Hand bank\n0.30 m|truck z");
	acting_end(&acting);
}

static void test_a_cap_of_influences_is_shown(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb", "[state a]\nclip = rest\n");
	acting.instance->max_influences = 2;
	expect_rows(&acting, "a\nat most 2|influences");
	acting_end(&acting);
}

static const char keys_text[] =
	"[state a]\nclip = rest\n[parameter p]\nrange = 0 4\n"
	"[layer l]\nclip = wave\non = no\n"
	"[buttons]\nUP = add p 3 \"more\"\nDOWN = keys \"list\"\n"
	"ENTER = labels \"hide\"\n"
	"[buttons low]\nwhen = p < 3\nLEFT = toggle l \"layer\"\n"
	"LEFT hold = add p 1 \"hold\"\n"
	"RIGHT = toggle p \"high\"\nF6 = on l \"on\"\n"
	"[buttons high]\nwhen = p > 2\nlabel = no\nF8 = pause \"stop\"\n";

static void test_the_list_of_keys_has_all_that_act_now(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb", keys_text);
	expect_rows(&acting, "a\n0.00|p\nLEFT layer\nRIGHT high\nF6|on");
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_rows(&acting,
		"UP|more\nDOWN list\nENTER hide\nLEFT layer\n"
		"LEFT hold\nRIGHT high\nF6|on");
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	expect_rows(&acting, "UP|more\nDOWN list\nENTER hide\nF8|stop");
	assert_string_equal(rows_in(&acting, 240, 320),
		"UP|more\nDOWN list\nENTER hide\nF8|stop");
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_rows(&acting, "a\n3.00|p");
	acting_tap(&acting, BUTTON_ENTER, 0.1, rate_hz);
	expect_rows(&acting, "");
	acting_end(&acting);
}

/* Whether the only switch of the text is shown as on. */
static bool shows_on(const struct acting *acting)
{
	expect_rows(acting, "a\nLEFT it");
	return hud_read_width(&hud, hud_color_green) > 0;
}

/* In the upper half of its range, a parameter is on. */
static void test_a_button_that_toggles_shows_whether_it_is_on(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[parameter q]\nrange = 2 6\n"
		"label = no\n[parameter zero]\nlabel = no\n"
		"[buttons]\nUP = set q 4.1\nDOWN = set q 3.9\n"
		"[buttons now]\nwhen = zero < 1\nLEFT = toggle q \"it\"\n");
	assert_false(shows_on(&acting));
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	assert_true(shows_on(&acting));
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	assert_false(shows_on(&acting));
	acting_end(&acting);
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[look k]\nbone = head\ntarget = t\n"
		"label = no\non = no\n[target t]\nplace = 0 1 2\n"
		"[parameter zero]\nlabel = no\n"
		"[buttons now]\nwhen = zero < 1\nLEFT = toggle k \"it\"\n");
	assert_false(shows_on(&acting));
	acting_tap(&acting, BUTTON_LEFT, 0.1, rate_hz);
	assert_true(shows_on(&acting));
	acting_end(&acting);
}

static void expect_below(const struct acting *acting, int keys, int switches)
{
	struct framing_below below = character_label_below(acting->character);

	assert_int_equal(below.keys, keys);
	assert_int_equal(below.switches, switches);
}

static void test_the_figure_has_room_above_the_rows_below(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb", keys_text);
	expect_below(&acting, 0, 3);
	acting.character->touring = true;
	expect_below(&acting, 0, 0);
	expect_rows(&acting, "a\n0.00|p");
	acting.character->touring = false;
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_below(&acting, 7, 0);
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	expect_below(&acting, 4, 0);
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_below(&acting, 0, 0);
	acting_tap(&acting, BUTTON_ENTER, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_below(&acting, 0, 0);
	acting_end(&acting);
}

/* Where labels begin and end, from the picture's left. */
static void find_sides(const char *side, bool list, int *left, int *right)
{
	struct acting acting;
	char text[512];

	snprintf(text, sizeof(text), "%s[scene]\nlabels = %s\n", keys_text,
		side);
	begin(&acting, "assets/walker.glb", text);
	if (list) {
		acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	}
	rows(&acting);
	*left = 1024;
	*right = 0;
	for (int i = 0; i < 4 * hud.quad_count; i++) {
		int x = hud.vertex[i].x;

		*left = x < *left ? x : *left;
		*right = x > *right ? x : *right;
	}
	acting_end(&acting);
}

static void test_labels_are_at_their_side_of_the_picture(void **state)
{
	int left, right;

	(void)state;
	for (int list = 0; list < 2; list++) {
		find_sides("left", list, &left, &right);
		assert_true(left < 40 && right < 800);
		find_sides("right", list, &left, &right);
		assert_true(list == 0 || left > 40);
		assert_true(right > 984);
		find_sides("none", list, &left, &right);
		assert_int_equal(right, 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_clip_has_its_time),
		cmocka_unit_test(test_a_morph_has_its_key_frames_and_its_pace),
		cmocka_unit_test(
			test_beside_a_clip_a_morph_is_shown_while_it_runs),
		cmocka_unit_test(test_parameters_have_bars_and_choices_names),
		cmocka_unit_test(test_switches_are_shown_with_their_weights),
		cmocka_unit_test(test_parts_have_the_values_that_buttons_move),
		cmocka_unit_test(
			test_a_sequence_has_its_step_and_the_values_it_moves),
		cmocka_unit_test(test_a_cap_of_influences_is_shown),
		cmocka_unit_test(test_the_list_of_keys_has_all_that_act_now),
		cmocka_unit_test(
			test_a_button_that_toggles_shows_whether_it_is_on),
		cmocka_unit_test(test_the_figure_has_room_above_the_rows_below),
		cmocka_unit_test(test_labels_are_at_their_side_of_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
