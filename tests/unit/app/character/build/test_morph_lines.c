/* What the lines of [expression] and [morph] say, up to their limits. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	KEYS_MAX = 64
};

/*
 * Two nodes show a mesh with so many targets, of which the second has a name,
 * and one a mesh without any.
 */
static void begin(struct acting *acting, int targets)
{
	static const float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "morphs.bin");
	FILE *file;

	file_write(path.text, triangle, sizeof(triangle));
	path = path_join(&folder, "morphs.gltf");
	file = fopen(path.text, "w");
	assert_non_null(file);
	fprintf(file,
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,1,2,3]}],\"nodes\":["
		"{\"name\":\"A\",\"mesh\":0},{\"name\":\"B\",\"mesh\":0},"
		"{\"name\":\"C\"},{\"name\":\"P\",\"mesh\":1}],"
		"\"meshes\":[{\"extras\":{\"targetNames\":[");
	for (int i = 0; i < targets; i++) {
		fprintf(file, "%s\"%s\"", i ? "," : "", i == 1 ? "s" : "");
	}
	fprintf(file,
		"]},\"primitives\":[{\"attributes\":{\"POSITION\":0},"
		"\"targets\":[");
	for (int i = 0; i < targets; i++) {
		fprintf(file, "%s{\"POSITION\":0}", i ? "," : "");
	}
	fprintf(file,
		"]}]},{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
		"\"accessors\":[{\"bufferView\":0,"
		"\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
		"\"min\":[0,0,0],\"max\":[1,1,0]}],"
		"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
		"\"buffers\":[{\"byteLength\":36,\"uri\":\"morphs.bin\"}]}");
	assert_int_equal(fclose(file), 0);
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
}

static void refuse(struct acting *acting, const char *text, const char *why)
{
	acting_read(acting, text);
	if (acting->error != -EINVAL) {
		fail_msg("accepted: %s", text);
	}
	assert_contains(acting->logged.sentence[0], why);
}

static void test_a_section_is_about_the_first_node_or_another(void **state)
{
	static const struct {
		const char *line;
		int node;
	} cases[] = {{"", 0}, {"node = A\n", 0}, {"node = B\n", 1}};
	struct acting acting;

	(void)state;
	begin(&acting, 5);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character *character;
		char text[128];

		snprintf(text, sizeof(text),
			"[morph m]\n%s[expression e]\n%stargets = 3 0.5, s\n",
			cases[i].line, cases[i].line);
		acting_expect(&acting, text);
		character = acting.character;
		assert_int_equal(character->morph[0].node, cases[i].node);
		assert_int_equal(character->expression[0].count, 2);
		for (int k = 0; k < 2; k++) {
			assert_int_equal(character->expression[0].target[k],
				5 * cases[i].node + (k ? 1 : 3));
			assert_near(character->expression[0].amount[k],
				k ? 1 : 0.5, 0);
		}
	}
	refuse(&acting, "[morph m]\nnode = C\n",
		"the node has no morph targets");
	refuse(&acting, "[morph m]\nnode = P\n",
		"the node has no morph targets");
	refuse(&acting, "[morph m]\nnode = D\n", "there is no node named D");
	acting_end(&acting);
	begin(&acting, 1);
	acting_expect(&acting, "[morph m]\nnode = B\n");
	acting_end(&acting);
}

static void test_an_expression_mixes_up_to_32_targets(void **state)
{
	char text[512] = "[expression e]\ntargets = 0 0.25";
	struct acting acting;

	(void)state;
	begin(&acting, 2);
	for (int i = 1; i < 31; i++) {
		strcat(text, ", 1");
	}
	strcat(text, "\ntargets = s -0.5");
	acting_expect(&acting, text);
	assert_int_equal(acting.character->expression[0].count, 32);
	assert_int_equal(acting.character->expression[0].target[31], 1);
	assert_near(acting.character->expression[0].amount[31], -0.5, 0);
	strcat(text, ", s");
	refuse(&acting, text, "at most 32 targets can be mixed");
	acting_end(&acting);
}

static float weight_in(const struct character_morph *morph, int key, int target)
{
	return morph->key[key].position[target / 3][target % 3];
}

/* The neutral shape comes first; of too many targets the last are left out. */
static void test_without_keys_each_target_is_one(void **state)
{
	static const int counts[] = {1, 2, 3, 4, 63, 64, 70};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counts); i++) {
		int count = counts[i];
		const struct character_morph *morph;
		struct acting acting;

		begin(&acting, count);
		acting_expect(&acting, "[morph m]\n");
		morph = acting.character->morph;
		assert_true(morph->plain_keys);
		assert_int_equal(morph->target_count, count);
		assert_int_equal(
			morph->key_count, count < 63 ? count + 1 : KEYS_MAX);
		assert_string_equal(morph->key_name[0], "neutral");
		for (int k = 0; k < morph->key_count; k++) {
			char number[16];

			for (int t = 0; t < count; t++) {
				assert_near(
					weight_in(morph, k, t), t == k - 1, 0);
			}
			snprintf(number, sizeof(number), "%d", k - 1);
			if (k > 0) {
				assert_string_equal(morph->key_name[k],
					k == 2 ? "s" : number);
			}
		}
		assert_int_equal(morph->morph.vertex_count, (count + 2) / 3);
		acting_end(&acting);
	}
}

static void test_a_morph_has_up_to_64_key_frames(void **state)
{
	char text[1024] = "[morph m]\nkey = a, 0 0.5, 3 -0.25\n";
	const struct character_morph *morph;
	struct acting acting;

	(void)state;
	begin(&acting, 4);
	for (int i = 1; i < KEYS_MAX; i++) {
		strcat(text, "key = b\n");
	}
	acting_expect(&acting, text);
	morph = acting.character->morph;
	assert_false(morph->plain_keys);
	assert_int_equal(morph->key_count, KEYS_MAX);
	assert_near(weight_in(morph, 0, 0), 0.5, 0);
	assert_near(weight_in(morph, 0, 1), 0, 0);
	assert_near(weight_in(morph, 0, 3), -0.25, 0);
	assert_near(weight_in(morph, 1, 3), 0, 0);
	strcat(text, "key = c\n");
	refuse(&acting, text, "a morph has at most 64 key frames");
	refuse(&acting, "[morph m]\nkey = , s\n", "the name is missing");
	acting_end(&acting);
}

/* By frames only if the section gives frames alone. */
static void test_a_morph_goes_over_time_or_by_frames(void **state)
{
	static const struct {
		const char *lines;
		bool by_frames;
		int frames;
	} cases[] = {{"", false, 18}, {"frames = 7\n", true, 7},
		{"time = 2\n", false, 60}, {"time = 2\nframes = 7\n", false, 7},
		{"frames = 1\ntime = 2\n", false, 1},
		{"time = 0.048\n", false, 1}, {"time = 0.052\n", false, 2},
		{"time = 0.01\n", false, 1}};
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_morph *morph;
		char text[128];

		snprintf(text, sizeof(text), "[morph m]\n%s", cases[i].lines);
		acting_expect(&acting, text);
		morph = acting.character->morph;
		assert_int_equal(morph->by_frames, cases[i].by_frames);
		assert_int_equal(morph->frame_count, cases[i].frames);
		assert_near(morph->pace, 1, 0);
		assert_near(*morph->weight, 1, 0);
		assert_int_equal(morph->destiny, 0);
		assert_int_equal(morph->chosen, 0);
	}
	acting_end(&acting);
}

/* Only these move the vertices one by one. */
static void test_a_sine_or_a_turn_bends_the_shape(void **state)
{
	static const struct {
		const char *lines;
		bool bends;
	} cases[] = {{"", false}, {"curve = linear\ncurve = table 0 1\n", false},
		{"curve = sine 0.1\n", true},
		{"curve = linear\ncurve = sine 0.1\n", true},
		{"curve = sine 0.1\ncurve = linear\n", true},
		{"neck = 0.1 0.2\n", false},
		{"neck = 0.1 0.2\nturn = 0\n", true}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_morph *morph;
		char text[128];

		snprintf(text, sizeof(text), "[morph m]\n%s", cases[i].lines);
		acting_expect(&acting, text);
		morph = acting.character->morph;
		assert_int_equal(morph->bend.part_count > 0, cases[i].bends);
		if (strstr(text, "neck")) {
			assert_near(morph->neck.low, 0.1, 1e-6);
			assert_near(morph->neck.high, 0.2, 1e-6);
		}
	}
	refuse(&acting, "[morph m]\nneck = 0.2 0.2\n",
		"the second height has to be larger");
	acting_end(&acting);
}

#define THIRTY "0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9"

static void test_curves_and_tables_have_limits(void **state)
{
	static const struct {
		const char *lines, *error; /* NULL: they are right */
	} cases[] = {
		{"curve = linear\ncurve = linear\ncurve = linear\n"
		 "curve = linear\n",
			NULL},
		{"curve = linear\ncurve = linear\ncurve = linear\n"
		 "curve = linear\ncurve = linear\n",
			"a morph has at most 4 curves"},
		{"curve = table " THIRTY " 5 1\n", NULL},
		{"curve = table " THIRTY " 5 5\n", "a table has 2 to 32 numbers"},
		{"curve = table " THIRTY " 5 1 1\n", "1 is too much"},
		{"curve = table 0 1\n", NULL},
		{"curve = table 0\n", "a table has 2 to 32 numbers"},
		{"curve = table 1\n", "a table has 2 to 32 numbers"},
		{"curve = table\n", "a table has 2 to 32 numbers"},
		{"curve = table 0.1 1\n", "a table has 2 to 32 numbers"},
		{"curve = table 0 0.9\n", "a table has 2 to 32 numbers"},
		{"curve = bezier 0 -5 1 7\n", NULL},
		{"curve = bezier 1 -5 0 7\n", NULL},
		{"curve = bezier 0 0 1\n", "a Bezier curve has four numbers"},
		{"curve = bezier 0 0 1 1 1\n", "a Bezier curve has four numbers"},
		{"curve = bezier 1.1 0 1 1\n", "a Bezier curve has four numbers"},
		{"curve = bezier -0.1 0 1 1\n",
			"a Bezier curve has four numbers"},
		{"curve = bezier 0 0 1.1 1\n", "a Bezier curve has four numbers"},
		{"curve = bezier 0 0 -0.1 1\n",
			"a Bezier curve has four numbers"},
		{"curve = sine 0 0 0 1 100\n", NULL},
		{"curve = sine 1000000\n", NULL},
		{"curve = sine 1000001\n", "is not right here"},
		{"curve = sine -1\n", "is not right here"},
		{"curve = sine 1 0 1 0\n", "a word is missing"},
		{"curve = sine 1 0 1\n", "a word is missing"},
		{"curve = sine 1 0\n", "a word is missing"},
		{"curve = sine 1 0 1 0 101\n", "is not right here"},
		{"curve = sine 1 0 1 0 -1\n", "is not right here"},
		{"curve = sine 1 0 0 0 1\n", "axis must not be 0 0 0"},
	};
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[256];

		snprintf(text, sizeof(text), "[morph m]\n%s", cases[i].lines);
		if (cases[i].error) {
			refuse(&acting, text, cases[i].error);
		} else {
			acting_expect(&acting, text);
		}
	}
	acting_end(&acting);
}

static void test_curves_have_names(void **state)
{
	static const char *const names[] = {
		"linear", "sinusoidal", "Bezier", "table"};
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	acting_expect(&acting,
		"[morph m]\ncurve = linear\ncurve = sine 1\n"
		"curve = bezier 0 0 1 1\ncurve = table 0 1\n");
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		assert_string_equal(
			acting.character->morph[0].curve[i].name, names[i]);
	}
	acting_expect(&acting, "[morph m]\ncurve = linear \"at first\"\n");
	assert_string_equal(
		acting.character->morph[0].curve[0].name, "at first");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_section_is_about_the_first_node_or_another),
		cmocka_unit_test(test_an_expression_mixes_up_to_32_targets),
		cmocka_unit_test(test_without_keys_each_target_is_one),
		cmocka_unit_test(test_a_morph_has_up_to_64_key_frames),
		cmocka_unit_test(test_a_morph_goes_over_time_or_by_frames),
		cmocka_unit_test(test_a_sine_or_a_turn_bends_the_shape),
		cmocka_unit_test(test_curves_and_tables_have_limits),
		cmocka_unit_test(test_curves_have_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
