/* Where a list of keys is alone in a picture, and where a time is shortened. */
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

/* Both times where the longest ones just fit, then one, then none. */
static void test_a_time_is_whole_where_it_just_fits(void **state)
{
	static const struct {
		const char *longest;
		int room; /* beside it, pixels */
		const char *expected;
	} cases[] = {
		{"1.07 / 1.07 s", 0, "0.42 / 1.07 s"},
		{"1.07 / 1.07 s", -1, "0.42 s"},
		{"1.07 s", 0, "0.42 s"},
		{"1.07 s", -1, ""},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		static struct hud hud[2];
		struct hud_group group[2];

		for (int k = 0; k < 2; k++) {
			hud[k] = (struct hud){.font = &font_default};
			hud_begin(&hud[k], 480, 640);
			group[k] = hud_group_begin(&hud[k], HUD_TOP_LEFT, NULL);
			group[k].width = hud_text_width(&hud[k], "walk") +
				hud_em(&hud[k]) * 4 / 8 +
				hud_text_width(&hud[k], cases[i].longest) +
				cases[i].room;
		}
		hud_group_time(&group[0], "walk", 0.42f, 1.07f, hud_color_blue);
		hud_group_bar(&group[1], "walk", cases[i].expected,
			0.42f / 1.07f, hud_color_blue);
		assert_int_equal(hud[0].quad_count, hud[1].quad_count);
		assert_memory_equal(
			hud[0].vertex, hud[1].vertex, sizeof(hud[0].vertex));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_list_is_alone_where_figures_have_no_room),
		cmocka_unit_test(test_a_time_is_whole_where_it_just_fits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
