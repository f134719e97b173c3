/*
 * From a triangle's planes to runs: what of the state the span functions need,
 * and the walk along a triangle's rows.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_SPANS_H
#define PLATFORM_GL_SOFT_SPAN_SPANS_H

#include "platform/gl/soft/stages/combine_rows.h"
#include "platform/gl/soft/stages/coverage.h"

struct draw;
struct setup;

/* From fog's 8.16 to a run's 1.15. */
enum {
	SOFT_FOG_SCALE = 8402980
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

/* A level of a texture as runs read it, by a filter. */
struct soft_view {
	const uint8_t *texels;
	uint32_t stride_log2; /* bytes, as texel_log2 */
	int texel_log2;
	int s_shift, t_shift; /* from 16.16 of the base's texels to 23.9 */
	int32_t s_half, t_half;
	uint32_t s_last, t_last;   /* texels */
	struct soft_window window; /* as large as it can be */
};

/* From 8.16 to struct soft_run's: the product's upper half, and a half more. */
struct soft_scales {
	int32_t red_blue, green, red_blue_half, green_half;
};

/* Where a run's texels are in the base, and how they run: 16.16. */
struct soft_made_at {
	int32_t s, t, s_step, t_step;
};

/* One level of a texture, or two of which texels are mixed. */
struct soft_made_levels {
	int level; /* -1: none yet */
	bool linear;
	int share;   /* of next_view, of 256 */
	bool packed; /* as words of soft_run.second, not bytes */
	const soft_span_function *sampler;
	struct soft_view view, next_view;
};

/* What of a draw call is the same for all of its runs. */
struct soft_spans {
	bool colored;        /* the vertices' colours are wanted */
	bool alpha;          /* and their alpha */
	bool alpha_read;     /* by the span function, if only as white's */
	uint32_t white_bits; /* colours that a texture takes the place of */
	bool textured;
	bool lod_wanted; /* levels, or filters, differ */
	/* Colours change so fast that rounding at edges may leave their range. */
	bool steep;
	/* Columns and rows of triangles whose colours a list steps, at most. */
	int stepped_size;
	/* Of the triangle under way: rows choose levels, and none has yet */
	bool level_by_row, level_unknown;
	bool alpha_moves, fog_moves;
	bool rare;           /* either of them, or steep colours */
	int32_t green_start; /* green_half, and the alpha that stays the same */
	int color_tolerance; /* see rows_color_tolerance() */
	bool tested_by_functions; /* but they write depths, too */
	bool equal_passes;        /* LEQUAL, else LESS is their depth test */
	bool depth_by_less;       /* or LEQUAL: what is behind shows nothing */
	bool depth_written;
	bool direct; /* the functions themselves do all that fragments need */
	bool stenciled, alpha_tested;
	bool untested;   /* by depth or stencil, and no depth is written */
	bool whole_rows; /* see soft_fill_untested() */
	/*
	 * The functions draw RGBA8888 beside the picture, which stages/blend_row.c
	 * blends: after an alpha test, or by another function than by alpha.
	 */
	bool blended_last;
	uint32_t color_mask; /* bits of pixels that are written, twice of 565 */
	enum soft_finish finish;
	const soft_span_table *table; /* of all of the state's functions */
	int plain_pixels;             /* the most of a run without a texture */
	int longest;                  /* and with one */
	struct soft_scales scales;
	/* of minified and magnified textures, by enum soft_place */
	const soft_span_function *min, *mag;
	/* The level and filter under way */
	int level; /* -1: none yet */
	bool small;
	const soft_span_function *function;
	/* the same, with the depth test before them that they do not do */
	soft_span_function draw_anywhere, draw;
	soft_span_function draw_tested; /* what untested.c does not draw */
	struct soft_view view;
	struct soft_window window; /* of the triangle */
	/*
	 * Where the texels of a small triangle's listed runs lie: all of the
	 * window, or what of it the triangle needs, up to the level's edge.
	 */
	struct soft_window part;
	const uint8_t *part_texel; /* its first one */
	uint32_t part_s, part_t;   /* its first coordinates, unless masked */
	/* Texels are made beforehand, see made.h, or whole colours */
	bool made, combined;
	/* How made runs choose their level; NULL for all others. */
	void (*set_level)(struct draw *draw, int lod);
	bool multiplied; /* made: the product of both textures */
	/*
	 * How draw reads the second texture's texels of runs, before it calls
	 * seconded; NULL where that does not read them.
	 */
	void (*read_second)(struct draw *draw, uint32_t *texel);
	soft_span_function seconded;
	bool joined;       /* they find them where the first texture's are */
	uint32_t white[2]; /* red_blue and green_alpha of a run */
	struct soft_made_levels made_levels[SOFT_UNITS];
	struct soft_environment environment[SOFT_UNITS];
	struct soft_made_at made_at;   /* of the first texture, in run */
	struct soft_coverage coverage; /* of the point or line under way */
	soft_span_function draw_row;   /* what is made */
	int pixel_log2;                /* bytes */
	struct soft_fragment_stages stages;
	struct soft_run run;
};

/*
 * Which functions draw the state, and all that they need. False where the alpha
 * test lets nothing through.
 */
bool soft_prepare_spans(struct draw *draw);

/*
 * stages/prepare_second.c: lets span functions read the second texture's
 * texels, if they have a finish for that; false where they have none.
 */
bool soft_choose_second(struct draw *draw);

/*
 * beside.c: sets the functions that draw runs anywhere in the texture, and
 * inside of the window, with the tests that they do not do by themselves.
 */
void soft_set_functions(struct soft_spans *spans,
	const soft_span_function function[SOFT_PLACES]);

/*
 * untested.c: span functions without a texture, and of the nearest texels of an
 * RGB565 texture. They leave runs to draw_tested where the colours of a row
 * differ, or where its texels are tinted or of several rows.
 */
void soft_fill_untested(const struct soft_run *run);
void soft_copy_untested(const struct soft_run *run);

/*
 * untested.c: a row of pixels from a row of texels, at s_q16 and steps further,
 * which are all there.
 */
void soft_copy_texels(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16);

/* All rows of a triangle whose planes are set up. */
void soft_walk_rows(struct draw *draw, const struct setup *setup);

#endif
