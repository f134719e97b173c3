/* Demos keep what moves in the picture, and stand on the ground. */
#include "app/character/show/character_bounds.h"
#include "tests/support/demo_shown.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

/* But for what rigid parts are off at a sole. */
static void test_figures_of_the_duel_are_not_below_the_ground(void **state)
{
	struct shown shown;

	(void)state;
	shown_begin(&shown, "duel", shown_sizes[0], false);
	for (int step = 0; step < 12; step++) {
		struct overlay_figure figure;

		shown.driver->update(shown.demo, 0.1);
		for (int i = 0; i < 3; i++) {
			struct bounds bounds;
			float ground = ((const struct demo_base *)shown.demo)
					       ->stage.floor.y;

			assert_true(shown.driver->get_figure(
				shown.demo, i, &figure));
			bounds = bounds_of_instance(figure.instance);
			assert_true(bounds.low[1] > ground - 0.05f);
		}
	}
	shown_end(&shown);
}

/* Pitched back and turned aside as far as it goes. */
static void test_parts_that_buttons_turn_stay_in_the_picture(void **state)
{
	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		struct button_event held = {.button = BUTTON_UP, .down = true};
		struct camera_region region;
		struct shown shown;

		shown_begin(&shown, "arm", shown_sizes[s], false);
		demo_press(shown.driver, shown.demo, &held);
		held.button = BUTTON_LEFT;
		demo_press(shown.driver, shown.demo, &held);
		for (int frame = 0; frame < 200; frame++) {
			shown.driver->update(shown.demo, 0.05 + 0.04 * frame);
		}
		region = shown_now(&shown, shown_sizes[s]);
		shown_check_whole(&region);
		shown_end(&shown);
	}
}

static void test_shapes_without_a_clip_are_in_the_picture_whole(void **state)
{
	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		struct shown shown;
		struct demo_base *base;
		struct instance *instance;

		shown_begin(&shown, "../tests/fixtures/gltf/mesh/weights.gltf",
			shown_sizes[s], false);
		base = (struct demo_base *)shown.demo;
		instance = base->actor.instance;
		assert_int_equal(instance->model->clip_count, 0);
		assert_int_not_equal(instance->pose.weight_count, 0);
		for (int i = 0; i < instance->pose.weight_count; i++) {
			struct bounds bounds;
			float center[3], half[3];
			struct camera_region region;

			pose_rest(&instance->pose, instance->model);
			instance->pose.weight[i] = 1.0f;
			instance_update(instance);
			bounds = bounds_of_instance(instance);
			bounds_center(&bounds, center);
			for (int axis = 0; axis < 3; axis++) {
				half[axis] = bounds.high[axis] - center[axis];
			}
			region = shown_project(&base->stage.camera,
				shown_sizes[s], center, half);
			shown_check_whole(&region);
		}
		shown_end(&shown);
	}
}

static void test_what_swings_stays_in_the_picture(void **state)
{
	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		struct camera_region region;
		struct shown shown;

		shown_begin_env(&shown, "walker.glb",
			"tests/fixtures/swing.character", shown_sizes[s], false);
		for (int frame = 0; frame < 150; frame++) {
			shown.driver->update(shown.demo, 0.05 + 0.04 * frame);
		}
		region = shown_now(&shown, shown_sizes[s]);
		shown_check_whole(&region);
		shown_end(&shown);
	}
}

/* Plays the fixture's next clip until the camera has settled. */
static double play_next(struct shown *shown, double time_s)
{
	struct button_event down = {.button = BUTTON_DOWN, .down = true};
	double end_s = time_s + 6.0;

	demo_press(shown->driver, shown->demo, &down);
	down.down = false;
	demo_press(shown->driver, shown->demo, &down);
	while (time_s < end_s) {
		time_s += 0.04;
		shown->driver->update(shown->demo, time_s);
	}
	return time_s;
}

/* Two times the clip, at whose end the figure is at its start at once. */
static double check_followed(
	struct shown *shown, const int size[2], double time_s)
{
	for (int frame = 0; frame < 100; frame++) {
		struct camera_region region;

		time_s += 0.04;
		shown->driver->update(shown->demo, time_s);
		region = shown_now(shown, size);
		shown_check_whole(&region);
		/* Large, of the 2 that the picture has. */
		assert_true(region.right - region.left > 0.5f ||
			region.top - region.bottom > 0.5f);
	}
	return time_s;
}

static void test_the_camera_follows_what_goes_far(void **state)
{
	(void)state;
	for (size_t s = 0; s < SHOWN_SIZES; s++) {
		const int *size = shown_sizes[s];
		double time_s = 0.02;
		struct shown shown;

		shown_begin(&shown, "../tests/fixtures/gltf/clip/far.gltf",
			size, false);
		time_s = check_followed(&shown, size, time_s); /* leave */
		time_s = play_next(&shown, time_s);
		time_s = check_followed(&shown, size, time_s); /* climb */
		time_s = play_next(&shown, time_s);
		check_followed(&shown, size, time_s); /* circle */
		shown_end(&shown);
	}
}

static void test_the_camera_stays_while_a_figure_sways(void **state)
{
	const int *size = shown_sizes[0];
	double time_s = 0.02;
	const struct camera *camera;
	struct camera_region region;
	struct shown shown;
	float target[3];

	(void)state;
	shown_begin(&shown, "../tests/fixtures/gltf/clip/far.gltf", size, false);
	camera = &((const struct demo_base *)shown.demo)->stage.camera;
	for (int clip = 0; clip < 3; clip++) {
		time_s = play_next(&shown, time_s);
	}
	memcpy(target, camera->target, sizeof(target));
	for (int frame = 0; frame < 100; frame++) {
		time_s += 0.04;
		shown.driver->update(shown.demo, time_s);
		region = shown_now(&shown, size);
		shown_check_whole(&region);
		assert_all_near(camera->target, target, 3, 1e-3);
	}
	shown_end(&shown);
}

/* The ground is drawn around the place where the figure is. */
static void test_the_ground_goes_with_the_camera(void **state)
{
	struct shown shown;
	const struct stage *stage;
	struct floor_sight begin, end;
	double time_s = 0.02;
	float way[2];

	(void)state;
	shown_begin(&shown, "../tests/fixtures/gltf/clip/far.gltf",
		shown_sizes[0], false);
	time_s = play_next(&shown, time_s);
	time_s = play_next(&shown, time_s); /* circle */
	stage = &((const struct demo_base *)shown.demo)->stage;
	way[0] = stage->floor.way[0];
	way[1] = stage->floor.way[1];
	floor_find_sight(&stage->floor, &stage->camera, shown_sizes[0][0],
		shown_sizes[0][1], &stage->content, &begin);
	/* Half a round later it is on the other side. */
	shown.driver->update(shown.demo, time_s + 1.0);
	assert_true(fmaxf(fabsf(stage->floor.way[0] - way[0]),
			    fabsf(stage->floor.way[1] - way[1])) >
		15.0f * stage->floor.tile);
	floor_find_sight(&stage->floor, &stage->camera, shown_sizes[0][0],
		shown_sizes[0][1], &stage->content, &end);
	assert_int_equal(end.strips.covered_px, begin.strips.covered_px);
	assert_int_equal(end.strips.horizon_px, begin.strips.horizon_px);
	shown_end(&shown);
}

/* Two surfaces in one plane would fight. */
static void test_the_floor_is_below_ground_of_the_model(void **state)
{
	const struct demo_base *base;
	struct shown shown;

	(void)state;
	shown_begin(&shown, "../tests/fixtures/gltf/scene/ground.gltf",
		shown_sizes[0], false);
	base = (const struct demo_base *)shown.demo;
	assert_true(base->stage.floor.y < 0.0f);
	assert_near(base->stage.floor.y, 0, 0.002 * base->actor.extent);
	shown_end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_figures_of_the_duel_are_not_below_the_ground),
		cmocka_unit_test(
			test_parts_that_buttons_turn_stay_in_the_picture),
		cmocka_unit_test(
			test_shapes_without_a_clip_are_in_the_picture_whole),
		cmocka_unit_test(test_what_swings_stays_in_the_picture),
		cmocka_unit_test(test_the_camera_follows_what_goes_far),
		cmocka_unit_test(test_the_camera_stays_while_a_figure_sways),
		cmocka_unit_test(test_the_ground_goes_with_the_camera),
		cmocka_unit_test(test_the_floor_is_below_ground_of_the_model),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
