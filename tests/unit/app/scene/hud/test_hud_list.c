/* Where a list of keys has the picture for itself. */
#include "app/scene/hud/hud_group.h"
#include "tests/support/test.h"

/* Panels of 13 ems with their margins at both sides, and room for figures. */
static void test_a_list_is_alone_where_figures_have_no_room(void **state)
{
	(void)state;
	for (int height = 240; height < 2200; height += 240) {
		struct hud hud = {.font = &font_default};
		int column;

		hud_begin(&hud, 480, height);
		column = 13 * hud_em(&hud) + 2 * (hud_em(&hud) * 6 / 8);
		assert_true(hud_group_list_is_alone(4 * column - 1, height));
		assert_false(hud_group_list_is_alone(4 * column, height));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_list_is_alone_where_figures_have_no_room),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
