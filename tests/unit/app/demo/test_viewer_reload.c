/* The viewer reloads a changed file. */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/model/model_file.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct bench {
	struct log log;
	struct gl gl;
	struct test_path folder, path;
	struct demo *demo;
	double now_s;
};

static void put(const struct bench *bench, const void *data, size_t size)
{
	file_write(bench->path.text, data, size);
}

static void put_model(const struct bench *bench, const char *asset)
{
	struct model_file file;

	assert_int_equal(model_file_read(asset, NULL, &bench->log, &file), 0);
	put(bench, file.data, file.size);
	model_file_release(&file);
}

static void run_to(struct bench *bench, double time_s)
{
	while (bench->now_s < time_s) {
		bench->now_s += 0.05;
		demo_driver_viewer.update(bench->demo, bench->now_s);
	}
}

static long triangles(const struct bench *bench)
{
	return demo_get_facts(&demo_driver_viewer, bench->demo).triangles;
}

static const struct model *model_of(const struct bench *bench)
{
	return ((const struct demo_base *)bench->demo)->actor.model;
}

static struct bench *begin_bench_as(
	bool follow, const char *clip, const char *character)
{
	struct bench *bench = calloc(1, sizeof(*bench));
	struct demo_env env;

	assert_non_null(bench);
	bench->log = log_to_stderr(LOG_ERROR);
	bench->gl = gl_recorder_begin();
	bench->folder = temp_dir_make();
	bench->path = path_join(&bench->folder, "followed.glb");
	put_model(bench, "assets/walker.glb");
	if (character) {
		struct test_path path =
			path_join(&bench->folder, "followed.character");

		file_write(path.text, character, strlen(character));
	}
	env = (struct demo_env){
		.log = &bench->log,
		.gl = &bench->gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 240,
		.height = 320,
		.model_path = bench->path.text,
		.clip = clip,
		.repeat = CLIP_LOOP,
		.speed = 1.0f,
		.follow_file = follow,
	};
	assert_int_equal(
		demo_create(&demo_driver_viewer, &env, &bench->demo), 0);
	return bench;
}

static struct bench *begin_bench(bool follow)
{
	return begin_bench_as(follow, "walk", NULL);
}

static void end_bench(struct bench *bench)
{
	demo_destroy(&demo_driver_viewer, bench->demo);
	temp_dir_remove(&bench->folder);
	free(bench);
}

static void test_a_new_file_is_shown_at_the_same_clip_and_time(void **state)
{
	struct bench *bench = begin_bench(true);
	struct bench *other = begin_bench(true);
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	const struct demo_base *same = (const struct demo_base *)other->demo;
	const struct model *old;

	(void)state;
	old = model_of(bench);
	run_to(bench, 1.5);
	run_to(other, 1.5);
	put_model(bench, "assets/walker.glb");
	run_to(bench, 4.3);
	run_to(other, 4.3);
	assert_ptr_not_equal(model_of(bench), old);
	for (int v = 0; v < 100; v++) {
		float a[3], b[3];

		instance_world_vertex(base->actor.instance,
			&base->actor.instance->drawable[0], v, a);
		instance_world_vertex(same->actor.instance,
			&same->actor.instance->drawable[0], v, b);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(a[axis], b[axis], 1e-4);
		}
	}
	end_bench(other);
	end_bench(bench);
}

static void test_overlays_are_shown_for_the_new_model(void **state)
{
	struct bench *bench = begin_bench(true);
	const struct demo_base *base = (const struct demo_base *)bench->demo;

	(void)state;
	demo_show_next_overlay(&demo_driver_viewer, bench->demo);
	demo_draw(&demo_driver_viewer, bench->demo, 240, 320);
	put_model(bench, "assets/arm.glb");
	run_to(bench, 4.3);
	assert_null(base->overlay);
	demo_draw(&demo_driver_viewer, bench->demo, 240, 320);
	assert_non_null(base->overlay);
	assert_ptr_equal(base->overlay->subject.instance, base->actor.instance);
	assert_true(overlay_shows(base->overlay, OVERLAY_SKELETON));
	end_bench(bench);
}

/* Hills that come with the feet are there at once. */
static void test_the_first_picture_has_the_hills(void **state)
{
	struct bench *bench = begin_bench_as(true, NULL,
		"[state a]\nclip = walk\n[scene]\nwaves = 0.1\n"
		"[feet f]\nhips = hips\nleft = thigh.L shin.L foot.L\n"
		"right = thigh.R shin.R foot.R\n");
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	float first;

	(void)state;
	demo_driver_viewer.update(bench->demo, 0.0);
	first = base->stage.floor.wave_height;
	assert_true(first > 0.0f);
	run_to(bench, 1.0);
	assert_near(base->stage.floor.wave_height, first, 0.0);
	end_bench(bench);
}

static void put_character(
	const struct bench *bench, const char *name, const char *text)
{
	struct test_path path = path_join(&bench->folder, name);

	file_write(path.text, text, strlen(text));
}

/* How the right arm is turned shows which file acts. */
static float arm_turn(const struct bench *bench)
{
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	int arm = model_find_node(base->actor.model, "upper_arm.R");

	return base->actor.instance->pose.local[arm].rotation[2];
}

static void test_a_changed_character_file_is_read_anew(void **state)
{
	struct bench *bench =
		begin_bench_as(true, NULL, "[state a]\nclip = rest\n");
	float rest, lifted;

	(void)state;
	run_to(bench, 1.0);
	rest = arm_turn(bench);
	put_character(bench, "followed.character",
		"[state a]\nclip = rest\n[turn b]\nbone = upper_arm.R\n"
		"axis = 0 0 1\nangle = 40\n");
	run_to(bench, 4.3);
	lifted = arm_turn(bench);
	assert_true(fabsf(lifted - rest) > 0.05f);
	/* A broken file leaves the one before in place. */
	put_character(bench, "followed.character", "[state a]\nclip = none\n");
	run_to(bench, 7.5);
	assert_near(arm_turn(bench), lifted, 1e-6);
	put_character(bench, "followed.character", "[state a]\nclip = rest\n\n");
	run_to(bench, 10.5);
	assert_near(arm_turn(bench), rest, 1e-6);
	end_bench(bench);
}

/* A check a second, two of which have to see the same file. */
static void test_a_file_is_reloaded_once_it_has_not_changed_for_a_second(
	void **state)
{
	struct bench *bench = begin_bench(true);
	const struct model *old = model_of(bench);

	(void)state;
	run_to(bench, 1.5);
	put_model(bench, "assets/walker.glb");
	run_to(bench, 2.8);
	put_model(bench, "assets/walker.glb");
	run_to(bench, 3.9);
	assert_ptr_equal(model_of(bench), old);
	run_to(bench, 4.4);
	assert_ptr_not_equal(model_of(bench), old);
	old = model_of(bench);
	run_to(bench, 9.0);
	assert_ptr_equal(model_of(bench), old);
	end_bench(bench);
}

/* A triangle whose longest side is this long, and which is so high. */
static void put_triangle(const struct bench *bench, double side, double height)
{
	char nodes[120];

	snprintf(nodes, sizeof(nodes),
		"{\"mesh\":0,\"scale\":[%g,%g,%g],\"translation\":[0,%g,0]}",
		side, side, side, height);
	triangle_file_write(bench->path.text, nodes);
}

/* The stage stays for what is a little larger or smaller. */
static void test_a_model_of_another_size_gets_a_stage_of_its_own(void **state)
{
	static const struct {
		double ratio;
		bool stays;
	} changes[] = {{1.24, true}, {1.26, false}, {0.81, true}, {0.79, false},
		{10, false}, {0.1, false}};
	struct bench *bench =
		begin_bench_as(true, NULL, "[state a]\nclip = rest\n");
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	double side = 1.0;

	(void)state;
	run_to(bench, 0.5);
	put_triangle(bench, side, 0.0);
	run_to(bench, 3.5);
	assert_near(base->actor.extent, side, 1e-6);
	for (size_t i = 0; i < ARRAY_COUNT(changes); i++) {
		const float before = base->stage.camera.radius;

		side *= changes[i].ratio;
		put_triangle(bench, side, 0.0);
		run_to(bench, bench->now_s + 3.0);
		assert_near(base->actor.extent, side, 1e-5);
		assert_int_equal(
			base->stage.camera.radius == before, changes[i].stays);
	}
	end_bench(bench);
}

/* The floor stays where the model rose or sank by less than a two hundredth. */
static void test_a_model_at_another_height_gets_a_floor_of_its_own(void **state)
{
	static const double sides[] = {0.2, 8.0};
	static const struct {
		double rise;
		bool stays;
	} changes[] = {{0.9, true}, {1.1, false}, {-0.9, true}, {-1.1, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		struct bench *bench =
			begin_bench_as(true, NULL, "[state a]\nclip = rest\n");
		const struct demo_base *base =
			(const struct demo_base *)bench->demo;
		double height = 0.0;

		run_to(bench, 0.5);
		put_triangle(bench, sides[i], height);
		run_to(bench, 3.5);
		for (size_t j = 0; j < ARRAY_COUNT(changes); j++) {
			const float before = base->stage.floor.y;

			height += changes[j].rise * sides[i] / 200.0;
			put_triangle(bench, sides[i], height);
			run_to(bench, bench->now_s + 3.0);
			assert_int_equal(base->stage.floor.y == before,
				changes[j].stays);
		}
		end_bench(bench);
	}
}

static void test_a_label_says_that_the_new_file_is_broken(void **state)
{
	struct bench *bench =
		begin_bench_as(true, NULL, "[state a]\nclip = rest\n");
	static struct hud shown, wanted;
	struct hud *const both[] = {&shown, &wanted};
	struct hud_group group;

	(void)state;
	bench->log = log_to_nowhere();
	for (int i = 0; i < 2; i++) {
		both[i]->font = &font_default;
		hud_begin(both[i], 240, 320);
	}
	run_to(bench, 1.5);
	demo_driver_viewer.label(bench->demo, &wanted);
	group = hud_group_begin(&wanted, HUD_BOTTOM_LEFT, NULL);
	hud_group_mark(&group, "new file is broken", "", hud_color_rose);
	hud_group_end(&group);
	put(bench, "glTF, but not really", 20);
	run_to(bench, 4.0);
	demo_driver_viewer.label(bench->demo, &shown);
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)shown.quad_count * 4 * sizeof(shown.vertex[0]));
	put_model(bench, "assets/walker.glb");
	run_to(bench, 7.0);
	hud_begin(&shown, 240, 320);
	demo_driver_viewer.label(bench->demo, &shown);
	assert_true(shown.quad_count < wanted.quad_count);
	end_bench(bench);
}

/*
 * What an unattended run repeats: the tour, the clip as it is played, or else a
 * second.
 */
static void test_a_run_repeats_after_its_tour_or_its_clip(void **state)
{
	static const struct {
		const char *clip, *character;
		double period_s, walks;
	} runs[] = {{"walk", NULL, 0.0, 1.0},
		{NULL, "[state a]\nclip = rest\n", 1.0, 0.0},
		{NULL, "[state a]\nclip = walk\nrate = 0\n", 1.0, 0.0},
		{NULL, "[state a]\nclip = walk\nrate = -2\n", 0.0, 0.5},
		{NULL, "[state a]\nclip = walk\nrepeat = ping-pong\n", 0.0, 2.0},
		{NULL, "[scene]\nperiod = 7\n[state a]\nclip = walk\n", 7.0, 0.0},
		{NULL, "[scene]\nperiod = 0.5\n[state a]\nclip = walk\n", 0.5,
			0.0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(runs); i++) {
		struct bench *bench =
			begin_bench_as(false, runs[i].clip, runs[i].character);
		const struct model *model = model_of(bench);
		const double walk_s =
			(double)model->clip[model_find_clip(model, "walk")]
				.duration_s;

		assert_near(demo_driver_viewer.period_s(bench->demo),
			runs[i].period_s + runs[i].walks * walk_s, 1e-6);
		end_bench(bench);
	}
}

static void test_another_model_takes_its_place(void **state)
{
	struct bench *bench = begin_bench(true);
	long before = triangles(bench);

	(void)state;
	run_to(bench, 1.5);
	put_model(bench, "assets/arm.glb");
	run_to(bench, 4.0);
	assert_true(triangles(bench) != before);
	demo_driver_viewer.draw(bench->demo, 240, 320);
	end_bench(bench);
}

/* The governor says what to leave out only when that changes. */
static void test_a_new_file_is_reduced_as_the_old_one_was(void **state)
{
	const struct demo_reduction reduction = {
		.max_influences = 1, .error_px = 3.0f, .hold_normals = true};
	struct bench *bench = begin_bench(true);
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	const struct model *old = model_of(bench);

	(void)state;
	demo_set_reduction(bench->demo, &reduction);
	run_to(bench, 1.5);
	put_model(bench, "assets/walker.glb");
	run_to(bench, 4.0);
	assert_ptr_not_equal(model_of(bench), old);
	assert_int_equal(base->actor.influence_limit, 1);
	assert_near(base->actor.min_error_px, 3.0, 0.0);
	assert_true(base->actor.instance->hold_normals);
	end_bench(bench);
}

/* Also if the new model is of another size, so that the stage is made anew. */
static void test_the_row_of_shapes_has_room_below_the_new_model(void **state)
{
	struct bench *bench = begin_bench(true);
	const struct demo_base *base = (const struct demo_base *)bench->demo;
	static const char *const models[] = {
		"assets/face.glb", "tests/fixtures/gltf/mesh/weights.gltf"};

	(void)state;
	run_to(bench, 1.5);
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct overlay_row row;

		put_model(bench, models[i]);
		run_to(bench, bench->now_s + 2.5);
		while (!base->overlay ||
			!overlay_shows(base->overlay, OVERLAY_KEYS)) {
			demo_show_next_overlay(&demo_driver_viewer, bench->demo);
		}
		demo_draw(&demo_driver_viewer, bench->demo, 240, 320);
		row = overlay_row_of(base->overlay, 240, 320);
		assert_true(base->stage.camera.fit.region.bottom >=
			2.0f * (float)row.height / 320.0f - 1.0f);
	}
	end_bench(bench);
}

static void test_a_broken_file_leaves_the_old_one(void **state)
{
	struct bench *bench = begin_bench(true);
	const struct model *old = model_of(bench);

	(void)state;
	run_to(bench, 1.5);
	put(bench, "glTF, but not really", 20);
	run_to(bench, 6.0);
	assert_ptr_equal(model_of(bench), old);
	unlink(bench->path.text);
	run_to(bench, 9.0);
	assert_ptr_equal(model_of(bench), old);
	put_model(bench, "assets/walker.glb");
	run_to(bench, 12.0);
	assert_ptr_not_equal(model_of(bench), old);
	end_bench(bench);
}

static void test_a_file_that_is_not_followed_is_left_alone(void **state)
{
	struct bench *bench = begin_bench(false);
	const struct model *old = model_of(bench);

	(void)state;
	run_to(bench, 1.5);
	put_model(bench, "assets/arm.glb");
	run_to(bench, 5.0);
	assert_ptr_equal(model_of(bench), old);
	end_bench(bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_new_file_is_shown_at_the_same_clip_and_time),
		cmocka_unit_test(test_overlays_are_shown_for_the_new_model),
		cmocka_unit_test(test_the_first_picture_has_the_hills),
		cmocka_unit_test(test_a_changed_character_file_is_read_anew),
		cmocka_unit_test(
			test_a_file_is_reloaded_once_it_has_not_changed_for_a_second),
		cmocka_unit_test(
			test_a_model_of_another_size_gets_a_stage_of_its_own),
		cmocka_unit_test(
			test_a_model_at_another_height_gets_a_floor_of_its_own),
		cmocka_unit_test(test_a_label_says_that_the_new_file_is_broken),
		cmocka_unit_test(test_a_run_repeats_after_its_tour_or_its_clip),
		cmocka_unit_test(test_another_model_takes_its_place),
		cmocka_unit_test(test_a_new_file_is_reduced_as_the_old_one_was),
		cmocka_unit_test(
			test_the_row_of_shapes_has_room_below_the_new_model),
		cmocka_unit_test(test_a_broken_file_leaves_the_old_one),
		cmocka_unit_test(test_a_file_that_is_not_followed_is_left_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
