/* The corner that labels of overlays take, beside figures and other labels. */
#include "app/demo/demo_overlay.h"
#include "tests/support/demo_shown.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	SIZES = 4,
	STEPS = 9
};

/* Pixels beside the figures in each direction. */
struct room {
	int left, right, above, below;
};

static struct room room_of(const struct shown *shown, const struct hud *hud)
{
	const struct demo_base *base = (const void *)shown->demo;
	struct camera_region taken = camera_covered(&base->stage.camera);
	float x = 0.5f * (float)hud->width, y = 0.5f * (float)hud->height;

	return (struct room){
		.left = (int)((1.0f + taken.left) * x) + 1,
		.right = (int)((1.0f - taken.right) * x) + 1,
		.above = (int)((1.0f - taken.top) * y),
		.below = (int)((1.0f + taken.bottom) * y),
	};
}

/* A column at the left, else one at the right, else the larger room. */
static int wanted_corner(const struct room *room, const int *stacked,
	const struct hud *hud, int *px)
{
	int column = hud_group_extent_of(hud->width, hud->height, 0, 0).column;
	int below = room->below - stacked[HUD_BOTTOM_LEFT];
	int above_left = room->above - stacked[HUD_TOP_LEFT];

	*px = hud->height;
	if (room->left >= column) {
		return HUD_BOTTOM_LEFT;
	}
	if (room->right >= column) {
		return HUD_BOTTOM_RIGHT;
	}
	/* Two columns stand side by side above the figures, or one. */
	if (hud->width >= 2 * column && room->above > below) {
		*px = room->above;
		return HUD_TOP_RIGHT;
	}
	*px = above_left > below ? above_left : below;
	return above_left > below ? HUD_TOP_LEFT : HUD_BOTTOM_LEFT;
}

static void check_place(const struct shown *shown, struct hud *hud,
	const int size[2], int top, int bottom, int *seen)
{
	struct overlay *overlay = ((struct demo_base *)shown->demo)->overlay;
	int before[HUD_CORNERS], least, px, corner;
	struct room room;
	bool added;

	hud_begin(hud, size[0], size[1]);
	hud->stacked_px[HUD_TOP_LEFT] = top * size[1] / 32;
	hud->stacked_px[HUD_BOTTOM_LEFT] = bottom * size[1] / 32;
	memcpy(before, hud->stacked_px, sizeof(before));
	room = room_of(shown, hud);
	corner = wanted_corner(&room, before, hud, &px);
	least = hud_group_extent_of(hud->width, hud->height, 1, 1).top;
	added = demo_overlay_label(shown->driver, shown->demo, overlay, hud);
	if (px < least) {
		assert_false(added);
	}
	for (int i = 0; i < HUD_CORNERS; i++) {
		if (i != corner || px < least) {
			assert_int_equal(hud->stacked_px[i], before[i]);
		} else {
			assert_true(hud->stacked_px[i] >= before[i]);
			seen[i] += hud->stacked_px[i] > before[i];
		}
	}
}

static void test_labels_take_the_free_side(void **state)
{
	static const char *const names[] = {"arm", "face"};
	const struct overlay_choice choice = {
		.kinds = 1 << OVERLAY_SKELETON | 1 << OVERLAY_CURVE};
	/* High pictures have room above and below. */
	static const int sizes[SIZES][2] = {
		{480, 640}, {640, 480}, {300, 900}, {600, 1400}};
	int seen[HUD_CORNERS] = {0};

	(void)state;
	for (int i = 0; i < 2 * SIZES; i++) {
		const int *size = sizes[i / 2];
		struct shown shown;
		struct hud hud;

		shown_begin(&shown, names[i % 2], size, false);
		assert_int_equal(
			demo_overlay_make(shown.driver, shown.demo, &choice), 0);
		assert_int_equal(hud_init(&hud, &shown.gl, &shown.log), 0);
		for (int k = 0; k < STEPS * STEPS; k++) {
			check_place(
				&shown, &hud, size, k / STEPS, k % STEPS, seen);
		}
		hud_finish(&hud, &shown.gl);
		shown_end(&shown);
	}
	/* Where the right side is free in these demos, so is the left one. */
	assert_true(seen[HUD_BOTTOM_LEFT] > 0);
	assert_true(seen[HUD_TOP_LEFT] > 0);
	assert_true(seen[HUD_TOP_RIGHT] > 0);
}

/* Such as the times of frames, which come below the overlays' labels there. */
static void test_labels_at_the_right_leave_less_room_above_figures(void **state)
{
	const int size[2] = {600, 1400};
	struct shown shown;
	struct hud hud;
	struct room room;
	int seen = 0;

	(void)state;
	shown_begin(&shown, "face", size, false);
	assert_int_equal(hud_init(&hud, &shown.gl, &shown.log), 0);
	hud_begin(&hud, size[0], size[1]);
	room = room_of(&shown, &hud);
	for (int px = 0; px <= room.above; px += 10) {
		struct hud_place place;

		hud.stacked_px[HUD_TOP_RIGHT] = px;
		place = demo_overlay_place(shown.demo, &hud);
		if (place.corner == HUD_TOP_RIGHT) {
			assert_int_equal(place.room, room.above - px);
			seen++;
		}
	}
	assert_true(seen > 1);
	hud_finish(&hud, &shown.gl);
	shown_end(&shown);
}

/* Below a figure in a narrow picture, where so many pixels are left. */
static bool is_added(const struct shown *shown, struct hud *hud, int px)
{
	struct overlay *overlay = ((struct demo_base *)shown->demo)->overlay;
	struct room room;

	hud_begin(hud, 300, 900);
	room = room_of(shown, hud);
	assert_true(px <= room.below);
	hud->stacked_px[HUD_TOP_LEFT] = room.above;
	hud->stacked_px[HUD_BOTTOM_LEFT] = room.below - px;
	(void)demo_overlay_label(shown->driver, shown->demo, overlay, hud);
	return hud->stacked_px[HUD_BOTTOM_LEFT] > room.below - px;
}

static void test_labels_need_room_for_a_row_with_a_bar(void **state)
{
	const struct overlay_choice choice = {.kinds = 1 << OVERLAY_SKELETON};
	const int size[2] = {300, 900};
	struct shown shown;
	struct hud hud;
	int least;

	(void)state;
	shown_begin(&shown, "face", size, false);
	assert_int_equal(
		demo_overlay_make(shown.driver, shown.demo, &choice), 0);
	assert_int_equal(hud_init(&hud, &shown.gl, &shown.log), 0);
	hud_begin(&hud, size[0], size[1]);
	least = hud_group_extent_of(size[0], size[1], 1, 1).top;
	assert_true(least > hud_group_extent_of(size[0], size[1], 1, 0).top);
	assert_false(is_added(&shown, &hud, least - 1));
	assert_true(is_added(&shown, &hud, least));
	hud_finish(&hud, &shown.gl);
	shown_end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_labels_take_the_free_side),
		cmocka_unit_test(
			test_labels_at_the_right_leave_less_room_above_figures),
		cmocka_unit_test(test_labels_need_room_for_a_row_with_a_bar),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
