/* The duel's contenders compared with the figures of `limber compare`. */
#include "app/compare/candidate/candidate_error.h"
#include "app/compare/measure/sampling.h"
#include "app/demo/actor.h"
#include "app/demo/duel/contender.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

struct bench {
	struct compared_clip of;
	struct demo_env env;
	struct contender contender;
};

static const char path[] = "assets/walker.glb";

static void begin(struct bench *bench, enum contender_kind kind)
{
	memset(bench, 0, sizeof(*bench));
	compared_clip_begin(&bench->of, path, "walk");
	bench->env = (struct demo_env){.log = &bench->of.log,
		.kernel = &kernel_float,
		.model_path = path};
	assert_int_equal(
		contender_init(&bench->contender, kind, bench->of.reference,
			&bench->of.screen, &bench->of.grid, &bench->env),
		0);
	assert_int_equal(contender_bake(&bench->contender, &bench->of.screen,
				 &bench->of.grid, 0.5f, &bench->env),
		0);
}

static void end(struct bench *bench)
{
	contender_finish(&bench->contender);
	compared_clip_end(&bench->of);
}

static float largest_error(struct bench *bench, float full_px)
{
	float peak_px = 0.0f;

	for (int f = 0; f < bench->of.grid.count; f++) {
		float at_s = bench->of.grid.time_s[f];

		contender_pose(&bench->contender, at_s);
		reference_pose(bench->of.reference, at_s, false);
		contender_measure_error(
			&bench->contender, &bench->of.screen, full_px);
		if (bench->contender.peak_px > peak_px) {
			peak_px = bench->contender.peak_px;
		}
	}
	return peak_px;
}

static void agrees(enum contender_kind kind)
{
	struct candidate_error error;
	struct bench bench;
	float shown_px;

	begin(&bench, kind);
	shown_px = largest_error(&bench, 4.0f);
	assert_int_equal(candidate_error_measure(&bench.contender.candidate,
				 &bench.of.screen, &bench.of.grid,
				 SAMPLING_NORMALS_MAX, NULL, &error),
		0);
	/* The figure shown is posed at the grid's moments alone. */
	assert_true(shown_px <= error.peak_px + 2e-3f);
	contender_pose(&bench.contender, error.peak_s);
	reference_pose(bench.of.reference, error.peak_s, false);
	contender_measure_error(&bench.contender, &bench.of.screen, 4.0f);
	assert_near(bench.contender.peak_px, error.peak_px, 2e-3);
	assert_true(bench.contender.candidate.bytes.shared +
			bench.contender.candidate.bytes.own >
		100000);
	end(&bench);
}

static void test_the_skin_shown_is_as_far_off_as_measured(void **state)
{
	(void)state;
	agrees(CONTENDER_SKIN);
}

static void test_the_morph_shown_is_as_far_off_as_measured(void **state)
{
	(void)state;
	agrees(CONTENDER_MORPH);
}

static void test_the_rigid_parts_shown_are_as_far_off_as_measured(void **state)
{
	(void)state;
	agrees(CONTENDER_RIGID);
}

static void test_rigid_parts_keep_every_triangle(void **state)
{
	struct bench bench;
	int corners = 0, wanted = 0;

	(void)state;
	begin(&bench, CONTENDER_RIGID);
	for (int i = 0; i < bench.contender.shown->drawable_count; i++) {
		corners +=
			bench.contender.shown->drawable[i].primitive->index_count;
	}
	for (int i = 0; i < bench.of.reference->instance->drawable_count; i++) {
		wanted += bench.of.reference->instance->drawable[i]
				  .primitive->index_count;
	}
	assert_int_equal(corners, wanted);
	end(&bench);
}

static void test_heat_is_red_where_a_part_is_far_off(void **state)
{
	struct bench bench;
	int red = 0, blue = 0;

	(void)state;
	begin(&bench, CONTENDER_RIGID);
	largest_error(&bench, 1.0f);
	overlay_heat_switch(&bench.contender.heat, true);
	for (int i = 0; i < bench.contender.shown->drawable_count; i++) {
		const struct drawable *d = &bench.contender.shown->drawable[i];

		for (int v = 0; v < d->primitive->vertex_count; v++) {
			const uint8_t *rgb = d->batch[0].color[v];

			red += rgb[0] > 200 && rgb[1] < 100;
			blue += rgb[0] < 80 && rgb[2] > 180;
		}
	}
	assert_true(red > 20);
	assert_true(blue > 1000);
	assert_ptr_equal(
		bench.contender.shown->model, &bench.contender.heat.plain);
	overlay_heat_switch(&bench.contender.heat, false);
	assert_ptr_equal(bench.contender.shown->model, bench.contender.baked);
	end(&bench);
}

/* Each frame takes a millisecond more than the one before. */
static int64_t later_each_time(void)
{
	static int64_t now_ns, frames;

	return now_ns += ++frames % 2 ? 0 : 500000 * frames;
}

static void test_times_are_means_by_the_clock_it_is_given(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, CONTENDER_SKIN);
	contender_pose(&bench.contender, 0.1f);
	assert_true(bench.contender.ms < 0.0f);
	bench.contender.now_ns = later_each_time;
	contender_pose(&bench.contender, 0.2f);
	assert_near(bench.contender.ms, 1.0, 1e-6);
	/* Then the means of 16 frames: of 2 to 17 ms, and of 18 to 33 ms. */
	for (int i = 1; i <= 32; i++) {
		contender_pose(&bench.contender, 0.2f);
		assert_near(bench.contender.ms,
			i < 16           ? 1.0
				: i < 32 ? 9.5
					 : 25.5,
			1e-4);
	}
	end(&bench);
}

static void test_buttons_run_through_the_duel(void **state)
{
	static const struct demo_press presses[] = {{0.1, BUTTON_F8},
		{0.2, BUTTON_UP}, {0.3, BUTTON_F6}, {0.4, BUTTON_ENTER},
		{0.5, BUTTON_LEFT}, {0.6, BUTTON_DOWN}, {0.7, BUTTON_F9}};
	struct demo_run run;

	(void)state;
	demo_run_begin(&run, "duel");
	demo_run_to(&run, 1.0, 10, presses, (int)ARRAY_COUNT(presses));
	demo_run_draw(&run);
	assert_true(gl_recorder_result()->vertex_count > 10000);
	assert_true(demo_get_facts(run.driver, run.demo).triangles > 3 * 3000);
	demo_run_end(&run);
}

/*
 * The figure in the middle stays in the middle of a picture that shows it as
 * large as at the beginning, however far it goes.
 */
static void expect_followed(const struct demo_driver *duel, struct demo *demo)
{
	const struct camera *camera =
		&((const struct demo_base *)demo)->stage.camera;
	float first = 0.0f, from[3], way = 0.0f;

	for (int step = 1; step <= 20; step++) {
		struct overlay_figure figure;
		struct bounds box;
		float at[3], extent;

		duel->update(demo, 0.15 * step);
		assert_true(duel->get_figure(demo, 1, &figure));
		box = bounds_of_instance(figure.instance);
		bounds_center(&box, at);
		extent = bounds_extent(&box);
		if (step == 1) {
			first = camera->distance;
			memcpy(from, at, sizeof(from));
		}
		for (int i = 0; i < 3; i++) {
			assert_near(camera->target[i], at[i], extent);
			way = fmaxf(way, fabsf(at[i] - from[i]) / extent);
		}
		assert_near(camera->distance, first, 1e-3f * first);
	}
	assert_true(way > 6.0f);
}

/* What a duel uses for as long as it lives. */
struct around {
	struct log_capture heard;
	struct log log;
	struct gl gl;
};

/* Creates the duel of a clip of a model of the fixtures; NULL: of its walk. */
static int create_duel(const char *model_path, const char *clip,
	struct around *around, struct demo **demo)
{
	const struct demo_env env = {.log = &around->log,
		.gl = &around->gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 480,
		.height = 640,
		.model_path = model_path,
		.character = "none",
		.clip = clip,
		.repeat = CLIP_LOOP,
		.speed = 1.0f};

	around->log = log_capture_begin(&around->heard);
	around->gl = gl_recorder_begin();
	return demo_create(demo_find("duel"), &env, demo);
}

/*
 * Whether the duel begins with a model of the fixtures. If it does, the camera
 * has to follow the model.
 */
static int begin_with(const char *model_path, struct around *around)
{
	const struct demo_driver *duel = demo_find("duel");
	struct demo *demo;
	int error = create_duel(model_path, NULL, around, &demo);

	if (!error) {
		expect_followed(duel, demo);
		demo_destroy(duel, demo);
	}
	return error;
}

static void test_it_follows_a_model_and_needs_clips_and_triangles(void **state)
{
	struct around around;

	(void)state;
	/* Its first clip is its walk. */
	assert_int_equal(
		begin_with("tests/fixtures/gltf/clip/far.gltf", &around), 0);
	assert_int_equal(log_capture_count(&around.heard, LOG_ERROR), 0);
	assert_int_equal(
		begin_with("tests/fixtures/gltf/mesh/weights.gltf", &around),
		-EINVAL);
	assert_true(
		log_capture_has(&around.heard, LOG_ERROR, "has no clip: give"));
	assert_int_equal(
		begin_with("tests/fixtures/gltf/scene/matrices.gltf", &around),
		-EINVAL);
	assert_true(log_capture_has(
		&around.heard, LOG_ERROR, "has no triangles: give"));
}

static void test_a_morph_that_turns_inside_out_is_told(void **state)
{
	static const char turned[] = "tests/fixtures/gltf/clip/mirror.gltf";
	static const char *const clips[] = {"mirrored", "turning"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct around around;
		struct demo *demo;

		assert_int_equal(
			create_duel(turned, clips[i], &around, &demo), 0);
		assert_int_equal(log_capture_has(&around.heard, LOG_WARNING,
					 "clip 1 turns a surface inside out"),
			i == 1);
		demo_destroy(demo_find("duel"), demo);
	}
}

/* Its keys are at 1/24, 1/2 and 1 s, of which the second moves it by 1. */
static void test_a_loop_of_blender_does_not_pause(void **state)
{
	static const float lead_s = 1 / 24.0f;
	const struct demo_driver *duel = demo_find("duel");
	struct around around;
	struct demo *demo;

	(void)state;
	assert_int_equal(create_duel("tests/fixtures/gltf/clip/frame_one.gltf",
				 NULL, &around, &demo),
		0);
	for (int round = 0; round < 3; round++) {
		struct overlay_motion motion = overlay_motion_none();
		float at_s = round == 0 ? 0.02f : lead_s + 0.02f * (1 - lead_s);
		float place = round == 0 ? 0 : (at_s - lead_s) / (0.5f - lead_s);

		duel->update(demo, round + 0.02);
		duel->get_motion(demo, &motion);
		assert_near(motion.time_s, at_s, 1e-5);
		for (int i = 0; i < CONTENDER_KINDS; i++) {
			struct overlay_figure figure;
			float at[3];

			assert_true(duel->get_figure(demo, i, &figure));
			instance_world_vertex(figure.instance,
				&figure.instance->drawable[0], 0, at);
			assert_near(at[0], place, 1e-4);
		}
	}
	demo_destroy(duel, demo);
}

static bool are_equal(const struct hud *a, const struct hud *b)
{
	return a->quad_count == b->quad_count &&
		memcmp(a->vertex, b->vertex,
			(size_t)a->quad_count * 4 * sizeof(a->vertex[0])) == 0;
}

/* Errors are painted red from 4 pixels on at first, then from 1 to 16. */
static void test_the_scale_of_errors_has_five_steps(void **state)
{
	static const struct demo_press presses[] = {{0.1, BUTTON_F8},
		{0.1, BUTTON_ENTER}, {1.0, BUTTON_DOWN}, {2.0, BUTTON_DOWN},
		{3.0, BUTTON_DOWN}, {4.0, BUTTON_UP}, {5.0, BUTTON_UP},
		{6.0, BUTTON_UP}, {7.0, BUTTON_UP}, {8.0, BUTTON_UP}};
	static const int steps[] = {2, 1, 0, 0, 1, 2, 3, 4, 4};
	static struct hud board[ARRAY_COUNT(steps)];
	struct demo_run run;

	(void)state;
	demo_run_begin(&run, "duel");
	for (size_t i = 0; i < ARRAY_COUNT(steps); i++) {
		board[i].font = &font_default;
		hud_begin(&board[i], 480, 640);
		demo_run_to(&run, 0.9 + (double)i, 10, presses,
			(int)ARRAY_COUNT(presses));
		run.driver->label(run.demo, &board[i]);
		for (size_t k = 0; k < i; k++) {
			assert_int_equal(are_equal(&board[i], &board[k]),
				steps[i] == steps[k]);
		}
	}
	/* 16 has a digit more than the others. */
	assert_int_equal(board[2].quad_count, board[0].quad_count);
	assert_int_equal(board[7].quad_count, board[0].quad_count + 1);
	demo_run_end(&run);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_skin_shown_is_as_far_off_as_measured),
		cmocka_unit_test(test_the_morph_shown_is_as_far_off_as_measured),
		cmocka_unit_test(
			test_the_rigid_parts_shown_are_as_far_off_as_measured),
		cmocka_unit_test(test_rigid_parts_keep_every_triangle),
		cmocka_unit_test(test_heat_is_red_where_a_part_is_far_off),
		cmocka_unit_test(test_times_are_means_by_the_clock_it_is_given),
		cmocka_unit_test(test_the_scale_of_errors_has_five_steps),
		cmocka_unit_test(test_a_morph_that_turns_inside_out_is_told),
		cmocka_unit_test(test_a_loop_of_blender_does_not_pause),
		cmocka_unit_test(
			test_it_follows_a_model_and_needs_clips_and_triangles),
		cmocka_unit_test(test_buttons_run_through_the_duel),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
