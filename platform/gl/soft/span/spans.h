/*
 * From a triangle's planes to runs: what of the state the span functions need,
 * and the walk along a triangle's rows.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_SPANS_H
#define PLATFORM_GL_SOFT_SPAN_SPANS_H

#include "platform/gl/soft/span/run.h"

struct draw;
struct setup;

/* From fog's 8.16 to a run's 1.15. */
enum {
	SOFT_FOG_SCALE = 8402980
};

/* How runs are tested for depth, which span functions only do by LESS. */
enum soft_depth_way {
	SOFT_DEPTH_DIRECT, /* LESS, written */
	SOFT_DEPTH_FREE,   /* no test */
	SOFT_DEPTH_KEPT,   /* LESS, not written */
	SOFT_DEPTH_FIRST,  /* with a stencil: tested and written before */
	SOFT_DEPTH_LAST,   /* tested before, written after the span */
};

/*
 * The coordinates of a level from which no texel wraps around: counted from the
 * first ones and masked they are less than the rooms. None where the span
 * functions that need that are missing.
 */
struct soft_window {
	uint32_t s_first, t_first, s_mask, t_mask, s_room, t_room;
	bool large; /* a run's texels count from its own first one */
};

/* What of a draw call is the same for all of its runs. */
struct soft_spans {
	bool takes_state;
	bool used;       /* else fragment.c draws */
	bool colored;    /* the vertices' colours are wanted */
	bool alpha;      /* and their alpha */
	bool alpha_read; /* by the span function, if only as white's */
	bool textured, fogged;
	bool lod_wanted; /* levels, or filters, differ */
	/* Colours change so fast that rounding at edges may leave their range. */
	bool steep;
	bool level_by_row; /* of the triangle under way */
	bool alpha_moves, fog_moves;
	bool rare;           /* either of them, or steep colours */
	int32_t green_start; /* green_half, and the alpha that stays the same */
	int color_tolerance; /* see rows_color_tolerance() */
	enum soft_depth_way depth_way;
	enum soft_finish finish;
	int plain_pixels; /* of a run without a texture, at most */
	/* From 8.16 to struct soft_run's: upper half of the product, and more */
	int32_t red_blue_scale, green_scale, red_blue_half, green_half;
	/* of minified and magnified textures: anywhere and inside */
	soft_span_function min[2], mag[2];
	/* The level and filter under way */
	int level; /* -1: none yet */
	bool small;
	const soft_span_function *function;
	/* the same, with the depth test before them that they do not do */
	soft_span_function draw_anywhere, draw;
	struct soft_window window;       /* of the triangle */
	struct soft_window level_window; /* as large as it can be */
	int s_shift, t_shift; /* from 16.16 of the base's texels to 24.8 */
	int32_t s_half, t_half;
	int texel_log2, pixel_log2; /* bytes */
	struct soft_fragment_stages stages;
	struct soft_run run;
	uint16_t aside[SOFT_RUN_PIXELS]; /* depths, where not the buffer's */
};

/* Whether a span function takes the state, and all that it needs. */
void soft_prepare_spans(struct draw *draw);

/* All rows of a triangle whose planes are set up. */
void soft_walk_rows(struct draw *draw, const struct setup *setup);

#endif
