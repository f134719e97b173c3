/* What lines of turns, springs, breaths and muscles say, as these keep it. */
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Joints below each other at a unit's distance; C is turned about y. */
static void begin(struct acting *acting, int unit)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "chain.gltf");
	char json[768];

	snprintf(json, sizeof(json),
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
		"{\"name\":\"A\",\"children\":[1]},{\"name\":\"B\","
		"\"children\":[2],\"translation\":[0,%d,0]},"
		"{\"name\":\"C\",\"children\":[3],\"translation\":[0,%d,0],"
		"\"rotation\":[0,0.70710678,0,0.70710678]},"
		"{\"name\":\"D\",\"translation\":[0,%d,0]}]}",
		unit, unit, unit);
	file_write(path.text, json, strlen(json));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
}

/* The text's first operation. */
static const void *read(struct acting *acting, const char *text)
{
	acting_expect(acting, text);
	assert_int_equal(acting->character->op_count, 1);
	return acting->character->op[0].what;
}

static void test_a_turn_has_bones_with_axes(void **state)
{
	const struct character_turn *turn;
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	turn = read(&acting, "[turn t]\nbone = A, C\nbone = D\n");
	assert_int_equal(turn->bone_count, 3);
	assert_int_equal(turn->bone[0], 0);
	assert_int_equal(turn->bone[1], 2);
	assert_int_equal(turn->bone[2], 3);
	assert_near(turn->angle_rad, 0.5, 0);
	assert_int_equal(turn->from, CHARACTER_FROM_CLIP);
	for (int i = 0; i < 3; i++) {
		float axis[3] = {i ? 0 : 1, 0, i ? 1 : 0};

		assert_all_near(turn->bone_axis[i], axis, 3, 1e-6);
	}
	turn = read(&acting,
		"[turn t]\nbone = A\naxis = 0 -2 0\nangle = 90\nfrom = rest\n");
	assert_all_near(turn->bone_axis[0], ((float[]){0, -1, 0}), 3, 1e-6);
	assert_near(turn->angle_rad, 1.5707963, 1e-6);
	assert_int_equal(turn->from, CHARACTER_FROM_REST);
	turn = read(&acting, "[turn t]\nbone = A, B, C, D, A, B, C\nbone = D\n");
	assert_int_equal(turn->bone_count, CHARACTER_BONES_MAX);
	acting_end(&acting);
}

/* Usual numbers are in the model's unit, of which the chain may have 300. */
static void test_a_spring_has_bones_gravity_and_bodies(void **state)
{
	const struct character_spring *spring;
	struct acting acting;
	char text[512] = "[spring s]\nbones = D 4\n";

	(void)state;
	begin(&acting, 1);
	spring = read(&acting, "[spring s]\nbones = D 2\n");
	assert_int_equal(spring->spring.count, 2);
	assert_near(spring->spring.gravity[1], -9.81, 1e-5);
	assert_all_near(spring->gravity, spring->spring.gravity, 3, 0);
	assert_int_equal(spring->body_count, 0);
	spring = read(&acting,
		"[spring s]\nbones = D 1\ngravity = 1 2 3\nlimit = 90\n"
		"frequency = 4\ndamping = 0.5\nradius = 0.25\n");
	assert_int_equal(spring->spring.count, 1);
	assert_all_near(spring->gravity, ((float[]){1, 2, 3}), 3, 0);
	assert_near(spring->spring.limit_rad, 1.5707963, 1e-6);
	assert_near(spring->spring.frequency_hz, 4, 0);
	assert_near(spring->spring.damping, 0.5, 0);
	assert_near(spring->spring.radius, 0.25, 0);
	for (int i = 0; i < CHARACTER_BONES_MAX; i++) {
		strcat(text, "body = A B 0.5 1 2 3\n");
	}
	spring = read(&acting, text);
	assert_int_equal(spring->spring.count, 4);
	assert_int_equal(spring->body_count, CHARACTER_BONES_MAX);
	for (int i = 0; i < CHARACTER_BONES_MAX; i++) {
		assert_int_equal(spring->body[i].node_a, 0);
		assert_int_equal(spring->body[i].node_b, 1);
		assert_near(spring->body[i].radius, 0.5, 0);
		assert_all_near(
			spring->body[i].offset_a, ((float[]){1, 2, 3}), 3, 0);
		assert_all_near(
			spring->body[i].offset_b, ((float[]){1, 2, 3}), 3, 0);
	}
	acting_end(&acting);
	begin(&acting, 100);
	spring = read(&acting, "[spring s]\nbones = D 2\n");
	assert_near(spring->gravity[1], -9.81 * 300 / 1.65, 1e-2);
	acting_expect(&acting, "[shake s]\nbone = A\n");
	assert_near(acting.character->shake[0]->swing.preset.unit,
		0.01 * 300 / 1.65, 1e-5);
	acting_end(&acting);
}

/* The first node, too, may breathe and swell. */
static void test_breaths_and_muscles_have_nodes_and_numbers(void **state)
{
	const struct character_breath *breath;
	const struct character_muscle *muscle;
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	breath = read(&acting,
		"[breath b]\nbone = A\nrate = 0.5\nswell = 1 2 3\nlift = 45\n");
	assert_int_equal(breath->breath.chest, 0);
	assert_near(breath->breath.rate_hz, 0.5, 0);
	assert_all_near(breath->breath.swell, ((float[]){1, 2, 3}), 3, 0);
	assert_near(breath->breath.lift_rad, 0.78539816, 1e-6);
	muscle = read(&acting, "[muscle m]\njoint = A\nbone = B\n");
	assert_int_equal(muscle->muscle.joint, 0);
	assert_int_equal(muscle->muscle.node, 1);
	assert_int_equal(muscle->muscle.weight, -1);
	assert_near(muscle->muscle.from_rad, 0.3, 1e-6);
	assert_near(muscle->muscle.to_rad, 1.6, 1e-6);
	assert_all_near(muscle->swell, ((float[]){0, 0, 0}), 3, 0);
	muscle = read(&acting,
		"[muscle m]\njoint = B\nbone = A\nfrom = 90\nto = 180\n"
		"swell = 1 2 3\n");
	assert_int_equal(muscle->muscle.node, 0);
	assert_near(muscle->muscle.from_rad, 1.5707963, 1e-6);
	assert_near(muscle->muscle.to_rad, 3.1415926, 1e-6);
	assert_all_near(muscle->swell, ((float[]){1, 2, 3}), 3, 0);
	acting_end(&acting);
}

static void test_shakes_are_counted_in_the_order_of_the_file(void **state)
{
	const struct character *character;
	struct acting acting;

	(void)state;
	begin(&acting, 1);
	acting_expect(&acting,
		"[shake b]\nbone = B\n[turn t]\nbone = A\n"
		"[shake a]\nbone = A\ndelay = 2\n");
	character = acting.character;
	assert_int_equal(character->shake_count, 2);
	assert_string_equal(character->shake[0]->is.name, "b");
	assert_int_equal(character->shake[0]->swing.node, 1);
	assert_near(character->shake[0]->swing.preset.unit, 0.01, 1e-8);
	assert_int_equal(character->shake[1]->swing.node, 0);
	assert_near(character->shake[1]->delay_s, 2, 0);
	acting_end(&acting);
}

static void test_effects_that_limber_refuses(void **state)
{
	static const char *const cases[][2] = {
		{"[turn t]\n", "add bone = NODE"},
		{"[turn t]\nbone = A, B, C, D, A, B, C, D, A\n",
			"there are at most 8 bones"},
		{"[turn t]\nbone = A,\n", "a word is missing"},
		{"[spring s]\n", "add bones = LAST COUNT"},
		{"[spring s]\nlimit = 4\nbones = D 2\n",
			"add bones = LAST COUNT"},
		{"[spring s]\nbones = D\n", "the number of bones is from 1"},
		{"[spring s]\nbones = D 0\n", "the number of bones is from 1"},
		{"[spring s]\nbones = D 5\n", "the number of bones is from 1"},
		{"[spring s]\nbones = E 2\n", "there is no node named E"},
		{"[breath b]\nrate = 1\n", "add bone = NODE"},
		{"[muscle m]\njoint = A\n", "add joint = NODE and bone"},
		{"[muscle m]\nbone = A\n", "add joint = NODE and bone"},
		{"[shake s]\nspeed = 1\n", "add bone = NODE"},
		{"[shake s]\nbone = A\npresets = p.ini\n",
			"a file is needed that lies beside this one"},
	};
	struct acting acting;
	char text[512] = "[spring s]\nbones = D 4\n";

	(void)state;
	begin(&acting, 1);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		acting_read(&acting, cases[i][0]);
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(acting.logged.sentence[0], cases[i][1]);
	}
	for (int i = 0; i <= CHARACTER_BONES_MAX; i++) {
		strcat(text, "body = A B 0.5\n");
	}
	acting_read(&acting, text);
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(acting.logged.sentence[0], "there are at most 8 bodies");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_turn_has_bones_with_axes),
		cmocka_unit_test(test_a_spring_has_bones_gravity_and_bodies),
		cmocka_unit_test(test_breaths_and_muscles_have_nodes_and_numbers),
		cmocka_unit_test(
			test_shakes_are_counted_in_the_order_of_the_file),
		cmocka_unit_test(test_effects_that_limber_refuses),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
