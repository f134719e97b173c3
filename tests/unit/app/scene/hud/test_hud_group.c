#include "app/scene/hud/hud_group.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __SANITIZE_ADDRESS__
static const bool counts_allocations = false;
static int allocation_count;
#else
/* Replaces the C library's allocator by one that counts. */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *block, size_t size);

static const bool counts_allocations = true;
static volatile int allocation_count;

void *malloc(size_t size)
{
	allocation_count++;
	return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
	allocation_count++;
	return __libc_calloc(count, size);
}

void *realloc(void *block, size_t size)
{
	allocation_count++;
	return __libc_realloc(block, size);
}
#endif

static struct hud *hud_of_size(int width, int height)
{
	static struct hud hud;

	memset(&hud, 0, sizeof(hud));
	hud.font = &font_default;
	hud_begin(&hud, width, height);
	return &hud;
}

struct box {
	int left, top, right, bottom;
};

static struct box box_of(const struct hud *hud, int first, int end)
{
	struct box box = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};

	for (int i = first * 4; i < end * 4; i++) {
		const struct hud_vertex *v = &hud->vertex[i];

		box.left = v->x < box.left ? v->x : box.left;
		box.top = v->y < box.top ? v->y : box.top;
		box.right = v->x > box.right ? v->x : box.right;
		box.bottom = v->y > box.bottom ? v->y : box.bottom;
	}
	return box;
}

/* The text of the quads from first on; '?' for characters beyond ASCII. */
static const char *text_of(const struct hud *hud, int first)
{
	static char text[HUD_QUADS_MAX + 1];
	int length = 0;

	for (int i = first; i < hud->quad_count; i++) {
		const struct hud_vertex *v = &hud->vertex[i * 4];

		for (int k = 0; k < hud->font->glyph_count; k++) {
			const struct font_glyph *glyph = &hud->face->glyph[k];
			uint16_t code = hud->font->code[k];

			if (glyph->width && glyph->s == v->s &&
				glyph->t == v->t) {
				text[length++] = code < 0x7F ? (char)code : '?';
			}
		}
	}
	text[length] = 0;
	return text;
}

static void add_sample(struct hud *hud, enum hud_corner corner)
{
	struct hud_group group = hud_group_begin(hud, corner, "Skeletal");

	hud_group_text(&group, "influences", "4");
	hud_group_time(&group, "walk", 0.42f, 1.07f, hud_color_blue);
	hud_group_weight(&group, "run", 0.35f, hud_color_green);
	hud_group_bar(&group, "face", "smile", 0.5f, hud_color_amber);
	hud_group_key(&group, "F6", "wave");
	hud_group_switch(&group, "F10", "shadow", true, hud_color_rose);
	hud_group_switch(&group, "F8", "cape", false, hud_color_rose);
	hud_group_end(&group);
}

static void test_groups_keep_an_equal_margin_in_every_corner(void **state)
{
	static const int sizes[][2] = {
		{240, 320}, {480, 640}, {1280, 720}, {3840, 2160}};

	(void)state;
	for (int i = 0; i < 4 * 4; i++) {
		int width = sizes[i / 4][0], height = sizes[i / 4][1];
		enum hud_corner corner = (enum hud_corner)(i % 4);
		struct hud *hud = hud_of_size(width, height);
		bool right =
			corner == HUD_TOP_RIGHT || corner == HUD_BOTTOM_RIGHT;
		bool bottom =
			corner == HUD_BOTTOM_LEFT || corner == HUD_BOTTOM_RIGHT;
		struct box box;

		add_sample(hud, corner);
		box = box_of(hud, 0, hud->quad_count);
		assert_in_range(right ? width - box.right : box.left,
			hud_em(hud) / 2, hud_em(hud));
		assert_int_equal(right ? width - box.right : box.left,
			bottom ? height - box.bottom : box.top);
		assert_true(box.right - box.left <= width);
	}
}

static void test_everything_lies_on_the_panel(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	struct box backdrop, rows;
	int quads;

	(void)state;
	hud_panel(hud, 0, 0, 90, 90, 9, hud_color_panel);
	quads = hud->quad_count;
	hud_begin(hud, 480, 640);
	add_sample(hud, HUD_BOTTOM_RIGHT);
	backdrop = box_of(hud, 0, quads);
	rows = box_of(hud, quads, hud->quad_count);
	assert_true(rows.left > backdrop.left && rows.right < backdrop.right);
	assert_true(rows.top > backdrop.top && rows.bottom < backdrop.bottom);
	/* The margins on both sides are equal. */
	assert_int_equal(rows.left - backdrop.left, backdrop.right - rows.right);
}

static void test_groups_of_a_corner_stack_towards_the_middle(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	struct box first, second;
	int middle;

	(void)state;
	for (int i = 0; i < 2; i++) {
		hud_begin(hud, 480, 640);
		add_sample(hud, i ? HUD_BOTTOM_LEFT : HUD_TOP_LEFT);
		middle = hud->quad_count;
		add_sample(hud, i ? HUD_BOTTOM_LEFT : HUD_TOP_LEFT);
		first = box_of(hud, 0, middle);
		second = box_of(hud, middle, hud->quad_count);
		assert_int_equal(first.left, second.left);
		assert_int_equal(first.right, second.right);
		assert_int_equal(i ? first.top - second.bottom
				   : second.top - first.bottom,
			first.left);
	}
}

static void test_labels_stay_in_place_while_values_change(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	struct box first = {0};

	(void)state;
	for (int i = 0; i <= 100; i++) {
		struct hud_group group;
		struct box box;

		hud_begin(hud, 480, 640);
		group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
		hud_group_time(&group, i % 2 ? "walk" : "run backwards fast",
			0.37f * (float)i, 37.0f, hud_color_blue);
		hud_group_weight(&group, "w", 0.01f * (float)i, hud_color_blue);
		hud_group_end(&group);
		box = box_of(hud, 0, hud->quad_count);
		first = i ? first : box;
		assert_memory_equal(&box, &first, sizeof(box));
	}
}

static const char *time_text(float time_s, float duration_s)
{
	struct hud *hud = hud_of_size(480, 640);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
	int first = hud->quad_count;

	hud_group_time(&group, "", time_s, duration_s, hud_color_blue);
	return text_of(hud, first);
}

static const char *weight_text(float weight)
{
	struct hud *hud = hud_of_size(480, 640);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
	int first = hud->quad_count;

	hud_group_weight(&group, "", weight, hud_color_blue);
	return text_of(hud, first);
}

static const char *named_time_text(const char *label, float time_s)
{
	struct hud *hud = hud_of_size(320, 240);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
	int first = hud->quad_count;

	hud_group_time(&group, label, time_s, 3.0f, hud_color_blue);
	return text_of(hud, first);
}

static void test_a_long_name_takes_the_place_of_times(void **state)
{
	(void)state;
	for (float time_s = 0.0f; time_s < 3.0f; time_s += 0.11f) {
		char time[16];

		snprintf(time, sizeof(time), "%.2fs", (double)time_s);
		assert_non_null(
			strstr(named_time_text("run", time_s), "/3.00s"));
		assert_null(strstr(named_time_text("Dog_Run", time_s), "/"));
		assert_non_null(
			strstr(named_time_text("Dog_Run", time_s), time));
		assert_non_null(
			strstr(named_time_text("Dog_Run", time_s), "Dog_Run"));
		assert_string_equal(named_time_text("Dog_RunFetch", time_s),
			"Dog_RunFetch");
	}
}

/* The height of a group with this many rows of each kind. */
static int height_of_group(struct hud *hud, int rows)
{
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, "title");

	for (int i = 0; i < rows; i++) {
		hud_group_text(&group, "label", "value");
		hud_group_weight(&group, "label", 0.5f, hud_color_blue);
		hud_group_mark(&group, "label", "value", hud_color_rose);
	}
	hud_group_end(&group);
	return hud->stacked_px[HUD_TOP_LEFT];
}

static void test_groups_are_shorter_in_narrow_pictures(void **state)
{
	int four, eight;

	(void)state;
	four = height_of_group(hud_of_size(240, 320), 2);
	eight = height_of_group(hud_of_size(240, 320), 8);
	assert_int_equal(four, eight);
	assert_true(four < 160);
	assert_int_equal(hud_group_rows_max(240, 320), HUD_GROUP_ROWS_NARROW);
	four = height_of_group(hud_of_size(320, 240), 2);
	eight = height_of_group(hud_of_size(320, 240), 4);
	assert_true(eight > four + 60);
	assert_true(hud_group_rows_max(320, 240) > 100);
	assert_true(hud_group_rows_max(480, 640) > 100);
}

static void test_groups_leave_figures_half_of_a_small_picture(void **state)
{
	static const int sizes[][3] = {{240, 320, HUD_GROUP_ROWS_NARROW},
		{176, 208, 2}, {220, 176, 1}, {128, 160, 1}, {160, 120, 0},
		{128, 96, 0}, {96, 64, 0}, {32, 32, 0},
		/* Too narrow for more than an ellipsis. */
		{48, 200, 0}, {60, 200, 0}, {64, 200, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		int width = sizes[i][0], height = sizes[i][1];
		int group = height_of_group(hud_of_size(width, height), 8);

		assert_int_equal(hud_group_rows_max(width, height), sizes[i][2]);
		assert_true(2 * group <= height);
		assert_true((group > 0) == (sizes[i][2] > 0));
	}
}

static void add_weight(struct hud_group *group)
{
	hud_group_weight(group, "row", 0.5f, hud_color_green);
}

static void add_key(struct hud_group *group)
{
	hud_group_key(group, "UP", "go up");
}

static void add_switch(struct hud_group *group)
{
	hud_group_switch(group, "F8", "cape", true, hud_color_rose);
}

static void test_rows_beyond_the_picture_are_left_out(void **state)
{
	static const int sizes[][2] = {{320, 240}, {640, 480}, {400, 120}};
	static void (*const add[])(struct hud_group *) = {
		add_weight, add_key, add_switch};

	(void)state;
	for (size_t i = 0; i < 3 * sizeof(sizes) / sizeof(sizes[0]); i++) {
		const int *size = sizes[i % 3];
		struct hud *hud = hud_of_size(size[0], size[1]);
		struct hud_group group =
			hud_group_begin(hud, HUD_BOTTOM_LEFT, "title");
		struct box box;

		for (int row = 0; row < 60; row++) {
			add[i / 3](&group);
		}
		hud_group_end(&group);
		box = box_of(hud, 0, hud->quad_count);
		assert_true(box.top >= 0 && box.bottom <= size[1]);
		assert_true(box.bottom - box.top > size[1] / 2);
	}
}

static void test_a_list_of_keys_is_in_the_picture_and_no_higher_than_said(
	void **state)
{
	static const int sizes[][2] = {{240, 320}, {480, 640}, {400, 120}};

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		for (int rows = 1; rows < 60; rows += 6) {
			struct hud *hud = hud_of_size(sizes[i][0], sizes[i][1]);
			struct hud_group_extent extent = hud_group_extent_of(
				sizes[i][0], sizes[i][1], rows, 0);
			struct hud_group group = hud_group_begin_wide(
				hud, HUD_BOTTOM_LEFT, NULL);
			struct box box;

			for (int row = 0; row < rows; row++) {
				hud_group_key(&group, "UP", "go up");
			}
			hud_group_end(&group);
			box = box_of(hud, 0, hud->quad_count);
			assert_true(box.top >= 0);
			assert_true(box.top >= sizes[i][1] - extent.list_height);
			assert_true(box.right <= extent.list_width);
		}
	}
}

static void test_times_show_hundredths(void **state)
{
	(void)state;
	assert_string_equal(time_text(0.416f, 1.0667f), "0.42/1.07s");
	assert_string_equal(time_text(0.0f, 12.0f), "0.00/12.00s");
	assert_string_equal(time_text(0.996f, 0.0f), "1.00/0.00s");
	assert_string_equal(time_text(-3.0f, NAN), "0.00/0.00s");
	assert_string_equal(time_text(INFINITY, 1e30f), "9999.00/9999.00s");
}

static void test_weights_show_percent(void **state)
{
	(void)state;
	assert_string_equal(weight_text(0.0f), "0%");
	assert_string_equal(weight_text(0.354f), "35%");
	assert_string_equal(weight_text(0.996f), "100%");
	assert_string_equal(weight_text(-1.0f), "0%");
	assert_string_equal(weight_text(2.0f), "100%");
	assert_string_equal(weight_text(NAN), "0%");
}

static void test_a_long_label_gives_way_to_its_value(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
	int first = hud->quad_count;

	(void)state;
	hud_group_text(&group, "a label that is much too long for it", "4711");
	assert_contains(text_of(hud, first), "4711");
	assert_contains(text_of(hud, first), "alabel");
	assert_null(strstr(text_of(hud, first), "forit"));
	first = hud->quad_count;
	hud_group_text(&group, "Armature|mixamo.com|Layer0.001", "4711");
	assert_contains(text_of(hud, first), ".001");
	hud_group_end(&group);
}

static void test_switches_show_on_and_off(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, NULL);
	int quads[2], knob[2];

	(void)state;
	for (int on = 0; on < 2; on++) {
		int first = hud->quad_count;

		hud_group_switch(&group, "F6", "cape", on, hud_color_rose);
		quads[on] = hud->quad_count - first;
		knob[on] = hud->vertex[hud->quad_count * 4 - 4].x;
	}
	assert_int_equal(quads[0], quads[1]);
	/* The knob moves right, and the switch is coloured. */
	assert_true(knob[1] > knob[0] + 4);
	hud_group_end(&group);
}

static void test_a_group_widens_for_the_text_of_a_switch(void **state)
{
	struct hud *hud = hud_of_size(320, 240);
	struct hud_group group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
	int standard = group.width, first = hud->quad_count;

	(void)state;
	hud_group_widen(&group, "F8", "cape");
	assert_int_equal(group.width, standard);
	hud_group_widen(&group, "F8", "arm shake");
	hud_group_switch(&group, "F8", "arm shake", true, hud_color_rose);
	assert_contains(text_of(hud, first), "armshake");
	hud_group_widen(&group, "F8", "what nobody reads to its end");
	assert_int_equal(group.width, standard * 5 / 4);
	hud_group_end(&group);
}

static void test_groups_that_do_not_fit_are_harmless(void **state)
{
	(void)state;
	for (int size = 1; size < 200; size += 9) {
		struct hud *hud = hud_of_size(size, size);

		for (int i = 0; i < 30; i++) {
			add_sample(hud, (enum hud_corner)(i % 4));
		}
		assert_true(hud->quad_count <= HUD_QUADS_MAX);
	}
}

static void test_drawing_takes_nothing_from_the_heap(void **state)
{
	struct hud *hud = hud_of_size(480, 640);
	int before;

	(void)state;
	if (!counts_allocations) {
		skip_because("the sanitizer keeps the heap to itself");
	}
	/* cmocka itself has allocated, so counting works. */
	assert_true(allocation_count > 0);
	before = allocation_count;
	for (int i = 0; i < 10; i++) {
		hud_begin(hud, 480, 640);
		for (int corner = 0; corner < 4; corner++) {
			add_sample(hud, (enum hud_corner)corner);
		}
	}
	assert_int_equal(allocation_count, before);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_groups_keep_an_equal_margin_in_every_corner),
		cmocka_unit_test(test_everything_lies_on_the_panel),
		cmocka_unit_test(
			test_groups_of_a_corner_stack_towards_the_middle),
		cmocka_unit_test(test_labels_stay_in_place_while_values_change),
		cmocka_unit_test(test_a_long_name_takes_the_place_of_times),
		cmocka_unit_test(test_groups_are_shorter_in_narrow_pictures),
		cmocka_unit_test(
			test_groups_leave_figures_half_of_a_small_picture),
		cmocka_unit_test(test_rows_beyond_the_picture_are_left_out),
		cmocka_unit_test(
			test_a_list_of_keys_is_in_the_picture_and_no_higher_than_said),
		cmocka_unit_test(test_times_show_hundredths),
		cmocka_unit_test(test_weights_show_percent),
		cmocka_unit_test(test_a_long_label_gives_way_to_its_value),
		cmocka_unit_test(test_switches_show_on_and_off),
		cmocka_unit_test(test_a_group_widens_for_the_text_of_a_switch),
		cmocka_unit_test(test_groups_that_do_not_fit_are_harmless),
		cmocka_unit_test(test_drawing_takes_nothing_from_the_heap),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
