#include "platform/display/display.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern const struct display_driver display_driver_null;

static void test_every_display_is_complete(void **state)
{
	struct log log = log_to_nowhere();

	(void)state;
	for (int i = 0; display_registry[i]; i++) {
		const struct display_driver *driver = display_registry[i];

		assert_non_null(driver->name);
		assert_non_null(driver->summary);
		assert_non_null(driver->create);
		assert_non_null(driver->end_frame);
		assert_non_null(driver->destroy);
		assert_non_null(driver->get_info);
		assert_true(!driver->get_surface != !driver->begin_frame);
		assert_ptr_equal(display_choose(driver->name, &log), driver);
		driver->destroy(NULL);
	}
	assert_null(display_choose("hologram", &log));
}

static void test_an_unknown_display_lists_the_known_ones(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_null(display_choose("hologram", &log));
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "--display hologram");
	for (int i = 0; display_registry[i]; i++) {
		assert_contains(capture.sentence[0], display_registry[i]->name);
	}
}

static void test_a_named_display_is_chosen(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_string_equal(display_choose("image", &log)->name, "image");
	assert_int_equal(capture.count, 0);
}

static void test_a_device_is_refused_where_none_is_used(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	assert_null(display_choose("null:/dev/null", &log));
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "--display null:/dev/null");
	assert_null(display_choose("nul", &log));
	assert_null(display_choose("nulls", &log));
}

/* Whether this machine has a screen that "auto" may take. */
static bool has_screen(void)
{
	return access("/dev/fb0", F_OK) == 0 ||
		access("/dev/dri/card0", F_OK) == 0;
}

static void test_auto_takes_no_display_that_shows_nothing(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct display_options options = {
		.width = 13, .height = 7, .log = &log};
	const struct display_driver *driver;
	struct display *display;

	(void)state;
	if (has_screen()) {
		skip_because("this machine has a screen");
	}
	unsetenv("DISPLAY");
	unsetenv("WAYLAND_DISPLAY");
	unsetenv("SDL_VIDEODRIVER");
	assert_int_equal(
		display_open(NULL, &options, &driver, &display), -ENODEV);
	assert_int_equal(
		display_open("auto", &options, &driver, &display), -ENODEV);
	assert_int_equal(capture.count, 2);
	assert_contains(capture.sentence[0], "image");
}

static void test_pictures_have_the_requested_format(void **state)
{
	static const enum pixel_format formats[] = {
		PIXELS_RGB565, PIXELS_RGBA8888};
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct display_options options = {
		.width = 13, .height = 7, .format_given = true, .log = &log};
	const struct display_driver *driver;
	struct display *display;
	struct display_info info;
	struct pixels pixels;

	(void)state;
	for (int i = 0; i < 2; i++) {
		options.format = formats[i];
		assert_int_equal(
			display_open("null", &options, &driver, &display), 0);
		driver->get_info(display, &info);
		assert_int_equal(info.format, formats[i]);
		assert_int_equal(info.width, 13);
		assert_int_equal(info.height, 7);
		assert_int_equal(driver->begin_frame(display, &pixels), 0);
		assert_int_equal(pixels.format, formats[i]);
		driver->destroy(display);
	}
}

static void test_null_hands_out_memory(void **state)
{
	const struct display_driver *driver = &display_driver_null;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct display_options options = {
		.width = 13, .height = 7, .log = &log};
	struct display *display;
	struct pixels pixels;

	(void)state;
	assert_int_equal(driver->create(&options, &display), 0);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(driver->begin_frame(display, &pixels), 0);
		assert_int_equal(pixels.width, 13);
		assert_int_equal(pixels.height, 7);
		assert_true(pixels.stride_bytes >= 13 * 4);
		memset(pixels.data, 0xA5,
			(size_t)(pixels.stride_bytes * pixels.height));
		assert_int_equal(driver->end_frame(display), 0);
	}
	driver->destroy(display);
	assert_int_equal(capture.count, 0);
}

static void test_impossible_sizes_are_refused(void **state)
{
	static const int sizes[][2] = {{0, 1}, {1, 0}, {-5, 5},
		{PIXELS_SIZE_MAX + 1, 1}, {1, 1 << 30}};
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct pixels pixels;

	(void)state;
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		assert_int_equal(pixels_alloc(&pixels, sizes[i][0], sizes[i][1],
					 PIXELS_RGB565, &log),
			-EINVAL);
		assert_int_equal(capture.count, (int)i + 1);
		assert_contains(capture.sentence[i], "--size");
	}
	assert_int_equal(pixels_alloc(&pixels, 3, 2, PIXELS_RGB565, &log), 0);
	assert_int_equal(pixels.stride_bytes, 6);
	free(pixels.data);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_display_is_complete),
		cmocka_unit_test(test_an_unknown_display_lists_the_known_ones),
		cmocka_unit_test(test_a_named_display_is_chosen),
		cmocka_unit_test(test_a_device_is_refused_where_none_is_used),
		cmocka_unit_test(test_pictures_have_the_requested_format),
		cmocka_unit_test(test_auto_takes_no_display_that_shows_nothing),
		cmocka_unit_test(test_null_hands_out_memory),
		cmocka_unit_test(test_impossible_sizes_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
