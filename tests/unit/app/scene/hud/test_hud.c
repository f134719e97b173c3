#include "app/scene/hud/hud.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const struct hud_color orange = {255, 128, 0, 255};

/* A hud without GL, for what happens before hud_end(). */
static struct hud *hud_of_size(int width, int height)
{
	static struct hud hud;

	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, width, height);
	return &hud;
}

static void test_widths_of_pieces_add_up(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int walk = hud_text_width(hud, "walk "),
	    time = hud_text_width(hud, "1.07");

	(void)state;
	assert_int_equal(hud_text_width(hud, ""), 0);
	assert_true(walk > 0 && time > 0);
	assert_int_equal(hud_text_width(hud, "walk 1.07"), walk + time);
	assert_int_equal(hud_text_width(hud, "1.07walk "), walk + time);
	assert_int_equal(hud_text_width(hud, "3.48"), time);
	assert_int_equal(
		hud_text(hud, 40, 0, orange, "walk 1.07"), 40 + walk + time);
}

static void test_text_grows_with_the_picture(void **state)
{
	static const int sizes[][3] = {{240, 320, 12}, {480, 640, 16},
		{1280, 720, 16}, {1920, 1080, 24}, {3840, 2160, 48}, {1, 1, 12}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		struct hud *hud = hud_of_size(sizes[i][0], sizes[i][1]);

		assert_int_equal(hud_em(hud), sizes[i][2]);
		assert_in_range(
			hud_line_height(hud), hud_em(hud), hud_em(hud) * 3 / 2);
	}
}

/* In a picture of twice the height all letters are twice as large. */
static void test_large_letters_are_enlarged_ones(void **state)
{
	static struct hud once;
	struct hud *twice;

	(void)state;
	once = *hud_of_size(1920, 1080);
	assert_int_equal(hud_text(&once, 10, 20, orange, "Way 1"),
		10 + hud_text_width(&once, "Way 1"));
	twice = hud_of_size(3840, 2160);
	assert_int_equal(hud_text(twice, 20, 40, orange, "Way 1"),
		20 + hud_text_width(twice, "Way 1"));
	assert_int_equal(once.quad_count, 4);
	assert_int_equal(twice->quad_count, 4);
	for (int i = 0; i < 4 * 4; i++) {
		const struct hud_vertex *a = &once.vertex[i];
		const struct hud_vertex *b = &twice->vertex[i];

		assert_int_equal(b->x, 2 * a->x);
		assert_int_equal(b->y, 2 * a->y);
		assert_near(b->s, a->s, 0);
		assert_near(b->t, a->t, 0);
	}
}

static void test_a_picture_has_at_least_one_pixel(void **state)
{
	static const int sizes[][2] = {{0, 0}, {-5, 7}, {9, -1}, {1, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		const int *size = sizes[i];
		struct hud *hud = hud_of_size(size[0], size[1]);

		assert_int_equal(hud->width, size[0] < 1 ? 1 : size[0]);
		assert_int_equal(hud->height, size[1] < 1 ? 1 : size[1]);
	}
}

static void test_long_text_is_cut_with_an_ellipsis(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int whole = hud_text_width(hud, "walk backwards");
	const struct font_glyph *ellipsis =
		&hud->face->glyph[font_find_glyph(hud->font, 0x2026)];

	(void)state;
	assert_int_equal(
		hud_text_cut(hud, 7, 0, whole, orange, "walk backwards"),
		7 + whole);
	assert_int_equal(hud->quad_count, 13);
	for (int width = 0; width < whole; width++) {
		int end;

		hud_begin(hud, 480, 640);
		end = hud_text_cut(hud, 7, 0, width, orange, "walk backwards");
		assert_in_range(end, 7, 7 + width);
		if (hud->quad_count > 0) {
			const struct hud_vertex *last =
				&hud->vertex[hud->quad_count * 4 - 4];

			assert_int_equal(last->s, ellipsis->s);
			assert_int_equal(last->t, ellipsis->t);
		} else {
			assert_true(width < ellipsis->advance);
		}
	}
}

static void test_no_ellipsis_follows_a_space(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int word = hud_text_width(hud, "walk");
	int more = hud_text_width(hud, " \xE2\x80\xA6");

	(void)state;
	assert_int_equal(
		hud_text_cut(hud, 0, 0, word + more, orange, "walk backwards"),
		word + hud_text_width(hud, "\xE2\x80\xA6"));
}

/* The texels from which a text's glyphs are drawn are the same. */
static void expect_glyphs(const struct hud *hud, const char *text)
{
	static struct hud other;

	other.font = &font_default;
	hud_begin(&other, hud->width, hud->height);
	hud_text(&other, 0, 0, orange, text);
	assert_int_equal(hud->quad_count, other.quad_count);
	for (int i = 0; i < hud->quad_count * 4; i++) {
		assert_true(hud->vertex[i].s == other.vertex[i].s &&
			hud->vertex[i].t == other.vertex[i].t);
	}
}

static void test_names_lose_their_middle(void **state)
{
	static const char *const shown[][2] = {
		{"Armature|mixamo.com|Layer0.001",
			"Armature\xE2\x80\xA6yer0.001"},
		{"mixamorig:LeftHandIndex1",
			"mixamori\xE2\x80\xA6"
			"dIndex1"},
		{"Excavator_Base_Group heading", "Excavato\xE2\x80\xA6 heading"},
		{"a Armature|mixamo.com|Layer0.001",
			"a Armature|mixam\xE2\x80\xA6"},
		{"a name of some words", "a name of some w\xE2\x80\xA6"},
		{"walk", "walk"}};
	struct hud *hud = hud_of_size(480, 640);
	int width = hud_text_width(hud, "Armature\xE2\x80\xA6yer0.001");

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(shown); i++) {
		int end;

		hud_begin(hud, 480, 640);
		end = hud_text_shorten(hud, 3, 0, width, orange, shown[i][0]);
		expect_glyphs(hud, shown[i][1]);
		assert_int_equal(end, 3 + hud_text_width(hud, shown[i][1]));
	}
	/* A letter at each end would say less than two at the beginning. */
	hud_begin(hud, 480, 640);
	width = hud_text_width(hud, "bo\xE2\x80\xA6");
	hud_text_shorten(hud, 3, 0, width, orange, "bone");
	expect_glyphs(hud, "bo\xE2\x80\xA6");
}

static void test_shortened_names_are_never_too_wide(void **state)
{
	static const char name[] = "\xC3\x9C"
				   "berw\xC3\xA4ltigend_\xE8\xB5\xB0.001";
	struct hud *hud = hud_of_size(480, 640);

	(void)state;
	for (int width = -9; width < 300; width++) {
		int end;

		hud_begin(hud, 480, 640);
		end = hud_text_shorten(hud, 7, 0, width, orange, name);
		assert_in_range(end, 7, 7 + (width > 0 ? width : 0));
	}
}

/* Adds more than fits. */
static void overfill(struct hud *hud)
{
	for (int i = 0; i < HUD_QUADS_MAX; i++) {
		hud_text(hud, i, i, orange, "no longer fits");
		hud_bar(hud, i, i, 100, 10, 0.5f, orange);
	}
}

static void test_elements_beyond_the_capacity_are_dropped(void **state)
{
	struct hud *hud = hud_of_size(480, 640);

	(void)state;
	memset(hud->index, 0xA5, sizeof(hud->index));
	overfill(hud);
	assert_int_equal(hud->quad_count, HUD_QUADS_MAX);
	for (int i = 0; i < HUD_QUADS_MAX * 6; i++) {
		assert_int_equal(hud->index[i], 0xA5A5);
	}
	hud_begin(hud, 480, 640);
	assert_int_equal(hud->quad_count, 0);
}

static void test_absurd_positions_and_sizes_are_harmless(void **state)
{
	struct hud *hud = hud_of_size(480, 640);

	(void)state;
	hud_panel(hud, 10, 10, 0, 20, 5, orange);
	hud_panel(hud, 10, 10, -5, -5, 5, orange);
	hud_bar(hud, 10, 10, 0, 4, 1.0f, orange);
	hud_rectangle(hud, 0, 0, -1, 5, orange);
	assert_int_equal(hud->quad_count, 0);
	hud_text(hud, 1 << 24, -(1 << 24), orange, "far away");
	hud_panel(hud, 0, 0, 50, 50, 1 << 20, orange);
	hud_panel(hud, 0, 0, 50, 50, -1, orange);
	hud_move(hud, 0, 30000, -30000);
	hud_move(hud, 0, 30000, -30000);
}

/* How far the upper left corner of a panel is round, in pixels. */
static int roundness(int height, int w, int h, int radius)
{
	struct hud *hud = hud_of_size(480, height);

	hud_panel(hud, 0, 0, w, h, radius, orange);
	assert_true(hud->quad_count >= 4);
	return hud->vertex[2].x > hud->vertex[1].x ? hud->vertex[2].x
						   : hud->vertex[1].x;
}

static void test_corners_are_as_round_as_asked_or_half_a_side(void **state)
{
	(void)state;
	for (int height = 640; height < 3000; height *= 2) {
		assert_in_range(roundness(height, 100, 60, 8), 6, 8);
		assert_in_range(roundness(height, 100, 12, 8), 4, 6);
		assert_in_range(roundness(height, 12, 100, 8), 4, 6);
	}
}

/* The filled width of a bar of 100 pixels: the right edge of its last quad. */
static int filled_width(float fraction)
{
	struct hud *hud = hud_of_size(480, 640);
	int track, right = 0;

	hud_panel(hud, 0, 0, 100, 4, 2, orange);
	track = hud->quad_count;
	hud_begin(hud, 480, 640);
	hud_bar(hud, 0, 0, 100, 4, fraction, orange);
	for (int i = track * 4; i < hud->quad_count * 4; i++) {
		right = hud->vertex[i].x > right ? hud->vertex[i].x : right;
	}
	return right;
}

static void test_bars_fill_by_their_fraction(void **state)
{
	(void)state;
	assert_int_equal(filled_width(0.5f), 50);
	assert_int_equal(filled_width(0.254f), 25);
	assert_int_equal(filled_width(1.0f), 100);
	assert_int_equal(filled_width(7.0f), 100);
	assert_int_equal(filled_width(0.0f), 0);
	assert_int_equal(filled_width(-1.0f), 0);
	assert_int_equal(filled_width(NAN), 0);
	/* The smallest fraction is visible as a dot. */
	assert_int_equal(filled_width(0.001f), 4);
}

/* sRGB; all labels, graphs and overlays take their colours from here. */
static void test_labels_have_one_palette(void **state)
{
	const struct {
		struct hud_color color;
		uint8_t rgba[4];
	} palette[] = {{hud_color_text, {244, 247, 250, 255}},
		{hud_color_dim, {190, 201, 214, 255}},
		{hud_color_panel, {16, 21, 29, 184}},
		{hud_color_blue, {92, 172, 255, 255}},
		{hud_color_green, {104, 211, 145, 255}},
		{hud_color_amber, {250, 190, 88, 255}},
		{hud_color_rose, {248, 128, 140, 255}},
		{hud_color_violet, {178, 148, 255, 255}}};

	(void)state;
	for (size_t i = 0; i < sizeof(palette) / sizeof(palette[0]); i++) {
		assert_memory_equal(&palette[i].color, palette[i].rgba, 4);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_widths_of_pieces_add_up),
		cmocka_unit_test(test_text_grows_with_the_picture),
		cmocka_unit_test(test_a_picture_has_at_least_one_pixel),
		cmocka_unit_test(test_long_text_is_cut_with_an_ellipsis),
		cmocka_unit_test(test_no_ellipsis_follows_a_space),
		cmocka_unit_test(test_names_lose_their_middle),
		cmocka_unit_test(test_shortened_names_are_never_too_wide),
		cmocka_unit_test(test_elements_beyond_the_capacity_are_dropped),
		cmocka_unit_test(test_absurd_positions_and_sizes_are_harmless),
		cmocka_unit_test(
			test_corners_are_as_round_as_asked_or_half_a_side),
		cmocka_unit_test(test_bars_fill_by_their_fraction),
		cmocka_unit_test(test_large_letters_are_enlarged_ones),
		cmocka_unit_test(test_labels_have_one_palette),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
