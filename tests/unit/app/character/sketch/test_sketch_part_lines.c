/* What a sketch writes about the parts of a model. */
#include "app/character/sketch/sketch_parts.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/character/sketch/made.h"

#include <stdio.h>

static void find(struct scene *scene, const struct made *made, int count,
	bool still, struct sketch_parts *parts)
{
	static const bool no_joint[MOST], named[MOST] = {true, true, true, true};

	make(made, count, scene);
	assert_int_equal(
		sketch_find_parts(&scene->model, no_joint, named, still, parts),
		0);
}

/* The parts of a model that clips move. */
static void expect_lines(const struct made *made, int count, const char *wanted)
{
	struct scene scene;
	struct sketch_parts parts;
	char text[1024] = "";
	FILE *out = fmemopen(text, sizeof(text), "w");

	assert_non_null(out);
	find(&scene, made, count, false, &parts);
	sketch_write_parts(&scene.model, &parts, out);
	assert_int_equal(fclose(out), 0);
	assert_string_equal(text, wanted);
}

#define TITLE                                                 \
	"; Rigid parts turn on their pivots: start, lowest, " \
	"highest, degrees a second.\n"

/* Rods swing across their length, first aside and then forward or up. */
static void test_each_form_has_freedoms_of_its_own(void **state)
{
	static const struct {
		struct made made;
		const char *wanted;
	} rows[] = {
		{{"needle", .low = {-0.05f, 0, 0}, .high = {0.05f, 0.8f, 0}},
			TITLE ";[part needle]\n"
			      ";bank = 0 ; in its plane, without limits\n\n"},
		{{"wheel", .low = {-0.1f, -1, -1}, .high = {0.1f, 1, 1}},
			TITLE ";[part wheel]\n"
			      ";pitch = 0 ; in its plane, without limits\n\n"},
		{{"left door", .low = {-0.02f, -0.5f, -1},
			 .high = {0.02f, 0.5f, 0}},
			TITLE ";[part \"left door\"]\n"
			      ";heading = 0 -110 110 60 ; on its hinge\n\n"},
		{{"head", .low = {-1, -1, -1}, .high = {1, 1, 1}},
			TITLE ";[part head]\n;heading = 0 -90 90 45\n"
			      ";pitch = 0 -45 45 45\n\n"},
		{{"x", .low = {0, -0.1f, -0.1f}, .high = {2, 0.1f, 0.1f}},
			TITLE ";[part x]\n;heading = 0 -90 90 45\n"
			      ";bank = 0 -45 45 45\n\n"},
		{{"y", .low = {-0.1f, 0, -0.1f}, .high = {0.1f, 2, 0.1f}},
			TITLE ";[part y]\n;bank = 0 -90 90 45\n"
			      ";pitch = 0 -45 45 45\n\n"},
		{{"z", .low = {-0.1f, -0.1f, 0}, .high = {0.1f, 0.1f, 2}},
			TITLE ";[part z]\n;heading = 0 -90 90 45\n"
			      ";pitch = 0 -45 45 45\n\n"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct made made = rows[i].made;

		made.parent = -1;
		expect_lines(&made, 1, rows[i].wanted);
	}
	expect_lines(NULL, 0, "");
}

/* Also if it is the only part that users expect to move. */
static void test_buttons_move_a_needle_beside_a_box(void **state)
{
	static const struct made gauge[] = {
		{"box", -1, {-1, -1, -1}, {1, 1, 1}, .form = BOX},
		{"needle", -1, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, .form = BOX},
		{"lid", -1, {-1, -1, -1}, {1, 1, 1}, .form = BOX}};
	struct scene scene;
	struct sketch_parts parts;

	(void)state;
	find(&scene, gauge, ARRAY_COUNT(gauge), true, &parts);
	assert_int_equal(parts.count, 3);
	assert_int_equal(parts.node[0], 1);
	assert_true(parts.moved);
	find(&scene, gauge, ARRAY_COUNT(gauge), false, &parts);
	assert_false(parts.moved);
}

/* The font of labels has no such letters: the part's number says which it is. */
static void test_a_label_numbers_parts_of_unreadable_names(void **state)
{
	static const struct made made[] = {
		{"\xe7\xae\xb1", -1, {-1, -1, -1}, {1, 1, 1}, .form = BOX},
		{"\xe8\x93\x8b", -1, {-1, -1, -1}, {1, 1, 1}, .form = BOX}};
	struct scene scene;
	struct sketch_parts parts;

	(void)state;
	find(&scene, made, ARRAY_COUNT(made), true, &parts);
	for (int i = 0; i < 2; i++) {
		char text[1024] = "", wanted[128];
		FILE *out = fmemopen(text, sizeof(text), "w");

		assert_non_null(out);
		sketch_write_part_buttons(&scene.model, &parts, i, out);
		assert_int_equal(fclose(out), 0);
		snprintf(wanted, sizeof(wanted),
			"[buttons part%d]\nwhen = arrows is part%d\n"
			"UP = move %s pitch -1 \"turn part %d back\"\n",
			i + 1, i + 1, made[i].name, i + 1);
		assert_contains(text, wanted);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_form_has_freedoms_of_its_own),
		cmocka_unit_test(test_buttons_move_a_needle_beside_a_box),
		cmocka_unit_test(test_a_label_numbers_parts_of_unreadable_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
