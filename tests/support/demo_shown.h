/*
 * Demos as they appear in a picture, for tests of framing.
 */
#ifndef TESTS_SUPPORT_DEMO_SHOWN_H
#define TESTS_SUPPORT_DEMO_SHOWN_H

#include "app/demo/actor.h"
#include "app/demo/demo.h"

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
 * Begins the demo of this name, or shows the model of this name in assets/ as
 * the character file says (NULL: the model's), and updates it once.
 */
void shown_begin_env(struct shown *shown, const char *name,
	const char *character, const int size[2], bool no_labels);
void shown_begin(struct shown *shown, const char *name, const int size[2],
	bool no_labels);
void shown_end(struct shown *shown);

/* A box of the scene as the picture shows it, -1 to 1. */
struct camera_region shown_project(const struct camera *camera,
	const int size[2], const float center[3], const float half_extent[3]);

/* The box that the camera frames. */
struct camera_region shown_framed(const struct shown *shown, const int size[2]);

/* The box of the vertices of the demo's figure. */
struct camera_region shown_now(const struct shown *shown, const int size[2]);

/* The region is in the picture. */
void shown_check_whole(const struct camera_region *region);

#endif
