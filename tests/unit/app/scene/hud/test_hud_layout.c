/*
 * Where each element of a group and of the graph lies: the same as rectangles,
 * texts and panels that a test places itself. Lengths are eighths of an em.
 */
#include "app/scene/hud/hud_graph.h"
#include "tests/support/test.h"

#include <limits.h>
#include <string.h>

static const struct hud_color white_40 = {255, 255, 255, 40};
static const struct hud_color pink = {200, 100, 120, 255};

static struct hud shown, wanted;

static void begin(int width, int height)
{
	struct hud *const both[] = {&shown, &wanted};

	for (int i = 0; i < 2; i++) {
		memset(both[i], 0, sizeof(*both[i]));
		both[i]->font = &font_default;
		hud_begin(both[i], width, height);
	}
}

static int e(int eighths)
{
	int pixels = hud_em(&wanted) * eighths / 8;

	return pixels < 1 ? 1 : pixels;
}

static int line(void)
{
	return hud_line_height(&wanted);
}

/* Quads from `first` on are those that the test has placed, and no more. */
static void expect_wanted(int first)
{
	assert_int_equal(shown.quad_count - first, wanted.quad_count);
	assert_true(wanted.quad_count > 0);
	assert_memory_equal(&shown.vertex[first * 4], wanted.vertex,
		(size_t)wanted.quad_count * 4 * sizeof(wanted.vertex[0]));
}

static void want_right(int right, int y, const char *text)
{
	hud_text(&wanted, right - hud_text_width(&wanted, text), y,
		hud_color_text, text);
}

static void want_key(
	const struct hud_group *group, int y, int cap, const char *key)
{
	hud_panel(&wanted, group->left, y, cap, line(), e(2), white_40);
	hud_text(&wanted, group->left + (cap - hud_text_width(&wanted, key)) / 2,
		y, hud_color_text, key);
}

static const int sizes[][2] = {{480, 640}, {640, 480}, {1280, 720}, {240, 320}};

#define SIZES ((int)ARRAY_COUNT(sizes))

static void begin_size(int i)
{
	begin(sizes[i][0], sizes[i][1]);
}

static void test_a_text_has_its_value_at_the_right(void **state)
{
	(void)state;
	for (int i = 0; i < SIZES; i++) {
		struct hud_group group;
		int first, y;

		begin_size(i);
		group = hud_group_begin(&shown, HUD_TOP_LEFT, NULL);
		first = shown.quad_count;
		y = group.y;
		hud_group_text(&group, "GL", "soft");
		want_right(group.left + group.width, y, "soft");
		hud_text(&wanted, group.left, y, hud_color_dim, "GL");
		expect_wanted(first);
		assert_int_equal(group.y - y, line() + e(2));
	}
}

static void test_a_bar_lies_below_its_text(void **state)
{
	(void)state;
	for (int i = 0; i < SIZES; i++) {
		struct hud_group group;
		int first, y;

		begin_size(i);
		group = hud_group_begin(&shown, HUD_TOP_RIGHT, NULL);
		first = shown.quad_count;
		y = group.y;
		hud_group_bar(&group, "a", "b", 0.4f, pink);
		want_right(group.left + group.width, y, "b");
		hud_text(&wanted, group.left, y, hud_color_dim, "a");
		hud_bar(&wanted, group.left, y + line() + e(1), group.width,
			e(2), 0.4f, pink);
		expect_wanted(first);
		assert_int_equal(group.y - y, line() + e(1) + 3 * e(2));
	}
}

static void test_a_mark_is_a_dot_before_its_text(void **state)
{
	(void)state;
	for (int i = 0; i < SIZES; i++) {
		struct hud_group group;
		int first, y;

		begin_size(i);
		group = hud_group_begin(&shown, HUD_BOTTOM_LEFT, NULL);
		first = shown.quad_count;
		y = group.y;
		hud_group_mark(&group, "on", "1 ms", pink);
		hud_panel(&wanted, group.left, y + (line() - e(4)) / 2, e(4),
			e(4), e(4) / 2, pink);
		want_right(group.left + group.width, y, "1 ms");
		hud_text(&wanted, group.left + e(4) + e(3), y, hud_color_dim,
			"on");
		expect_wanted(first);
		assert_int_equal(group.y - y, line() + e(2));
	}
}

static void test_a_key_has_a_cap(void **state)
{
	(void)state;
	for (int i = 0; i < SIZES; i++) {
		static const char *const keys[] = {"F6", "LEFT RIGHT UP"};

		for (int k = 0; k < 2; k++) {
			struct hud_group group;
			int first, y, cap;

			begin_size(i);
			group = hud_group_begin_wide(
				&shown, HUD_BOTTOM_RIGHT, NULL);
			first = shown.quad_count;
			y = group.y;
			cap = k ? hud_text_width(&wanted, keys[k]) + 2 * e(2)
				: e(20);
			hud_group_key(&group, keys[k], "go");
			want_key(&group, y, cap, keys[k]);
			hud_text(&wanted, group.left + cap + e(4), y,
				hud_color_dim, "go");
			expect_wanted(first);
			assert_int_equal(group.y - y, line() + e(2));
		}
	}
}

static void test_a_switch_has_its_knob_at_one_end(void **state)
{
	static const struct hud_color off = {255, 255, 255, 56};
	static const struct hud_color off_knob = {196, 204, 214, 255};

	(void)state;
	for (int i = 0; i < 2 * SIZES; i++) {
		bool on = i >= SIZES;
		struct hud_group group;
		int first, y, left, top, knob;

		begin_size(i % SIZES);
		group = hud_group_begin(&shown, HUD_TOP_LEFT, NULL);
		first = shown.quad_count;
		y = group.y;
		hud_group_switch(&group, "F8", "it", on, pink);
		want_key(&group, y, e(20), "F8");
		hud_text(&wanted, group.left + e(20) + e(4), y,
			on ? hud_color_text : hud_color_dim, "it");
		left = group.left + group.width - e(12);
		top = y + (line() - e(6)) / 2;
		knob = e(6) - 2 * e(1);
		hud_panel(&wanted, left, top, e(12), e(6), e(6) / 2,
			on ? pink : off);
		hud_panel(&wanted, on ? left + e(12) - e(1) - knob : left + e(1),
			top + e(1), knob, knob, knob / 2,
			on ? hud_color_text : off_knob);
		expect_wanted(first);
		assert_int_equal(group.y - y, line() + e(2));
	}
}

static void test_a_title_has_a_rule_and_all_lies_on_a_panel(void **state)
{
	static const struct hud_color rule = {255, 255, 255, 36};

	(void)state;
	for (int i = 0; i < 4 * SIZES; i++) {
		enum hud_corner corner = (enum hud_corner)(i / SIZES);
		struct hud_group group;
		int y, panel, height, top;

		begin_size(i % SIZES);
		y = e(4);
		group = hud_group_begin(&shown, corner, "Title");
		top = y + line() + shown.scale + 2 * e(2);
		assert_int_equal(group.y, top);
		assert_int_equal(hud_group_space(&group, 30), top);
		assert_int_equal(group.y, top + 30 + e(2));
		hud_group_end(&group);
		/* The gap below the last row gives way to the padding. */
		height = group.y - e(2) + e(4);
		top = corner == HUD_TOP_LEFT || corner == HUD_TOP_RIGHT
			? e(6)
			: shown.height - e(6) - height;
		panel = group.width + 2 * e(5);
		hud_panel(&wanted,
			corner == HUD_TOP_LEFT || corner == HUD_BOTTOM_LEFT
				? e(6)
				: shown.width - e(6) - panel,
			top, panel, height, e(3), hud_color_panel);
		hud_text(&wanted, group.left, top + y, hud_color_text, "Title");
		hud_rectangle(&wanted, group.left, top + y + line() + e(2),
			group.width, shown.scale, rule);
		expect_wanted(0);
		assert_int_equal(shown.stacked_px[corner], height + e(6));
	}
}

/* Three eighths of the picture, from 11 to 13 ems, within the margins. */
static void test_a_groups_width_follows_the_pictures(void **state)
{
	(void)state;
	for (int width = 20; width < 1400; width += 7) {
		struct hud_group group;
		int panel, all;

		begin(width, 480);
		group = hud_group_begin(&shown, HUD_TOP_LEFT, NULL);
		panel = group.width + 2 * e(5);
		all = width - 2 * e(6);
		if (all < e(88)) {
			assert_int_equal(panel, all);
		} else if (width * 3 / 8 < e(88)) {
			assert_int_equal(panel, e(88));
		} else if (width * 3 / 8 > e(104)) {
			assert_int_equal(panel, e(104));
		} else {
			assert_int_equal(panel, width * 3 / 8);
		}
		assert_int_equal(hud_group_extent_of(width, 480, 0, 0).column,
			panel + 2 * e(6));
		group = hud_group_begin_wide(&shown, HUD_TOP_LEFT, NULL);
		assert_int_equal(group.width + 2 * e(5),
			2 * panel < all ? 2 * panel : all);
	}
}

static void test_the_extent_is_that_of_a_group(void **state)
{
	(void)state;
	for (int i = 0; i < SIZES; i++) {
		const int *size = sizes[i];
		struct hud_group_extent extent =
			hud_group_extent_of(size[0], size[1], 3, 2);
		struct hud_group group;

		begin_size(i);
		group = hud_group_begin(&shown, HUD_TOP_LEFT, "Title");
		hud_group_text(&group, "a", "b");
		hud_group_bar(&group, "a", "b", 0.5f, pink);
		hud_group_bar(&group, "a", "b", 0.5f, pink);
		hud_group_end(&group);
		assert_int_equal(extent.line, line());
		/* A margin on both sides; a group rounds each length. */
		assert_in_range(extent.top -
				(shown.stacked_px[HUD_TOP_LEFT] + e(6)) + 16,
			16 - 1 - e(2) / 2, 16 + 10);
		assert_int_equal(hud_group_extent_of(size[0], size[1], 4, 2).top -
				extent.top,
			line() + hud_em(&shown) * 2 / 8);
		assert_int_equal(hud_group_extent_of(size[0], size[1], 3, 4).top -
				extent.top,
			2 * (hud_em(&shown) * 5 / 8));
	}
}

static void test_rows_end_at_the_limit(void **state)
{
	struct hud_group group;
	int row;

	(void)state;
	begin(480, 640);
	row = line() + e(1 + 2 + 4);
	group = hud_group_begin(&shown, HUD_TOP_LEFT, NULL);
	hud_group_limit(&group, group.y + 3 * row + 20 + 2 * e(6));
	assert_true(hud_group_fits(&group, 3, 20));
	assert_false(hud_group_fits(&group, 3, 21));
	assert_false(hud_group_fits(&group, 4, 0));
	/* A limit never makes a group larger. */
	hud_group_limit(&group, 640);
	assert_false(hud_group_fits(&group, 3, 21));
	group.room = INT_MAX;
	group.rows_left = 2;
	assert_true(hud_group_fits(&group, 2, 0));
	assert_false(hud_group_fits(&group, 3, 0));
	/* A row that is left out draws nothing. */
	hud_group_text(&group, "a", "b");
	hud_group_text(&group, "a", "b");
	row = shown.quad_count;
	hud_group_text(&group, "a", "b");
	hud_group_bar(&group, "a", "b", 1.0f, pink);
	hud_group_mark(&group, "a", "b", pink);
	assert_int_equal(shown.quad_count, row);
}

static void test_narrow_pictures_have_few_rows(void **state)
{
	int column = hud_group_extent_of(480, 640, 0, 0).column;

	(void)state;
	for (int width = 2 * column - 40; width < 2 * column + 40; width++) {
		int both = 2 * hud_group_extent_of(width, 640, 0, 0).column;

		assert_int_equal(hud_group_rows_max(width, 640),
			width < both ? HUD_GROUP_ROWS_NARROW : INT_MAX);
	}
	assert_int_equal(hud_group_rows_max(100, 640), HUD_GROUP_ROWS_NARROW);
	assert_int_equal(hud_group_rows_max(1000, 640), INT_MAX);
}

static void test_groups_overlap_where_they_are_higher_than_the_picture(
	void **state)
{
	(void)state;
	for (int side = 0; side < 2; side++) {
		int *upper, *lower;

		begin(480, 640);
		upper = &shown.stacked_px[side ? HUD_TOP_RIGHT : HUD_TOP_LEFT];
		lower = &shown.stacked_px[side ? HUD_BOTTOM_RIGHT
					       : HUD_BOTTOM_LEFT];
		*upper = 300;
		*lower = 340;
		assert_false(hud_groups_overlap(&shown));
		*lower = 341;
		assert_true(hud_groups_overlap(&shown));
		*upper = 299;
		assert_false(hud_groups_overlap(&shown));
	}
}

static void test_going_back_takes_away_what_was_added(void **state)
{
	struct hud_mark mark;
	struct hud_group group;

	(void)state;
	begin(480, 640);
	group = hud_group_begin(&shown, HUD_TOP_LEFT, "one");
	hud_group_end(&group);
	memcpy(&wanted, &shown, sizeof(shown));
	mark = hud_mark(&shown);
	for (int corner = 0; corner < HUD_CORNERS; corner++) {
		group = hud_group_begin(&shown, (enum hud_corner)corner, "two");
		hud_group_end(&group);
	}
	assert_true(shown.quad_count > wanted.quad_count);
	hud_go_back(&shown, &mark);
	expect_wanted(0);
	assert_memory_equal(
		shown.stacked_px, wanted.stacked_px, sizeof(shown.stacked_px));
}

/* A frame of 10 + 20 + 5 ms, of 16 ms, and none before, on 40 ms. */
static void want_bars(const struct hud_group *group)
{
	static const int ends[2][3] = {{10, 30, 35}, {4, 12, 16}};
	static const struct hud_color *const colors[3] = {
		&hud_color_blue, &hud_color_green, &hud_color_amber};
	int height = 3 * hud_em(&wanted), bottom = group->y + height;

	hud_rectangle(&wanted, group->left, group->y, group->width, height,
		(struct hud_color){255, 255, 255, 22});
	for (int i = 0; i < 2; i++) {
		int x = group->left + group->width * (46 + i) / 48;
		int end = group->left + group->width * (47 + i) / 48;
		int from = 0;

		for (int stage = 0; stage < 3; stage++) {
			int to = (2 * ends[i][stage] * height + 40) / 80;

			hud_rectangle(&wanted, x, bottom - to,
				end - x - (end - x > 2), to - from,
				*colors[stage]);
			from = to;
		}
	}
	for (int i = 0; i < 2; i++) {
		int up = (int)(1000.0f / (i ? 30.0f : 60.0f) * (float)height /
				40.0f +
			0.5f);

		hud_rectangle(&wanted, group->left, bottom - up, group->width,
			wanted.scale, (struct hud_color){255, 255, 255, 110});
	}
}

static void want_graph(struct hud_group *group)
{
	hud_group_text(group, "0 to 40 ms", "50 fps");
	want_bars(group);
	hud_group_space(group, 3 * hud_em(&wanted));
	hud_group_mark(group, "animate", "10.0 ms", hud_color_blue);
	hud_group_mark(group, "draw", "20.0 ms", hud_color_green);
	hud_group_mark(group, "present", "5.0 ms", hud_color_amber);
	hud_group_mark(group, "left out", "shadow", hud_color_rose);
	hud_group_text(group, "GL driver", "soft");
	hud_group_text(group, "triangles", "4711");
	hud_group_text(group, "memory", "1.5 MiB");
	hud_group_text(group, "Skeletal", "");
}

/* Figures take the whole picture. */
static const struct hud_place nowhere = {HUD_BOTTOM_LEFT, 0};

static void test_the_graph_shows_each_stage_of_each_frame(void **state)
{
	static const float stage_ms[2][3] = {{10, 20, 5}, {4, 8, 4}};
	const struct hud_facts facts = {.technique = "Skeletal",
		.driver = "soft",
		.triangles = 4711,
		.memory_bytes = 3 << 19,
		.reduction = "shadow"};

	(void)state;
	for (int i = 0; i < SIZES - 1; i++) {
		struct hud_graph graph = {.next = 0};
		struct hud_group group;

		begin_size(i);
		for (int frame = 0; frame < 2; frame++) {
			hud_graph_add(&graph, stage_ms[frame], 20.0f);
		}
		hud_graph_show(&graph, &facts, &nowhere, &shown);
		group = hud_group_begin(&wanted, HUD_BOTTOM_LEFT, NULL);
		want_graph(&group);
		hud_group_end(&group);
		expect_wanted(0);
	}
}

static void test_the_graph_leaves_out_what_is_unknown(void **state)
{
	const struct hud_facts facts = {
		.technique = "Morphing", .driver = "soft", .triangles = 0};
	const struct hud_graph graph = {.next = 0};
	struct hud_group group;

	(void)state;
	begin(640, 480);
	hud_graph_show(&graph, &facts, &nowhere, &shown);
	group = hud_group_begin(&wanted, HUD_BOTTOM_LEFT, NULL);
	hud_group_text(&group, "0 to 5 ms", "0 fps");
	hud_rectangle(&wanted, group.left, group.y, group.width,
		3 * hud_em(&wanted), (struct hud_color){255, 255, 255, 22});
	hud_group_space(&group, 3 * hud_em(&wanted));
	hud_group_mark(&group, "animate", "0.0 ms", hud_color_blue);
	hud_group_mark(&group, "draw", "0.0 ms", hud_color_green);
	hud_group_mark(&group, "present", "0.0 ms", hud_color_amber);
	hud_group_text(&group, "GL driver", "soft");
	hud_group_text(&group, "triangles", "0");
	hud_group_text(&group, "Morphing", "");
	hud_group_end(&group);
	expect_wanted(0);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_text_has_its_value_at_the_right),
		cmocka_unit_test(test_a_bar_lies_below_its_text),
		cmocka_unit_test(test_a_mark_is_a_dot_before_its_text),
		cmocka_unit_test(test_a_key_has_a_cap),
		cmocka_unit_test(test_a_switch_has_its_knob_at_one_end),
		cmocka_unit_test(test_a_title_has_a_rule_and_all_lies_on_a_panel),
		cmocka_unit_test(test_a_groups_width_follows_the_pictures),
		cmocka_unit_test(test_the_extent_is_that_of_a_group),
		cmocka_unit_test(test_rows_end_at_the_limit),
		cmocka_unit_test(test_narrow_pictures_have_few_rows),
		cmocka_unit_test(
			test_groups_overlap_where_they_are_higher_than_the_picture),
		cmocka_unit_test(test_going_back_takes_away_what_was_added),
		cmocka_unit_test(test_the_graph_shows_each_stage_of_each_frame),
		cmocka_unit_test(test_the_graph_leaves_out_what_is_unknown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
