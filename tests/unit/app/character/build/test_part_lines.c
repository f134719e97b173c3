/* What the lines of [part] and [sequence] say, as these keep it. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* A part below a node with a scale, and a node above it at this height. */
static void begin(struct acting *acting, const char *scale, double height)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "part.gltf");
	char json[512];

	snprintf(json, sizeof(json),
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,2]}],\"nodes\":["
		"{\"name\":\"Base\",\"children\":[1],\"scale\":[%s]},"
		"{\"name\":\"Arm\",\"scale\":[1,2,4]},"
		"{\"name\":\"Top\",\"translation\":[0,%g,0]}]}",
		scale, height);
	file_write(path.text, json, strlen(json));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
}

static const struct character_part *read(
	struct acting *acting, const char *lines)
{
	char text[512];

	snprintf(text, sizeof(text),
		"[parameter p]\nstart = 0.5\n[part Arm]\n%s\n", lines);
	acting_expect(acting, text);
	return &acting->character->part[0];
}

static void refuse(struct acting *acting, const char *lines, const char *why)
{
	char text[512];

	snprintf(text, sizeof(text), "[parameter p]\n[part Arm]\n%s\n", lines);
	acting_read(acting, text);
	if (acting->error != -EINVAL) {
		fail_msg("accepted: %s", lines);
	}
	assert_contains(acting->logged.sentence[0], why);
}

/* A metre of a skeleton of 165 units is 100 units long. */
static void test_a_freedom_has_a_start_limits_and_a_speed(void **state)
{
	static const struct {
		const char *line;
		int which;
		float start, low, high, speed;
	} cases[] = {{"heading = 5", CHARACTER_HEADING, 5, -1e6f, 1e6f, 45},
		{"pitch = 5 -6 7", CHARACTER_PITCH, 5, -6, 7, 45},
		{"bank = 5 5 5 9", CHARACTER_BANK, 5, 5, 5, 9},
		{"x = -1", CHARACTER_X, -1, -1e6f, 1e6f, 50},
		{"y = 2 2 3", CHARACTER_Y, 2, 2, 3, 50},
		{"z = 3 2 3 0.25", CHARACTER_Z, 3, 2, 3, 0.25f}};
	struct acting acting;

	(void)state;
	begin(&acting, "1,1,1", 165);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_part *part = read(&acting, cases[i].line);

		for (int k = 0; k < CHARACTER_FREEDOMS; k++) {
			const struct character_freedom *one = &part->freedom[k];

			assert_int_equal(one->given, k == cases[i].which);
			assert_null(part->follows[k]);
			if (one->given) {
				assert_near(one->start, cases[i].start, 0);
				assert_near(one->value, cases[i].start, 0);
				assert_near(one->low, cases[i].low, 0);
				assert_near(one->high, cases[i].high, 0);
				assert_near(one->speed, cases[i].speed, 1e-4);
			}
		}
	}
	refuse(&acting, "x = 1 1.5 2", "the start has to lie between");
	refuse(&acting, "x = 3 1.5 2", "the start has to lie between");
	refuse(&acting, "x = 1 0", "the highest value is missing");
	acting_end(&acting);
}

static void test_an_order_has_each_angle_once(void **state)
{
	static const struct {
		const char *line;
		int order[3];
	} cases[] = {{"", {0, 1, 2}}, {"order = heading bank pitch", {0, 2, 1}},
		{"order = pitch heading bank", {1, 0, 2}},
		{"order = bank pitch heading", {2, 1, 0}}};
	static const char *const wrong[] = {"heading pitch",
		"heading pitch pitch", "heading heading pitch",
		"heading pitch x", "y heading pitch", "heading z pitch"};
	struct acting acting;
	char line[64];

	(void)state;
	begin(&acting, "1,1,1", 1.65);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_part *part = read(&acting, cases[i].line);

		assert_memory_equal(
			part->order, cases[i].order, sizeof(part->order));
		assert_false(part->rotates_first);
	}
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		snprintf(line, sizeof(line), "order = %s", wrong[i]);
		refuse(&acting, line, "give each of heading pitch bank once");
	}
	assert_true(read(&acting, "first = rotate")->rotates_first);
	acting_end(&acting);
}

/* Scales of 1, 2 and 4 of the part, and of those above. */
static void test_places_have_the_units_of_the_part(void **state)
{
	const struct character_part *part;
	struct acting acting;

	(void)state;
	begin(&acting, "2,0.25,1", 1.65);
	part = read(&acting,
		"guard = 0.1 1 2 3 4 5 6\nguard = 0.2 8 8 8\nguard = 0.3\n"
		"top = 1 2 3 4 5");
	assert_all_near(part->metre, ((float[]){0.5f, 4, 1}), 3, 1e-6);
	assert_int_equal(part->guard_count, 3);
	assert_false(part->has_radius);
	assert_near(part->guard[0].radius_m, 0.1, 1e-6);
	assert_all_near(
		part->guard[0].from, ((float[]){0.5f, 4, 0.75f}), 3, 1e-6);
	assert_all_near(part->guard[0].to, ((float[]){2, 10, 1.5f}), 3, 1e-6);
	assert_all_near(part->guard[1].from, ((float[]){0, 0, 0}), 3, 0);
	assert_all_near(part->guard[1].to, ((float[]){4, 16, 2}), 3, 1e-6);
	assert_near(part->guard[2].radius_m, 0.3, 1e-6);
	assert_int_equal(part->top_count, 1);
	assert_all_near(
		part->top[0], ((float[]){2, 1, 0.75f, 2, 1.25f}), 5, 1e-6);
	acting_end(&acting);
	/* A scale of 0 leaves metres as they are. */
	begin(&acting, "0,1,2", 1.65);
	part = read(&acting, "guard = 0.1 1 2 3");
	assert_all_near(part->metre, ((float[]){1, 1, 0.5f}), 3, 1e-6);
	assert_all_near(part->guard[0].to, ((float[]){1, 1, 0.375f}), 3, 1e-6);
	acting_end(&acting);
}

/* Radius and tip are the first, wherever they stand. */
static void test_a_part_has_up_to_four_capsules(void **state)
{
	const struct character_part *part;
	struct acting acting;

	(void)state;
	begin(&acting, "1,1,1", 1.65);
	part = read(&acting,
		"guard = 1\nguard = 2\nradius = 3\nguard = 4\ntip = 4 4 4");
	assert_int_equal(part->guard_count, 4);
	assert_true(part->has_radius);
	for (int i = 0; i < 4; i++) {
		static const float radii[] = {3, 1, 2, 4};

		assert_near(part->guard[i].radius_m, radii[i], 0);
	}
	assert_all_near(part->guard[0].to, ((float[]){4, 2, 1}), 3, 1e-6);
	assert_all_near(part->guard[1].to, ((float[]){0, 0, 0}), 3, 0);
	part = read(&acting, "guard = 1 1 1 1\ntip = 4 4 4");
	assert_near(part->guard[0].radius_m, 0, 0);
	assert_int_equal(part->guard_count, 2);
	assert_int_equal(
		read(&acting, "guard = 1\nguard = 2\nguard = 3\nguard = 4")
			->guard_count,
		4);
	refuse(&acting, "guard = 1\nguard = 2\nguard = 3\nguard = 4\nguard = 5",
		"a part has at most 4 capsules");
	refuse(&acting, "guard = 1\nguard = 2\nguard = 3\nguard = 4\nradius = 5",
		"a part has at most 4 capsules");
	refuse(&acting,
		"guard = 1\nguard = 2\nguard = 3\nguard = 4\ntip = 1 1 1",
		"a part has at most 4 capsules");
	acting_end(&acting);
}

static void test_the_second_corner_of_a_top_is_larger(void **state)
{
	static const char *const wrong[] = {"1 0 0 0 1", "1 0 0 1 0",
		"1 0.1 0 0 1", "1 0 0.5 1 0.25", "1 0.5 0 0.75 -0.5"};
	struct acting acting;
	char line[64];

	(void)state;
	begin(&acting, "1,1,1", 1.65);
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		snprintf(line, sizeof(line), "top = %s", wrong[i]);
		refuse(&acting, line,
			"the second corner has the larger x and z");
	}
	refuse(&acting, "top = 1 0 0 1", "a word is missing");
	assert_int_equal(read(&acting,
				 "top = 1 0 0 1 1\ntop = 2 0 0 1 1\n"
				 "top = 3 0 0 1 1\ntop = -4 -1 -2 -0.5 -1")
				 ->top_count,
		4);
	acting_end(&acting);
}

static void test_steps_of_a_sequence_have_goals(void **state)
{
	const struct character_sequence *sequence;
	const struct character_step *step;
	const struct character_part *part;
	struct acting acting;

	(void)state;
	begin(&acting, "1,1,1", 1.65);
	part = read(&acting,
		"pitch = 0 -20 20\n[sequence s]\n"
		"step = a 0.01, Arm pitch -20, Arm z 7\n"
		"step = b 3600, Arm pitch 20\nthen = pause\nstart = yes\n"
		"[sequence t]\nstep = c 1\nrepeat = yes");
	sequence = acting.character->sequence;
	assert_string_equal(sequence[0].name, "s");
	assert_string_equal(sequence[1].name, "t");
	step = sequence[0].step;
	assert_string_equal(step->name, "a");
	assert_near(step->duration_s, 0.01, 1e-9);
	assert_int_equal(step->goal->freedom, CHARACTER_PITCH);
	assert_near(step->goal->value, -20, 0);
	assert_int_equal(step->goal->next->freedom, CHARACTER_Z);
	assert_near(step->goal->next->value, 7, 0);
	assert_null(step->goal->next->next);
	assert_null(step->then);
	assert_near(step->next->duration_s, 3600, 0);
	assert_int_equal(step->next->then->verb, CHARACTER_PAUSE);
	assert_null(step->next->next);
	/* A goal gives the part its freedom. */
	assert_true(part->freedom[CHARACTER_Z].given);
	assert_near(part->freedom[CHARACTER_Z].high, 1e6, 0);
	assert_near(part->freedom[CHARACTER_PITCH].high, 20, 0);
	assert_ptr_equal(sequence[0].now, step);
	assert_false(sequence[0].repeats);
	assert_null(sequence[1].now);
	assert_true(sequence[1].repeat);
	acting_end(&acting);
}

static void test_steps_that_limber_refuses(void **state)
{
	static const char *const cases[][2] = {
		{"step = a 0.0099", "a step begins with its name"},
		{"step = a 3601", "a step begins with its name"},
		{"step = a -1", "a step begins with its name"},
		{"step = a", "a step begins with its name"},
		{"step = , 1", "a step begins with its name"},
		{"step = a 1, Arm up 5", "give PART FREEDOM VALUE"},
		{"step = a 1, Arm", "give PART FREEDOM VALUE"},
		{"step = a 1, Arm x", "give PART FREEDOM VALUE"},
		{"step = a 1, Leg x 1", "there is no part named Leg"},
		{"step = a 1, Arm pitch 21",
			"21 is outside of the part's limits -20 to 20"},
		{"step = a 1, Arm pitch -21",
			"-21 is outside of the part's limits -20 to 20"},
		{"then = pause", "there is no step before it"},
	};
	struct acting acting;

	(void)state;
	begin(&acting, "1,1,1", 1.65);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char lines[128];

		snprintf(lines, sizeof(lines),
			"pitch = 0 -20 20\n[sequence s]\n%s", cases[i][0]);
		refuse(&acting, lines, cases[i][1]);
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_freedom_has_a_start_limits_and_a_speed),
		cmocka_unit_test(test_an_order_has_each_angle_once),
		cmocka_unit_test(test_places_have_the_units_of_the_part),
		cmocka_unit_test(test_a_part_has_up_to_four_capsules),
		cmocka_unit_test(test_the_second_corner_of_a_top_is_larger),
		cmocka_unit_test(test_steps_of_a_sequence_have_goals),
		cmocka_unit_test(test_steps_that_limber_refuses),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
