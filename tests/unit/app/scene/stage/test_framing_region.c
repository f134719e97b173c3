/* The part of a picture that labels and keys leave to the figure. */
#include "app/scene/hud/hud_graph.h"
#include "app/scene/stage/framing.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

/* Upright, level, and very large pictures. */
static const int sizes[][2] = {{480, 640}, {640, 480}, {800, 600}, {1280, 720}};

static const struct bounds tall = {{-0.2f, 0.0f, -0.2f}, {0.2f, 4.0f, 0.2f}};
static const struct bounds wide = {{-4.0f, 0.0f, -0.2f}, {4.0f, 0.3f, 0.2f}};

static struct framing framing_of(int rows, int bars)
{
	return (struct framing){
		.camera = {.margin = 1.1f, .follow = true},
		.label_rows = rows,
		.label_bars = bars,
	};
}

static void expect_region(const struct framing *framing,
	const struct bounds *bounds, const int size[2], float left, float right,
	float bottom, float top)
{
	struct camera_region region =
		framing_region(framing, bounds, size[0], size[1]);

	assert_near(region.left, left, 1e-5);
	assert_near(region.right, right, 1e-5);
	assert_near(region.bottom, bottom, 1e-5);
	assert_near(region.top, top, 1e-5);
}

/* From pixels of the picture's side to -1..1. */
static float at(int pixels, int side)
{
	return 2.0f * (float)pixels / (float)side - 1.0f;
}

static void test_without_labels_the_whole_picture_is_free(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		struct hud_group_extent extent =
			hud_group_extent_of(sizes[i][0], sizes[i][1], 0, 0);
		struct framing framing = framing_of(0, 0);

		expect_region(&framing, &tall, sizes[i], -1, 1, -1, 1);
		framing.lines_below = 2;
		expect_region(&framing, &tall, sizes[i], -1, 1,
			at(2 * extent.line, sizes[i][1]), 1);
		/* More lines than leave a fifth of the picture. */
		framing.lines_below = 9 * sizes[i][1] / extent.line / 10;
		expect_region(&framing, &tall, sizes[i], -1, 1, -1, 1);
	}
}

/* The last picture is so small that it has no room for the stages' times. */
static void test_without_labels_figures_leave_frame_times_their_room(
	void **state)
{
	static const int narrow[][3] = {
		{480, 640, HUD_STAGES}, {240, 320, HUD_STAGES}, {128, 160, 0}};
	static const int level[] = {320, 240};
	struct framing framing = framing_of(0, 0);

	(void)state;
	framing.frame_times = true;
	for (size_t i = 0; i < ARRAY_COUNT(narrow); i++) {
		int room = hud_graph_room(
			narrow[i][0], narrow[i][1], narrow[i][2]);

		expect_region(&framing, &wide, narrow[i], -1, 1,
			at(room, narrow[i][1]), 1);
	}
	expect_region(&framing, &tall, level,
		at(hud_group_extent_of(level[0], level[1], 0, 0).column,
			level[0]),
		1, -1, 1);
}

/* Beside the labels, or else between them and some of the graph below. */
static void test_labels_and_frame_times_share_small_pictures_with_figures(
	void **state)
{
	static const int small[][2] = {
		{240, 320}, {128, 160}, {320, 240}, {800, 480}, {1280, 720}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(small); i++) {
		const int *size = small[i / 2];
		const struct bounds *bounds = i % 2 ? &tall : &wide;
		int most = hud_group_rows_max(size[0], size[1]);
		int rows = most < 4 ? most : 4;
		struct hud_group_extent labels =
			hud_group_extent_of(size[0], size[1], rows, rows);
		int least = hud_graph_room(size[0], size[1], HUD_GRAPH_RATE);
		struct framing framing = framing_of(4, 4);
		struct camera_region region;

		framing.frame_times = true;
		region = framing_region(&framing, bounds, size[0], size[1]);
		assert_true(region.top - region.bottom >= 0.3f);
		if (region.left > -1.0f) {
			assert_near(
				region.left, at(labels.column, size[0]), 1e-5);
			continue;
		}
		assert_true(region.top <= -at(labels.top, size[1]) + 1e-5f);
		assert_true(region.bottom >= at(least, size[1]) - 1e-5f);
	}
}

/* Eleven rows of labels fill the column of the last picture. */
static void test_labels_that_fill_the_column_move_frame_times_below(void **state)
{
	static const int level[] = {320, 240};
	struct framing framing = framing_of(3, 0);
	int column = hud_group_extent_of(320, 240, 0, 0).column;

	(void)state;
	framing.frame_times = true;
	expect_region(&framing, &tall, level, at(column, 320), 1, -1, 1);
	framing.label_rows = 11;
	expect_region(&framing, &tall, level, at(column, 320), 1,
		at(hud_graph_room(320, 240, HUD_GRAPH_RATE), 240), 1);
}

static void test_lines_of_text_lie_below_frame_times(void **state)
{
	struct framing framing = framing_of(0, 0);
	int line = hud_group_extent_of(240, 320, 0, 0).line;

	(void)state;
	framing.frame_times = true;
	framing.lines_below = 6;
	expect_region(&framing, &wide, (const int[]){240, 320}, -1, 1,
		at(6 * line + hud_graph_room(240, 320, 0), 320), 1);
}

static void test_tall_figures_stand_beside_labels_and_wide_ones_below(
	void **state)
{
	int below = 0;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		const int *size = sizes[i];
		int most = hud_group_rows_max(size[0], size[1]);
		int rows = most < 3 ? most : 3;
		struct hud_group_extent extent =
			hud_group_extent_of(size[0], size[1], rows, 1);
		struct framing framing = framing_of(rows, 1);
		float left = at(extent.column, size[0]);
		float top = -at(extent.top, size[1]);
		float bottom = at(extent.line, size[1]);

		framing.lines_below = 1;
		expect_region(&framing, &tall, size, left, 1, bottom, 1);
		if (top > bottom + 0.4f) {
			expect_region(&framing, &wide, size, -1, 1, bottom, top);
			below++;
		} else {
			expect_region(&framing, &wide, size, left, 1, bottom, 1);
		}
		framing.labels_right = true;
		expect_region(&framing, &tall, size, -1, -left, bottom, 1);
	}
	assert_true(below > 1);
}

/* Further rows are not shown, and no more of them have a bar. */
static void test_more_labels_than_are_shown_take_no_more_room(void **state)
{
	static const int small[][2] = {{240, 320}, {320, 240}, {200, 300}};
	int limited = 0;

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(small); i++) {
		const int *size = small[i / 2];
		const struct bounds *bounds = i % 2 ? &tall : &wide;
		int most = hud_group_rows_max(size[0], size[1]);
		struct camera_region region;
		struct framing framing;

		if (most > 100) {
			continue;
		}
		framing = framing_of(most, most);
		region = framing_region(&framing, bounds, size[0], size[1]);
		framing = framing_of(most + 40, most + 50);
		expect_region(&framing, bounds, size, region.left, region.right,
			region.bottom, region.top);
		limited++;
	}
	assert_true(limited > 0);
}

static void test_wide_figures_stand_above_switches(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		const int *size = sizes[i];
		struct framing framing = framing_of(2, 0);
		int top = hud_group_extent_of(size[0], size[1], 2, 0).top;
		int list =
			hud_group_extent_of(size[0], size[1], 1, 0).list_height;

		framing.below.switches = 1;
		expect_region(&framing, &wide, size, -1, 1, at(list, size[1]),
			-at(top, size[1]));
	}
}

/* Labels are hidden where the list of keys takes their room. */
static void test_figures_stand_beside_or_above_a_list_of_keys(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		const int *size = sizes[i];
		struct framing framing = framing_of(2, 0);
		struct hud_group_extent extent =
			hud_group_extent_of(size[0], size[1], 3, 0);
		bool alone = hud_group_list_is_alone(size[0], size[1]);
		float beside = at(extent.list_width, size[0]);

		framing.below.keys = 3;
		expect_region(&framing, &wide, size,
			alone ? -1.0f : at(extent.column, size[0]), 1,
			at(extent.list_height, size[1]), 1);
		if (beside < 0.3f) {
			expect_region(&framing, &tall, size, beside, 1, -1, 1);
		}
		/* So many that nothing is left above them. */
		framing.below.keys = 100;
		if (beside < 0.6f) {
			expect_region(&framing, &wide, size, beside, 1, -1, 1);
		}
	}
}

/* Groups are not drawn there, and neither are the frame times. */
static void test_a_picture_too_small_for_groups_is_all_free(void **state)
{
	static const int small[][2] = {
		{160, 120}, {160, 128}, {176, 144}, {200, 150}, {40, 60}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(small); i++) {
		struct framing framing = framing_of((int)i % 2, 0);

		assert_int_equal(
			hud_group_rows_max(small[i][0], small[i][1]), 0);
		framing.frame_times = true;
		expect_region(&framing, &tall, small[i], -1, 1, -1, 1);
		expect_region(&framing, &wide, small[i], -1, 1, -1, 1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_labels_the_whole_picture_is_free),
		cmocka_unit_test(
			test_without_labels_figures_leave_frame_times_their_room),
		cmocka_unit_test(
			test_labels_and_frame_times_share_small_pictures_with_figures),
		cmocka_unit_test(
			test_labels_that_fill_the_column_move_frame_times_below),
		cmocka_unit_test(test_lines_of_text_lie_below_frame_times),
		cmocka_unit_test(
			test_tall_figures_stand_beside_labels_and_wide_ones_below),
		cmocka_unit_test(
			test_more_labels_than_are_shown_take_no_more_room),
		cmocka_unit_test(test_wide_figures_stand_above_switches),
		cmocka_unit_test(
			test_figures_stand_beside_or_above_a_list_of_keys),
		cmocka_unit_test(test_a_picture_too_small_for_groups_is_all_free),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
