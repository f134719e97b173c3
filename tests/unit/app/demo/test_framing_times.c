/* Labels, figures and the graph of frame times share pictures of any size. */
#include "app/demo/demo_overlay.h"
#include "app/scene/hud/hud_graph.h"
#include "tests/support/demo_shown.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <string.h>

static const int sizes[][2] = {
	{240, 320}, {128, 160}, {320, 240}, {800, 480}, {1280, 720}};

static const char *const names[] = {"walker", "arm", "face", "crowd", "duel",
	"tuner", "arm.glb", "walker.glb"};

/* Whether a tiny picture has no room for more than frames a second. */
static bool is_least(const struct hud *hud, int stacked)
{
	int room = hud_graph_room(hud->width, hud->height, HUD_GRAPH_RATE);

	return hud->width == 128 &&
		hud->stacked_px[HUD_BOTTOM_LEFT] - stacked <= room;
}

/* Draws the demo after its picture got this size as the order-th one. */
static void show_at(struct shown *shown, const int size[2], int order)
{
	/* The crowd's camera moves to its new place. */
	bool eases = strcmp(shown->driver->name, "crowd") == 0;

	gl_recorder_clear();
	demo_draw(shown->driver, shown->demo, size[0], size[1]);
	if (eases) {
		shown->driver->update(shown->demo, 20.0 * order);
		gl_recorder_clear();
		demo_draw(shown->driver, shown->demo, size[0], size[1]);
	}
}

static void check_times(struct shown *shown, const char *name,
	const int size[2], bool no_labels)
{
	const struct hud_facts facts = {.technique = "Skeletal",
		.driver = "soft",
		.triangles = 4711,
		.memory_bytes = 1 << 24};
	const struct hud_graph graph = {.next = 0};
	struct camera_region figure;
	struct hud_place place;
	struct hud hud;
	int first, stacked;

	assert_int_equal(hud_init(&hud, &shown->gl, &shown->log), 0);
	hud_begin(&hud, size[0], size[1]);
	if (!no_labels) {
		demo_label(shown->driver, shown->demo, &hud);
	}
	first = hud.quad_count;
	stacked = hud.stacked_px[HUD_BOTTOM_LEFT];
	place = demo_times_place(shown->demo, &hud);
	hud_graph_show(&graph, &facts, &place, &hud);
	assert_true(hud.quad_count > first);
	figure = shown_framed(shown, size);
	shown_check_whole(&figure);
	if (hud_groups_overlap(&hud) ||
		(shown_hides(&hud, first, &figure) && !is_least(&hud, stacked))) {
		fail_msg("%s %dx%d", name, size[0], size[1]);
	}
	hud_finish(&hud, &shown->gl);
}

/*
 * A demo begins in one size and gets all others after that, as it takes seconds
 * to begin some. Each size is the first one of some demo.
 */
static void check_all(bool no_labels)
{
	for (size_t n = 0; n < ARRAY_COUNT(names); n++) {
		struct shown shown;

		shown_begin_timed(&shown, names[n],
			sizes[n % ARRAY_COUNT(sizes)], no_labels);
		for (size_t s = 0; s < ARRAY_COUNT(sizes); s++) {
			const int *size = sizes[(n + s) % ARRAY_COUNT(sizes)];

			show_at(&shown, size, (int)s + 1);
			check_times(&shown, names[n], size, no_labels);
		}
		shown_end(&shown);
	}
}

static void test_frame_times_cover_neither_figures_nor_labels(void **state)
{
	(void)state;
	check_all(false);
}

static void test_frame_times_cover_no_figures_without_labels(void **state)
{
	(void)state;
	check_all(true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_frame_times_cover_neither_figures_nor_labels),
		cmocka_unit_test(
			test_frame_times_cover_no_figures_without_labels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
