/* What sections that look and reach say, as their bones keep it. */
#include "app/character/character_data.h"
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Four joints below each other; the third is turned by a quarter about y. */
static const char chain[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"A\",\"children\":[1],\"scale\":[%s]},"
	"{\"name\":\"B\",\"children\":[2],\"translation\":[0,1,0]},"
	"{\"name\":\"C\",\"children\":[3],\"translation\":[0,1,0],"
	"\"rotation\":[0,0.70710678,0,0.70710678]},"
	"{\"name\":\"D\",\"translation\":[0,1,0]}]}";

#define TARGET "[target t]\nplace = 0 1 1\n"
#define LOOK \
	TARGET "[look a]\ntarget = t\nbone = A\nbone = B 0.5\nbone = C 0 12\n"

struct bench {
	struct test_path folder;
	struct acting acting;
};

static void begin(struct bench *bench, const char *scale)
{
	struct test_path path;
	char file[sizeof(chain) + 16];

	bench->folder = temp_dir_make();
	path = path_join(&bench->folder, "chain.gltf");
	snprintf(file, sizeof(file), chain, scale);
	file_write(path.text, file, strlen(file));
	acting_begin(&bench->acting, path.text);
}

static void end(struct bench *bench)
{
	acting_end(&bench->acting);
	temp_dir_remove(&bench->folder);
}

/* The operation of the text's only section of this kind. */
static void *read_one(struct bench *bench, const char *text,
	void (*run)(struct character *character, void *what))
{
	const struct character *character;

	acting_expect(&bench->acting, text);
	character = bench->acting.character;
	for (int i = 0; i < character->op_count; i++) {
		if (character->op[i].run == run) {
			return character->op[i].what;
		}
	}
	fail_msg("nothing runs: %s", text);
	return NULL;
}

/* C's own z points along the model's x, and its x along the model's -z. */
static void test_bones_look_ahead_unless_told_otherwise(void **state)
{
	static const float shares[] = {1, 0.5f, 0}, rates[] = {8, 8, 12};
	static const float forward[][3] = {{0, 0, 1}, {0, 0, 1}, {-1, 0, 0}};
	struct bench bench;
	const struct character_look *look;

	(void)state;
	begin(&bench, "1,1,1");
	look = read_one(&bench, LOOK, character_look_run);
	assert_int_equal(look->bone_count, 3);
	for (int i = 0; i < 3; i++) {
		const struct lookat *bone = &look->bone[i];

		assert_near(look->share[i], shares[i], 0);
		assert_near(bone->rate, rates[i], 0);
		assert_all_near(bone->forward, forward[i], 3, 1e-6);
		assert_all_near(bone->up, ((float[]){0, 1, 0}), 3, 1e-6);
		assert_near(bone->yaw_limit_rad, 1.396, 1e-6);
		assert_near(bone->pitch_limit_rad, 0.873, 1e-6);
		assert_near(bone->release_rad, 2.094, 1e-6);
	}
	end(&bench);
}

static void test_settings_of_a_look_hold_for_all_of_its_bones(void **state)
{
	static const float forward[][3] = {{1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
	static const float up[][3] = {{0, 0, 1}, {0, 0, 1}, {-1, 0, 0}};
	struct bench bench;
	const struct character_look *look;

	(void)state;
	begin(&bench, "1,1,1");
	look = read_one(&bench,
		LOOK
		"forward = 2 0 0\nup = 0 0 0.5\nyaw = 90\npitch = 30\nrate = 7\n",
		character_look_run);
	for (int i = 0; i < 3; i++) {
		const struct lookat *bone = &look->bone[i];

		assert_near(bone->rate, 7, 0);
		assert_all_near(bone->forward, forward[i], 3, 1e-6);
		assert_all_near(bone->up, up[i], 3, 1e-6);
		assert_near(bone->yaw_limit_rad, 1.5707963, 1e-6);
		assert_near(bone->pitch_limit_rad, 0.5235988, 1e-6);
		assert_near(bone->release_rad, 0, 0);
	}
	end(&bench);
}

/* The bones are 300 units long, so that a metre has many of these. */
static void test_a_chain_has_limits_and_a_tolerance_in_metres(void **state)
{
	struct bench bench;
	const struct character_reach *reach;

	(void)state;
	begin(&bench, "100,100,100");
	reach = read_one(&bench,
		TARGET "[reach a]\ntarget = t\nchain = D 3\nlimit = 30\n",
		character_reach_run);
	assert_true(reach->is_chain);
	assert_int_equal(reach->chain.count, 3);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(reach->chain.node[i], i + 1);
		assert_near(reach->chain.limit_rad[i], 0.5235988, 1e-6);
	}
	assert_true(bench.acting.character->metre > 50.0f);
	assert_near(reach->chain.tolerance,
		0.0005 * (double)bench.acting.character->metre, 1e-6);
	reach = read_one(&bench, TARGET "[reach a]\ntarget = t\nchain = D 4\n",
		character_reach_run);
	assert_int_equal(reach->chain.count, 4);
	assert_near(reach->chain.limit_rad[3], 0, 0);
	assert_near(reach->short_m, 0, 0);
	assert_false(reach->has_pole);
	assert_false(reach->has_grip);
	end(&bench);
}

static void test_a_limb_has_a_pole_and_a_grip(void **state)
{
	struct bench bench;
	const struct character_reach *reach;

	(void)state;
	begin(&bench, "1,1,1");
	reach = read_one(&bench,
		TARGET
		"[reach a]\ntarget = t\nlimb = A B D\npole = 1 2 3\ngrip = 4 5 6\n",
		character_reach_run);
	assert_false(reach->is_chain);
	assert_int_equal(reach->limb.upper, 0);
	assert_true(reach->has_pole);
	assert_all_near(reach->pole, ((float[]){1, 2, 3}), 3, 0);
	assert_true(reach->has_grip);
	assert_all_near(reach->grip, ((float[]){4, 5, 6}), 3, 0);
	end(&bench);
}

static void test_an_effect_aims_at_the_target_that_it_names(void **state)
{
	static const char *const effects[] = {"[look a]\nbone = A\n",
		"[reach a]\nlimb = A B D\n", "[reach a]\nchain = D 2\n"};
	struct bench bench;

	(void)state;
	begin(&bench, "1,1,1");
	for (size_t i = 0; i < ARRAY_COUNT(effects); i++) {
		for (int target = 0; target < 3; target++) {
			const struct character *character;
			char text[256];

			snprintf(text, sizeof(text),
				"[target t0]\n[target t1]\n[target t2]\n"
				"%starget = t%d\n",
				effects[i], target);
			acting_expect(&bench.acting, text);
			character = bench.acting.character;
			for (int k = 0; k < 3; k++) {
				assert_int_equal(character->target[k].has_users,
					k == target);
			}
		}
	}
	end(&bench);
}

/* A rate of 0 is the usual one. */
static void test_a_bone_that_looks_has_a_share_and_a_rate(void **state)
{
	static const struct {
		const char *words;
		double share, rate;
	} cases[] = {{"A", 1, 8}, {"A 0.25", 0.25, 8}, {"A 0.5 0.5", 0.5, 0.5},
		{"A 1 0", 1, 8}, {"A 0 100", 0, 100}};
	struct bench bench;

	(void)state;
	begin(&bench, "1,1,1");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_look *look;
		char text[256];

		snprintf(text, sizeof(text),
			TARGET "[look a]\ntarget = t\nbone = %s\n",
			cases[i].words);
		look = read_one(&bench, text, character_look_run);
		assert_near(look->share[0], cases[i].share, 0);
		assert_near(look->bone[0].rate, cases[i].rate, 0);
	}
	end(&bench);
}

/* The last line counts. */
static void test_a_limb_has_three_nodes_below_each_other(void **state)
{
	const struct character_reach *reach;
	struct bench bench;

	(void)state;
	begin(&bench, "1,1,1");
	reach = read_one(&bench,
		TARGET "[reach a]\ntarget = t\nchain = D 3\nlimb = B C D\n",
		character_reach_run);
	assert_false(reach->is_chain);
	assert_int_equal(reach->limb.upper, 1);
	assert_int_equal(reach->limb.lower, 2);
	assert_int_equal(reach->limb.tip, 3);
	reach = read_one(&bench,
		TARGET "[reach a]\ntarget = t\nlimb = B C D\nchain = D 3\n",
		character_reach_run);
	assert_true(reach->is_chain);
	end(&bench);
}

static void test_what_looks_and_reaches_need(void **state)
{
	static const char *const cases[][2] = {
		{"[reach a]\ntarget = t\n", "add limb = UPPER LOWER TIP or"},
		{"[reach a]\nlimb = A B D\n", "add target = NAME"},
		{"[reach a]\nchain = D 3\n", "add target = NAME"},
		{"[reach a]\nlimb = A A D\n", "each bone has to be below"},
		{"[reach a]\nlimb = A B B\n", "each bone has to be below"},
		{"[reach a]\nlimb = B A D\n", "each bone has to be below"},
		{"[reach a]\nlimb = A C B\n", "each bone has to be below"},
		{"[reach a]\nlimb = A B\n", "a word is missing"},
		{"[reach a]\nchain = D 1\n", "the number of bones is from 2"},
		{"[reach a]\nchain = D 5\n", "the number of bones is from 2"},
		{"[reach a]\nchain = D\n", "the number of bones is from 2"},
		{"[look a]\ntarget = t\n", "add bone = NODE"},
		{"[look a]\nbone = A\n", "add target = NAME"},
		{"[look a]\ntarget = u\n", "no target named u"},
	};
	struct bench bench;

	(void)state;
	begin(&bench, "1,1,1");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[256];

		snprintf(text, sizeof(text), TARGET "%s", cases[i][0]);
		acting_read(&bench.acting, text);
		assert_int_equal(bench.acting.error, -EINVAL);
		assert_contains(bench.acting.logged.sentence[0], cases[i][1]);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_bones_look_ahead_unless_told_otherwise),
		cmocka_unit_test(
			test_settings_of_a_look_hold_for_all_of_its_bones),
		cmocka_unit_test(
			test_a_chain_has_limits_and_a_tolerance_in_metres),
		cmocka_unit_test(test_a_limb_has_a_pole_and_a_grip),
		cmocka_unit_test(test_an_effect_aims_at_the_target_that_it_names),
		cmocka_unit_test(test_a_bone_that_looks_has_a_share_and_a_rate),
		cmocka_unit_test(test_a_limb_has_three_nodes_below_each_other),
		cmocka_unit_test(test_what_looks_and_reaches_need),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
