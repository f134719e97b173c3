/* What the walk over a triangle's rows calls. */
#ifndef PLATFORM_GL_SOFT_SPAN_WALK_H
#define PLATFORM_GL_SOFT_SPAN_WALK_H

#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/draw.h"

/*
 * begin.c: what of a triangle's runs is the same for all; which of colours,
 * alpha and fog move, as bits. Red, green and blue do so together.
 */
uint32_t soft_begin_walk(struct draw *draw);
/* And the steps of what runs linearly, of which soft_begin_walk() told. */
void soft_begin_steps(struct draw *draw, uint32_t moving);

/* level.c: the level and filter for a level of detail. */
void soft_set_level(struct draw *draw, int lod);

/* level.c: a level by a filter, which soft_use_view() gives a run to read. */
struct soft_view soft_find_view(
	const struct texture_input *input, int number, bool linear);
void soft_use_view(const struct soft_view *view, struct soft_run *run);

/* level.c: a window of few texels, if the triangle has few; else the level's. */
void soft_set_window(struct draw *draw);

/*
 * The runs of a triangle that is not divided by w: many are listed, so that one
 * call of the span function draws them. begin_list.c sets the list up,
 * walk_list.c walks the triangle's rows.
 */

/* A value of a run's, at column 0 of the first row; wraps. */
struct list_value {
	uint32_t start, right, down;
};

/* How a coordinate leads from the base's texels into the window. */
struct list_coordinate {
	struct list_value value;
	struct bend bend;
	uint32_t level_right; /* where it does not bend */
	/* unless all is certain: the window's, and half a texel */
	uint32_t offset, mask, room;
	uint32_t round; /* half of what shift drops */
	int shift;
};

struct run_list {
	struct draw *draw;
	struct list_value z, red_blue, green;
	struct list_coordinate s, t;
	uint32_t fog;      /* that stays the same */
	bool rare;         /* a run needs more than these values */
	bool colors_exact; /* its colours are found from planes, run by run */
	/* No texel lies outside of the window, and a row is one run. */
	bool certain;
	int most;                   /* pixels of a run */
	const uint8_t *first_texel; /* of the runs; see struct soft_run */
	/* Of the row under way, which counts from the triangle's first one. */
	int y;
	uint16_t *depth; /* of column 0 */
	uint8_t *pixel;
	struct band_edges edges;
	struct soft_row *next; /* of the list, and where it is full */
	struct soft_row *end;
	struct soft_row row[SOFT_BATCH_RUNS];
};

/* walk_list.c: draws all rows of a triangle whose list is set up. */
void soft_walk_list(struct run_list *list, const struct setup *setup);

/*
 * begin_list.c: the same, of a triangle that soft_begin_walk() has begun;
 * moving is what that returned.
 */
void soft_draw_list(
	struct draw *draw, const struct setup *setup, uint32_t moving);

#endif
