/*
 * A display on a graphics card that is made up in memory.
 */
#ifndef TESTS_UNIT_PLATFORM_DISPLAY_KMS_SCENE_H
#define TESTS_UNIT_PLATFORM_DISPLAY_KMS_SCENE_H

#include "platform/display/kms/kms_calls.h"
#include "tests/support/fake/fake_card.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/gl/paint.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <linux/kd.h>

extern const struct display_driver display_driver_kms;

enum {
	WIDTH = 20,
	HEIGHT = 12
};

struct scene {
	const struct display_driver *driver;
	struct display *display;
	struct display_options options;
	struct log_capture capture;
	struct log log;
};

static inline int reset(void **state)
{
	static const struct pixel_layout any = {
		.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};

	(void)state;
	fake_card_begin();
	/* The console belongs to fake_fb. */
	fake_fb_begin(8, 8, 8, 8, 16, any);
	fake_fb.has_console = true;
	return 0;
}

static inline int scene_open(struct scene *scene)
{
	scene->driver = &display_driver_kms;
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	return kms_create_on(&fake_card_calls, &scene->options, &scene->display);
}

static inline void expect_all_closed(void)
{
	assert_int_equal(fake_card.open_count, 0);
	assert_int_equal(fake_card.map_count, 0);
	assert_int_equal(fake_card.resource_count, 0);
	assert_null(fake_card.flip_user);
	for (int i = 0; i < 2; i++) {
		assert_false(fake_card.buffers[i].used);
		assert_false(fake_card.buffers[i].added);
	}
	assert_int_equal(fake_fb.open_count, 0);
	assert_int_equal(fake_fb.console_mode, KD_TEXT);
}

static inline void scene_close(struct scene *scene)
{
	scene->driver->destroy(scene->display);
	expect_all_closed();
}

/* Draws a picture with its number as red in a corner. */
static inline struct pixels draw(struct scene *scene, int number)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	paint_all(&pixels, 0, 0, 255);
	paint_pixel(&pixels, 0, 0, number << 3, 0, 0);
	paint_pixel(&pixels, pixels.width - 1, pixels.height - 1, 0, 255, 0);
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
	return pixels;
}

#define KMS_TEST(name) cmocka_unit_test_setup(name, reset)

#endif
