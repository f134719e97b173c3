/* What the duel's buttons and its clock do to clip, camera and colours. */
#include "app/demo/actor.h"
#include "app/demo/demo_figures.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>

enum {
	FIGURES = 3,
	MORPH = 1,
	RIGID = 2
};

static struct demo_base *base_of(const struct demo_run *run)
{
	return (struct demo_base *)run->demo;
}

static void put(struct demo_run *run, enum button button, bool down)
{
	const struct button_event event = {.button = button, .down = down};

	demo_press(run->driver, run->demo, &event);
}

static void step(struct demo_run *run, double by_s)
{
	run->now_s += by_s;
	run->driver->update(run->demo, run->now_s);
}

static float clip_s(const struct demo_run *run)
{
	struct overlay_motion motion = overlay_motion_none();

	run->driver->get_motion(run->demo, &motion);
	assert_string_equal(
		base_of(run)->actor.model->clip[motion.clip].name, "walk");
	return motion.time_s;
}

static struct overlay_figure figure_of(const struct demo_run *run, int number)
{
	struct overlay_figure figure;

	assert_true(demo_find_figure(run->driver, run->demo, number, &figure));
	return figure;
}

/* Painted figures have white materials. */
static bool is_painted(const struct demo_run *run)
{
	const struct instance *instance = figure_of(run, 0).instance;
	int white = 0, count = instance->model->material_count;

	for (int i = 0; i < count; i++) {
		white += instance->model->material[i].texture < 0;
	}
	return white == count;
}

/* Over the bytes of a figure's colours. */
static uint32_t colors_of(const struct demo_run *run, int number)
{
	const struct instance *instance = figure_of(run, number).instance;
	uint32_t hash = 0x811c9dc5u;

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct batch *batch = instance->drawable[d].batch;

		for (int v = 0; v < 4 * batch->vertex_count; v++) {
			hash = (hash ^ batch->color[v / 4][v % 4]) * 0x01000193u;
		}
	}
	return hash;
}

static int begin(void **state)
{
	struct demo_run *run = calloc(1, sizeof(*run));

	assert_non_null(run);
	demo_run_begin(run, "duel");
	*state = run;
	return 0;
}

static int end(void **state)
{
	demo_run_end(*state);
	free(*state);
	return 0;
}

/* The distance from a to b on a circle of this length. */
static double way(double a, double b, double length)
{
	return remainder(b - a, length);
}

/* Floor and clip go by the same time, which ENTER stops. */
static void test_the_clip_plays_at_a_half_down_to_an_eighth(void **state)
{
	static const double speed[] = {1, 1.0 / 2, 1.0 / 4, 1.0 / 8, 1};
	struct demo_run *run = *state;
	const struct floor *floor = &base_of(run)->stage.floor;
	double duration_s, full = 0.0;

	step(run, 0.05);
	duration_s =
		(double)base_of(run)
			->actor.model
			->clip[model_find_clip(base_of(run)->actor.model, "walk")]
			.duration_s;
	for (size_t i = 0; i < ARRAY_COUNT(speed); i++) {
		double at_s = (double)clip_s(run), z = (double)floor->offset[1];

		step(run, 0.125);
		assert_near(way(at_s, (double)clip_s(run), duration_s),
			0.125 * speed[i], 1e-5);
		z = way(z, (double)floor->offset[1], (double)floor->tile);
		full = i == 0 ? z : full;
		assert_true(fabs(full) > 0.05);
		assert_near(z, full * speed[i], 1e-4);
		put(run, BUTTON_ENTER, true);
		at_s = (double)clip_s(run);
		z = (double)floor->offset[1];
		step(run, 0.125);
		assert_near(clip_s(run), at_s, 0.0);
		assert_near(floor->offset[1], z, 0.0);
		put(run, BUTTON_ENTER, true);
		put(run, BUTTON_F6, true);
	}
	put(run, BUTTON_F6, true);
	put(run, BUTTON_F6, true);
	put(run, BUTTON_F6, true);
}

/* Of two arrows the last one counts, and the first one again when it is gone. */
static void test_the_camera_turns_while_an_arrow_is_held(void **state)
{
	static const struct {
		enum button button;
		bool down;
		double rad_per_s; /* from then on */
	} change[] = {{BUTTON_RIGHT, true, 1.2}, {BUTTON_RIGHT, false, 0.0},
		{BUTTON_LEFT, true, -1.2}, {BUTTON_RIGHT, true, 1.2},
		{BUTTON_RIGHT, false, -1.2}, {BUTTON_LEFT, false, 0.0}};
	struct demo_run *run = *state;
	const struct camera *camera = &base_of(run)->stage.camera;

	for (size_t i = 0; i < ARRAY_COUNT(change); i++) {
		float yaw_rad = camera->yaw_rad;

		put(run, change[i].button, change[i].down);
		step(run, 0.25);
		assert_near(camera->yaw_rad - yaw_rad,
			0.25 * change[i].rad_per_s, 1e-5);
	}
}

/* For 3.3 seconds, every 6.6; then F8 ends that. */
static void test_f9_paints_the_errors_from_time_to_time(void **state)
{
	struct demo_run *run = *state;

	assert_false(is_painted(run));
	put(run, BUTTON_F9, true);
	for (int i = 0; i < 14; i++) {
		step(run, 0.9);
		assert_int_equal(is_painted(run), fmod(run->now_s, 6.6) >= 3.3);
	}
	assert_near(run->driver->period_s(run->demo), 6.6, 1e-9);
	while (!is_painted(run)) {
		step(run, 0.9);
	}
	put(run, BUTTON_F8, true);
	assert_false(is_painted(run));
	step(run, 0.1);
	assert_false(is_painted(run));
	put(run, BUTTON_F8, true);
	step(run, 6.6);
	assert_true(is_painted(run));
}

/* The first frame measures all; the skin is never off. */
static void test_each_frame_measures_one_figure(void **state)
{
	struct demo_run *run = *state;
	uint32_t before[FIGURES];

	put(run, BUTTON_F8, true);
	for (int i = 0; i < FIGURES; i++) {
		before[i] = colors_of(run, i);
	}
	for (int frame = 0; frame < 7; frame++) {
		step(run, 0.1);
		for (int i = 0; i < FIGURES; i++) {
			uint32_t now = colors_of(run, i);

			assert_int_equal(now != before[i],
				i > 0 && (frame == 0 || frame % FIGURES == i));
			before[i] = now;
		}
	}
	put(run, BUTTON_F8, true);
}

/* They are seen from the side a little, which takes a quarter of their depth. */
static void test_three_figures_stand_in_a_row(void **state)
{
	struct demo_run *run = *state;
	struct bounds bounds = bounds_empty();
	struct overlay_figure figure;
	float width, slanted;

	for (int i = 0; i < FIGURES; i++) {
		struct bounds one;

		figure = figure_of(run, i);
		one = bounds_of_clip(figure.instance,
			i ? 0 : model_find_clip(figure.instance->model, "walk"));
		bounds_join(&bounds, &one);
		assert_int_equal(figure.unposed_nodes, i == MORPH);
	}
	width = bounds.high[0] - bounds.low[0];
	slanted = width + 0.25f * (bounds.high[2] - bounds.low[2]);
	assert_true(slanted > 1.2f * width);
	for (int i = 0; i < FIGURES; i++) {
		figure = figure_of(run, i);
		assert_near(figure.place[3][0],
			(double)slanted * (double)(i - 1), 1e-3);
		assert_near(figure.place[3][2], 0.0, 0.0);
	}
	assert_false(demo_find_figure(run->driver, run->demo, 3, &figure));
	assert_string_equal(
		demo_get_facts(run->driver, run->demo).technique, "All three");
	/* Soles that are a little below the ground do not lower it. */
	assert_true(bounds.low[1] < 0.0f);
	assert_near(base_of(run)->stage.floor.y, 0.0, 0.0);
}

static void test_all_figures_have_the_same_level_of_detail(void **state)
{
	const struct demo_reduction reduction = {.error_px = 8.0f};
	struct demo_run *run = *state;
	const struct demo_base *base = base_of(run);
	long all = demo_get_facts(run->driver, run->demo).triangles;

	for (int i = 0; i < FIGURES; i++) {
		float px = figure_of(run, i).instance->lod_px_per_unit;
		float wanted = lod_px_per_unit(base->actor.instance,
			&base->stage.camera, base->actor.extent, base->height);

		assert_true(px > wanted / 1.11f && px < wanted * 1.11f);
	}
	demo_set_reduction(run->demo, &reduction);
	step(run, 0.01);
	assert_true(demo_get_facts(run->driver, run->demo).triangles <
		9 * all / 10);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_frame_measures_one_figure),
		cmocka_unit_test(test_the_clip_plays_at_a_half_down_to_an_eighth),
		cmocka_unit_test(test_the_camera_turns_while_an_arrow_is_held),
		cmocka_unit_test(test_three_figures_stand_in_a_row),
		cmocka_unit_test(test_f9_paints_the_errors_from_time_to_time),
		cmocka_unit_test(test_all_figures_have_the_same_level_of_detail),
	};

	return cmocka_run_group_tests(tests, begin, end);
}
