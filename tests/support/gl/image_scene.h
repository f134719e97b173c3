/*
 * The image display, with small pictures of known content to write: a gradient,
 * and a red square that moves over it.
 *
 * Functions that return nothing fail the running test if they fail themselves.
 */
#ifndef TESTS_SUPPORT_GL_IMAGE_SCENE_H
#define TESTS_SUPPORT_GL_IMAGE_SCENE_H

#include "platform/display/display.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"

enum {
	IMAGE_SCENE_WIDTH = 37,
	IMAGE_SCENE_HEIGHT = 21
};

/* A display that writes the file path, in a folder of its own. */
struct image_scene {
	const struct display_driver *driver;
	struct display *display;
	struct test_path directory, path;
	struct log_capture capture;
	struct log log;
};

/* Opens the display on a file of that name in a fresh folder. */
void image_scene_open(struct image_scene *scene, const char *name,
	int frame_count, double rate_hz);

/* Destroys the display and removes the folder. */
void image_scene_close(struct image_scene *scene);

/*
 * Opens the display on a file of the caller's, with scene->log, which the
 * caller has set. Returns what the driver's create() returns.
 */
int image_scene_open_at(struct image_scene *scene, const char *path,
	int frame_count, double rate_hz);

/* The colour of the frame's pixel (x, y). */
void image_scene_color(int frame, int x, int y, uint8_t rgb[3]);

/* Draws and ends one frame; returns what end_frame() returns. */
int image_scene_draw(struct image_scene *scene, int frame);

/* Draws the frames 0..count-1 and finishes; fails the test on an error. */
void image_scene_draw_all(struct image_scene *scene, int count);

#endif
