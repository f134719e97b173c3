/*
 * A triangle whose runs one loop lists, so that one call of the span function
 * draws all of them. list_small.c sets it up, span/walk_small.c lists the runs.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_SMALL_LIST_H
#define PLATFORM_GL_SOFT_RASTER_SMALL_LIST_H

#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/draw.h"

enum {
	SMALL_RUNS = 64, /* in a triangle, at most */
};

/* A value of a run's, at column 0 of the first row; wraps. */
struct small_value {
	uint32_t start, right, down;
};

/* How a coordinate leads from the base's texels into the window. */
struct small_coordinate {
	struct small_value value;
	struct bend bend;
	uint32_t level_right; /* where it does not bend */
	/* unless all is certain: the window's, and half a texel */
	uint32_t offset, mask, room;
	uint32_t round; /* half of what shift drops */
	int shift;
};

struct small_list {
	struct draw *draw;
	struct small_value z, red_blue, green, alpha, fog;
	struct small_coordinate s, t;
	bool rare; /* alpha or fog moves, or colours are made of rows */
	bool alpha_moves;
	/* No texel lies outside of the window, and a row is one run. */
	bool certain;
	int most;                   /* pixels of a run */
	const uint8_t *first_texel; /* of the runs; see struct soft_run */
	struct soft_row *end;
	struct soft_row row[SMALL_RUNS];
};

/* span/walk_small.c: draws all runs. */
void soft_walk_small(struct small_list *list, const struct setup *setup);

#endif
