/* What a character knows of its skeleton, targets, outputs and surroundings. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Node 1 is below node 0; nothing else is in the model. */
static void begin_pair(
	struct acting *acting, const float away[3], const float way[3])
{
	acting_begin(acting, "tests/fixtures/gltf/clip/far.gltf");
	assert_int_equal(acting->model->node_count, 2);
	memcpy(acting->model->node[0].rest.translation, away, 3 * sizeof(*away));
	memcpy(acting->model->node[1].rest.translation, way, 3 * sizeof(*way));
}

/*
 * A skeleton with a largest side of 0.3 to 10 is in metres. Any other is as
 * large as a human of 1.65 m.
 */
static void test_a_skeleton_of_an_unlikely_size_has_another_metre(void **state)
{
	static const struct {
		float size;
		double metre;
	} rows[] = {{0, 1}, {0.29f, 0.29 / 1.65}, {0.31f, 1}, {9.9f, 1},
		{10.1f, 10.1 / 1.65}, {165, 100}};

	(void)state;
	for (size_t i = 0; i < 6 * ARRAY_COUNT(rows); i++) {
		const struct character_motion *motion;
		int axis = (int)i % 3;
		float way[3], size = rows[i / 6].size;
		struct acting acting;

		for (int k = 0; k < 3; k++) {
			way[k] = (k == axis ? 1.0f : 0.25f) *
				(i % 6 < 3 ? size : -size);
		}
		begin_pair(&acting, (float[]){-5, 6, 7}, way);
		acting_expect(&acting, "[state a]\nclip = rest\n");
		assert_near(acting.character->metre, rows[i / 6].metre, 1e-4);
		motion = &acting.character->motion;
		size *= axis == 1 ? 1.0f : 0.25f;
		assert_near(motion->height_m, size, 1e-4);
		assert_near(motion->near_m, 0.025f * size, 1e-5);
		acting_end(&acting);
	}
}

static void test_the_sizes_at_the_limits_are_likely(void **state)
{
	static const float sizes[] = {0.3f, 10};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct acting acting;

		begin_pair(&acting, (float[3]){0}, (float[]){0, 0, sizes[i]});
		acting_expect(&acting, "[state a]\nclip = rest\n");
		assert_near(acting.character->metre, 1, 0);
		acting_end(&acting);
	}
}

static void test_without_words_about_it_nothing_moves_the_ground(void **state)
{
	const struct character_motion *motion;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "[state a]\nclip = rest\n");
	motion = &acting.character->motion;
	assert_int_equal(motion->root, -1);
	assert_int_equal(motion->foot[0], -1);
	assert_int_equal(motion->foot[1], -1);
	assert_int_equal(motion->planted, -1);
	assert_null(motion->speed);
	assert_false(motion->by_clips);
	acting_expect(&acting,
		"[parameter v]\n[state a]\nclip = rest\n[motion]\n"
		"root = hips\nfeet = foot.L foot.R\nspeed = v\nclips = yes\n");
	motion = &acting.character->motion;
	assert_int_equal(motion->root, model_find_node(acting.model, "hips"));
	assert_int_equal(
		motion->foot[0], model_find_node(acting.model, "foot.L"));
	assert_int_equal(
		motion->foot[1], model_find_node(acting.model, "foot.R"));
	assert_ptr_equal(motion->speed, &acting.character->parameter[0].value);
	assert_true(motion->by_clips);
	acting_end(&acting);
}

static void test_a_target_is_where_its_lines_say(void **state)
{
	const struct character_target *target;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter p]\n[target plain]\n[target t]\nplace = 1 p -3\n"
		"node = head\nradius = 0.5\ncolor = 0.1 0.2 0.3\n"
		"[target c]\ncamera = yes\n");
	assert_int_equal(acting.character->target_count, 3);
	target = acting.character->target;
	assert_string_equal(target[1].name, "t");
	assert_near(*target[1].place[0], 1, 0);
	assert_ptr_equal(
		target[1].place[1], &acting.character->parameter[0].value);
	assert_near(*target[1].place[2], -3, 0);
	assert_int_equal(target[1].node, model_find_node(acting.model, "head"));
	assert_near(target[1].radius_m, 0.5, 0);
	assert_all_near(target[1].color, ((float[]){0.1f, 0.2f, 0.3f}), 3, 1e-6);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(target[i].is_camera, i == 2);
	}
	assert_near(target[0].radius_m, 0, 0);
	acting_end(&acting);
}

/* There are at most eight. */
static void test_outputs_know_where_the_file_names_them(void **state)
{
	char text[512] = "[state a]\nclip = rest\n";
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int i = 0; i < 9; i++) {
		const struct character_output *output;
		size_t length = strlen(text);

		snprintf(text + length, sizeof(text) - length,
			"[output o%d]\nline = gpiochip0/%d\n", i, i + 3);
		acting_read(&acting, text);
		if (i == 8) {
			assert_int_equal(acting.error, -EINVAL);
			assert_contains(acting.logged.sentence[0],
				"test.character:19: [output o8]: a character has at most 8 outputs");
			break;
		}
		assert_int_equal(acting.error, 0);
		assert_int_equal(acting.character->output_count, i + 1);
		output = &acting.character->output[i];
		assert_int_equal(output->name[0], 'o');
		assert_int_equal(output->name[1], '0' + i);
		snprintf(text + sizeof(text) - 32, 32, "gpiochip0/%d", i + 3);
		assert_string_equal(output->line, text + sizeof(text) - 32);
		assert_string_equal(output->file, "test.character");
		assert_int_equal(output->number, 4 + 2 * i);
	}
	acting_end(&acting);
}

static void test_a_scene_is_as_its_lines_say(void **state)
{
	static const float right_angle = 1.57079633f;
	const struct character_scene *scene;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter p]\n[state a]\nclip = rest\n[scene]\nwaves = p\n"
		"yaw = -90\npitch = 45\nmargin = 2\nzoom = 0.25\nshadow = p\n"
		"relief = no\nlabels = right\nperiod = 7.5\n");
	scene = &acting.character->scene;
	assert_ptr_equal(scene->wave_m, &acting.character->parameter[0].value);
	assert_ptr_equal(scene->shadow, &acting.character->parameter[0].value);
	assert_near(*scene->relief, 0, 0);
	assert_near(scene->yaw_rad, -right_angle, 1e-6);
	assert_near(scene->pitch_rad, right_angle / 2, 1e-6);
	assert_near(scene->margin, 2, 0);
	assert_near(scene->zoom, 0.25, 0);
	assert_int_equal(scene->labels, CHARACTER_LABELS_RIGHT);
	assert_near(scene->tour_s, 7.5, 0);
	assert_null(scene->tour);
	acting_expect(&acting,
		"[state a]\nclip = rest\n[scene]\nshadow = no\nrelief = yes\n");
	scene = &acting.character->scene;
	assert_near(*scene->shadow, 0, 0);
	assert_near(*scene->relief, 1, 0);
	assert_near(scene->zoom, 1, 0);
	assert_near(scene->tour_s, 0, 0);
	acting_end(&acting);
}

/* A file may say otherwise than the one that it includes. */
static void test_a_shadow_that_another_file_hides_is_shown(void **state)
{
	static const char hides[] = "[scene]\nshadow = no\nrelief = yes\n",
			  shows[] = "include = hides.character\n[scene]\n"
				    "shadow = yes\nrelief = no\n";
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");
	struct acting acting;

	(void)state;
	file_write(path_join(&folder, "hides.character").text, hides,
		strlen(hides));
	file_write(path.text, shows, strlen(shows));
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, path.text);
	assert_int_equal(acting.error, 0);
	assert_near(*acting.character->scene.shadow, 1, 0);
	assert_near(*acting.character->scene.relief, 0, 0);
	acting_end(&acting);
	temp_dir_remove(&folder);
}

/* Sorted by their times; those of one time keep their order. */
static void test_the_lines_of_a_tour_follow_each_other(void **state)
{
	static const struct {
		double time_s;
		enum button button;
		float amount;
	} wanted[] = {{0, BUTTON_COUNT, 3}, {1, BUTTON_COUNT, 2},
		{1, BUTTON_DOWN, 0}, {1, BUTTON_COUNT, 4},
		{2.5, BUTTON_COUNT, 1}};
	const struct character_tour *one;
	struct acting acting;
	size_t count = 0;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 9\n[state a]\nclip = rest\n[scene]\n"
		"tour = 2.5 set v 1, pause\ntour = 1 set v 2\ntour = 1 DOWN\n"
		"tour = 0 set v 3\ntour = 1 set v 4\n"
		"[buttons]\nUP = pause\nDOWN long = labels\nDOWN = tour\n");
	for (one = acting.character->scene.tour; one; one = one->next) {
		assert_true(count < ARRAY_COUNT(wanted));
		assert_near(one->time_s, wanted[count].time_s, 0);
		assert_int_equal(one->button, wanted[count].button);
		assert_int_equal(one->action != NULL, wanted[count].amount > 0);
		if (one->action) {
			assert_near(
				one->action->amount, wanted[count].amount, 0);
			assert_int_equal(one->action->next != NULL, count == 4);
		}
		count++;
	}
	assert_int_equal(count, ARRAY_COUNT(wanted));
	/* It begins again two seconds after its last line. */
	assert_near(acting.character->scene.tour_s, 4.5, 0);
	acting_read(&acting, "[scene]\ntour = -0.1 pause\n");
	assert_int_equal(acting.error, -EINVAL);
	/* It presses one button at a time. */
	acting_read(&acting,
		"[scene]\ntour = 1 UP DOWN\n[buttons]\nUP = pause\n"
		"DOWN = tour\n");
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(acting.logged.sentence[0], "DOWN is too much");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_skeleton_of_an_unlikely_size_has_another_metre),
		cmocka_unit_test(test_the_sizes_at_the_limits_are_likely),
		cmocka_unit_test(
			test_without_words_about_it_nothing_moves_the_ground),
		cmocka_unit_test(test_a_target_is_where_its_lines_say),
		cmocka_unit_test(test_outputs_know_where_the_file_names_them),
		cmocka_unit_test(test_a_scene_is_as_its_lines_say),
		cmocka_unit_test(test_a_shadow_that_another_file_hides_is_shown),
		cmocka_unit_test(test_the_lines_of_a_tour_follow_each_other),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
