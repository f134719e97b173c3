/*
 * What vertices are lit by: what prepare_light.c derives from the state once a
 * draw call. Numbers are named as in draw.h.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_SHADING_H
#define PLATFORM_GL_SOFT_VERTEX_SHADING_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

/*
 * The powers of cosines for one shininess: 64 steps from where they begin to
 * count, 2^-10, to 1.
 */
enum {
	SPEC_TABLE_STEPS = 64,
	SPEC_TABLES = 4
};

struct spec_table {
	int32_t shininess_q16;
	int32_t least_q26; /* the cosine where they begin */
	int32_t scale; /* from there, Q26, to steps with 8 bits, Q-18; 0: none */
	struct spec_table_step {
		_Alignas(8) int32_t value_q28;
		int32_t rise_q28; /* a 256th of the way to the next */
	} step[SPEC_TABLE_STEPS];
};

/*
 * A light in the space that normals are lit in; directions are shorter than 2.
 * Diffuse and ambient colours are 257/256 of what they are, so that a byte's
 * 255 makes 1 of them; all are less by 2^shift, so that they stay below 2.
 */
struct light_source {
	int32_t towards_q30[3], diffuse_q30[3];
	const struct spec_table_step *step; /* NULL: no highlights */
	int32_t half_q30[3], least_q26, scale;
	int32_t specular_q20[3]; /* as it is */
	int shift;
	/* positional ones, in eye space; for each vertex they become as above */
	bool positional, spot;
	int32_t ambient_q24[3];
	int32_t position_q16[3], direction_q28[3];
	int32_t attenuation_q16[3], cutoff_q28, exponent_q16;
};

struct shading {
	/*
	 * Most vertices are lit the fast way: by directional lights and normals
	 * that are not rotated, three GL_SHORTs of any length or three aligned
	 * floats, and colours of four bytes.
	 */
	_Alignas(32) const uint8_t *normals;
	int normal_stride;
	const uint8_t *colors;
	int color_stride;      /* 0: all of the same colour, below */
	const uint16_t *roots; /* soft_root_table */
	const struct light_source *end;
	int floats;
	/*
	 * Floats whose squares, Q24, are not from least on and less than range
	 * above it are not taken; the sum is at most 2^26.
	 */
	uint32_t square_least, square_range;
	int32_t ambient_q24[3], emission_q16[3]; /* the latter as it is */
	struct light_source light_source[SOFT_LIGHTS];
	uint8_t color[4];

	bool lit, fast, two_side, tracked, color_array;
	bool normalize, rotate_normals;
	int32_t normal_q28[9]; /* rotates normals where lights stay behind */
	int32_t ambient_q16[3], alpha_q16; /* without light sources */
};

/*
 * Colours beyond +-1024 change no picture. Without them every sum of colours in
 * light.c stays below 2^31.
 */
static inline int32_t shading_bound(int64_t color_q16)
{
	const int32_t most = 1 << 26;

	return color_q16 > most     ? most
		: color_q16 < -most ? -most
				    : (int32_t)color_q16;
}

#endif
