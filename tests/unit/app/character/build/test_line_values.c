/* What the words of a line mean that several kinds of sections have. */
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* A duration is given in seconds or in whole frames. */
static void test_a_fade_lasts_seconds_or_frames(void **state)
{
	static const struct {
		const char *words;
		double duration_s;
		int frames;
		enum inertia_curve curve;
	} rows[] = {
		{"0.25", 0.25, 0, INERTIA_SMOOTH},
		{"0.25 s", 0.25, 0, INERTIA_SMOOTH},
		{"0.25 s cubic", 0.25, 0, INERTIA_CUBIC},
		{"2 linear", 2, 0, INERTIA_LINEAR},
		{"3 frames", 0, 3, INERTIA_SMOOTH},
		{"3 frames smooth", 0, 3, INERTIA_SMOOTH},
		{"0 frames", 0, 0, INERTIA_SMOOTH},
		{"60 frames cubic", 0, 60, INERTIA_CUBIC},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_fade *fade;
		char text[128];

		snprintf(text, sizeof(text),
			"[state a]\nclip = walk\nfade = %s\n", rows[i].words);
		acting_expect(&acting, text);
		fade = &acting.character->machine.state[0].fade;
		assert_near(fade->duration_s, rows[i].duration_s, 0);
		assert_int_equal(fade->frames, rows[i].frames);
		assert_int_equal(fade->curve, rows[i].curve);
	}
	acting_read(&acting, "[state a]\nclip = walk\nfade = 1 smooth cubic\n");
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(acting.logged.sentence[0], "cubic is too much");
	acting_end(&acting);
}

/* The sentence names the first word that is wrong. */
static void test_a_wrong_number_is_named(void **state)
{
	static const struct {
		const char *text, *wrong; /* NULL: it is right */
	} rows[] = {
		{"[parameter a]\nrange = -1e9 1e9", NULL},
		{"[parameter a]\nrange = -1.01e9 0", "-1.01e9 is not right"},
		{"[parameter a]\nrange = 0 1.01e9", "1.01e9 is not right"},
		{"[parameter a]\nrange = 0 nan", "nan is not right"},
		{"[parameter a]\nrange = 0 1x", "1x is not right"},
		{"[parameter a]\nrange = 0 \"1\"", "1 is not right"},
		{"[parameter a]\nrange = 0", "a word is missing"},
		{"[parameter a]\nrange = 0 1 2", "2 is too much"},
		{"[parameter a]\nrange =", "the value is missing"},
		{"[target a]\ncolor = 0 2 0.5", "2 is not right"},
		{"[target a]\ncolor = 0 0.5 -1", "-1 is not right"},
		{"[scene]\nshadow = 1.5", "1.5 is not right"},
		{"[scene]\nshadow = -1", "-1 is not right"},
		{"[scene]\nshadow = , 1", ", is not right"},
		{"[state a]\nclip = walk\nfade = 61 frames", "61 is not right"},
		{"[state a]\nclip = walk\nfade = -1", "-1 is not right"},
		{"[layer a]\nclip = wave\nsoft = 1.5", "1.5 is no whole"},
		{"[layer a]\nclip = wave\nsoft = 17", "17 is not right"},
		{"[trigger a]\nwhat = 1", "use one of when, then, else"},
		{"[layer a]\nclip = wave\nmask = ,",
			"the node's name is missing"},
		{"[layer a]\nclip = wave\nmode = \"additive\"",
			"additive is not right"},
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		char text[128];

		snprintf(text, sizeof(text), "%s\n", rows[i].text);
		acting_read(&acting, text);
		if (!rows[i].wrong) {
			assert_int_equal(acting.error, 0);
			continue;
		}
		assert_int_equal(acting.error, -EINVAL);
		assert_int_equal(acting.logged.count, 1);
		assert_contains(acting.logged.sentence[0], rows[i].wrong);
	}
	acting_end(&acting);
}

/* Such lines add to each other; of all others, there is one. */
static void test_some_lines_may_be_repeated(void **state)
{
	static const struct {
		const char *model, *section, *line;
		bool may; /* be repeated */
	} rows[] = {
		{"walker", "[state a]\nclip = walk", "enter = line x", true},
		{"walker", "[state a]\nclip = walk", "leave = line x", true},
		{"walker", "[state a]\nclip = walk", "rate = 1", false},
		{"walker", "[clip walk]", "event = 0.1 line x", true},
		{"walker", "[clip walk]", "marks = 0.1", false},
		{"walker", "[layer a]\nclip = wave", "mask = head", true},
		{"walker", "[spring a]\nbones = ponytail.4 4",
			"body = hips chest 0.1", true},
		{"walker", "[turn a]", "bone = head", true},
		{"walker", "[target a]", "place = 0 0 0", false},
		{"walker", "[buttons]\nUP = pause\n[scene]", "tour = 1 UP", true},
		{"walker",
			"[parameter p]\n[state a]\nclip = walk\n"
			"[transition * a]",
			"when = p > 0.5", true},
		{"walker", "[parameter p]\n[trigger t]\nwhen = p > 0.5",
			"then = line x", true},
		{"walker", "[parameter p]\n[trigger t]\nwhen = p > 0.5",
			"else = line x", true},
		{"face", "[morph a]", "curve = linear", true},
		{"face", "[morph a]", "key = calm", true},
		{"face", "[morph a]\ncurve = sine 0.1", "direction = 0 0 1",
			true},
		{"face", "[morph a]", "time = 1", false},
		{"face", "[expression a]", "targets = smile 0.5", true},
		{"arm", "[part Arm]", "top = 0 0 0 1 1", true},
		{"arm", "[part Arm]", "guard = 0.1", true},
		{"arm", "[part Arm]", "radius = 0.1", false},
		{"arm", "[part Arm]\npitch = 0\n[sequence a]",
			"step = up 1, Arm pitch 0", true},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct acting acting;
		char path[32], text[256];

		snprintf(path, sizeof(path), "assets/%s.glb", rows[i].model);
		acting_begin(&acting, path);
		snprintf(text, sizeof(text), "%s\n%s\n", rows[i].section,
			rows[i].line);
		acting_expect(&acting, text);
		snprintf(text, sizeof(text), "%s\n%s\n%s\n", rows[i].section,
			rows[i].line, rows[i].line);
		acting_read(&acting, text);
		if ((acting.error == 0) != rows[i].may) {
			fail_msg("%s", text);
		}
		if (!rows[i].may) {
			assert_contains(acting.logged.sentence[0],
				"says this already: remove one of both");
		}
		acting_end(&acting);
	}
}

/* Three numbers behind the radius move both ends. */
static void test_an_offset_moves_both_ends_of_a_body(void **state)
{
	static const float offset[] = {0.01f, -0.02f, 0.03f};
	const struct character_spring *effect;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = walk\n[spring a]\nbones = ponytail.4 4\n"
		"body = hips chest 0.2 0.01 -0.02 0.03\nbody = chest head 0.1\n");
	assert_int_equal(acting.character->op_count, 1);
	effect = acting.character->op[0].what;
	assert_int_equal(effect->body_count, 2);
	assert_int_equal(
		effect->body[0].node_a, model_find_node(acting.model, "hips"));
	assert_int_equal(
		effect->body[0].node_b, model_find_node(acting.model, "chest"));
	assert_near(effect->body[0].radius, 0.2, 1e-7);
	assert_all_near(effect->body[0].offset_a, offset, 3, 0);
	assert_all_near(effect->body[0].offset_b, offset, 3, 0);
	assert_all_near(effect->body[1].offset_a, ((float[3]){0}), 3, 0);
	assert_all_near(effect->body[1].offset_b, ((float[3]){0}), 3, 0);
	acting_end(&acting);
}

static void test_a_refused_text_gives_no_character(void **state)
{
	struct acting acting;
	struct character *character;
	struct log nowhere = log_to_nowhere();

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "[state a]\nclip = walk\n");
	character = acting.character;
	assert_int_equal(character_load("/dev/null/none", acting.instance,
				 &nowhere, &character),
		-ENOTDIR);
	assert_null(character);
	acting_end(&acting);
}

/* Where another character left the instance does not matter. */
static void test_a_character_begins_with_the_model_at_rest(void **state)
{
	static const char text[] =
		"[motion]\nroot = hips\n[state a]\nclip = walk\n";
	struct acting fresh, moved;

	(void)state;
	acting_begin(&fresh, "assets/walker.glb");
	acting_begin(&moved, "assets/walker.glb");
	acting_expect(&fresh, text);
	for (int i = 0; i < moved.model->node_count; i++) {
		moved.instance->pose.local[i].translation[1] += 3;
	}
	instance_update_nodes(moved.instance);
	acting_expect(&moved, text);
	assert_near(moved.character->motion.height_m,
		fresh.character->motion.height_m, 1e-6);
	assert_near(moved.character->metre, fresh.character->metre, 0);
	assert_memory_equal(moved.instance->world, fresh.instance->world,
		(size_t)fresh.model->node_count * sizeof(*fresh.instance->world));
	acting_end(&fresh);
	acting_end(&moved);
}

/* The same model within less memory than it has with a character. */
static void test_a_character_takes_its_memory_from_the_model(void **state)
{
	static const char text[] = "[state a]\nclip = walk\n";
	struct memory_budget *budget;
	struct acting acting;
	size_t before;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	budget = acting.model->budget;
	before = budget->used_bytes;
	acting_expect(&acting, text);
	assert_true(budget->used_bytes > before);
	acting_read(&acting, "[state a]\n");
	assert_int_equal(acting.error, -EINVAL);
	assert_int_equal(budget->used_bytes, before);
	budget->limit_bytes = before + 1000;
	acting_read(&acting, text);
	assert_int_equal(acting.error, -ENOMEM);
	assert_contains(acting.logged.sentence[0], "test.character");
	assert_int_equal(budget->used_bytes, before);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_fade_lasts_seconds_or_frames),
		cmocka_unit_test(test_a_wrong_number_is_named),
		cmocka_unit_test(test_some_lines_may_be_repeated),
		cmocka_unit_test(test_an_offset_moves_both_ends_of_a_body),
		cmocka_unit_test(test_a_refused_text_gives_no_character),
		cmocka_unit_test(test_a_character_begins_with_the_model_at_rest),
		cmocka_unit_test(
			test_a_character_takes_its_memory_from_the_model),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
