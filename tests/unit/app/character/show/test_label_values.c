/* Values, numbers and places of the labels of a character. */
#include "app/character/show/character_label.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/files.h"
#include "tests/support/hud_read.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static struct hud hud;

#define HAN1 "\u4e00" /* letters that the font lacks */
#define HAN2 "\u4e8c"

/* Begins with the first frame, at 0.02 s. */
static void begin(struct acting *acting, const char *model, const char *text)
{
	acting_begin(acting, model);
	acting_expect(acting, text);
	acting_run_to(acting, 1.0 / rate_hz, rate_hz);
}

static void expect_in(
	const struct acting *acting, int width, int height, const char *wanted)
{
	char text[2048];

	hud_read_begin(&hud, width, height);
	character_label_all(acting->character, "", &hud);
	hud_read_text(&hud, text, sizeof(text));
	assert_string_equal(text, wanted);
}

static void expect_rows(const struct acting *acting, const char *wanted)
{
	expect_in(acting, 1024, 1200, wanted);
}

/* Where names cannot be shown, numbers from 1. */
static void test_values_without_names_have_numbers(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[parameter " HAN1
		"]\nchoices = one " HAN2 "\nstart = 1\n[parameter " HAN2 "]\n");
	expect_rows(&acting, "a\nchoice 2|parameter 1\n0.00|parameter 2");
	acting_end(&acting);
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\ntime = 0.8\n"
		"curve = linear\ncurve = sine 0.1 \"" HAN1 "\"\n"
		"[buttons]\nUP = curve m\nDOWN = pace m 2\n");
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	expect_rows(&acting, "neutral|from\n100%|neutral\n400 ms|linear");
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	expect_rows(&acting, "neutral|from\n100%|neutral\n400 ms|curve 2");
	acting_end(&acting);
}

/* A turn in degrees, a way in metres. */
static void test_parts_without_names_have_numbers(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/arm.glb",
		"[part " HAN1 "]\nnode = Arm\npitch = 7 -9 9\n"
		"[part " HAN2 "]\nnode = Car\nx = 0.1 -1 1\ny = 0.2 -1 1\n"
		"[buttons]\nUP hold = move " HAN1 " pitch 1\n"
		"DOWN hold = move " HAN2 " x 1, move " HAN2 " y 1\n");
	expect_rows(&acting,
		"7\u00b0|part 1 pitch\n0.10 m|part 2 x\n0.20 m|part 2 y");
	acting_end(&acting);
}

/* Each once, and at most four. */
static void test_the_first_four_values_are_shown(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/arm.glb",
		"[part Arm]\nheading = 1 -9 9\npitch = 2 -9 9\nbank = 3 -9 9\n"
		"[part Hand]\nheading = 4 -9 9\npitch = 5 -9 9\n"
		"[sequence s]\nstep = go 1, Arm heading 1, Hand heading 4\n"
		"step = on 1, Arm bank 3, Arm pitch 2, Hand pitch 5\n"
		"[buttons]\nENTER = run s\n"
		"UP hold = move Hand heading 1, move Arm heading 1\n"
		"DOWN hold = move Hand heading -1, move Arm heading -1\n"
		"LEFT hold = move Hand pitch 1, move Arm pitch 1\n"
		"RIGHT hold = move Arm bank 1\n");
	expect_rows(&acting,
		"4\u00b0|Hand heading\n1\u00b0|Arm heading\n"
		"5\u00b0|Hand pitch\n2\u00b0|Arm pitch");
	acting_tap(&acting, BUTTON_ENTER, 0.1, rate_hz);
	expect_rows(&acting,
		"go\n0.10 / 1.00 s\n1\u00b0|Arm heading\n4\u00b0|Hand heading\n"
		"3\u00b0|Arm bank\n2\u00b0|Arm pitch");
	acting_end(&acting);
}

static void test_a_fade_is_shown_by_its_share(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[state b]\nclip = rest\n"
		"fade = 2 linear\n[buttons]\nUP = go b\n");
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	expect_rows(&acting, "b\n25%|fade");
	acting.instance->max_influences = 1;
	expect_rows(&acting, "b\n25%|fade\nat most 1|influences");
	acting_end(&acting);
}

/* The second one's colour, as the first is often that of a parameter. */
static void test_the_first_switch_has_a_bar_of_its_own_colour(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[layer l]\nclip = wave\nweight = 0.5\n"
		"[layer m]\nclip = wave\nweight = 0.25\n");
	expect_rows(&acting, "a\n50%|l\n25%|m");
	assert_true(hud_read_width(&hud, hud_color_amber) > 0);
	assert_near(hud_read_width(&hud, hud_color_violet),
		0.5 * hud_read_width(&hud, hud_color_amber), 2);
	assert_int_equal(hud_read_width(&hud, hud_color_green), 0);
	assert_int_equal(hud_read_width(&hud, hud_color_rose), 0);
	acting_end(&acting);
}

static void test_presets_have_a_row_and_a_number(void **state)
{
	static const char presets[] = "[calm]\n[" HAN1 "]\n";
	static const struct {
		const char *keys;
		int rows;
		const char *shown;
	} rows[] = {
		{"", 2, "a\n0.00|v"},
		{"presets = p.ini\n", 3, "a\n0.00|v\ncalm|preset"},
		{"presets = one.ini\n", 3, "a\n0.00|v\ncalm|preset"},
		{"presets = p.ini\n[shake t]\nbone = neck\n", 3,
			"a\n0.00|v\ncalm|preset"},
		{"[shake t]\nbone = neck\npresets = p.ini\n"
		 "[buttons]\nUP = preset t next\n",
			3, "a\n0.00|v\npreset 2|preset"},
	};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");

	(void)state;
	file_write(path_join(&folder, "p.ini").text, presets, strlen(presets));
	file_write(path_join(&folder, "one.ini").text, presets, 7);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct acting acting;
		char text[256];
		int bars;

		snprintf(text, sizeof(text),
			"[state a]\nclip = rest\n[parameter v]\n"
			"[shake s]\nbone = head\n%s",
			rows[i].keys);
		file_write(path.text, text, strlen(text));
		acting_begin(&acting, "assets/walker.glb");
		acting_load(&acting, path.text);
		assert_int_equal(acting.error, 0);
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		assert_int_equal(character_label_count(acting.character, &bars),
			rows[i].rows);
		assert_int_equal(bars, 2);
		expect_rows(&acting, rows[i].shown);
		acting_end(&acting);
	}
	temp_dir_remove(&folder);
}

/* It says nothing of the rest pose, as if there were either of them. */
static void test_a_morph_and_a_part_have_their_rows(void **state)
{
	struct acting acting;
	int bars;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\n[part Face]\n"
		"heading = 0 -9 9\n");
	assert_int_equal(character_label_count(acting.character, &bars), 7);
	assert_int_equal(bars, 1);
	acting_end(&acting);
}

/* Only what toggles has a switch. */
static void test_buttons_that_switch_nothing_have_no_switch(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[parameter p]\nrange = 2 6\n"
		"start = 4\nlabel = no\n[layer l]\nclip = wave\nlabel = no\n"
		"[parameter zero]\nlabel = no\n[buttons b]\nwhen = zero < 1\n"
		"UP = add p -1 \"less\"\nDOWN = off l \"off\"\n"
		"LEFT = on l \"on\"\nRIGHT = toggle p \"half\"\n");
	expect_rows(&acting, "a\nUP|less\nDOWN off\nLEFT on\nRIGHT half");
	/* Half of its range is not on. */
	assert_int_equal(hud_read_width(&hud, hud_color_green), 0);
	acting_end(&acting);
}

/* The right edge of all that labels take. */
static int right_edge(void)
{
	int right = 0;

	for (int i = 0; i < 4 * hud.quad_count; i++) {
		right = hud.vertex[i].x > right ? hud.vertex[i].x : right;
	}
	return right;
}

/* The right edge of a group with these two buttons; *height becomes its height. */
static int edge_of(const char *key, const char *sentence, int *height)
{
	struct hud_group group;

	hud_read_begin(&hud, 480, 640);
	group = hud_group_begin(&hud, HUD_BOTTOM_LEFT, NULL);
	hud_group_widen(&group, key, sentence);
	hud_group_key(&group, key, sentence);
	hud_group_key(&group, "UP", "short");
	hud_group_end(&group);
	*height = hud.stacked_px[HUD_BOTTOM_LEFT];
	return right_edge();
}

/* A row of the buttons is as wide as a sentence needs. */
static void test_buttons_are_below_and_as_wide_as_they_need(void **state)
{
	static const char sentence[] = "goes ahead";
	struct acting acting;
	char text[256];
	int right, height;

	(void)state;
	snprintf(text, sizeof(text),
		"[state a]\nclip = rest\n[parameter z]\nlabel = no\n"
		"[buttons b]\nwhen = z < 1\nRIGHT = pause \"%s\"\n"
		"UP = pause \"short\"\n",
		sentence);
	begin(&acting, "assets/walker.glb", text);
	right = edge_of("RIGHT", sentence, &height);
	assert_true(edge_of("", sentence, &height) < right);
	assert_true(edge_of("RIGHT+DOWN", sentence, &height) > right);
	hud_read_begin(&hud, 480, 640);
	character_label_all(acting.character, "", &hud);
	assert_int_equal(right_edge(), right);
	assert_true(hud.stacked_px[HUD_TOP_LEFT] > 0);
	assert_int_equal(hud.stacked_px[HUD_BOTTOM_LEFT], height);
	acting_end(&acting);
}

/* Below the labels; where there is no room, in their place. */
static void test_the_list_of_keys_is_below_or_alone(void **state)
{
	static const char list[] = "UP|one\nDOWN list\nLEFT three\nRIGHT four";
	struct acting acting;
	char both[128];

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[parameter p]\n[buttons]\n"
		"UP = set p 1 \"one\"\nDOWN = keys \"list\"\n"
		"LEFT = pause \"three\"\nRIGHT = tour \"four\"\n");
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	snprintf(both, sizeof(both), "a\n0.00|p\n%s", list);
	expect_in(&acting, 2400, 1200, both);
	assert_true(hud.stacked_px[HUD_BOTTOM_LEFT] > 0);
	assert_true(hud.stacked_px[HUD_TOP_LEFT] > 0);
	expect_in(&acting, 1024, 1200, list);
	expect_in(&acting, 1200, 160, list);
	assert_int_equal(hud.stacked_px[HUD_TOP_LEFT], 0);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_values_without_names_have_numbers),
		cmocka_unit_test(test_parts_without_names_have_numbers),
		cmocka_unit_test(test_the_first_four_values_are_shown),
		cmocka_unit_test(test_a_fade_is_shown_by_its_share),
		cmocka_unit_test(
			test_the_first_switch_has_a_bar_of_its_own_colour),
		cmocka_unit_test(test_presets_have_a_row_and_a_number),
		cmocka_unit_test(test_a_morph_and_a_part_have_their_rows),
		cmocka_unit_test(test_buttons_that_switch_nothing_have_no_switch),
		cmocka_unit_test(test_buttons_are_below_and_as_wide_as_they_need),
		cmocka_unit_test(test_the_list_of_keys_is_below_or_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
