/* Swings of roots and ends, fades beyond their ends, and limits of texts. */
#include "app/anim/procedural/procedural.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* A root with a bone below it, another root, and a bone below that. */
enum {
	ROOT,
	BELOW,
	OTHER,
	END,
	NODES
};

static void set_up(struct bones *bones)
{
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones_add(bones, ROOT, 0, 1, 0);
	bones_add(bones, -1, 2, 0, 0);
	bones_add(bones, OTHER, 0, 1, 0);
	bones_pose(bones);
}

static struct procedural begin(int node)
{
	struct procedural_preset preset = procedural_preset_default();
	struct procedural shake = procedural_begin(&preset, node);

	procedural_fade(&shake, 0, 0);
	return shake;
}

/* The nodes that moved, as bits; only these count as animated. */
static int moved(const struct bones *bones)
{
	int bits = 0;

	for (int i = 0; i < NODES; i++) {
		bool same = memcmp(&bones->pose.local[i], &bones->node[i].rest,
				    sizeof(struct transform)) == 0;

		assert_int_equal(bones->pose.animated[i], !same);
		bits |= same ? 0 : 1 << i;
	}
	return bits;
}

static void test_a_swing_moves_its_bone_and_those_below(void **state)
{
	static const int want[NODES + 1] = {0, 1 << ROOT | 1 << BELOW,
		1 << BELOW, 1 << OTHER | 1 << END, 1 << END};

	(void)state;
	for (int node = -1; node < NODES; node++) {
		struct procedural shake = begin(node);
		struct bones bones;

		set_up(&bones);
		procedural_apply(&shake, 0, &bones.pose);
		assert_int_equal(moved(&bones), want[node + 1]);
		bones_end(&bones);
	}
}

/* Nodes beyond those of the pose are none of its bones. */
static void test_a_swing_ends_with_the_pose(void **state)
{
	struct procedural shake = begin(OTHER);
	struct bones bones;

	(void)state;
	set_up(&bones);
	bones.pose.node_count = END;
	procedural_apply(&shake, 0, &bones.pose);
	assert_int_equal(moved(&bones), 1 << OTHER);
	bones_end(&bones);
}

static void test_a_swing_is_off_at_fade_1_and_on_before(void **state)
{
	static const float fade[] = {0.99f, 1, 1.5f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct procedural shake = begin(BELOW);
		struct bones bones;

		set_up(&bones);
		shake.fade = fade[i];
		procedural_apply(&shake, 0, &bones.pose);
		assert_int_equal(moved(&bones), i == 0 ? 1 << BELOW : 0);
		bones_end(&bones);
	}
}

/* Rotations that are off by rounding do not grow from frame to frame. */
static void test_a_swung_bone_is_of_unit_length(void **state)
{
	struct procedural shake = begin(BELOW);
	struct bones bones;
	const float *q;

	(void)state;
	set_up(&bones);
	q = bones.pose.local[BELOW].rotation;
	bones.pose.local[BELOW].rotation[3] = 1.01f;
	procedural_apply(&shake, 0, &bones.pose);
	assert_near(
		q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-6);
	bones_end(&bones);
}

static void test_a_swing_begins_faded_out_and_stays_so(void **state)
{
	struct procedural_preset preset = procedural_preset_default();
	struct procedural shake = procedural_begin(&preset, 0);

	(void)state;
	assert_true(shake.fade == 1 && shake.fade_goal == 1);
	procedural_update(&shake, 10);
	assert_true(shake.fade == 1);
}

static void test_fades_end_between_0_and_1(void **state)
{
	static const float goal[][2] = {
		{-3, 0}, {0.25f, 0.25f}, {1, 1}, {1.5f, 1}, {5, 1}};

	(void)state;
	for (int i = 0; i < 5 * 2; i++) {
		struct procedural shake = begin(0);

		shake.fade = 0.5f;
		procedural_fade(&shake, goal[i / 2][0], i % 2 ? 0.5f : 0);
		procedural_update(&shake, i % 2 ? 3 : 0);
		assert_near(shake.fade, (double)goal[i / 2][1], 0);
		procedural_update(&shake, 0);
		assert_near(shake.fade, (double)goal[i / 2][1], 0);
	}
}

static void test_no_time_and_time_backwards_fade_nothing(void **state)
{
	static const float step_s[] = {0, -0.1f, -2};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct procedural shake = begin(0);

		procedural_fade(&shake, 1, 4);
		procedural_update(&shake, step_s[i]);
		assert_near(shake.fade, 0, 0);
	}
}

static void test_only_the_presets_counted_are_found(void **state)
{
	struct procedural_preset preset[2] = {
		procedural_preset_default(), procedural_preset_default()};

	(void)state;
	strcpy(preset[1].name, "twist");
	assert_int_equal(procedural_preset_find(preset, 2, "twist"), 1);
	assert_int_equal(procedural_preset_find(preset, 1, "twist"), -1);
	assert_int_equal(procedural_preset_find(preset, 0, "snowboard"), -1);
}

/* The result, and the sentence if there is one, else "". */
static int parse(const char *text, struct procedural_preset preset[2],
	char sentence[], size_t size)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	int result;

	memset(preset, 0x55, 2 * sizeof(*preset));
	result = procedural_presets_parse(text, "p.ini", &log, preset, 2);
	assert_int_equal(capture.count, result < 0);
	snprintf(sentence, size, "%s", result < 0 ? capture.sentence[0] : "");
	return result;
}

static void test_texts_at_their_limits_are_read(void **state)
{
	static const struct {
		const char *text;
		int count;
		const char *name; /* of the last preset */
		float speed;
	} cases[] = {
		{"", 0, "", 0},
		{" \t\r\n;\n#\n", 0, "", 0},
		{"[a]", 1, "a", 40},
		{"[a]\n[b]", 2, "b", 40},
		{"[a]\nspeed=1\n[b]\nspeed=2", 2, "b", 2},
		{"[aaaaaaaaaabbbbbbbbbbccccccccccd]", 1,
			"aaaaaaaaaabbbbbbbbbbccccccccccd", 40},
		{"[ \t a b\t ]", 1, "a b", 40},
		{"[a]\nspeed=999999", 1, "a", 999999},
		{"[a]\nspeed=-999999", 1, "a", -999999},
		{"[a]\nspeed=3#4", 1, "a", 3},
		{"[a]\nspeed=3;4#5\n", 1, "a", 3},
		{"[a]\nspeed=3#4;5\n", 1, "a", 3},
		{"[a]\n \tspeed \t=\t 5 \t\r\n", 1, "a", 5},
		{"[a]\n#speed=4", 1, "a", 40},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct procedural_preset preset[2];
		char sentence[256];
		int count = parse(
			cases[i].text, preset, sentence, sizeof(sentence));

		assert_int_equal(count, cases[i].count);
		if (count > 0) {
			assert_string_equal(
				preset[count - 1].name, cases[i].name);
			assert_near(preset[count - 1].speed,
				(double)cases[i].speed, 0);
		}
	}
}

static void test_texts_beyond_their_limits_are_refused(void **state)
{
	static const struct {
		const char *text;
		const char *sentence;
	} cases[] = {
		{"[", "p.ini:1: a section must look like [name]"},
		{"\n\n[\n", "p.ini:3: a section must look like [name]"},
		{"[]", "p.ini:1: a name must have 1 to 31 characters"},
		{"[ \t]", "p.ini:1: a name must have 1 to 31 characters"},
		{"[a#]", "p.ini:1: a section must look like [name]"},
		{"[a]\nspeed=1000000", "p.ini:2: this key takes one number"},
		{"[a]\nspeed=-1000000", "p.ini:2: this key takes one number"},
		{"[a]\nspeed=1 2", "p.ini:2: this key takes one number"},
		{"[a]\nunit=", "p.ini:2: this key takes one number"},
		{"[a]\nspeed=#7", "p.ini:2: this key takes one number"},
		{"[a]\nrotation=1 2", "p.ini:2: this key takes three numbers"},
		{"[a]\ntranslation=1 2 3 4",
			"p.ini:2: this key takes three numbers"},
		{"[a]\nrotation=1 2\n3", "p.ini:2: this key takes three numbers"},
		{"[a]\nspeed", "p.ini:2: a setting must look like key = value"},
		{"[a]\nspeed#=7",
			"p.ini:2: a setting must look like key = value"},
		{"=1", "p.ini:1: a setting must follow a [name]"},
		{"[a]\n=1", "p.ini:2: unknown key"},
		{"[a]\nspeed x=1", "p.ini:2: unknown key"},
		{"[a]\nspee=1", "p.ini:2: unknown key"},
		{"[a]\n[b]\n\n[c]", "p.ini:4: a file can have at most 2 presets"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct procedural_preset preset[2];
		char sentence[256];

		assert_true(parse(cases[i].text, preset, sentence,
				    sizeof(sentence)) < 0);
		assert_contains(sentence, cases[i].sentence);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_swing_moves_its_bone_and_those_below),
		cmocka_unit_test(test_a_swing_ends_with_the_pose),
		cmocka_unit_test(test_a_swing_is_off_at_fade_1_and_on_before),
		cmocka_unit_test(test_a_swung_bone_is_of_unit_length),
		cmocka_unit_test(test_a_swing_begins_faded_out_and_stays_so),
		cmocka_unit_test(test_fades_end_between_0_and_1),
		cmocka_unit_test(test_no_time_and_time_backwards_fade_nothing),
		cmocka_unit_test(test_only_the_presets_counted_are_found),
		cmocka_unit_test(test_texts_at_their_limits_are_read),
		cmocka_unit_test(test_texts_beyond_their_limits_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
