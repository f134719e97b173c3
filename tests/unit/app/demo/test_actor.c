/* What a demo says of the model that it loads, and the pictures it frames. */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "tests/support/demo_shown.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

/* Loads the model and returns how many warnings and errors that brings. */
static int load(const char *path, size_t memory_bytes,
	struct log_capture *heard, int *error)
{
	struct log log = log_capture_begin(heard);
	struct gl gl = gl_recorder_begin();
	const struct demo_env env = {.log = &log,
		.gl = &gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.model_path = path,
		.memory_bytes = memory_bytes};
	struct actor actor;

	*error = actor_load(&actor, &env);
	if (*error) {
		assert_null(actor.model);
	} else {
		actor_unload(&actor, &gl);
	}
	return log_capture_count(heard, LOG_WARNING) +
		log_capture_count(heard, LOG_ERROR);
}

static void test_a_model_far_from_the_origin_is_named(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "far.gltf");
	struct log_capture heard;
	int error;

	(void)state;
	triangle_file_write(
		path.text, "{\"mesh\":0,\"translation\":[0,0,-31999]}");
	assert_int_equal(load(path.text, 0, &heard, &error), 0);
	/* Two metres long. */
	triangle_file_write(path.text,
		"{\"mesh\":0,\"translation\":[0,0,32001],\"scale\":[2,2,2]}");
	assert_int_equal(load(path.text, 0, &heard, &error), 1);
	assert_int_equal(error, 0);
	assert_true(log_capture_has(&heard, LOG_WARNING,
		"stands 32001 m from the origin, 16000 times its size"));
	temp_dir_remove(&folder);
}

static void test_a_model_without_triangles_is_named(void **state)
{
	struct log_capture heard;
	int error;

	(void)state;
	(void)load("tests/fixtures/gltf/scene/matrices.gltf", 0, &heard, &error);
	assert_int_equal(error, 0);
	assert_true(log_capture_has(
		&heard, LOG_WARNING, "has no triangles, so the stage stays"));
}

static void test_a_model_has_to_fit_its_memory(void **state)
{
	struct log_capture heard;
	int error;

	(void)state;
	assert_int_equal(load("assets/arm.glb", 4096, &heard, &error), 1);
	assert_int_not_equal(error, 0);
	assert_int_equal(load("assets/arm.glb", 0, &heard, &error), 0);
	assert_int_equal(error, 0);
}

static void test_demos_are_found_by_their_names(void **state)
{
	(void)state;
	for (int i = 0; demo_registry[i]; i++) {
		assert_ptr_equal(
			demo_find(demo_registry[i]->name), demo_registry[i]);
	}
	assert_string_equal(demo_registry[0]->name, "walker");
	assert_null(demo_find("walk"));
	assert_null(demo_find("viewer"));
}

/* The lower edge of the region that the figure has. */
static double bottom_of(const struct shown *shown)
{
	return (double)((const struct demo_base *)shown->demo)
		->stage.camera.fit.region.bottom;
}

/* The row of a face's shapes takes the picture's lower edge while it is shown. */
static void test_small_pictures_take_room_below_the_figure(void **state)
{
	static const int sizes[][2] = {{480, 640}, {320, 240}, {640, 120}};

	(void)state;
	for (size_t s = 0; s < ARRAY_COUNT(sizes); s++) {
		const int *size = sizes[s];
		struct shown shown;
		const struct demo_base *base;
		struct overlay_row row;
		double before, room, most;

		shown_begin(&shown, "face", size, false);
		base = (const struct demo_base *)shown.demo;
		demo_draw(shown.driver, shown.demo, size[0], size[1]);
		before = bottom_of(&shown);
		/* A fifth of half the picture is left for the figure. */
		most = (double)base->stage.camera.fit.region.top - before - 0.2;
		while (!base->overlay ||
			!overlay_shows(base->overlay, OVERLAY_KEYS)) {
			demo_show_next_overlay(shown.driver, shown.demo);
		}
		row = overlay_row_of(base->overlay, size[0], size[1]);
		room = fmax(0.0,
			fmin(most, 2.0 * (double)row.height / (double)size[1]));
		for (int i = 0; i < 2; i++) {
			demo_draw(shown.driver, shown.demo, size[0], size[1]);
			assert_near(bottom_of(&shown), before + room, 1e-5);
		}
		while (overlay_shows(base->overlay, OVERLAY_KEYS)) {
			demo_show_next_overlay(shown.driver, shown.demo);
		}
		demo_draw(shown.driver, shown.demo, size[0], size[1]);
		assert_near(bottom_of(&shown), before, 1e-5);
		shown_end(&shown);
	}
}

static void test_only_a_camera_has_uses(void **state)
{
	static const struct camera_feed feed = {0};
	struct shown shown;
	struct live *live;

	(void)state;
	shown_begin(&shown, "arm.glb", (const int[]){320, 240}, false);
	live = &((struct demo_base *)shown.demo)->live;
	demo_next_camera_use(shown.demo);
	assert_int_equal(live->use, LIVE_BACKGROUND);
	live->feed = &feed;
	for (int use = LIVE_BACKGROUND; use < LIVE_USES; use++) {
		assert_int_equal(live->use, use);
		demo_next_camera_use(shown.demo);
	}
	assert_int_equal(live->use, LIVE_BACKGROUND);
	live->feed = NULL;
	shown_end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_model_far_from_the_origin_is_named),
		cmocka_unit_test(test_a_model_without_triangles_is_named),
		cmocka_unit_test(test_a_model_has_to_fit_its_memory),
		cmocka_unit_test(test_demos_are_found_by_their_names),
		cmocka_unit_test(test_small_pictures_take_room_below_the_figure),
		cmocka_unit_test(test_only_a_camera_has_uses),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
