/* A model with four legs, whose two pairs of feet keep to uneven ground. */
#include "app/character/run/feet.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Hips with hind legs, which carry a chest with front legs. */
static const char json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"hips\",\"translation\":[0,0.62,-0.3],\"children\":[1,2,5]},"
	"{\"name\":\"chest\",\"translation\":[0,0.03,0.65],\"children\":[8,11]},"
	"{\"name\":\"ul\",\"translation\":[0.1,0,0],\"children\":[3]},"
	"{\"name\":\"ll\",\"translation\":[0,-0.3,0.04],\"children\":[4]},"
	"{\"name\":\"fl\",\"translation\":[0,-0.3,-0.04]},"
	"{\"name\":\"ur\",\"translation\":[-0.1,0,0],\"children\":[6]},"
	"{\"name\":\"lr\",\"translation\":[0,-0.3,0.04],\"children\":[7]},"
	"{\"name\":\"fr\",\"translation\":[0,-0.3,-0.04]},"
	"{\"name\":\"UL\",\"translation\":[0.1,0,0],\"children\":[9]},"
	"{\"name\":\"LL\",\"translation\":[0,-0.31,0.05],\"children\":[10]},"
	"{\"name\":\"FL\",\"translation\":[0,-0.32,-0.05]},"
	"{\"name\":\"UR\",\"translation\":[-0.1,0,0],\"children\":[12]},"
	"{\"name\":\"LR\",\"translation\":[0,-0.31,0.05],\"children\":[13]},"
	"{\"name\":\"FR\",\"translation\":[0,-0.32,-0.05]}]}";

static const char hind[] =
	"[feet hind]\nhips = hips\nleft = ul ll fl\nright = ur lr fr\n";
static const char front[] =
	"[feet front]\nhips = chest\nleft = UL LL FL\nright = UR LR FR\n";
static const char both[] =
	"[feet front]\nhips = hips\nleft = UL LL FL\nright = UR LR FR\n";

static const char *const foot_names[] = {"fl", "fr", "FL", "FR"};

struct fixture {
	struct test_path folder;
	struct acting acting;
	double shift; /* of the hills, metres */
};

static void begin(struct fixture *f)
{
	struct test_path path;

	f->folder = temp_dir_make();
	f->shift = 0;
	path = path_join(&f->folder, "four.gltf");
	file_write(path.text, json, strlen(json));
	acting_begin(&f->acting, path.text);
}

static void end(struct fixture *f)
{
	acting_end(&f->acting);
	temp_dir_remove(&f->folder);
}

/* Reads two sections, one after the other. */
static void read(struct fixture *f, const char *first, const char *second)
{
	char text[512];

	snprintf(text, sizeof(text), "%s%s", first, second);
	acting_read(&f->acting, text);
}

static float hills(void *user, float x, float z)
{
	const struct fixture *f = user;

	return 0.08f * sinf(3.0f * (z + (float)f->shift)) + 0.03f * x;
}

/* Each foot is as high above the hills below it as it is above a plane. */
static void expect_on_hills(const struct fixture *f, float level_m)
{
	for (size_t i = 0; i < ARRAY_COUNT(foot_names); i++) {
		float at[3];

		acting_place(&f->acting, foot_names[i], at);
		assert_near(
			at[1] - hills((void *)f, at[0], at[2]), level_m, 0.002);
	}
}

static void test_all_four_feet_keep_to_the_hills(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	read(&f, hind, front);
	assert_int_equal(f.acting.error, 0);
	f.acting.character->ground_height = hills;
	f.acting.character->ground_user = &f;
	for (int i = 0; i < 40; i++) {
		f.shift = 0.1 * i;
		acting_run_to(&f.acting, 0.5 * (i + 1), 30.0);
		expect_on_hills(&f, 0.02f);
	}
	end(&f);
}

/* While the hind feet fade out, the front feet stay on the ground. */
static void test_a_pair_may_be_switched_off(void **state)
{
	struct fixture f;
	float at[3];

	(void)state;
	begin(&f);
	read(&f, hind,
		"[feet front]\nhips = chest\nleft = UL LL FL\n"
		"right = UR LR FR\n[buttons]\nUP = off hind\n");
	assert_int_equal(f.acting.error, 0);
	f.acting.character->ground_height = hills;
	f.acting.character->ground_user = &f;
	acting_run_to(&f.acting, 0.5, 30.0);
	acting_tap(&f.acting, BUTTON_UP, 0.1, 30.0);
	acting_run_to(&f.acting, 3.0, 30.0);
	acting_place(&f.acting, "hips", at);
	assert_near(at[1], 0.62, 1e-5);
	acting_place(&f.acting, "FL", at);
	assert_near(at[1] - hills(&f, at[0], at[2]), 0.02, 0.002);
	end(&f);
}

/* Hips that moved the feet of an earlier pair would lift them off the ground. */
static void test_hips_may_not_carry_another_pair(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	read(&f, front, hind);
	assert_int_equal(f.acting.error, -EINVAL);
	assert_contains(f.acting.logged.sentence[0],
		"test.character:5: [feet hind]: its hips carry the feet of [feet front], too");
	read(&f, hind, both);
	assert_int_equal(f.acting.error, -EINVAL);
	assert_contains(f.acting.logged.sentence[0],
		"[feet front]: its hips carry the feet of [feet hind], too");
	end(&f);
}

/* One foot is enough. */
static void test_hips_may_not_carry_a_foot_of_another_pair(void **state)
{
	static const char *const mixed[] = {
		"[feet mixed]\nhips = hips\nleft = UL LL FL\nright = ur lr fr\n",
		"[feet mixed]\nhips = hips\nleft = ul ll fl\nright = UR LR FR\n"};
	struct fixture f;

	(void)state;
	begin(&f);
	for (size_t i = 0; i < ARRAY_COUNT(mixed); i++) {
		read(&f, mixed[i], front);
		assert_int_equal(f.acting.error, -EINVAL);
		assert_contains(f.acting.logged.sentence[0],
			"[feet front]: its hips carry the feet of [feet mixed], too");
	}
	end(&f);
}

static void test_a_pair_needs_hips_and_both_legs(void **state)
{
	static const char *const lines[] = {"hips = hips\nleft = ul ll fl\n",
		"hips = hips\nright = ur lr fr\n",
		"left = ul ll fl\nright = ur lr fr\n"};
	struct fixture f;

	(void)state;
	begin(&f);
	for (size_t i = 0; i < ARRAY_COUNT(lines); i++) {
		read(&f, "[feet a]\n", lines[i]);
		assert_int_equal(f.acting.error, -EINVAL);
		assert_contains(f.acting.logged.sentence[0],
			"[feet a]: a line is missing: add hips = NODE, left");
	}
	end(&f);
}

/* A chest and a tail below the hips, and a neck below the chest. */
static const char hips_json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"hips\",\"children\":[1,3,4]},"
	"{\"name\":\"chest\",\"children\":[2]},{\"name\":\"neck\"},"
	"{\"name\":\"tail\"},{\"name\":\"u\",\"children\":[5]},"
	"{\"name\":\"l\",\"children\":[6]},{\"name\":\"f\"}]}";

static void test_the_next_hips_above_carry_a_pair(void **state)
{
	static const char *const names[] = {"hips", "chest", "tail", "neck"};
	static const int carriers[] = {-1, 0, 0, 1};
	const struct character_feet *pair[4];
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "pairs.gltf");
	char text[512] = "";
	struct acting acting;

	(void)state;
	file_write(path.text, hips_json, strlen(hips_json));
	acting_begin(&acting, path.text);
	temp_dir_remove(&folder);
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		size_t used = strlen(text);

		snprintf(text + used, sizeof(text) - used,
			"[feet %s]\nhips = %s\nleft = u l f\nright = u l f\n",
			names[i], names[i]);
	}
	acting_expect(&acting, text);
	pair[0] = acting.character->feet;
	for (int i = 0; i < 4; i++) {
		assert_string_equal(pair[i]->is.name, names[i]);
		assert_int_equal(pair[i]->pair, i);
		assert_ptr_equal(pair[i]->carrier,
			carriers[i] < 0 ? NULL : pair[carriers[i]]);
		if (i < 3) {
			pair[i + 1] = pair[i]->next;
		}
	}
	assert_null(pair[3]->next);
	acting_end(&acting);
}

/* From the upper joint by the lower one to the tip, at rest. */
static void test_legs_are_as_long_as_their_bones(void **state)
{
	const double hind_m = 2 * hypot(0.3, 0.04);
	const double front_m = hypot(0.31, 0.05) + hypot(0.32, 0.05);
	struct fixture f;
	const struct character_feet *feet;

	(void)state;
	begin(&f);
	read(&f, hind, front);
	assert_int_equal(f.acting.error, 0);
	feet = f.acting.character->feet;
	for (int side = 0; side < 2; side++) {
		const struct character_foot *one = &feet->foot[side];

		assert_near(one->length_m, hind_m, 1e-6);
		assert_near(feet->next->foot[side].length_m, front_m, 1e-6);
		assert_near(
			one->planted_m, 0.002 * (double)feet->height_m, 1e-7);
		assert_int_equal(one->sole_count, 1);
	}
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_four_feet_keep_to_the_hills),
		cmocka_unit_test(test_a_pair_may_be_switched_off),
		cmocka_unit_test(test_hips_may_not_carry_another_pair),
		cmocka_unit_test(test_hips_may_not_carry_a_foot_of_another_pair),
		cmocka_unit_test(test_a_pair_needs_hips_and_both_legs),
		cmocka_unit_test(test_the_next_hips_above_carry_a_pair),
		cmocka_unit_test(test_legs_are_as_long_as_their_bones),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
