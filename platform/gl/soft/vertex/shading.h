/*
 * What vertices are lit by: what prepare_light.c and prepare_dir_lights.c
 * derive from the state once a draw call. Numbers are named as in draw.h.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_SHADING_H
#define PLATFORM_GL_SOFT_VERTEX_SHADING_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

/* A light as vertices meet it, in the space normals are given in. */
struct light_source {
	bool positional, spot, specular;
	int32_t towards_q28[3], half_q28[3];
	int32_t diffuse_q22[3], specular_q20[3], ambient_q16[3];
	/* positional ones, in eye space */
	int32_t position_q16[3], direction_q28[3];
	int32_t attenuation_q16[3], cutoff_q28, exponent_q16;
};

struct shading {
	bool lit, two_side, tracked, normalize, rotate_normals;
	int32_t normal_q28[9]; /* rotates normals where lights stay behind */
	int light_source_count;
	struct light_source light_source[SOFT_LIGHTS];
	int32_t base_q16[4]; /* the colour without light sources */
	int32_t emission_q16[3];
	int32_t ambient_q16[3]; /* where the colour is tracked */
	int32_t shininess_q16;
	bool color_array;
	bool by_dir_lights; /* struct dir_lights takes it */
};

/*
 * The powers of cosines for one shininess, of 1 or more: 64 steps from where
 * they begin to count, 2^-10, to 1.
 */
enum {
	SPEC_TABLE_STEPS = 64,
	SPEC_TABLES = 4
};

struct spec_table {
	int32_t shininess_q16; /* 0: none yet */
	int32_t least_q26;     /* the cosine where they begin */
	int32_t scale;         /* from there, Q26, to steps with 8 bits, Q-18 */
	struct spec_table_step {
		_Alignas(8) int32_t value_q28;
		int32_t rise_q28; /* a 256th of the way to the next */
	} step[SPEC_TABLE_STEPS];
};

/*
 * What most vertices are lit by: directional lights in the normals' space, for
 * normals of three GL_SHORTs of any length or three aligned floats, and colours
 * of four bytes. Colours are 257/256 of what they are, so that a byte's 255
 * makes 1 of them.
 */
struct dir_light {
	int32_t towards_q30[3], diffuse_q30[3];
	const struct spec_table_step *step; /* NULL: no highlights */
	int32_t half_q30[3], least_q26, scale;
	int32_t specular_q20[3]; /* as it is */
};

struct dir_lights {
	_Alignas(32) const uint8_t *normals;
	int normal_stride;
	const uint8_t *colors;
	int color_stride;      /* 0: all of the same colour, below */
	const uint16_t *roots; /* soft_root_table */
	const struct dir_light *end;
	int two_side, floats;
	/*
	 * Floats whose squares, Q24, are not from least on and less than range
	 * above it are left to soft_light(); the sum is at most 2^26.
	 */
	uint32_t square_least, square_range;
	int32_t ambient_q24[3], emission_q16[3]; /* the latter as it is */
	struct dir_light dir_light[SOFT_LIGHTS];
	uint8_t color[4];
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
