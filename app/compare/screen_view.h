/*
 * Projects the clip onto the screen, to measure errors in pixels.
 */
#ifndef APP_COMPARE_SCREEN_VIEW_H
#define APP_COMPARE_SCREEN_VIEW_H

#include "app/compare/reference.h"

/* The view of a camera as plain numbers. */
struct screen_view {
	int width, height; /* pixels */
	mat4 view;      /* model units to eye space; the eye looks along -Z */
	float focal_px; /* pixels that one unit at distance 1 covers */
};

/* The view in which `limber play` frames the whole clip at its start. */
struct screen_view screen_view_create(
	const struct reference *reference, int width, int height);

/* The distance in pixels between two points of world space. */
float screen_view_distance_px(
	const struct screen_view *screen, const float a[3], const float b[3]);

#endif
