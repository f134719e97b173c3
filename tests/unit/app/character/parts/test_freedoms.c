/* Where the degrees of freedom of a part take it: against turns computed here. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char arm[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"Arm\",\"children\":[1],\"translation\":[0.1,1,0.2]},"
	"{\"name\":\"Hand\",\"translation\":[0.3,0.5,0.7]}]}";

static const char *const names[] = {"heading", "pitch", "bank", "x", "y", "z"};

/* About y, x and z; turns are counterclockwise against the axis. */
static void turn(int which, double degrees, double place[3])
{
	int axis = which == 0 ? 1 : which == 1 ? 0 : 2;
	double a = degrees * acos(-1.0) / 180.0;
	double u = place[(axis + 1) % 3], v = place[(axis + 2) % 3];

	place[(axis + 1) % 3] = u * cos(a) - v * sin(a);
	place[(axis + 2) % 3] = u * sin(a) + v * cos(a);
}

static void expect_hand(struct acting *acting, const double place[3])
{
	float at[3];

	acting_run_to(acting, acting->now_s + 0.1, 50.0);
	acting_place(acting, "Hand", at);
	for (int i = 0; i < 3; i++) {
		assert_near(at[i], place[i], 1e-5);
	}
}

static void begin(struct acting *acting, struct test_path *folder)
{
	struct test_path path;

	*folder = temp_dir_make();
	path = path_join(folder, "arm.gltf");
	file_write(path.text, arm, strlen(arm));
	acting_begin(acting, path.text);
}

static void end(struct acting *acting, const struct test_path *folder)
{
	acting_end(acting);
	temp_dir_remove(folder);
}

/* By the value that the line says, or by that of a parameter. */
static void test_each_freedom_moves_a_part(void **state)
{
	static const double values[] = {-1, 0, 1, 2, 90};
	struct test_path folder;
	struct acting acting;

	(void)state;
	begin(&acting, &folder);
	for (int i = 0; i < 6 * (int)ARRAY_COUNT(values); i++) {
		int which = i % 6;
		double value = values[i / 6], place[3] = {0.3, 0.5, 0.7};
		char text[128];

		if (which < 3) {
			turn(which, value, place);
		} else {
			place[which - 3] += value;
		}
		place[0] += 0.1;
		place[1] += 1;
		place[2] += 0.2;
		snprintf(text, sizeof(text), "[part Arm]\n%s = %g\n",
			names[which], value);
		acting_expect(&acting, text);
		expect_hand(&acting, place);
		snprintf(text, sizeof(text),
			"[parameter p]\nrange = -90 90\nstart = %g\n"
			"[part Arm]\n%s = p\n",
			value, names[which]);
		acting_expect(&acting, text);
		expect_hand(&acting, place);
	}
	end(&acting, &folder);
}

/* Degrees or metres a second, unless the line says it. */
static void test_a_freedom_has_limits_and_a_speed(void **state)
{
	static const struct {
		const char *value;
		double start, low, high;
		double speed; /* 0: 45 degrees or 0.5 m a second */
	} rows[] = {{"1", 1, -1e6, 1e6, 0}, {"1 0.5 2", 1, 0.5, 2, 0},
		{"1 1 1", 1, 1, 1, 0}, {"-1 -2 3 4", -1, -2, 3, 4}};
	struct test_path folder;
	struct acting acting;

	(void)state;
	begin(&acting, &folder);
	for (int i = 0; i < 6 * (int)ARRAY_COUNT(rows); i++) {
		const struct character_freedom *freedom;
		double usual = i % 6 < 3 ? 45 : 0.5, speed = rows[i / 6].speed;
		char text[128];

		snprintf(text, sizeof(text), "[part Arm]\n%s = %s\n",
			names[i % 6], rows[i / 6].value);
		acting_expect(&acting, text);
		freedom = &acting.character->part[0].freedom[i % 6];
		assert_true(freedom->given);
		assert_near(freedom->value, rows[i / 6].start, 0);
		assert_near(freedom->low, rows[i / 6].low, 0);
		assert_near(freedom->high, rows[i / 6].high, 0);
		assert_near(freedom->speed, speed > 0 ? speed : usual, 1e-6);
	}
	end(&acting, &folder);
}

/* The outermost turn comes first, and the shift before or after all of them. */
static void test_turns_have_an_order(void **state)
{
	static const int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
		{1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	static const double angles[] = {20, -35, 70};
	struct test_path folder;
	struct acting acting;

	(void)state;
	begin(&acting, &folder);
	for (int i = 0; i < 2 * (int)ARRAY_COUNT(orders); i++) {
		const int *order = orders[i / 2];
		double place[3] = {0.3, 0.5, 0.7};
		double shift[3] = {0.1 + 0.4, 1 - 0.3, 0.2 + 0.6};
		char text[256];

		for (int k = 2; k >= 0; k--) {
			turn(order[k], angles[order[k]], place);
			if (i % 2) {
				turn(order[k], angles[order[k]], shift);
			}
		}
		for (int k = 0; k < 3; k++) {
			place[k] += shift[k];
		}
		snprintf(text, sizeof(text),
			"[part Arm]\norder = %s %s %s\nfirst = %s\n"
			"heading = 20\npitch = -35\nbank = 70\n"
			"x = 0.4\ny = -0.3\nz = 0.6\n",
			names[order[0]], names[order[1]], names[order[2]],
			i % 2 ? "rotate" : "translate");
		acting_expect(&acting, text);
		expect_hand(&acting, place);
	}
	end(&acting, &folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_freedom_moves_a_part),
		cmocka_unit_test(test_a_freedom_has_limits_and_a_speed),
		cmocka_unit_test(test_turns_have_an_order),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
