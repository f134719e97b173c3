/*
 * Lights and materials as vertices use them, which prepare_light.c derives from
 * the state once a draw call. A name's suffix says its Q format.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_SHADING_H
#define PLATFORM_GL_SOFT_VERTEX_SHADING_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

/*
 * cosine ^ shininess for one shininess, interpolated linearly in 64 steps from
 * the cosine whose power is 2^-10 up to 1.
 */
enum {
	SPEC_TABLE_STEPS = 64
};

struct spec_table {
	int32_t shininess_q16;
	int32_t least_q26; /* the cosine at step 0 */
	int32_t scale; /* of (cosine - least) to steps in Q8; 0: table not made */
	struct spec_table_step {
		_Alignas(8) int32_t value_q28;
		int32_t rise_q28; /* 1/256 of the difference to the next value */
	} step[SPEC_TABLE_STEPS];
};

/*
 * A light in the space of the normals; directions are shorter than 2. Colours
 * are light times material, divided by 2^shift to stay below 2; diffuse and
 * ambient ones times 257/256, so that a vertex colour's byte of 255 keeps them.
 */
struct light_source {
	int32_t towards_q30[3], diffuse_q30[3];
	const struct spec_table_step *step; /* NULL: no highlights */
	int32_t half_q30[3], least_q26, scale;
	int32_t specular_q20[3]; /* without the factor of 257/256 */
	int shift;
	bool weighted, spot;
	int32_t share_q16; /* if weighted: what vertices get of the light */
	int32_t ambient_q24[3]; /* the same; else struct shading has it */
	/* positional lights, in eye space; meet() finds directions by vertex */
	bool positional;
	bool fades; /* share_q16, too, depends on the vertex */
	/* position_q fraction bits, as eye coordinates have >> eye_shift */
	int32_t position[3];
	int eye_shift, position_q;
	const struct light *light; /* of the state */
	int32_t direction_q28[3], attenuation_q16[3], cutoff_q26, exponent_q16;
};

struct shading {
	/*
	 * If fast, light.c fetches arrays without conversion and no light has a
	 * weight: no normal is rotated, normals are three GL_SHORTs of any
	 * length or three aligned floats, and colours are four bytes.
	 */
	_Alignas(32) const uint8_t *normals;
	int normal_stride;
	const uint8_t *colors;
	int color_stride;      /* 0: colors points to color below, for all */
	const uint16_t *roots; /* soft_root_table */
	int floats;            /* normals are floats, else shorts */
	/*
	 * Normals of floats are lit as they are if their length squared, Q24,
	 * minus square_least is less than square_range; the sum is at most 2^26.
	 */
	uint32_t square_least, square_range;
	/* of all lights without a weight; ambient times 257/256 */
	int32_t ambient_q24[3], emission_q16[3];
	/*
	 * Lights from weighted to end are multiplied by a weight, which may
	 * depend on the vertex; those before are directional with a shift of 0.
	 */
	struct light_source *weighted, *end;
	struct light_source light_source[SOFT_LIGHTS];
	uint8_t color[4];

	bool lit, fast, tracked;
	/* Both sides are lit, or the back in place of the front, if it is culled. */
	bool two_side, back_only;
	bool normalize, rotate_normals;
	/*
	 * If rotate_normals: to eye space, column-major, divided by
	 * 2^normal_shift, which the lights' weights make up for. Else turned,
	 * the same matrix, transforms lights.
	 */
	float turned[9];
	int32_t normal_q28[9];
	int normal_shift;
	int32_t alpha_q16;
};

#endif
