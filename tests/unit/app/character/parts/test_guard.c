/* How deep the guards of parts are in the ground and in those of other parts. */
#include "app/character/character_data.h"
#include "app/character/parts/guard.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

/* Three joints of an arm, 0.1 m apart along x, and a box 0.1 m above the hand. */
static const char arm[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,3]}],\"nodes\":["
	"{\"name\":\"Arm\",\"children\":[1],\"translation\":[0,1,0]},"
	"{\"name\":\"Hand\",\"children\":[2],\"translation\":[0.1,0,0]},"
	"{\"name\":\"Finger\",\"translation\":[0.1,0,0]},"
	"{\"name\":\"Box\",\"translation\":[0.1,1.1,0]}]}";

struct bench {
	struct test_path folder;
	struct acting acting;
};

static void begin(struct bench *bench)
{
	struct test_path path;

	bench->folder = temp_dir_make();
	path = path_join(&bench->folder, "arm.gltf");
	file_write(path.text, arm, strlen(arm));
	acting_begin(&bench->acting, path.text);
}

static void end(struct bench *bench)
{
	acting_end(&bench->acting);
	temp_dir_remove(&bench->folder);
}

/* The depth after UP was pressed, if it does something. */
static double depth_of(struct bench *bench, const char *text)
{
	struct acting *acting = &bench->acting;

	acting_expect(acting, text);
	acting_run_to(acting, acting->now_s + 0.1, rate_hz);
	acting_tap(acting, BUTTON_UP, 0.1, rate_hz);
	return (double)character_guard_depth(acting->character);
}

static void test_guards_keep_off_the_ground(void **state)
{
	static const struct {
		const char *guard;
		double depth;
	} rows[] = {{"1.1", 0}, {"1.2", 0.1}, {"0.05 0 -1.08 0", 0.03},
		{"0.05 0 -1.08 0 0.3 0 0", 0.03},
		{"0.05 0.3 0 0 0 -1.08 0", 0.03}, {"0.05 0 -1 0", 0},
		{"0.05 0 -1.08 0\nguard = 1.2\nguard = 0.1", 0.13}};
	struct bench bench;
	char text[128];

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		snprintf(text, sizeof(text), "[part Box]\nguard = %s\n",
			rows[i].guard);
		assert_near(depth_of(&bench, text), rows[i].depth, 1e-6);
	}
	bench.acting.character->ground_m = 0.02f;
	assert_near(character_guard_depth(bench.acting.character), 0.17, 1e-6);
	end(&bench);
}

/* Of each pair of guards counts how deep they are in each other. */
static void test_guards_of_parts_keep_off_each_other(void **state)
{
	static const struct {
		const char *text;
		double depth;
	} rows[] = {
		{"[part Box]\nguard = 0.05\n[part Hand]\nguard = 0.06\n", 0.01},
		{"[part Hand]\nguard = 0.05\n[part Box]\nguard = 0.06\n", 0.01},
		{"[part Box]\nguard = 0.04\n[part Hand]\nguard = 0.05\n", 0},
		{"[part Box]\nguard = 0.05\nguard = 0.07\n"
		 "[part Hand]\nguard = 0.06\nguard = 0.08\n",
			0.01 + 0.03 + 0.03 + 0.05},
		{"[part Box]\nguard = 0.03 0 -0.05 0\n[part Hand]\nguard = 0.04\n",
			0.02},
		{"[part Arm]\nguard = 0.15\n[part Finger]\nguard = 0.15\n", 0.1},
		{"[part Arm]\nguard = 0.15\n[part Hand]\nguard = 0.15\n", 0},
		{"[part Hand]\nguard = 0.15\n[part Arm]\nguard = 0.15\n", 0},
		/* A pivot alone may be inside. */
		{"[part Arm]\nguard = 0.3\n"
		 "[part Finger]\nguard = 0.05 0 0.5 0 0 0.6 0\n",
			0},
		{"[part Finger]\nguard = 0.05 0 0.5 0 0 0.6 0\n"
		 "[part Arm]\nguard = 0.3\n",
			0},
	};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_near(depth_of(&bench, rows[i].text), rows[i].depth, 1e-6);
	}
	end(&bench);
}

/* Beside a box of 0.08 all but Arm and Finger, 0.2 apart, are too near. */
static void test_a_part_may_touch_its_holder_and_the_holders_children(
	void **state)
{
	static const double above = 0.16 - 0.1, beside = 0.16 - 0.141421356;
	static const struct {
		const char *action;
		double depth;
	} rows[] = {{"detach Box", above + 2 * beside},
		{"attach Box Hand", beside},
		{"attach Box Finger", above + beside},
		{"attach Box Arm", beside}};
	static const char box[] = "[part Box]\nguard = 0.08\n";
	struct bench bench;
	char text[256];

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		snprintf(text, sizeof(text),
			"%s[part Arm]\nguard = 0.08\n[part Hand]\nguard = 0.08\n"
			"[part Finger]\nguard = 0.08\n%s[buttons]\nUP = %s\n",
			i % 2 ? box : "", i % 2 ? "" : box, rows[i / 2].action);
		assert_near(depth_of(&bench, text), rows[i / 2].depth, 1e-6);
	}
	end(&bench);
}

/* How far the hand is above its place at rest, in centimetres. */
static double height_of(const struct bench *bench)
{
	float at[3];

	acting_place(&bench->acting, "Hand", at);
	return 100.0 * ((double)at[1] - 1.0);
}

/*
 * The box is held 5 cm above the ground, or 10 cm in it. Each press moves a
 * freedom by up to 50 cm, 1 cm a frame.
 */
static void test_a_part_does_not_push_what_it_holds_into_the_ground(void **state)
{
	static const char text[] =
		"[part Arm]\ny = 0 -1 1 0.5\n[part Hand]\ny = 0 -1 1 0.5\n"
		"[part Box]\nguard = %s\n[buttons]\nUP = attach Box Hand\n"
		"DOWN hold = move Arm y -1, move Hand y -1\n"
		"LEFT hold = move Arm y 1\nRIGHT hold = move Arm y -1\n";
	static const struct {
		const char *guard;
		double down, up, down_again;
	} rows[] = {{"1.05", -5, -2, -5}, {"1.2", 0, 3, 3}};
	struct bench bench;
	char file[512];

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		snprintf(file, sizeof(file), text, rows[i].guard);
		acting_expect(&bench.acting, file);
		acting_run_to(&bench.acting, bench.acting.now_s + 0.1, rate_hz);
		acting_tap(&bench.acting, BUTTON_UP, 0.1, rate_hz);
		acting_tap(&bench.acting, BUTTON_DOWN, 1, rate_hz);
		assert_near(height_of(&bench), rows[i].down, 0.01);
		acting_tap(&bench.acting, BUTTON_LEFT, 2.5 / rate_hz, rate_hz);
		assert_near(height_of(&bench), rows[i].up, 0.01);
		acting_tap(&bench.acting, BUTTON_RIGHT, 1, rate_hz);
		assert_near(height_of(&bench), rows[i].down_again, 0.01);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_guards_keep_off_the_ground),
		cmocka_unit_test(test_guards_of_parts_keep_off_each_other),
		cmocka_unit_test(
			test_a_part_may_touch_its_holder_and_the_holders_children),
		cmocka_unit_test(
			test_a_part_does_not_push_what_it_holds_into_the_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
