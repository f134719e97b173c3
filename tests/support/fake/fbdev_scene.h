/*
 * The fbdev display on the framebuffer of fake_fb.h, for several tests.
 */
#ifndef TESTS_SUPPORT_FAKE_FBDEV_SCENE_H
#define TESTS_SUPPORT_FAKE_FBDEV_SCENE_H

#include "platform/display/fbdev/fbdev.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/log_capture.h"

enum {
	FBDEV_SCENE_WIDTH = 20,
	FBDEV_SCENE_HEIGHT = 12
};

extern const struct pixel_layout fbdev_scene_layout_565;
extern const struct pixel_layout fbdev_scene_layout_8888;

struct fbdev_scene {
	const struct display_driver *driver;
	struct display *display;
	struct display_options options;
	struct log_capture capture;
	struct log log;
};

/* Sets fake_fb up as a RGB565 screen with memory for one page or two. */
void fbdev_scene_begin_565(int pages);

/* Opens the display on fake_fb. Returns what its create() returns. */
int fbdev_scene_open(struct fbdev_scene *scene);

/* Destroys the display and checks that everything is closed. */
void fbdev_scene_close(struct fbdev_scene *scene);

/* Fails the test unless everything is closed and the console shows text. */
void fbdev_scene_expect_closed(void);

/*
 * Draws and ends a frame: gray, with one red, green, blue and white pixel in
 * its corners. Returns the picture it drew into.
 */
struct pixels fbdev_scene_draw(struct fbdev_scene *scene);

/* Fails the test unless the screen shows these pixels in its corners. */
void fbdev_scene_expect_corners(
	uint32_t red, uint32_t green, uint32_t blue, uint32_t white);

#endif
