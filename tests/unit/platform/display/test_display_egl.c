#include "platform/display/display.h"
#include "platform/gl/gl_context.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct scene {
	struct test_path folder, calls, library;
	struct log_capture capture;
	struct log log;
	const struct display_driver *driver;
	struct display *display;
	struct gl_context *gl;
};

/* The calls that open EGL 1.4 and 1.0. */
#define BEGUN                                          \
	"GetDisplay 0\nInitialize 1\nBindAPI 0x30a0\n" \
	"ChooseConfig surface 4 renderable 1 bits 5 5 5 depth 16\n"
#define BEGUN_OLD                      \
	"GetDisplay 0\nInitialize 1\n" \
	"ChooseConfig surface 4 renderable -1 bits 5 5 5 depth 16\n"

static void scene_begin(struct scene *scene, const char *library)
{
	*scene = (struct scene){.library = path_beside_program(library)};
	scene->log = log_capture_begin(&scene->capture);
	scene->folder = temp_dir_make();
	scene->calls = path_join(&scene->folder, "calls");
	file_write(scene->calls.text, "", 0);
	setenv("FAKE_GLES_LOG", scene->calls.text, 1);
	unsetenv("FAKE_GLES_SIZE");
	unsetenv("FAKE_GLES_REFUSE");
	unsetenv("FAKE_GLES_RENDERER");
}

static int scene_open(struct scene *scene, const char *spec,
	const char *gl_name, enum pixel_format format)
{
	const struct display_options options = {
		.format_given = true, .format = format, .log = &scene->log};
	struct native_surface surface;
	struct gl_request request = {.format = format,
		.surface = &surface,
		.egl_library = scene->library.text,
		.gles_library = scene->library.text,
		.log = &scene->log};
	int error =
		display_open(spec, &options, &scene->driver, &scene->display);

	if (error) {
		return error;
	}
	scene->driver->get_surface(scene->display, &surface);
	error = gl_open(gl_name, &request, &scene->gl);
	if (error) {
		scene->driver->destroy(scene->display);
	}
	return error;
}

static void scene_draw(struct scene *scene)
{
	assert_int_equal(scene->gl->driver->begin_frame(scene->gl, NULL), 0);
	assert_int_equal(scene->gl->driver->end_frame(scene->gl), 0);
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
}

static void scene_close(struct scene *scene)
{
	scene->gl->driver->destroy(scene->gl);
	scene->driver->destroy(scene->display);
}

/* Checks that exactly these calls were logged, and clears the log. */
static void expect_told(const struct scene *scene, const char *text)
{
	char *calls = file_read(scene->calls.text, NULL);

	assert_string_equal(calls, text);
	free(calls);
	file_write(scene->calls.text, "", 0);
}

static void scene_end(struct scene *scene)
{
	unsetenv("FAKE_GLES_LOG");
	temp_dir_remove(&scene->folder);
}

static void test_frames_are_drawn_on_the_whole_screen(void **state)
{
	struct scene scene;
	struct display_info info;

	(void)state;
	scene_begin(&scene, "fake_gles.so");
	assert_int_equal(scene_open(&scene, "egl", NULL, PIXELS_RGB565), 0);
	expect_told(&scene,
		BEGUN "CreateWindowSurface config 2 window 0x0\n"
		      "CreateContext config 2 version 1\n"
		      "MakeCurrent 7 9\n"
		      "SwapInterval 1\n");
	assert_string_equal(scene.gl->driver->name, "gles1");
	assert_true(scene.gl->accelerated);
	assert_int_equal(scene.gl->width, 48);
	assert_int_equal(scene.gl->height, 64);
	scene.driver->get_info(scene.display, &info);
	assert_int_equal(info.format, PIXELS_RGB565);
	scene_draw(&scene);
	expect_told(&scene,
		"MakeCurrent 7 9\n"
		"Viewport 0 0 48 64\n"
		"SwapBuffers 7\n");
	scene_draw(&scene);
	expect_told(&scene, "MakeCurrent 7 9\nSwapBuffers 7\n");
	scene_close(&scene);
	expect_told(&scene,
		"MakeCurrent 0 0\n"
		"DestroySurface 7\n"
		"DestroyContext 9\n");
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);
	scene_end(&scene);
}

static void test_only_old_calls_are_used_with_an_old_egl(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles_old.so");
	assert_int_equal(scene_open(&scene, "egl", "gles1", PIXELS_RGB565), 0);
	expect_told(&scene,
		BEGUN_OLD "CreateWindowSurface config 2 window 0x0\n"
			  "CreateContext config 2\n"
			  "MakeCurrent 7 9\n");
	scene_draw(&scene);
	scene_close(&scene);
	scene_end(&scene);
}

static void test_a_window_is_named_by_its_number(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles.so");
	assert_int_equal(
		scene_open(&scene, "egl:0x1e00003", "gles1", PIXELS_RGBA8888),
		0);
	expect_told(&scene,
		BEGUN "CreateWindowSurface config 1 window 0x1e00003\n"
		      "CreateContext config 1 version 1\n"
		      "MakeCurrent 7 9\n"
		      "SwapInterval 1\n");
	scene_close(&scene);
	scene_end(&scene);
}

static void test_a_window_must_be_a_number(void **state)
{
	static const char *const specs[] = {
		"egl:main", "egl:-1", "egl:1x", "egl:0x1ffffffffffffffff"};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct scene scene;

		scene_begin(&scene, "fake_gles.so");
		assert_int_equal(
			scene_open(&scene, specs[i], NULL, PIXELS_RGB565),
			-EINVAL);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], specs[i]);
		scene_end(&scene);
	}
}

static void test_the_next_configuration_is_tried(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles_old.so");
	setenv("FAKE_GLES_REFUSE", "1", 1);
	assert_int_equal(scene_open(&scene, "egl", "gles1", PIXELS_RGB565), 0);
	expect_told(&scene,
		BEGUN_OLD "CreateWindowSurface config 2 window 0x0\n"
			  "CreateWindowSurface config 1 window 0x0\n"
			  "CreateContext config 1\n"
			  "MakeCurrent 7 9\n");
	scene_close(&scene);
	scene_end(&scene);
}

static void test_a_window_without_a_configuration_is_reported(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles.so");
	setenv("FAKE_GLES_REFUSE", "1000", 1);
	assert_int_equal(
		scene_open(&scene, "egl:7", "gles1", PIXELS_RGB565), -EIO);
	expect_told(&scene,
		BEGUN "CreateWindowSurface config 2 window 0x7\n"
		      "CreateWindowSurface config 1 window 0x7\n"
		      "MakeCurrent 0 0\n");
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 1);
	assert_contains(scene.capture.sentence[0], "0x7");
	assert_contains(scene.capture.sentence[0], "0x3009");
	scene_end(&scene);
}

static void test_the_picture_follows_the_screens_size(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles.so");
	assert_int_equal(scene_open(&scene, "egl", "gles1", PIXELS_RGB565), 0);
	scene_draw(&scene);
	file_write(scene.calls.text, "", 0);
	setenv("FAKE_GLES_SIZE", "640x480", 1);
	scene_draw(&scene);
	expect_told(&scene,
		"MakeCurrent 7 9\n"
		"Viewport 0 0 640 480\n"
		"SwapBuffers 7\n");
	assert_int_equal(scene.gl->width, 640);
	assert_int_equal(scene.gl->height, 480);
	setenv("FAKE_GLES_SIZE", "0x0", 1);
	assert_int_equal(scene.gl->driver->begin_frame(scene.gl, NULL), -EIO);
	scene_close(&scene);
	scene_end(&scene);
}

static void test_the_message_names_a_missing_library(void **state)
{
	struct scene scene;

	(void)state;
	scene_begin(&scene, "fake_gles_nowhere.so");
	assert_int_equal(
		scene_open(&scene, "egl", "gles1", PIXELS_RGB565), -ENOENT);
	assert_int_equal(scene.capture.count, 1);
	assert_contains(scene.capture.sentence[0], "fake_gles_nowhere.so");
	scene_end(&scene);
}

static void test_drivers_without_surfaces_are_refused(void **state)
{
	static const char *const names[] = {"soft", "osmesa"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct scene scene;

		scene_begin(&scene, "fake_gles.so");
		assert_int_equal(
			scene_open(&scene, "egl", names[i], PIXELS_RGB565),
			-EINVAL);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
		scene_end(&scene);
	}
}

/* For a display of pixels the pictures are read back. */
static void test_auto_takes_a_graphics_processor(void **state)
{
	struct scene scene;
	uint8_t data[48 * 64 * 2] = {0};
	const struct pixels pixels = {data, 48, 64, 48 * 2, PIXELS_RGB565};
	struct gl_request request = {.format = PIXELS_RGB565};

	(void)state;
	scene_begin(&scene, "fake_gles.so");
	request.egl_library = scene.library.text;
	request.gles_library = scene.library.text;
	request.log = &scene.log;
	assert_int_equal(gl_open("auto", &request, &scene.gl), 0);
	assert_string_equal(scene.gl->driver->name, "gles1");
	assert_int_equal(scene.gl->driver->begin_frame(scene.gl, &pixels), 0);
	assert_int_equal(scene.gl->driver->end_frame(scene.gl), 0);
	assert_int_equal(data[0] | data[1] << 8, 8 << 11 | 16 << 5 | 8);
	scene.gl->driver->destroy(scene.gl);

	setenv("FAKE_GLES_RENDERER", "llvmpipe (LLVM 15.0.6, 256 bits)", 1);
	assert_int_equal(gl_open("auto", &request, &scene.gl), 0);
	assert_string_equal(scene.gl->driver->name, "soft");
	scene.gl->driver->destroy(scene.gl);
	assert_true(log_capture_has(&scene.capture, LOG_NOTE, "llvmpipe"));
	scene_end(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_frames_are_drawn_on_the_whole_screen),
		cmocka_unit_test(test_only_old_calls_are_used_with_an_old_egl),
		cmocka_unit_test(test_a_window_is_named_by_its_number),
		cmocka_unit_test(test_a_window_must_be_a_number),
		cmocka_unit_test(test_the_next_configuration_is_tried),
		cmocka_unit_test(
			test_a_window_without_a_configuration_is_reported),
		cmocka_unit_test(test_the_picture_follows_the_screens_size),
		cmocka_unit_test(test_the_message_names_a_missing_library),
		cmocka_unit_test(test_drivers_without_surfaces_are_refused),
		cmocka_unit_test(test_auto_takes_a_graphics_processor),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
