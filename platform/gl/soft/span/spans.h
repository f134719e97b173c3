/*
 * What span functions need of a draw call and of the triangle under way (struct
 * soft_spans), and the walk along a triangle's rows, which makes runs.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_SPANS_H
#define PLATFORM_GL_SOFT_SPAN_SPANS_H

#include "platform/gl/soft/span/run.h"

struct draw;
struct setup;

/* Factor of mul_high() from fog in 8.16 to a run's 1.15. */
enum {
	SOFT_FOG_SCALE = 8402980
};

/* A function of GL_COMBINE and its arguments. */
struct soft_combiner {
	GLenum function;
	GLenum source[3], operand[3];
	int doublings; /* log2 of the scale: 0 to 2 */
};

/* An environment of any mode, as functions of GL_COMBINE. */
struct soft_environment {
	struct soft_combiner rgb, alpha;
	bool alike;        /* rgb on all four bytes gives alpha, too */
	bool alpha_wanted; /* else the result's alpha is undefined */
	uint32_t constant; /* the environment's colour */
};

/* One coordinate of a level, as runs read the level with a filter. */
struct soft_axis {
	int shift;     /* from 16.16 of base texels to 23.9 of the level's */
	int32_t half;  /* subtracted: see soft_half_texel() */
	uint32_t last; /* the last column or row of texels */
	/* The window: if at & mask is below room, no texel wraps around. */
	uint32_t mask, room;
};

/* A level of a texture as runs read it with a filter. */
struct soft_view {
	const uint8_t *texels;
	uint32_t stride_log2; /* of bytes, as texel_log2 */
	int texel_log2;
	bool large; /* too large for soft_row.texel: each run has a first texel */
	struct soft_axis s, t;
};

/* Colours of 8.16 become struct soft_run's by mul_high_add(half, color, scale). */
struct soft_scales {
	int32_t red_blue, green, red_blue_half, green_half;
};

/* Coordinates in the base's texels, 16.16. */
struct texels {
	int32_t s, t;
};

/* A run's first texture coordinates and their steps. */
struct soft_made_at {
	struct texels at, step;
};

/* The level that runs read and its filter, or the two levels that they mix. */
struct soft_levels {
	int level; /* -1: none is chosen yet */
	bool linear;
	struct soft_view view;
	/* where stages/ makes rows: */
	struct soft_view next_view;
	int share;   /* weight of next_view, of 256; 0: it is not read */
	bool packed; /* the sampler packs texels for soft_run.second */
	const soft_span_function *sampler;
};

/*
 * The smooth point or line that a triangle belongs to, a disk or a rectangle:
 * see stages/coverage.c. x and y are window coordinates, in 1/16 pixels.
 */
struct soft_coverage {
	bool used;
	int32_t x, y;         /* the centre */
	int32_t radius_q8;    /* of a disk, in 1/256 pixels; else 0 */
	int32_t u_q14, v_q14; /* unit vector along a line */
	int32_t half_length_q8, half_width_q8;
};

/* The depths that span functions test and write. */
enum soft_depths {
	SOFT_DEPTHS_OWN,    /* the buffer's */
	SOFT_DEPTHS_COPIED, /* copies of them, which are written back */
	SOFT_DEPTHS_NONE,   /* 65535: all fragments pass */
};

/* What all runs of a draw call have in common, or all runs of a triangle. */
struct soft_spans {
	bool alpha_read;     /* span functions read alpha, if only white's */
	uint32_t white_bits; /* attributes that a texture replaces: white */
	bool textured;
	bool lod_wanted; /* mipmaps, or min_filter is unlike mag_filter */
	/* Colours change so fast that rounding at edges may leave their range. */
	bool steep;
	/* largest sum of columns and rows where a list may step colours */
	int stepped_size;
	int small_size; /* the same of soft_fill_small()'s triangles; else 0 */
	/* of the triangle: rows choose levels of detail; none has done so yet */
	bool level_by_row, level_unknown;
	bool alpha_moves, fog_moves; /* they are not constant in the triangle */
	bool rare;                   /* alpha_moves, fog_moves or steep */
	int32_t green_start; /* green_half, plus alpha if it is constant */
	enum soft_depths depths;
	/* All fragments pass: before, the buffer's depths are set to 65535. */
	bool depth_replaced;
	bool equal_passes; /* span functions' depth test is LEQUAL, else LESS */
	bool depth_by_less; /* LESS or LEQUAL, no stencil: hidden changes nothing */
	bool depth_written;
	bool inverted; /* depths are inverted, for GREATER and GEQUAL by LESS */
	/* soft_test() cuts runs; it also compares depths, whatever the stencil */
	bool parted, compared;
	bool tested_last; /* the stencil is written behind an alpha test */
	bool unseen;      /* no pixel is written, whatever its colour */
	bool direct;      /* span functions do all that fragments need */
	bool alpha_tested;
	bool untested;   /* no depth or stencil test, no depth is written */
	bool whole_rows; /* draw is one of untested.c's functions */
	/*
	 * Span functions draw RGBA8888 beside the picture, and then
	 * stages/blend_row.c blends these pixels, by any blend function.
	 */
	bool blended_last;
	enum soft_finish finish;
	bool wide; /* span functions draw RGBA8888, else RGB565 */
	const soft_span_table *table; /* that has the state's functions */
	int plain_pixels;             /* longest run without a texture */
	int longest;                  /* longest run with one */
	struct soft_scales scales;
	struct soft_levels levels[SOFT_UNITS];
	const soft_span_function *function; /* [enum soft_place] */
	/* draw runs anywhere or in the window, with all of the state's tests */
	soft_span_function draw_anywhere, draw;
	soft_span_function draw_tested; /* draws what untested.c does not */
	/* draw what draw and draw_anywhere count, while a program counts */
	soft_span_function counted, counted_anywhere;
	/* stages/ makes texels, or whole colours, before the run: see made.h */
	bool made, combined;
	/* made: how a function combines texels with colours, unless combined */
	enum soft_source made_source;
	/* how luminance.c chooses the first texture's level; else NULL */
	void (*set_level)(struct draw *draw, int lod);
	bool multiplied; /* made: the product of both textures */
	/*
	 * Reads the second texture's texels for seconded, which draw calls
	 * next; NULL where the span function has no texels from there.
	 */
	void (*read_second)(struct draw *draw, uint32_t *texel);
	soft_span_function seconded;
	bool joined;       /* functions read both textures in the same place */
	uint32_t white[2]; /* a run's red_blue and green_alpha for white */
	struct soft_environment environment[SOFT_UNITS];
	struct soft_made_at made_at;   /* of the first texture, for run.row */
	struct soft_coverage coverage; /* of the smooth point or line */
	soft_span_function draw_row;   /* draws a made row */
	int pixel_log2;                /* log2 of a pixel's bytes */
	struct soft_fragment_stages stages;
	/* where one instruction adds its offset in struct draw */
	_Alignas(32) struct soft_run run;
};

/*
 * prepare_spans.c: fills draw->spans for the state. False where no alpha can
 * pass the alpha test, so that nothing is drawn.
 */
bool soft_prepare_spans(struct draw *draw);

/*
 * stages/prepare_second.c: chooses the finish and the table of functions that
 * read a second texture; false where there is none for the state, and then
 * finds whether both textures are multiplied.
 */
bool soft_choose_second(struct draw *draw);

/*
 * beside.c: sets draw and draw_anywhere: span functions of a table's row, or
 * functions that call these and make the tests which they lack.
 */
void soft_set_functions(struct soft_spans *spans,
	const soft_span_function function[SOFT_PLACES]);

/*
 * raster/count_runs.c: makes draw and draw_anywhere count runs before they draw
 * them. Called after they were set, if a program counts.
 */
void soft_count_runs(struct soft_spans *spans);

/*
 * untested.c: span functions that fill runs with one colour, and that copy
 * nearest texels of RGB565. They leave runs to draw_tested where colours
 * change, or where texels are tinted or lie in several rows.
 */
void soft_fill_untested(const struct soft_run *run);
void soft_copy_untested(const struct soft_run *run);

/*
 * untested.c: copies to count pixels the texels at s_q16, s_q16 + s_right_q16
 * and so on of a row; all must lie in the row.
 */
void soft_copy_texels(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16);

/* walk_list.c: draws runs by one call of draw, if there are any. */
void soft_draw_runs(struct soft_spans *spans, const struct soft_row *rows,
	const struct soft_row *end);

/* walk.c: draws all rows of a triangle whose planes are set up. */
void soft_walk_rows(struct draw *draw, const struct setup *setup);

#endif
