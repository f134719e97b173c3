/*
 * Demos as they appear in a picture, for tests of framing.
 */
#ifndef TESTS_SUPPORT_DEMO_SHOWN_H
#define TESTS_SUPPORT_DEMO_SHOWN_H

#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/scene/hud/hud.h"

enum {
	SHOWN_SIZES = 6
};

/* Sizes of pictures. */
extern const int shown_sizes[SHOWN_SIZES][2];

/* A demo with a GL that draws nothing. */
struct shown {
	struct log log;
	struct gl gl;
	const struct demo_driver *driver;
	struct demo *demo;
};

/*
 * Begins the demo of that name or, if there is none, the viewer with the model
 * assets/NAME and a character file (NULL: the model's own), and updates it
 * once. shown_begin() uses the model's own. The caller ends with shown_end().
 */
void shown_begin_env(struct shown *shown, const char *name,
	const char *character, const int size[2], bool no_labels);
void shown_begin(struct shown *shown, const char *name, const int size[2],
	bool no_labels);
/* The same for a demo with the graph of frame times, which the caller draws. */
void shown_begin_timed(struct shown *shown, const char *name, const int size[2],
	bool no_labels);
void shown_end(struct shown *shown);

/* Projects a box of the scene. Returns its extent in the picture, -1 to 1. */
struct camera_region shown_project(const struct camera *camera,
	const int size[2], const float center[3], const float half_extent[3]);

/* The extent in the picture of the box that the camera frames. */
struct camera_region shown_framed(const struct shown *shown, const int size[2]);

/* The extent in the picture of the box around the demo's figure. */
struct camera_region shown_now(const struct shown *shown, const int size[2]);

/*
 * Whether a quad of the hud, from this one on, is over the figure, but for the
 * figure's outermost parts.
 */
bool shown_hides(
	const struct hud *hud, int first, const struct camera_region *figure);

/* Fails the test unless the region lies within the picture. */
void shown_check_whole(const struct camera_region *region);

#endif
