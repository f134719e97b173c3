/*
 * Runs: up to SOFT_RUN_PIXELS pixels of one row whose values change linearly,
 * and the functions that draw them, one for each combination of texture,
 * filter, fragment state and picture format. walk.c makes runs from
 * triangles; template.h is the text that all functions are made of.
 *
 * Number formats:
 *	z           16.16
 *	red, blue   in the halves of one word, and green in the lower half
 *	            of another: what a texel's channel is multiplied with,
 *	            1.14, times the ratio of the picture's and the texel's
 *	            largest values; without a texture what is drawn: 5.11 and
 *	            6.9, a half added, or 8.8
 *	alpha       8.7, above green
 *	fog         1.15: how much of the fragment's own colour stays
 *	s, t        in texels of the level, 9 bits of fraction; for bilinear
 *	            textures half a texel less
 */
#ifndef PLATFORM_GL_SOFT_SPAN_RUN_H
#define PLATFORM_GL_SOFT_SPAN_RUN_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

enum {
	/*
	 * s and t, which are exact in the middle, lose up to 1/1024 of a texel
	 * a pixel to rounding.
	 */
	SOFT_RUN_PIXELS = 64,
	/* Colours lose up to 1/2048 of a step of RGB565 a pixel. */
	SOFT_PLAIN_PIXELS = 512,
	/* Columns and rows of small triangles, whose runs are one list, at most. */
	SOFT_LISTED_SIZE = 62,
	/* Of all runs of a list that one call draws, and how many these are. */
	SOFT_BATCH_PIXELS = 1024,
	SOFT_BATCH_RUNS = 64,
	/* As many texels fit a half of a word, with 9 bits of fraction. */
	SOFT_RUN_TEXELS = 128,
};

/*
 * What all fragments of a draw call go through after their texture, where a
 * span function has no constants for it.
 */
struct soft_fragment_stages {
	/*
	 * Red, green and blue of the picture, times 2^14: the fog's colour and
	 * a half; or less than 0 what is added to all fragments, without fog
	 */
	int32_t far[3], fog[3];
	/* alpha passes when (alpha - low) modulo 256 is at most range */
	uint32_t alpha_low, alpha_range;
	bool alpha_scaled; /* the first texture's alpha times the fragment's */
	GLenum blend_source, blend_destination;
	/*
	 * SOFT_MIXED: the factors of the fragment's colour, and in the upper
	 * half of the picture's, are base and alpha times by.
	 */
	uint32_t factors_base, factors_by;
	uint32_t unseen; /* an alpha that changes nothing; 256: there is none */
};

struct draw;

/* What of a run is its own where others of its triangle follow. */
struct soft_row {
	uint16_t *depth;
	uint8_t *pixel;
	uint32_t count; /* 1 to SOFT_RUN_PIXELS, see plain_pixels */
	uint32_t z;
	uint32_t red_blue; /* blue in the upper half */
	uint32_t green_alpha;
	uint32_t fog;
	/* t in the upper half and s in the lower one, from first_texel on */
	uint32_t texel, texel_right;
	/*
	 * In states of soft_spans.made or second: the column, and in the upper
	 * half the row, counted from the triangle's first one.
	 */
	uint32_t place;
};

struct soft_run {
	/* The runs that are drawn: row alone, but where first_texel is used. */
	const struct soft_row *rows;
	uint32_t row_count;
	struct soft_row row;
	uint32_t z_right, red_blue_right, green_alpha_right, fog_right;
	/*
	 * Where all texels that are wanted lie in the level, both coordinates
	 * below SOFT_RUN_TEXELS from here.
	 */
	const uint8_t *first_texel;
	/* Elsewhere */
	const uint8_t *texels;
	int32_t s, t, s_right, t_right;
	uint32_t s_last, t_last; /* texels, and masks of coordinates */
	uint32_t stride_log2;    /* of the level, in bytes */
	/*
	 * With a second texture: the address of its texels, a word for each
	 * pixel, row by row.
	 */
	uintptr_t second;
	/* Or, where it has the first one's coordinates: from its texels to those. */
	uintptr_t joint;
	const struct soft_fragment_stages *stages;
	struct draw *draw; /* whose run it is */
};

typedef void (*soft_span_function)(const struct soft_run *run);

/* Textures as a span function reads them. */
enum soft_source {
	SOFT_NO_TEXTURE,
	SOFT_NEAREST, /* and enum texel_format - 1 */
	SOFT_LINEAR = SOFT_NEAREST + TEXEL_LA88,
	SOFT_SOURCES = SOFT_LINEAR + TEXEL_LA88,
};

/* What happens to a fragment after its texture. */
enum soft_finish {
	SOFT_OPAQUE,
	SOFT_TESTED,  /* by alpha; then opaque */
	SOFT_BLENDED, /* by GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA */
	SOFT_OPAQUE_FOG,
	SOFT_TESTED_FOG,
	SOFT_BLENDED_FOG,
	SOFT_MIXED,  /* tested, then blended by any factors that alpha makes */
	SOFT_SCALED, /* by a second texture's texel; opaque */
	/* A second texture's texel is added: opaque, tested, blended. */
	SOFT_SUMMED,
	SOFT_TESTED_SUMMED,
	SOFT_BLENDED_SUMMED,
	SOFT_FINISHES,
};

/*
 * Which runs a span function takes, anywhere in the texture or only those with
 * first_texel; and its depth test, LESS or LEQUAL. Without a texture the first
 * two are the same.
 */
enum soft_place {
	SOFT_ANYWHERE,
	SOFT_INSIDE,
	SOFT_LEQUAL, /* and one of the above */
	SOFT_PLACES = 2 * SOFT_LEQUAL,
};

typedef soft_span_function soft_span_table[SOFT_SOURCES][SOFT_FINISHES]
					  [SOFT_PLACES];

/* spans_second has the finishes with a second texture, and a few formats. */
extern const soft_span_table soft_spans_565, soft_spans_8888, soft_spans_second,
	soft_spans_joined;

/* stages/samplers.c: the same for a run's texels alone, which become RGBA8888 at pixel. */
extern const soft_span_function soft_samplers[SOFT_SOURCES][2];

/*
 * The same of RGB565 texels, nearest and linear, which become words for
 * soft_run.second: red of 5.5, green of 6.5 and blue of 5.6 bits, from the top.
 */
extern const soft_span_function soft_second_samplers[2][2];

#endif
