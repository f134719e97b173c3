/* Functions and data of the walk over a triangle's rows. */
#ifndef PLATFORM_GL_SOFT_SPAN_WALK_H
#define PLATFORM_GL_SOFT_SPAN_WALK_H

#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/draw.h"

/*
 * begin.c: sets what all runs of a triangle of so many rows have in common.
 * Returns the bits of colours, alpha and fog that are not constant in it.
 */
uint32_t soft_begin_walk(struct draw *draw, int rows);
/* Sets steps of colours that are linear; moving is soft_begin_walk()'s. */
void soft_begin_steps(struct draw *draw, uint32_t moving);
/*
 * Chooses the level, or two and their weights, and the filter of a unit for a
 * level of detail with 8 fraction bits: GL ES 1.1 section 3.7.7.
 */
void soft_set_level(struct draw *draw, int unit, int lod);
/*
 * In perspective: the second texture's coordinates in count pixels from column
 * x on of a row, counted from the triangle's first one; and its level of detail.
 */
struct soft_made_at soft_find_second(
	struct draw *draw, int row, int x, int count, int *lod);
/* Lets a run read a level. */
void soft_use_view(const struct soft_view *view, struct soft_run *run);

/*
 * A list of the runs of a triangle in which nothing is divided by w, so that
 * one call of the span function draws many runs. begin_list.c sets the list up,
 * and walk_list.c walks the triangle's rows.
 */

/* A texture coordinate, and how it is converted to the window's texels. */
struct list_coordinate {
	struct plane plane; /* 16.16 of base texels */
	struct bend bend;
	uint32_t level_right; /* step in the level, unless it is a polynomial */
	/* unless certain: (at - offset) & mask must be less than room */
	uint32_t offset, mask, room;
	uint32_t first; /* the window's coordinate that offset leads to */
	uint32_t round; /* 1 << (shift - 1), to round steps */
	int shift;      /* to the right, to 9 fraction bits of the level */
};

struct run_list {
	struct draw *draw;
	struct plane z, red_blue, green; /* in a run's number formats */
	struct list_coordinate s, t;
	uint32_t fog;      /* if it is constant */
	bool rare;         /* runs need set_rare() besides these values */
	bool alpha_alone;  /* that is because alpha is not constant */
	bool colors_exact; /* colours are found from planes for each run */
	/* No texel lies outside of the window, and each row is one run. */
	bool certain;
	int most;                   /* longest run, in pixels */
	const uint8_t *first_texel; /* soft_run.first_texel of all runs */
	/* the row under way, counted from the triangle's first one */
	int y;
	uint16_t *depth; /* the row's column 0 */
	uint8_t *pixel;
	struct band_edges edges;
	struct soft_row *next; /* the first free element of row */
	struct soft_row *end;  /* next is end: the list is full */
	struct soft_row row[SOFT_BATCH_RUNS];
};

/* walk_list.c: draws all rows of a triangle whose list is set up. */
void soft_walk_list(struct run_list *list, const struct setup *setup);

/*
 * begin_list.c: sets a list up and draws it. soft_begin_walk() was called and
 * has returned moving.
 */
void soft_draw_list(
	struct draw *draw, const struct setup *setup, uint32_t moving);

#endif
