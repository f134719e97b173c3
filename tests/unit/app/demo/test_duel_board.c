/* The duel's scoreboard: the same as texts and rectangles that a test places. */
#include "app/compare/measure/reference.h"
#include "app/demo/duel/duel_board.h"
#include "app/scene/overlay/overlay_heat.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static struct hud shown, wanted;
static struct model model = {.skin_count = 1};
static struct reference reference = {.model = &model};

static const struct hud_color *const color[2] = {
	&hud_color_text, &hud_color_green};

static void begin(struct contender contender[CONTENDER_KINDS])
{
	static const char *const titles[] = {"Skeletal", "Morph", "Parts"};
	struct hud *const both[] = {&shown, &wanted};

	for (int i = 0; i < 2; i++) {
		memset(both[i], 0, sizeof(*both[i]));
		both[i]->font = &font_default;
		hud_begin(both[i], 480, 640);
	}
	memset(contender, 0, CONTENDER_KINDS * sizeof(*contender));
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		contender[i].kind = (enum contender_kind)i;
		contender[i].title = titles[i];
		contender[i].reference = &reference;
		contender[i].ms = 1.5f - 0.25f * (float)i;
		contender[i].candidate.bytes.shared = 1024;
		contender[i].candidate.bytes.own = 1024 * (size_t)(1 + i);
		contender[i].peak_px = i == 1 ? 0.25f : 1.0f;
	}
	contender[1].key_count = 7;
}

static void want(int column, int line, const char *text, struct hud_color is)
{
	int em = hud_em(&wanted), width = (480 - em) / 3;
	int left = em / 2 + column * width;

	hud_text(&wanted, left + (width - hud_text_width(&wanted, text)) / 2,
		line, is, text);
}

static void expect_wanted(void)
{
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)shown.quad_count * 4 * sizeof(shown.vertex[0]));
	assert_memory_equal(
		shown.stacked_px, wanted.stacked_px, sizeof(shown.stacked_px));
}

/* Returns the top of the first line. */
static int want_panel(int rows)
{
	int em = hud_em(&wanted), height = rows * hud_line_height(&wanted) + em;
	int top = 640 - height - em / 2;

	hud_panel(&wanted, em / 2, top, 480 - em, height, em / 3,
		hud_color_panel);
	wanted.stacked_px[HUD_BOTTOM_LEFT] = height + em / 2;
	wanted.stacked_px[HUD_BOTTOM_RIGHT] = height + em / 2;
	return top + em / 2;
}

static void test_the_best_of_each_row_is_green(void **state)
{
	static const char *const means[] = {"skin", "7 keys", "rigid parts"};
	static const char *const ms[] = {"1.50 ms", "1.25 ms", "1.00 ms"};
	static const char *const bytes[] = {"2 KiB", "3 KiB", "4 KiB"};
	static const char *const px[] = {"1.00 px", "0.25 px", "1.00 px"};
	struct contender contender[CONTENDER_KINDS];
	int y, line;

	(void)state;
	begin(contender);
	duel_board_show(contender, 0.0f, &shown);
	y = want_panel(5);
	line = hud_line_height(&wanted);
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		want(i, y, contender[i].title, hud_color_text);
		want(i, y + line, means[i], hud_color_dim);
		want(i, y + 2 * line, ms[i], *color[i == 2]);
		want(i, y + 3 * line, bytes[i], *color[i == 0]);
		want(i, y + 4 * line, px[i], *color[i == 1]);
	}
	expect_wanted();
}

/* Without times there is a row less; a model without a skin is the file's. */
static void test_unknown_times_are_left_out(void **state)
{
	struct contender contender[CONTENDER_KINDS];
	int y, line;

	(void)state;
	begin(contender);
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		contender[i].ms = -1.0f;
		contender[i].peak_px = 0.0f;
		contender[i].candidate.bytes.own = 0;
	}
	contender[1].key_count = 1;
	model.skin_count = 0;
	duel_board_show(contender, 0.0f, &shown);
	model.skin_count = 1;
	y = want_panel(4);
	line = hud_line_height(&wanted);
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		static const char *const means[] = {
			"the file's own", "1 keys", "rigid parts"};

		want(i, y, contender[i].title, hud_color_text);
		want(i, y + line, means[i], hud_color_dim);
		want(i, y + 2 * line, "1 KiB", hud_color_green);
		want(i, y + 3 * line, "0.00 px", hud_color_green);
	}
	expect_wanted();
}

static void test_the_scale_of_errors_has_24_steps(void **state)
{
	struct contender contender[CONTENDER_KINDS];
	int em, line, y, x, first, bar;
	uint8_t cold[3], hot[3];

	(void)state;
	begin(contender);
	duel_board_show(contender, 5.0f, &shown);
	em = hud_em(&wanted);
	line = hud_line_height(&wanted);
	bar = (480 - 2 * em) / 3;
	y = want_panel(5) + line;
	wanted.quad_count = 0;
	x = hud_text(&wanted, em, y, hud_color_dim, "off by 0 ") + em / 4;
	for (int i = 0; i < 24; i++) {
		int from = x + bar * i / 24, to = x + bar * (i + 1) / 24;
		uint8_t rgb[3];

		overlay_heat_ramp((float)i / 23.0f, rgb);
		hud_rectangle(&wanted, from, y + line / 4, to - from, line / 2,
			(struct hud_color){rgb[0], rgb[1], rgb[2], 255});
	}
	hud_text(&wanted, x + bar + em / 2, y, hud_color_dim, "5 px or more");
	first = shown.quad_count - wanted.quad_count;
	assert_true(first > 0);
	assert_memory_equal(&shown.vertex[first * 4], wanted.vertex,
		(size_t)wanted.quad_count * 4 * sizeof(wanted.vertex[0]));
	overlay_heat_ramp(0.0f, cold);
	overlay_heat_ramp(1.0f, hot);
	assert_memory_not_equal(cold, hot, sizeof(cold));
}

/* Whether the quads of a text of its own are among those shown. */
static bool shows(const char *text, struct hud_color is)
{
	size_t bytes;

	wanted.quad_count = 0;
	hud_text(&wanted, 0, 0, is, text);
	bytes = (size_t)wanted.quad_count * 4 * sizeof(wanted.vertex[0]);
	for (int first = 0; first + wanted.quad_count <= shown.quad_count;
		first++) {
		const struct hud_vertex *at = &shown.vertex[first * 4];
		int x = at->x - wanted.vertex[0].x;
		int y = at->y - wanted.vertex[0].y;

		hud_move(&wanted, 0, x, y);
		if (memcmp(at, wanted.vertex, bytes) == 0) {
			return true;
		}
	}
	return false;
}

/* "1609..." and "0.0..." would be read as other figures. */
static void test_figures_are_shortened_and_not_cut(void **state)
{
	struct contender contender[CONTENDER_KINDS];

	(void)state;
	begin(contender);
	hud_begin(&shown, 128, 160);
	hud_begin(&wanted, 128, 160);
	contender[1].candidate.bytes.own = (size_t)1608 * 1024;
	duel_board_show(contender, 0.0f, &shown);
	assert_true(shows("1.5", hud_color_text));
	assert_true(shows("0.0M", hud_color_green));
	assert_true(shows("1.6M", hud_color_text));
	assert_true(shows("0.2px", hud_color_green));
	contender[1].candidate.bytes.own = (size_t)20 * 1024;
	hud_begin(&shown, 128, 160);
	duel_board_show(contender, 0.0f, &shown);
	assert_true(shows("2K", hud_color_green));
	assert_true(shows("21K", hud_color_text));
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_best_of_each_row_is_green),
		cmocka_unit_test(test_unknown_times_are_left_out),
		cmocka_unit_test(test_the_scale_of_errors_has_24_steps),
		cmocka_unit_test(test_figures_are_shortened_and_not_cut),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
