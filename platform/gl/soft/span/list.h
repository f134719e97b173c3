/*
 * The runs of a triangle that is not divided by w: many are listed, so that one
 * call of the span function draws them. begin_list.c sets the list up,
 * walk_list.c walks the triangle's rows.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_LIST_H
#define PLATFORM_GL_SOFT_SPAN_LIST_H

#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/draw.h"

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
	struct soft_row *end;       /* where it is full */
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
