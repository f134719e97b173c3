/* Demos frame their figures beside or below their labels, at every size. */
#include "app/demo/demo_overlay.h"
#include "tests/support/demo_shown.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static bool covers(const struct camera_region *region, const int size[2],
	int rows, int bars)
{
	int most = hud_group_rows_max(size[0], size[1]);
	struct hud_group_extent labels = hud_group_extent_of(size[0], size[1],
		rows < most ? rows : most, bars < most ? bars : most);
	float right = 2.0f * (float)labels.column / (float)size[0] - 1.0f;
	float bottom = 1.0f - 2.0f * (float)labels.top / (float)size[1];

	return region->left < right - 0.01f && region->top > bottom + 0.01f;
}

static const struct {
	const char *name;
	int rows, bars; /* of the labels */
} demos[] = {
	{"walker", 9, 8},
	{"arm", 6, 1},
	{"tuner", 12, 0},
	{"arm.glb", 2, 1},
	{"walker.glb", 2, 1},
};

/* Draws a frame and its labels; none of them is over the figure. */
static void check_labels_beside_figure(struct shown *shown, const int size[2])
{
	struct camera_region figure;
	struct hud hud;

	demo_draw(shown->driver, shown->demo, size[0], size[1]);
	assert_int_equal(hud_init(&hud, &shown->gl, &shown->log), 0);
	hud_begin(&hud, size[0], size[1]);
	demo_label(shown->driver, shown->demo, &hud);
	assert_true(hud.quad_count > 20);
	figure = shown_framed(shown, size);
	shown_check_whole(&figure);
	if (shown_hides(&hud, 0, &figure)) {
		fail_msg("%s %dx%d", shown->driver->name, size[0], size[1]);
	}
	hud_finish(&hud, &shown->gl);
}

static void check_framed(
	const struct shown *shown, const char *name, const int size[2])
{
	struct camera_region region = shown_framed(shown, size);

	shown_check_whole(&region);
	for (size_t d = 0; d < sizeof(demos) / sizeof(demos[0]); d++) {
		assert_false(strcmp(demos[d].name, name) == 0 &&
			covers(&region, size, demos[d].rows, demos[d].bars));
	}
}

static void press(struct shown *shown, enum button button)
{
	const struct button_event event = {.button = button, .down = true};

	demo_press(shown->driver, shown->demo, &event);
}

static const char *const names[] = {"walker", "arm", "face", "crowd", "duel",
	"tuner", "arm.glb", "walker.glb"};

/*
 * Labels of the state, of the buttons and of the overlays, and the scale of the
 * duel's errors. One demo shows them all, because it takes seconds to begin.
 */
static void test_labels_do_not_cover_the_figures(void **state)
{
	const struct overlay_choice all = {.kinds = (1U << OVERLAY_KINDS) - 1};

	(void)state;
	for (size_t n = 0; n < ARRAY_COUNT(names); n++) {
		for (size_t s = 0; s < SHOWN_SIZES; s++) {
			const int *size = shown_sizes[s];
			struct shown shown;

			shown_begin(&shown, names[n], size, false);
			check_framed(&shown, names[n], size);
			check_labels_beside_figure(&shown, size);
			if (strcmp(names[n], "duel") == 0) {
				press(&shown, BUTTON_F8);
				check_labels_beside_figure(&shown, size);
				press(&shown, BUTTON_F8);
			}
			assert_int_equal(demo_overlay_make(shown.driver,
						 shown.demo, &all),
				0);
			check_labels_beside_figure(&shown, size);
			shown_end(&shown);
		}
	}
}

static void test_the_label_of_a_camera_does_not_cover_the_figure(void **state)
{
	static const struct camera_feed feed = {0};

	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		struct shown shown;
		struct live *live;

		shown_begin(&shown, "walker.glb", shown_sizes[s], false);
		live = &((struct demo_base *)shown.demo)->live;
		live->feed = &feed;
		shown.driver->update(shown.demo, 0.04);
		check_labels_beside_figure(&shown, shown_sizes[s]);
		live->feed = NULL;
		shown_end(&shown);
	}
}

static void test_the_list_of_keys_does_not_cover_the_figure(void **state)
{
	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		const int *size = shown_sizes[s];
		struct camera_region figure;
		struct shown shown;

		shown_begin(&shown, "arm", size, false);
		press(&shown, BUTTON_F6);
		shown.driver->update(shown.demo, 0.04);
		check_labels_beside_figure(&shown, size);
		figure = shown_framed(&shown, size);
		assert_true(figure.top - figure.bottom > 0.5f);
		shown_end(&shown);
	}
}

static void test_without_labels_the_figure_is_in_the_middle(void **state)
{
	(void)state;
	for (size_t d = 0; d < sizeof(demos) / sizeof(demos[0]); d++) {
		for (size_t s = 0; s < SHOWN_SIZES; s++) {
			struct shown shown;
			struct camera_region region;

			shown_begin(&shown, demos[d].name, shown_sizes[s], true);
			region = shown_framed(&shown, shown_sizes[s]);
			shown_check_whole(&region);
			assert_near(region.left + region.right, 0.0, 0.01);
			assert_near(region.bottom + region.top, 0.0, 0.01);
			/* It fills the picture's width or its height. */
			assert_true(fmaxf(region.right, region.top) > 0.85f);
			shown_end(&shown);
		}
	}
}

static void test_a_picture_of_another_size_is_framed_anew(void **state)
{
	struct shown shown;

	(void)state;
	shown_begin_env(&shown, "arm.glb", "none", shown_sizes[0], false);
	for (size_t from = 0; from < SHOWN_SIZES; from++) {
		for (size_t to = 0; to < SHOWN_SIZES; to++) {
			struct camera_region region;

			gl_recorder_clear();
			demo_draw(shown.driver, shown.demo,
				shown_sizes[from][0], shown_sizes[from][1]);
			demo_draw(shown.driver, shown.demo, shown_sizes[to][0],
				shown_sizes[to][1]);
			region = shown_framed(&shown, shown_sizes[to]);
			shown_check_whole(&region);
			assert_false(covers(&region, shown_sizes[to], 2, 1));
		}
	}
	shown_end(&shown);
}

/* The crowd's camera keeps its distance, and shifts the picture. */
static void test_a_crowd_is_framed_anew_in_another_size(void **state)
{
	(void)state;
	for (size_t to = 0; to < SHOWN_SIZES; to++) {
		struct shown resized, fresh;
		const struct camera *a, *b;

		shown_begin(&resized, "crowd", shown_sizes[0], false);
		demo_draw(resized.driver, resized.demo, shown_sizes[to][0],
			shown_sizes[to][1]);
		resized.driver->update(resized.demo, 20.0);
		shown_begin(&fresh, "crowd", shown_sizes[to], false);
		a = &((const struct demo_base *)resized.demo)->stage.camera;
		b = &((const struct demo_base *)fresh.demo)->stage.camera;
		assert_near(a->distance, b->distance, 0.01);
		assert_near(a->shift_x, b->shift_x, 1e-4);
		assert_near(a->shift_y, b->shift_y, 1e-4);
		shown_end(&fresh);
		shown_end(&resized);
	}
}

static void test_a_target_that_moves_stays_in_the_picture(void **state)
{
	static const float center[3] = {-0.5f, 1.65f, 0.5f};
	static const float half[3] = {0.75f, 0.5f, 0.05f};

	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		struct shown shown;
		struct camera_region region;

		shown_begin_env(&shown, "walker.glb",
			"tests/fixtures/ball.character", shown_sizes[s], false);
		region = shown_project(
			&((struct demo_base *)shown.demo)->stage.camera,
			shown_sizes[s], center, half);
		shown_check_whole(&region);
		assert_false(covers(&region, shown_sizes[s], 2, 1));
		shown_end(&shown);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_labels_do_not_cover_the_figures),
		cmocka_unit_test(
			test_the_label_of_a_camera_does_not_cover_the_figure),
		cmocka_unit_test(test_the_list_of_keys_does_not_cover_the_figure),
		cmocka_unit_test(test_without_labels_the_figure_is_in_the_middle),
		cmocka_unit_test(test_a_picture_of_another_size_is_framed_anew),
		cmocka_unit_test(test_a_crowd_is_framed_anew_in_another_size),
		cmocka_unit_test(test_a_target_that_moves_stays_in_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
