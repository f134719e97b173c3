/* Which presses of F8, F9 and F10 the demo gets, and what the program does. */
#include "app/cmd/show/program_keys.h"
#include "tests/support/test.h"

struct scene {
	struct program_keys keys;
	struct button_event passed[PROGRAM_KEYS_PASSED_MAX];
	int count;
};

static enum program_action take(
	struct scene *scene, int64_t at_ms, enum button button, bool down)
{
	const struct button_event event = {at_ms, button, down, 0};

	return program_keys_press(
		&scene->keys, &event, scene->passed, &scene->count);
}

static void test_other_events_go_to_the_demo_unchanged(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	assert_int_equal(take(&scene, 5, BUTTON_F8, true), PROGRAM_NOTHING);
	assert_int_equal(scene.count, 1);
	assert_int_equal(scene.passed[0].button, BUTTON_F8);
	assert_true(scene.passed[0].down);
	take(&scene, 9, BUTTON_F8, false);
	assert_int_equal(scene.count, 1);
	assert_false(scene.passed[0].down);
}

static void test_the_demo_gets_a_short_f9_when_it_is_released(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	take(&scene, 100, BUTTON_F9, true);
	assert_int_equal(scene.count, 0);
	assert_int_equal(program_keys_update(&scene.keys, 799), PROGRAM_NOTHING);
	take(&scene, 799, BUTTON_F9, false);
	assert_int_equal(scene.count, 2);
	assert_true(scene.passed[0].down);
	assert_false(scene.passed[1].down);
	assert_int_equal(scene.passed[0].time_ms, 799);
}

static void test_a_held_f9_shows_the_graph_once(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	take(&scene, 100, BUTTON_F9, true);
	assert_int_equal(
		program_keys_update(&scene.keys, 800), PROGRAM_TOGGLE_GRAPH);
	assert_int_equal(program_keys_update(&scene.keys, 900), PROGRAM_NOTHING);
	take(&scene, 2000, BUTTON_F9, false);
	assert_int_equal(scene.count, 0);
	assert_int_equal(
		program_keys_update(&scene.keys, 9000), PROGRAM_NOTHING);
}

static void test_f8_while_f9_is_held_keeps_the_picture(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	take(&scene, 0, BUTTON_F9, true);
	assert_int_equal(
		take(&scene, 100, BUTTON_F8, true), PROGRAM_KEEP_PICTURE);
	assert_int_equal(scene.count, 0);
	take(&scene, 200, BUTTON_F9, false);
	assert_int_equal(scene.count, 0);
	take(&scene, 300, BUTTON_F8, false);
	assert_int_equal(scene.count, 0);
	take(&scene, 400, BUTTON_F8, true);
	assert_int_equal(scene.count, 1);
}

static void test_buttons_while_f9_is_held_choose_overlays(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	take(&scene, 0, BUTTON_F9, true);
	assert_int_equal(
		take(&scene, 100, BUTTON_F6, true), PROGRAM_NEXT_OVERLAY);
	take(&scene, 150, BUTTON_F6, false);
	assert_int_equal(scene.count, 0);
	assert_int_equal(
		take(&scene, 200, BUTTON_DOWN, true), PROGRAM_NEXT_JOINT);
	assert_int_equal(
		take(&scene, 250, BUTTON_UP, true), PROGRAM_PREVIOUS_JOINT);
	assert_int_equal(
		program_keys_update(&scene.keys, 2000), PROGRAM_NOTHING);
	take(&scene, 2100, BUTTON_F9, false);
	assert_int_equal(scene.count, 0);
	/* Their releases come late and are not the demo's either. */
	take(&scene, 2200, BUTTON_DOWN, false);
	assert_int_equal(scene.count, 0);
	take(&scene, 2300, BUTTON_UP, false);
	assert_int_equal(scene.count, 0);
	take(&scene, 2400, BUTTON_F6, true);
	assert_int_equal(scene.count, 1);
}

static void test_a_release_without_a_press_is_ignored(void **state)
{
	struct scene scene = {.count = 0};

	(void)state;
	take(&scene, 0, BUTTON_F9, false);
	assert_int_equal(scene.count, 0);
}

static void test_f10_belongs_to_the_camera_if_there_is_one(void **state)
{
	struct scene scene = {.keys.has_camera = true};

	(void)state;
	assert_int_equal(
		take(&scene, 0, BUTTON_F10, true), PROGRAM_NEXT_CAMERA_USE);
	assert_int_equal(scene.count, 0);
	assert_int_equal(take(&scene, 9, BUTTON_F10, false), PROGRAM_NOTHING);
	assert_int_equal(scene.count, 0);
	scene.keys.has_camera = false;
	assert_int_equal(take(&scene, 20, BUTTON_F10, true), PROGRAM_NOTHING);
	assert_int_equal(scene.count, 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_other_events_go_to_the_demo_unchanged),
		cmocka_unit_test(
			test_the_demo_gets_a_short_f9_when_it_is_released),
		cmocka_unit_test(test_a_held_f9_shows_the_graph_once),
		cmocka_unit_test(test_f8_while_f9_is_held_keeps_the_picture),
		cmocka_unit_test(test_f10_belongs_to_the_camera_if_there_is_one),
		cmocka_unit_test(test_buttons_while_f9_is_held_choose_overlays),
		cmocka_unit_test(test_a_release_without_a_press_is_ignored),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
