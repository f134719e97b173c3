/*
 * Runs: up to SOFT_RUN_PIXELS pixels of one row whose values change linearly,
 * and the functions that draw them, one for each combination of texture,
 * filter, fragment state and picture format. walk.c and walk_list.c make runs
 * from triangles; template.h has the code of all functions.
 *
 * Number formats:
 *	z           16.16
 *	red, blue   in the halves of one word, and green in the lower half of
 *	            another. With a texture: the factor of a texel's channel,
 *	            1.14, times the ratio of the picture's and the texel's
 *	            largest values. Without one: the pixel's channel, 5.11 and
 *	            6.9 (green) with a half added, or 8.8 for RGBA8888
 *	alpha       8.7, in the upper half above green
 *	fog         1.15: how much of the fragment's own colour stays
 *	s, t        in texels of the level, 9 bits of fraction; for bilinear
 *	            filters half a texel less
 */
#ifndef PLATFORM_GL_SOFT_SPAN_RUN_H
#define PLATFORM_GL_SOFT_SPAN_RUN_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

enum {
	/*
	 * s and t are exact in the run's middle; rounded steps make them lose
	 * up to 1/1024 of a texel a pixel from there.
	 */
	SOFT_RUN_PIXELS = 64,
	/* Colours lose up to 1/2048 of a step of RGB565 a pixel. */
	SOFT_PLAIN_PIXELS = 512,
	/* largest sum of columns and rows of triangles whose runs fit one list */
	SOFT_LISTED_SIZE = 62,
	/* most pixels and runs of a list that one call draws */
	SOFT_BATCH_PIXELS = 1024,
	SOFT_BATCH_RUNS = 64,
	SOFT_BATCH_ROOM = SOFT_BATCH_PIXELS + 3, /* drawn as four to the end */
	/* 2^7 texels, with 9 bits of fraction, fit half of a word */
	SOFT_RUN_TEXELS = 128,
};

/*
 * A draw call's values for the stages after the texture: fog, alpha test and
 * blending.
 */
struct soft_fragment_stages {
	/*
	 * Red, green and blue in the picture's 5, 6 or 8 bits, times 2^14. With
	 * fog, both are its colour and a half; else far is -1 times the colour
	 * that is added to all fragments, or 0, and fog is 0.
	 */
	int32_t far[3], fog[3];
	/* alpha passes when (alpha - low) modulo 256 is at most range */
	uint32_t alpha_low, alpha_range;
	GLenum blend_source, blend_destination;
	uint32_t environment[3]; /* GL_BLEND's colour, 8.8 */
	/*
	 * SOFT_MIXED: blend factors are base + alpha * by; the source's in the
	 * lower half, the destination's in the upper one.
	 */
	uint32_t factors_base, factors_by;
	uint32_t unseen; /* an alpha that leaves pixels unchanged; 256: none */
};

struct draw;

/* The part of a run that differs between the runs of a triangle. */
struct soft_row {
	uint16_t *depth;
	uint8_t *pixel;
	uint32_t count; /* 1 to SOFT_RUN_PIXELS, see plain_pixels */
	uint32_t z;
	uint32_t red_blue; /* blue in the upper half */
	uint32_t green_alpha;
	uint32_t fog;
	/*
	 * t in the upper half, s in the lower one, relative to first_texel; of
	 * SOFT_MADE sources the number of the first texel from there, and 1
	 */
	uint32_t texel, texel_right;
	/*
	 * If soft_spans.made or read_second: the column and, in the upper half,
	 * the row, counted from the triangle's first one.
	 */
	uint32_t place;
};

/* A texture coordinate in the level at a run's first pixel, and its step. */
struct soft_coordinate {
	uint32_t at, right;
};

struct soft_run {
	/* the runs to draw; several only for functions that read first_texel */
	const struct soft_row *rows;
	uint32_t row_count;
	struct soft_row row;
	uint32_t z_right, red_blue_right, green_alpha_right, fog_right;
	/*
	 * SOFT_INSIDE: texels lie in the level, and both coordinates of
	 * row.texel count from this texel and are below SOFT_RUN_TEXELS.
	 */
	const uint8_t *first_texel;
	/* SOFT_ANYWHERE: the level and coordinates that may wrap around */
	const uint8_t *texels;
	struct soft_coordinate s, t;
	uint32_t s_last, t_last; /* last column and row, which are also masks */
	uint32_t stride_log2; /* log2 of bytes from row to row of the level */
	/*
	 * With a second texture: address of its texels, one word for each
	 * pixel, run after run: RGBA8888, or packed for RGB565 pictures.
	 */
	uintptr_t second;
	/* Joined textures: bytes from a texel of the first to the second's. */
	uintptr_t joint;
	bool depth_kept; /* depths stay, if soft_keeps_depth() */
	/* the last address from which four pixels may be read and written */
	uintptr_t last;
	const struct soft_fragment_stages *stages;
	struct draw *draw; /* whose run it is */
};

typedef void (*soft_span_function)(const struct soft_run *run);

/* The texture's filter and format that a span function reads. */
enum soft_source {
	SOFT_NO_TEXTURE,
	SOFT_NEAREST, /* plus enum texel_format - 1 */
	SOFT_LINEAR = SOFT_NEAREST + TEXEL_LA88,
	/*
	 * RGBA8888 that stages/ made, one behind the other; the last ones meet
	 * the colour by a texture environment, in place of GL_MODULATE.
	 */
	SOFT_MADE = SOFT_LINEAR + TEXEL_LA88,
	SOFT_MADE_ADD,
	SOFT_MADE_DECAL,
	SOFT_MADE_BLEND,
	SOFT_SOURCES,
};

/* What happens to a fragment after its texture. */
enum soft_finish {
	SOFT_OPAQUE,
	SOFT_TESTED,  /* alpha test; then opaque */
	SOFT_BLENDED, /* by GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA */
	SOFT_MIXED,   /* alpha test; blended by any factors of 0, 1 and alpha */
	/* added to one of the first three: what happens before */
	SOFT_FOGGED = 4,
	SOFT_SUMMED = 8,  /* a second texture's texel is added */
	SOFT_SCALED = 12, /* times a second texture's texel; opaque */
	SOFT_FINISHES,
};

/* Whether functions of the finish can leave depths as they are. */
static inline bool soft_keeps_depth(enum soft_finish finish)
{
#ifdef __x86_64__ /* which draw four pixels at once */
	return true;
#endif
	return finish & SOFT_BLENDED; /* SOFT_MIXED, too */
}

/*
 * Which runs a span function draws, with texels anywhere or only inside of the
 * window, from first_texel; and its depth test, LESS or LEQUAL. Without a
 * texture the first two are the same.
 */
enum soft_place {
	SOFT_ANYWHERE,
	SOFT_INSIDE,
	SOFT_LEQUAL, /* added to one of the above; else LESS */
	SOFT_PLACES = 2 * SOFT_LEQUAL,
};

typedef soft_span_function soft_span_table[SOFT_SOURCES][SOFT_FINISHES]
					  [SOFT_PLACES];

/*
 * second, scaled (for RGBA8888 pictures) and joined have only finishes with a
 * second texture, and few formats.
 */
extern const soft_span_table soft_spans_565, soft_spans_8888, soft_spans_second,
	soft_spans_joined, soft_spans_scaled;

/* stages/samplers.c: [source][place]: write a run's texels as RGBA8888 to pixel. */
extern const soft_span_function soft_samplers[SOFT_SOURCES][2];

/*
 * [linear][place]: write a run's RGB565 texels as words for soft_run.second:
 * red of 5.5, green of 6.5 and blue of 5.6 bits, from the top.
 */
extern const soft_span_function soft_second_samplers[2][2];

#endif
