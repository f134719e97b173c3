/*
 * What a window and limber doctor say where SDL is missing or lacks functions.
 * The function below replaces that of the C library.
 */
#define _GNU_SOURCE /* RTLD_NEXT */

#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#if __has_include(<SDL.h>)
#include "platform/display/display.h"
#include "platform/display/window/window_survey.h"
#include "tests/support/log_capture.h"

static struct {
	const char *name; /* of the library that is opened instead of SDL */
	int opened;
} library;

void *dlopen(const char *name, int flags)
{
	static __typeof__(dlopen) *next;
	bool is_sdl = name && strcmp(name, "libSDL2-2.0.so.0") == 0;

	if (!next) {
		*(void **)&next = dlsym(RTLD_NEXT, "dlopen");
	}
	library.opened += is_sdl;
	return next(is_sdl ? library.name : name, flags);
}

static void expect_refused(int wanted, const char *cause)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	const struct display_options options = {
		.width = 4, .height = 4, .log = &log};
	const struct display_driver *driver = NULL;
	struct display *display = NULL;

	assert_int_equal(
		display_open("window", &options, &driver, &display), wanted);
	assert_null(display);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "--display window: ");
	assert_contains(capture.sentence[0], cause);
	assert_contains(
		capture.sentence[0], ": install Debian's libsdl2-2.0-0, ");
}

static void expect_surveyed(enum survey_state wanted, const char *cause)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	window_survey(&survey);
	assert_int_equal(capture.count, 1);
	survey_capture_expect(&capture, 0, wanted, "window", cause,
		"sudo apt install libsdl2-2.0-0");
}

static void test_without_sdl_its_package_is_named(void **state)
{
	static const char cause[] =
		"there is no libSDL2-2.0.so.0 on this machine (libnowhere.so.7: ";
	static const char *const variables[] = {
		"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"};

	(void)state;
	library.name = "libnowhere.so.7";
	for (size_t i = 0; i < ARRAY_COUNT(variables); i++) {
		library.opened = 0;
		setenv(variables[i], "dummy", 1);
		expect_refused(-ENOENT, cause);
		expect_surveyed(SURVEY_MISSING, cause);
		assert_int_equal(library.opened, 2);
		unsetenv(variables[i]);
	}
}

static void test_a_function_that_sdl_lacks_is_named(void **state)
{
	static const char cause[] = "libSDL2-2.0.so.0 has no SDL_Create";

	(void)state;
	library.name = "libm.so.6";
	setenv("SDL_VIDEODRIVER", "dummy", 1);
	expect_refused(-ENOSYS, cause);
	expect_surveyed(SURVEY_BROKEN, cause);
	unsetenv("SDL_VIDEODRIVER");
}

/* Opening SDL would take longer than all other findings. */
static void test_without_a_desktop_sdl_is_not_opened(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	library.opened = 0;
	window_survey(&survey);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "window",
		"no desktop", "export DISPLAY=:0");
	assert_int_equal(library.opened, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_sdl_its_package_is_named),
		cmocka_unit_test(test_a_function_that_sdl_lacks_is_named),
		cmocka_unit_test(test_without_a_desktop_sdl_is_not_opened),
	};

	unsetenv("DISPLAY");
	unsetenv("WAYLAND_DISPLAY");
	unsetenv("SDL_VIDEODRIVER");
	return cmocka_run_group_tests(tests, NULL, NULL);
}

#else
#include "tests/unit/platform/display/window/no_window.h"

int main(void)
{
	return skip_the_window();
}

#endif
