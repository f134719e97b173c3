/* Which names labels show, and what they show in place of others. */
#include "app/scene/hud/hud_name.h"
#include "tests/support/test.h"

static void expect(const char *name, const char *shown)
{
	char number[HUD_NAME_BYTES];

	assert_string_equal(hud_name(name, "clip", 3, number), shown);
}

static void test_a_name_that_the_font_has_is_shown(void **state)
{
	(void)state;
	expect("walk", "walk");
	expect("Stra\u00dfe \u00e9t\u00e9", "Stra\u00dfe \u00e9t\u00e9");
	expect("7", "7");
}

static void test_a_number_replaces_a_name_that_the_font_lacks(void **state)
{
	(void)state;
	expect("\u6b69\u304f", "clip 3");
	expect("\u05e9\u05dc\u05d5\u05dd", "clip 3");
	expect("\U0001f600", "clip 3");
	expect("", "clip 3");
	expect("  ", "clip 3");
}

/* Half of the letters tell such names apart, blanks do not. */
static void test_a_name_needs_half_of_its_letters(void **state)
{
	(void)state;
	expect("\U0001f600 ok", "\U0001f600 ok");
	expect("\u6b69\u304f ab", "\u6b69\u304f ab");
	expect("\u6b69\u304f    a", "clip 3");
}

/* Each name of a file may have the same ones, which hide the rest. */
static void test_namespaces_are_left_out(void **state)
{
	(void)state;
	expect("mixamorig:LeftArm", "LeftArm");
	expect("Armature|mixamo.com|Layer0.001", "Layer0.001");
	expect("Rig|walk slowly", "walk slowly");
	expect("a:b:\u00e9t\u00e9", "\u00e9t\u00e9");
	expect("Rig|\u6b69\u304f", "clip 3");
}

static void test_other_colons_and_bars_stay(void **state)
{
	(void)state;
	expect("12:30", "12:30");
	expect("1:", "1:");
	expect("|walk", "|walk");
	expect("two words:more", "two words:more");
	expect("either | or", "either | or");
	expect("note: stop", "note: stop");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_name_that_the_font_has_is_shown),
		cmocka_unit_test(
			test_a_number_replaces_a_name_that_the_font_lacks),
		cmocka_unit_test(test_a_name_needs_half_of_its_letters),
		cmocka_unit_test(test_namespaces_are_left_out),
		cmocka_unit_test(test_other_colons_and_bars_stay),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
