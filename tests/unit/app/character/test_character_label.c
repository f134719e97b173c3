/* How much room a character asks for, for its labels. */
#include "app/character/show/character_label.h"
#include "app/character/show/label_name.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

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

static void expect_count(const char *model, const char *text, int rows, int bars)
{
	struct acting acting;
	int count = -1;

	acting_begin(&acting, model);
	acting_expect(&acting, text);
	assert_int_equal(character_label_count(acting.character, &count), rows);
	assert_int_equal(count, bars);
	acting_end(&acting);
}

#define LOOK(name, keys) "[look " name "]\nbone = head\ntarget = t\n" keys
#define OFF(name)        LOOK(name, "on = no\n")

/* Those that are off at first are taken to be on together, up to six. */
static void test_switches_have_rows_with_bars(void **state)
{
	static const char model[] = "assets/walker.glb";

	(void)state;
	expect_count(model,
		"[state a]\nclip = walk\n[target t]\nplace = 0 1 2\n" OFF("a")
			LOOK("on", "") LOOK("hidden", "on = no\nlabel = no\n")
				OFF("b"),
		3, 3);
	expect_count(model,
		"[state a]\nclip = walk\n[target t]\nplace = 0 1 2\n" OFF("a")
			OFF("b") OFF("c") OFF("d") OFF("e") OFF("f") OFF("g"),
		7, 7);
}

/* Key frames and pace of a morph; values, and the step of a sequence. */
static void test_morphs_and_parts_have_rows(void **state)
{
	(void)state;
	expect_count(
		"assets/face.glb", "[state a]\nclip = rest\n[morph m]\n", 3, 1);
	expect_count("assets/arm.glb", "[part Arm]\n", 4, 0);
	expect_count("assets/arm.glb",
		"[part Arm]\npitch = 0 -9 9\n[parameter c]\nchoices = a b\n", 5,
		0);
	expect_count("assets/arm.glb",
		"[part Arm]\npitch = 0 -9 9\n[parameter c]\nchoices = a b\n"
		"[sequence s]\nstep = up 1, Arm pitch 5\n",
		6, 1);
	expect_count("assets/walker.glb",
		"[state a]\nclip = walk\n[parameter v]\n[scene]\n"
		"labels = none\n",
		0, 2);
}

/* What the label calls the walker's clip in a state of this name. */
static void expect_motion(const char *state, int clip, const char *shown)
{
	char text[128], number[HUD_NAME_BYTES];
	struct acting acting;

	snprintf(text, sizeof(text), "[state \"%s\"]\nclip = %d\n", state, clip);
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, text);
	assert_string_equal(
		label_name_motion(acting.character,
			&acting.character->instance->model->clip[clip], number),
		shown);
	acting_end(&acting);
}

/* Names that are too long for a section are still not too long for labels. */
static void test_a_state_that_is_only_a_number_shows_its_clip(void **state)
{
	const struct model *model;
	struct acting acting;
	char first[32];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	model = acting.instance->model;
	snprintf(first, sizeof(first), "%s", model->clip[0].name);
	acting_end(&acting);
	expect_motion("clip 0", 0, first);
	expect_motion("clip 1", 0, "clip 1");
	expect_motion("stands", 0, "stands");
}

/* Returns how many boxes labels show in place of letters that the font lacks. */
static int count_boxes(const struct character *character)
{
	static struct hud hud;
	const struct font_glyph *box;
	int count = 0;

	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, 480, 640);
	character_label_all(character, "title", &hud);
	box = &hud.face->glyph[FONT_UNKNOWN];
	assert_true(hud.quad_count > 10);
	for (int i = 0; i < hud.quad_count; i++) {
		const struct hud_vertex *corner = &hud.vertex[4 * i];

		count += corner->s == (float)box->s &&
			corner->t == (float)box->t;
	}
	return count;
}

/* Names that the font lacks, of all that labels show beside a model. */
static void test_no_label_is_a_row_of_boxes(void **state)
{
	static const char *const texts[][2] = {
		{"assets/walker.glb", "[state \u6b69]\nclip = walk\n"},
		{"assets/walker.glb",
			"[parameter \u6b69]\nchoices = \u6b69 \u304f\n"
			"[parameter \u304f]\nrange = 0 1\n"
			"[layer \u8d70]\nclip = wave\n"},
		{"assets/face.glb",
			"[state a]\nclip = rest\n"
			"[morph \u9854]\nnode = Face\ntime = 1\n"
			"key = \u7b11, smile 1\n"},
		{"assets/arm.glb",
			"[part \u8155]\nnode = Base\nheading = 0 -90 90 45\n"
			"[buttons]\nUP = move \u8155 heading 1 \"up\"\n"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		struct acting acting;

		acting_begin(&acting, texts[i][0]);
		acting_expect(&acting, texts[i][1]);
		acting_run_to(&acting, 0.1, 20.0);
		assert_int_equal(count_boxes(acting.character), 0);
		acting_end(&acting);
	}
}

/* By its actions, or by a number if they cannot be shown either. */
static void test_a_sentence_that_the_font_lacks_is_replaced(void **state)
{
	static const char *const shown[] = {
		"go faster", "set speed 1", "action 3", "go b"};
	const struct character_binding *one;
	struct acting acting;
	size_t i = 0;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter speed]\n[parameter \u901f\u5ea6\u901f\u5ea6\u901f]\n"
		"[state a]\nclip = walk\n[state b]\nclip = run\n[buttons]\n"
		"UP = set speed 1 \"go faster\"\n"
		"DOWN = set speed 1 \"\u8dd1\u5f97\u66f4\u5feb\"\n"
		"LEFT = add \u901f\u5ea6\u901f\u5ea6\u901f 1 \"\u8d70\"\n"
		"RIGHT = go b\n");
	for (one = acting.character->binding; one; one = one->next) {
		assert_string_equal(one->shown, shown[i]);
		i++;
	}
	assert_int_equal(i, ARRAY_COUNT(shown));
	acting_end(&acting);
}

static void test_the_first_such_sentence_is_reported(void **state)
{
	static const char text[] =
		"[state a]\nclip = walk\n[buttons]\n"
		"UP = pause \"\u505c\"\nDOWN = tour \"\u770b\"\n";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");
	struct acting acting;

	(void)state;
	file_write(path.text, text, strlen(text));
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, path.text);
	assert_int_equal(acting.error, 0);
	assert_int_equal(acting.logged.count, 1);
	assert_non_null(strstr(acting.logged.sentence[0],
		":4: the font of pictures has no letters for \"\u505c\", so labels show \"pause\""));
	acting_end(&acting);
	temp_dir_remove(&folder);
}

/* Letters and boxes of the labels of a walker with a shake. */
static int count_quads(const struct test_path *path, const char *keys)
{
	static struct hud hud;
	struct acting acting;
	char text[128];
	int bars;

	snprintf(text, sizeof(text),
		"[state a]\nclip = walk\n[shake s]\nbone = head\n%s", keys);
	file_write(path->text, text, strlen(text));
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, path->text);
	assert_int_equal(acting.error, 0);
	acting_run_to(&acting, 0.1, 20.0);
	/* A row for the preset, or for "paused". */
	assert_int_equal(character_label_count(acting.character, &bars), 2);
	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, 480, 640);
	character_label_all(acting.character, "title", &hud);
	acting_end(&acting);
	return hud.quad_count;
}

static void test_labels_name_a_shakes_only_preset(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");
	int without;

	(void)state;
	file_write(path_join(&folder, "p.ini").text, "[only]\n", 7);
	without = count_quads(&path, "");
	assert_true(count_quads(&path, "presets = p.ini\n") >=
		without + (int)strlen("presetonly"));
	assert_int_equal(
		count_quads(&path, "presets = p.ini\nlabel = no\n"), without);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_parameter_that_buttons_move_has_a_bar),
		cmocka_unit_test(test_a_fade_has_a_bar),
		cmocka_unit_test(test_switches_have_rows_with_bars),
		cmocka_unit_test(test_morphs_and_parts_have_rows),
		cmocka_unit_test(
			test_a_state_that_is_only_a_number_shows_its_clip),
		cmocka_unit_test(test_labels_name_a_shakes_only_preset),
		cmocka_unit_test(test_no_label_is_a_row_of_boxes),
		cmocka_unit_test(test_a_sentence_that_the_font_lacks_is_replaced),
		cmocka_unit_test(test_the_first_such_sentence_is_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
