/* The findings of displays and GL drivers on a simulated machine. */
#include "platform/display/fbdev/fbdev.h"
#include "platform/display/kms/kms_calls.h"
#include "platform/gl/gl_survey.h"
#include "tests/support/fake/fake_card.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/files.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 20,
	HEIGHT = 12,
	STRIDE = 48
};

static const struct pixel_layout rgb565 = {
	.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};

/* The simulated machine has one device of this number. */
static int open_fb1(const char *path, int flags)
{
	if (strncmp(path, "/dev/fb", 7) == 0 && strcmp(path, "/dev/fb1") != 0) {
		errno = ENOENT;
		return -1;
	}
	return fake_fb_calls.open(path, flags);
}

static struct device_calls one_screen(void)
{
	struct device_calls calls = fake_fb_calls;

	calls.open = open_fb1;
	return calls;
}

static int setup(void **state)
{
	(void)state;
	fake_card_begin();
	fake_card.number = 2;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, STRIDE, rgb565);
	fake_fb.has_console = true;
	strcpy(fake_fb.fix.id, "DISP3 BG");
	return 0;
}

static void survey_fbdev(struct survey_capture *capture)
{
	const struct device_calls calls = one_screen();
	const struct survey survey = survey_capture_begin(capture, NULL);

	fbdev_survey_on(&calls, &survey);
	assert_int_equal(capture->count, 1);
	assert_int_equal(fake_fb.open_count, 0);
	assert_int_equal(fake_fb.map_count, 0);
	assert_int_equal(fake_fb.put_count, 0);
	assert_int_equal(fake_fb.pan_count, 0);
}

static void test_a_framebuffer_is_described(void **state)
{
	struct survey_capture capture;

	(void)state;
	survey_fbdev(&capture);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/fb1",
		"DISP3 BG: 20x12, 16 bits (r5@11 g6@5 b5@0), 2 pages", NULL);
}

static void test_a_framebuffer_under_a_desktop_is_taken(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_fb.console_mode = 1;
	fake_fb.console_watched = true;
	survey_fbdev(&capture);
	survey_capture_expect(&capture, 0, SURVEY_TAKEN, "/dev/fb1",
		"another program uses it", "chvt");
}

static void test_a_framebuffer_without_permission_is_broken(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_fb.open_error = EACCES;
	survey_fbdev(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/fb1",
		"no permission", "root");
}

static void test_a_framebuffer_of_planes_is_broken(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_fb.fix.type = FB_TYPE_PLANES;
	survey_fbdev(&capture);
	survey_capture_expect(
		&capture, 0, SURVEY_BROKEN, "/dev/fb1", "not packed", "fbset");
}

static void test_no_framebuffer_is_one_finding(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_fb.open_error = ENOENT;
	survey_fbdev(&capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/fb*",
		"no framebuffer", "modprobe");
}

static void survey_kms(struct survey_capture *capture)
{
	const struct survey survey = survey_capture_begin(capture, NULL);

	kms_survey_on(&fake_card_calls, &survey);
	assert_int_equal(capture->count, 1);
	assert_int_equal(fake_card.open_count, 0);
	assert_int_equal(fake_card.resource_count, 0);
	assert_int_equal(fake_card.set_count, 0);
}

static void test_a_cards_screen_is_described(void **state)
{
	struct survey_capture capture;

	(void)state;
	survey_kms(&capture);
	survey_capture_expect(
		&capture, 0, SURVEY_WORKS, "/dev/dri/card2", "", NULL);
	assert_string_equal(
		capture.finding[0].text, "Unknown-0: 20x12 at 50 Hz, 3 modes");
	fake_card.modes[1].type = 0;
	fake_card.mode_count = 2;
	survey_kms(&capture);
	assert_string_equal(
		capture.finding[0].text, "Unknown-0: 24x14 at 60 Hz, 2 modes");
	fake_card.mode_count = 1;
	survey_kms(&capture);
	assert_string_equal(
		capture.finding[0].text, "Unknown-0: 24x14 at 60 Hz, 1 mode");
	/* As limber would, where the kernel has not looked for screens yet. */
	fake_card.must_ask = true;
	survey_kms(&capture);
	assert_string_equal(
		capture.finding[0].text, "Unknown-0: 24x14 at 60 Hz, 1 mode");
}

static void test_a_finding_names_what_a_card_lacks(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_card.not_connected = true;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/dri/card2", "",
		"connect a screen");
	assert_string_equal(capture.finding[0].text,
		"no screen is connected to its 1 connector");
	fake_card.not_connected = false;
	fake_card.mode_count = 0;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/dri/card2",
		"no screen is connected", "connect a screen");
	fake_card.mode_count = FAKE_CARD_MODES;
	fake_card.not_master = true;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_TAKEN, "/dev/dri/card2",
		"another program uses it", "chvt");
	fake_card.no_dumb = true;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/dri/card2",
		"no buffers", "choose another");
	fake_card.fail = CALL_RESOURCES;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_UNUSED, "/dev/dri/card2",
		"drives no screens", NULL);
}

static void test_a_screen_without_a_crtc_is_broken(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_card.fail = CALL_ENCODER;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/dri/card2",
		"the card has no CRTC for it", "choose another");
}

static void test_a_missing_card_is_one_finding(void **state)
{
	struct survey_capture capture;

	(void)state;
	fake_card.number = 99;
	survey_kms(&capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/dri/card*",
		"no graphics card", "modprobe");
}

static void test_cards_without_permission_are_broken(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	fake_card.open_error = EACCES;
	kms_survey_on(&fake_card_calls, &survey);
	assert_true(capture.count > 0);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/dri/card0",
		"no permission", "root");
	survey_capture_expect(&capture, 7, SURVEY_BROKEN, "/dev/dri/card7",
		"no permission", "root");
	assert_int_equal(capture.count, 8);
	capture.count = 0;
	fake_card.open_error = EPERM;
	kms_survey_on(&fake_card_calls, &survey);
	assert_int_equal(capture.count, 8);
}

static void test_framebuffers_without_permission_are_broken(void **state)
{
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	fake_fb.open_error = EPERM;
	fbdev_survey_on(&fake_fb_calls, &survey);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/fb0",
		"no permission", "root");
	survey_capture_expect(&capture, 7, SURVEY_BROKEN, "/dev/fb7",
		"no permission", "root");
	assert_int_equal(capture.count, 8);
}

/* Returns the index of the finding with that subject. */
static int find(const struct survey_capture *capture, const char *subject)
{
	for (int i = 0; i < capture->count; i++) {
		if (strcmp(capture->finding[i].subject, subject) == 0) {
			return i;
		}
	}
	fail();
	return 0;
}

static void test_each_gl_driver_is_opened(void **state)
{
	const struct gl_request request = {.format = PIXELS_RGB565,
		.egl_library = "/nonexistent/libEGL.so",
		.gles_library = "/nonexistent/libGLES.so"};
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	gl_survey(&request, &survey);
	survey_capture_expect(&capture, find(&capture, "soft"), SURVEY_WORKS,
		"soft", "limber's own, fixed point", NULL);
	assert_contains(capture.finding[find(&capture, "soft")].text,
		"; the processor draws");
	survey_capture_expect(&capture, find(&capture, "gles1"), SURVEY_BROKEN,
		"gles1", "an option names cannot be opened", "");
	survey_capture_expect(&capture, find(&capture, "auto"), SURVEY_WORKS,
		"auto", "takes soft", NULL);
}

static void test_a_vendors_gl_has_a_processor_and_a_screen(void **state)
{
	const struct test_path library = path_beside_program("fake_gles.so");
	struct gl_request request = {.format = PIXELS_RGB565,
		.egl_library = library.text,
		.gles_library = library.text};
	struct survey_capture capture;
	const struct survey survey = survey_capture_begin(&capture, NULL);

	(void)state;
	setenv("FAKE_GLES_LOG", "/dev/null", 1);
	gl_survey(&request, &survey);
	survey_capture_expect(&capture, find(&capture, "gles1"), SURVEY_WORKS,
		"gles1", "a graphics processor draws", NULL);
	survey_capture_expect(&capture, find(&capture, "auto"), SURVEY_WORKS,
		"auto", "takes gles1", NULL);
	gl_survey_screen(&request, "egl", &survey);
	survey_capture_expect(&capture, find(&capture, "egl"), SURVEY_WORKS,
		"egl", "--gl gles1 has a screen", NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(test_a_framebuffer_is_described, setup),
		cmocka_unit_test_setup(
			test_a_framebuffer_under_a_desktop_is_taken, setup),
		cmocka_unit_test_setup(
			test_a_framebuffer_without_permission_is_broken, setup),
		cmocka_unit_test_setup(
			test_a_framebuffer_of_planes_is_broken, setup),
		cmocka_unit_test_setup(test_no_framebuffer_is_one_finding, setup),
		cmocka_unit_test_setup(
			test_framebuffers_without_permission_are_broken, setup),
		cmocka_unit_test_setup(test_a_cards_screen_is_described, setup),
		cmocka_unit_test_setup(
			test_a_finding_names_what_a_card_lacks, setup),
		cmocka_unit_test_setup(
			test_a_screen_without_a_crtc_is_broken, setup),
		cmocka_unit_test_setup(test_a_missing_card_is_one_finding, setup),
		cmocka_unit_test_setup(
			test_cards_without_permission_are_broken, setup),
		cmocka_unit_test(test_each_gl_driver_is_opened),
		cmocka_unit_test(test_a_vendors_gl_has_a_processor_and_a_screen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
