#include "platform/gl/gl_context.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void test_an_unknown_driver_lists_the_known_ones(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gl_context *context = NULL;

	(void)state;
	assert_int_equal(gl_open("voodoo",
				 &(struct gl_request){.format = PIXELS_RGBA8888,
					 .log = &log},
				 &context),
		-EINVAL);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "--gl voodoo");
	for (int i = 0; gl_registry[i]; i++) {
		assert_contains(capture.sentence[0], gl_registry[i]->name);
	}
	assert_null(context);
}

static void test_every_driver_is_complete(void **state)
{
	(void)state;
	for (int i = 0; gl_registry[i]; i++) {
		assert_non_null(gl_registry[i]->name);
		assert_non_null(gl_registry[i]->summary);
		assert_non_null(gl_registry[i]->create);
		assert_non_null(gl_registry[i]->begin_frame);
		assert_non_null(gl_registry[i]->end_frame);
		assert_non_null(gl_registry[i]->destroy);
		gl_registry[i]->destroy(NULL);
	}
}

static void test_the_message_names_a_missing_library_and_its_package(
	void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gl_context *context = NULL;

	(void)state;
	setenv("LIMBER_EGL", "libnowhere.so.7", 1);
	assert_int_equal(gl_open("gles1",
				 &(struct gl_request){.format = PIXELS_RGBA8888,
					 .log = &log},
				 &context),
		-ENOENT);
	unsetenv("LIMBER_EGL");
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "LIMBER_EGL");
	assert_contains(capture.sentence[0], "libnowhere.so.7");
	assert_null(context);
}

static void test_a_library_without_a_function_is_refused(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gl_context *context = NULL;

	(void)state;
	setenv("LIMBER_EGL", "libm.so.6", 1);
	setenv("LIMBER_GLES", "libm.so.6", 1);
	assert_int_equal(gl_open("gles1",
				 &(struct gl_request){.format = PIXELS_RGBA8888,
					 .log = &log},
				 &context),
		-ENOSYS);
	unsetenv("LIMBER_EGL");
	unsetenv("LIMBER_GLES");
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "has no egl");
}

static void test_auto_opens_the_first_driver_that_works(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("auto", PIXELS_RGBA8888);

	(void)state;
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 0, 0, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

static void test_auto_takes_neither_reference_nor_software_gl(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gl_context *context = NULL;

	(void)state;
	assert_int_equal(gl_open("auto",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &context),
		0);
	assert_true(context->accelerated ||
		strcmp(context->driver->name, "soft") == 0);
	context->driver->destroy(context);
	assert_int_equal(log_capture_count(&capture, LOG_ERROR), 0);
}

static void test_auto_skips_a_gl_without_a_graphics_processor(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct gl_request request = {.format = PIXELS_RGBA8888,
		.egl_library = "libEGL.so.1",
		.log = &log};
	struct gl_context *context = NULL;

	(void)state;
	/* Opened by name, Mesa's EGL draws on the processor. */
	setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
	assert_int_equal(gl_open("auto", &request, &context), 0);
	unsetenv("LIBGL_ALWAYS_SOFTWARE");
	assert_string_equal(context->driver->name, "soft");
	context->driver->destroy(context);
	assert_true(log_capture_count(&capture, LOG_ERROR) > 0 ||
		log_capture_has(&capture, LOG_NOTE, "no graphics processor"));
}

static void test_auto_takes_a_vendors_gl_and_opens_no_other(void **state)
{
	const struct test_path library = path_beside_program("fake_gles.so");
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct gl_request request = {.format = PIXELS_RGBA8888,
		.egl_library = library.text,
		.gles_library = library.text,
		.log = &log};
	struct gl_context *context = NULL;

	(void)state;
	assert_int_equal(gl_open(NULL, &request, &context), 0);
	assert_string_equal(context->driver->name, "gles1");
	assert_true(context->accelerated);
	context->driver->destroy(context);
	assert_int_equal(capture.count, 1);
	assert_string_equal(capture.sentence[0],
		"--gl auto: using gles1 (PowerVR MBX Lite, OpenGL ES-CM 1.1)");
	/* The same library whose renderer is a program is none of a vendor's. */
	setenv("FAKE_GLES_RENDERER", "llvmpipe (LLVM 15)", 1);
	assert_int_equal(gl_open("auto", &request, &context), 0);
	unsetenv("FAKE_GLES_RENDERER");
	assert_string_equal(context->driver->name, "soft");
	context->driver->destroy(context);
	assert_true(log_capture_has(&capture, LOG_NOTE,
		"skipped gles1, which uses no graphics processor (llvmpipe"));
}

static void test_auto_fails_where_no_driver_draws_on_a_surface(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct native_surface surface = {0};
	const struct gl_request request = {.format = PIXELS_RGB565,
		.surface = &surface,
		.egl_library = "libnowhere.so.7",
		.log = &log};
	struct gl_context *context = NULL;

	(void)state;
	assert_int_equal(gl_open("auto", &request, &context), -ENOENT);
	assert_null(context);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "libnowhere.so.7");
	/* Drivers that draw into memory alone say so. */
	assert_int_equal(gl_open("soft", &request, &context), -EINVAL);
	assert_contains(
		capture.sentence[1], "--gl soft: it can only draw into memory");
	assert_int_equal(gl_open("auto2", &request, &context), -EINVAL);
	assert_contains(capture.sentence[2], "no such driver");
}

static void test_only_surface_drivers_draw_on_surfaces(void **state)
{
	(void)state;
	assert_true(gl_can_draw("gles1", true));
	assert_true(gl_can_draw(NULL, true));
	assert_true(gl_can_draw("auto", true));
	assert_false(gl_can_draw("soft", true));
	assert_false(gl_can_draw("osmesa", true));
	assert_true(gl_can_draw("soft", false));
	assert_true(gl_can_draw("gles1", false));
}

static void draw_with(
	const char *driver, enum pixel_format format, uint8_t *out, size_t size)
{
	struct gl_canvas canvas = gl_canvas_open(driver, format);

	canvas.gl->Disable(GL_DITHER);
	gl_canvas_draw_scene(&canvas);
	assert_int_equal(
		canvas.pixels.stride_bytes * canvas.pixels.height, size);
	memcpy(out, canvas.pixels.data, size);
	gl_canvas_close(&canvas);
}

/* In reverse order: the reference is last. */
static int last_driver(void)
{
	int last = 0;

	while (gl_registry[last + 1]) {
		last++;
	}
	return last;
}

/* Counts the bytes of two RGBA pictures that differ by more than 2. */
static int count_differences(const uint8_t *a, const uint8_t *b, size_t size)
{
	int count = 0;

	for (size_t i = 0; i < size; i++) {
		count += abs(a[i] - b[i]) > 2;
	}
	return count;
}

static void test_the_drivers_agree(void **state)
{
	enum {
		SIZE = GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT * 4
	};
	uint8_t first[SIZE], next[SIZE];
	int colors = 0;

	(void)state;
	draw_with(
		gl_registry[last_driver()]->name, PIXELS_RGBA8888, first, SIZE);
	for (int i = 4; i < SIZE; i += 4) {
		colors += memcmp(first + i, first + i - 4, 4) != 0;
	}
	/* The picture must not be empty. */
	assert_true(colors > 100);
	for (int i = last_driver() - 1; i >= 0; i--) {
		draw_with(gl_registry[i]->name, PIXELS_RGBA8888, next, SIZE);
		/* Pixels on edges may differ. */
		assert_in_range(
			count_differences(first, next, SIZE), 0, SIZE / 100);
	}
}

static void test_the_drivers_agree_in_565(void **state)
{
	enum {
		COUNT = GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT
	};
	uint16_t first[COUNT], next[COUNT];
	int differences = 0;

	(void)state;
	draw_with(gl_registry[last_driver()]->name, PIXELS_RGB565,
		(uint8_t *)first, sizeof(first));
	for (int i = last_driver() - 1; i >= 0; i--) {
		draw_with(gl_registry[i]->name, PIXELS_RGB565, (uint8_t *)next,
			sizeof(next));
		for (int j = 0; j < COUNT; j++) {
			int red = (first[j] >> 11) - (next[j] >> 11);
			int green = (first[j] >> 5 & 63) - (next[j] >> 5 & 63);
			int blue = (first[j] & 31) - (next[j] & 31);

			differences +=
				abs(red) > 1 || abs(green) > 1 || abs(blue) > 1;
		}
		assert_in_range(differences, 0, COUNT / 50);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_an_unknown_driver_lists_the_known_ones),
		cmocka_unit_test(test_every_driver_is_complete),
		cmocka_unit_test(
			test_the_message_names_a_missing_library_and_its_package),
		cmocka_unit_test(test_a_library_without_a_function_is_refused),
		cmocka_unit_test(test_auto_opens_the_first_driver_that_works),
		cmocka_unit_test(
			test_auto_takes_neither_reference_nor_software_gl),
		cmocka_unit_test(
			test_auto_skips_a_gl_without_a_graphics_processor),
		cmocka_unit_test(test_auto_takes_a_vendors_gl_and_opens_no_other),
		cmocka_unit_test(
			test_auto_fails_where_no_driver_draws_on_a_surface),
		cmocka_unit_test(test_only_surface_drivers_draw_on_surfaces),
		cmocka_unit_test(test_the_drivers_agree),
		cmocka_unit_test(test_the_drivers_agree_in_565),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
