/* What the words of each action mean. */
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

struct meaning {
	const char *words;
	enum character_verb verb;
	int index, detail;
	double amount;
};

/* Of things that have a number, the second one is named. */
static const char walker[] =
	"[parameter p]\nrange = 0 9\n[parameter q]\nrange = 0 9\n"
	"[parameter c]\nchoices = one two three\n"
	"[state a]\nclip = walk\n[state b]\nclip = run\n"
	"[layer l]\nclip = wave\nplay = once\n"
	"[layer m]\nclip = wave\nplay = once\n"
	"[shake plain]\nbone = neck\n"
	"[shake s]\nbone = head\npresets = p.ini\n"
	"[output lamp]\nline = gpiochip0/1\n[output bell]\n"
	"line = gpiochip0/2\n[buttons]\nUP = ";

static const struct meaning of_walker[] = {
	{"set q 4.5", CHARACTER_SET, 1, 0, 4.5},
	{"set c three", CHARACTER_SET, 2, 0, 2},
	{"add q -2", CHARACTER_ADD, 1, 0, -2},
	{"toggle q", CHARACTER_TOGGLE, 1, 0, 0},
	{"toggle m", CHARACTER_SWITCH, 1, 0, -1},
	{"on m", CHARACTER_SWITCH, 1, 0, 1},
	{"off m", CHARACTER_SWITCH, 1, 0, 0},
	{"go b", CHARACTER_GO, 1, 0, 0},
	{"next", CHARACTER_NEXT, 0, 0, 1},
	{"previous", CHARACTER_NEXT, 0, 0, -1},
	{"play m", CHARACTER_PLAY, 1, 0, 0},
	{"preset s next", CHARACTER_PRESET, 1, -1, 1},
	{"preset s previous", CHARACTER_PRESET, 1, -1, -1},
	{"preset s calm", CHARACTER_PRESET, 1, 0, 0},
	{"preset s wild", CHARACTER_PRESET, 1, 1, 0},
	{"output bell on", CHARACTER_OUTPUT, 1, 0, -1},
	{"output bell off", CHARACTER_OUTPUT, 1, 0, 0},
	{"output bell 1", CHARACTER_OUTPUT, 1, 0, 1},
	{"output bell 250", CHARACTER_OUTPUT, 1, 0, 250},
};

static const char arm[] =
	"[part Arm]\npitch = 0 -60 60\n[part Crate]\n[sequence r]\n"
	"step = a 1, Arm pitch 5\n[sequence s]\nstep = a 1, Arm pitch 5\n"
	"[buttons]\nUP hold = ";

static const struct meaning of_arm[] = {
	{"move Arm pitch -2", CHARACTER_MOVE, 0, CHARACTER_PITCH, -2},
	{"run s", CHARACTER_RUN, 1, 0, 0},
	{"repeat s", CHARACTER_REPEAT, 1, 0, 0},
	{"stop s", CHARACTER_STOP, 1, 0, 0},
	{"detach Crate", CHARACTER_ATTACH, 1, -1, 0},
	{"drop Crate", CHARACTER_DROP, 1, -1, 0},
	{"camera turn 180", CHARACTER_TURN, 0, 0, 3.14159265},
	{"camera tilt -90", CHARACTER_TILT, 0, 0, -1.57079633},
	{"camera zoom 30", CHARACTER_ZOOM, 0, 0, 0.3},
};

/* Without lines "key", the neutral shape is the first key frame. */
static const char face[] =
	"[morph a]\n[morph b]\nkey = calm\nkey = glad, smile\n"
	"[buttons]\nUP = ";

static const struct meaning of_face[] = {
	{"morph a neutral", CHARACTER_MORPH, 0, 0, 0},
	{"morph b calm", CHARACTER_MORPH, 1, 0, 0},
	{"morph b glad", CHARACTER_MORPH, 1, 1, 0},
	{"morph b next", CHARACTER_MORPH, 1, -1, 1},
	{"morph b previous", CHARACTER_MORPH, 1, -1, -1},
	{"pace b 0.5", CHARACTER_PACE, 1, 0, 0.5},
	{"curve b", CHARACTER_CURVE, 1, 0, 0},
	{"timing b", CHARACTER_TIMING, 1, 0, 0},
};

static void expect(const struct acting *acting, const struct meaning *wanted)
{
	const struct character_action *action =
		acting->character->binding->action;

	assert_int_equal(action->verb, wanted->verb);
	assert_int_equal(action->index, wanted->index);
	assert_int_equal(action->detail, wanted->detail);
	assert_near(action->amount, wanted->amount, 1e-6);
	assert_false(action->has_place);
	assert_null(action->next);
}

static void test_actions_of_figures(void **state)
{
	static const char presets[] = "[calm]\nspeed = 2\n[wild]\nspeed = 9\n";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");

	(void)state;
	file_write(path_join(&folder, "p.ini").text, presets, strlen(presets));
	for (size_t i = 0; i < sizeof(of_walker) / sizeof(of_walker[0]); i++) {
		struct acting acting;
		char text[1024];
		int length = snprintf(text, sizeof(text), "%s%s \"does it\"\n",
			walker, of_walker[i].words);

		file_write(path.text, text, (size_t)length);
		acting_begin(&acting, "assets/walker.glb");
		acting_load(&acting, path.text);
		assert_int_equal(acting.error, 0);
		expect(&acting, &of_walker[i]);
		acting_end(&acting);
	}
	temp_dir_remove(&folder);
}

static void test_actions_of_parts_and_the_camera(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(of_arm) / sizeof(of_arm[0]); i++) {
		struct acting acting;
		char text[512];
		/* Only some may be held. */
		bool held = strncmp(of_arm[i].words, "move", 4) == 0 ||
			strncmp(of_arm[i].words, "camera", 6) == 0;

		snprintf(text, sizeof(text), "%s%s\n", arm, of_arm[i].words);
		if (!held) {
			memmove(strstr(text, " hold"), strstr(text, " hold") + 5,
				strlen(strstr(text, " hold") + 5) + 1);
		}
		acting_begin(&acting, "assets/arm.glb");
		acting_expect(&acting, text);
		expect(&acting, &of_arm[i]);
		acting_end(&acting);
	}
}

static void test_actions_of_morphs(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	for (size_t i = 0; i < sizeof(of_face) / sizeof(of_face[0]); i++) {
		char text[256];

		snprintf(text, sizeof(text), "%s%s\n", face, of_face[i].words);
		acting_expect(&acting, text);
		expect(&acting, &of_face[i]);
	}
	acting_end(&acting);
}

/* A file of presets may have one. */
static void test_the_next_of_one_preset_is_that_preset(void **state)
{
	static const char presets[] = "[calm]\nspeed = 2\n";
	static const char text[] = "[shake s]\nbone = head\npresets = p.ini\n"
				   "[buttons]\nUP = preset s next\n";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");
	struct acting acting;

	(void)state;
	file_write(path_join(&folder, "p.ini").text, presets, strlen(presets));
	file_write(path.text, text, strlen(text));
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, path.text);
	assert_int_equal(acting.error, 0);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

static void test_an_error_names_what_an_action_needs(void **state)
{
	static const struct {
		const char *words, *error;
	} cases[] = {
		{"set p 3.5", "set: 3.5 is outside the range 1 to 2 of p"},
		{"set p", "write set PARAMETER NUMBER"},
		{"on ,", "no layer, expression or effect named \"\": write on NAME"},
		{"off ,", "write off NAME"},
		{"preset s ,", "\"\" is no preset of the shake s"},
		{"preset s calm", "calm is no preset of the shake s"},
		{"preset s next", "write preset SHAKE NAME"},
		{"move Arm ,", "write move PART"},
		{"move Arm up 1", "write move PART"},
		{"move Arm pitch", "write move PART"},
		{"move Arm z 1", "the part has no z"},
		{"output bell 0", "write output NAME on"},
		{"output bell -1", "write output NAME on"},
		{"output bell", "write output NAME on"},
		{"raw", "raw is no action: use set, "},
		{",", "\"\" is no action: use set, "},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		char text[256];

		snprintf(text, sizeof(text),
			"[parameter p]\nrange = 1 2\n[part Arm]\npitch = 0\n"
			"[shake s]\nbone = Hand\n"
			"[output bell]\nline = gpiochip0/2\n"
			"[buttons]\nUP = %s\n",
			cases[i].words);
		acting_read(&acting, text);
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(acting.logged.sentence[0], cases[i].error);
	}
	acting_end(&acting);
}

/* The first node of the model may hold a part, too. */
static void test_a_part_is_attached_at_a_place_of_a_node(void **state)
{
	static const struct {
		const char *words;
		const char *node;
		float amount, place[3];
		bool has_place;
	} cases[] = {{"attach Crate Hand", "Hand", 0, {0}, false},
		{"attach Crate Base", "Base", 0, {0}, false},
		{"attach Crate Hand 2", "Hand", 2, {0}, false},
		{"attach Crate Hand 2 0.1 0.2 0.3", "Hand", 2,
			{0.1f, 0.2f, 0.3f}, true},
		{"drop Crate Car", "Car", 0, {0}, false},
		{"drop Crate Base", "Base", 0, {0}, false}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const struct character_action *action;
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[part Crate]\n[buttons]\nUP = %s\n", cases[i].words);
		acting_begin(&acting, "assets/arm.glb");
		acting_expect(&acting, text);
		action = acting.character->binding->action;
		assert_int_equal(action->detail,
			model_find_node(acting.model, cases[i].node));
		assert_near(action->amount, cases[i].amount, 0);
		assert_int_equal(action->has_place, cases[i].has_place);
		assert_all_near(action->place, cases[i].place, 3, 0);
		acting_end(&acting);
	}
}

/* Nothing of what they do is left out without a word. */
static void test_an_action_needs_all_its_words(void **state)
{
	static const char *const words[] = {"attach Crate Hand 2 0.1",
		"attach Crate Hand 2 0.1 0.2", "attach Crate", "drop",
		"attach Crate Crate", "drop Crate Crate"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		char text[256];

		snprintf(text, sizeof(text),
			"[part Crate]\n[buttons]\nUP = %s\n", words[i]);
		acting_read(&acting, text);
		assert_int_not_equal(acting.error, 0);
	}
	acting_end(&acting);
}

/* A value out of range would be changed without a word. */
static void test_what_sets_a_parameter_is_in_its_range(void **state)
{
	static const struct {
		const char *stops, *words;
		bool right;
	} cases[] = {{"1 2", "set p 1", true}, {"1 2", "set p 2", true},
		{"1 2", "add p 9", true}, {"1 2", "set p 0.9", false},
		{"1 2", "set p 2.1", false}, {"0 2", "set p 2", false},
		{"1 2.5", "set p 2", false}, {"1 2", "set c 1", true},
		{"1 2", "set c 2", false}, {"1 2", "set c two", true}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		char text[256];

		snprintf(text, sizeof(text),
			"[parameter p]\nrange = 1 2\nstops = %s\n"
			"[parameter c]\nchoices = one two\n"
			"[buttons]\nUP = %s\n",
			cases[i].stops, cases[i].words);
		acting_read(&acting, text);
		assert_int_equal(acting.error == 0, cases[i].right);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_actions_of_figures),
		cmocka_unit_test(test_actions_of_parts_and_the_camera),
		cmocka_unit_test(test_actions_of_morphs),
		cmocka_unit_test(test_the_next_of_one_preset_is_that_preset),
		cmocka_unit_test(test_an_error_names_what_an_action_needs),
		cmocka_unit_test(test_a_part_is_attached_at_a_place_of_a_node),
		cmocka_unit_test(test_an_action_needs_all_its_words),
		cmocka_unit_test(test_what_sets_a_parameter_is_in_its_range),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
