/*
 * Projects a clip onto the screen, to measure errors in pixels.
 */
#ifndef APP_COMPARE_MEASURE_SCREEN_VIEW_H
#define APP_COMPARE_MEASURE_SCREEN_VIEW_H

#include "app/compare/measure/reference.h"
#include "app/compare/measure/time_grid.h"
#include "app/scene/instance/bounds.h"
#include "app/scene/stage/camera.h"

/*
 * Returns how `limber play` frames what it plays of a model without a character
 * file, whose box at rest this is: what it shows fills the picture. The caller
 * sets aspect and region.
 */
struct camera_framing screen_view_played(const struct bounds *rest);

/* The view of a camera as plain numbers. */
struct screen_view {
	int width, height; /* pixels */
	mat4 view;      /* model units to eye space; the eye looks along -Z */
	float focal_px; /* pixels that one unit at distance 1 covers */
	float unit;     /* scene units per unit of the model */
	/*
	 * A point of the box and a second point are at most px_per_unit times
	 * their distance apart on the screen, in pixels, if the square of their
	 * distance is at most near_square (model units).
	 */
	float px_per_unit, near_square;
	struct camera_framing framing; /* without aspect and region */
	struct bounds box; /* what the view frames, in model units */
};

/*
 * Returns the view of a picture that shows the reference's model, but frames
 * nothing yet. Poses the reference at rest.
 */
struct screen_view screen_view_begin(
	struct reference *reference, int width, int height);

/*
 * Returns the view in which the whole clip is played. Poses the reference at
 * every moment of the grid.
 */
struct screen_view screen_view_create(struct reference *reference,
	const struct time_grid *grid, int width, int height);

/* Moves the view so that it frames a box in the model's units. */
void screen_view_frame(struct screen_view *screen, const struct bounds *box);

/* One coordinate (row: 0 x, 1 y, 2 z) of a point in eye space. */
static inline float screen_view_eye(
	const struct screen_view *screen, const float point[3], int row)
{
	const vec4 *view = screen->view;

	return view[0][row] * point[0] + view[1][row] * point[1] +
		view[2][row] * point[2] + view[3][row];
}

/*
 * From world space to eye space. The clip is in front of the eye. A bad
 * conversion may move points behind the eye: they are placed just before it.
 */
static inline void screen_view_to_eye(
	const struct screen_view *screen, const float point[3], float eye[3])
{
	float z = screen_view_eye(screen, point, 2);

	eye[0] = screen_view_eye(screen, point, 0);
	eye[1] = screen_view_eye(screen, point, 1);
	eye[2] = z < -1e-3f ? z : -1e-3f;
}

/* Whether two points of eye space are at most px pixels apart. */
static inline bool screen_view_eyes_within(const struct screen_view *screen,
	const float a[3], const float b[3], float px)
{
	float x = a[0] * b[2] - b[0] * a[2], y = a[1] * b[2] - b[1] * a[2];
	float most = px * a[2] * b[2];
	float focal = screen->focal_px;

	return (x * x + y * y) * focal * focal <= most * most;
}

/* Projects a point of world space to pixels right of and above the middle. */
void screen_view_project(
	const struct screen_view *screen, const float point[3], float out[2]);

/* The distance in pixels between two points of world space. */
float screen_view_distance_px(
	const struct screen_view *screen, const float a[3], const float b[3]);

/*
 * Returns the square of a distance in model units: two points that close to
 * each other, of which one is in the box, are at most px pixels apart.
 */
static inline float screen_view_near_square(
	const struct screen_view *screen, float px)
{
	float units = px / screen->px_per_unit;
	float square = units * units;

	return square < screen->near_square ? square : screen->near_square;
}

/*
 * Whether two points are at most px pixels apart, of which a is in the box.
 * near_square is screen_view_near_square() of px: points that close to each
 * other need no projection.
 */
static inline bool screen_view_within(const struct screen_view *screen,
	const float a[3], const float b[3], float px, float near_square)
{
	float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
	float eye_a[3], eye_b[3];

	if (x * x + y * y + z * z <= near_square) {
		return true;
	}
	screen_view_to_eye(screen, a, eye_a);
	screen_view_to_eye(screen, b, eye_b);
	return screen_view_eyes_within(screen, eye_a, eye_b, px);
}

#endif
