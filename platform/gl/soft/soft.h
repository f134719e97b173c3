/*
 * The fixed-point driver's context, which all of its files share.
 *
 * README.md tells the way of a triangle. State is kept as the program sets it;
 * each draw call derives from it what drawing needs (struct draw, draw.h).
 *
 * GL functions have no parameter for a context: they work on soft_current(),
 * and change it by soft_change(). All other functions are given the context or
 * the draw call.
 */
#ifndef PLATFORM_GL_SOFT_SOFT_H
#define PLATFORM_GL_SOFT_SOFT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/gl/gl_context.h"

enum {
	SOFT_LIGHTS = 8,
	SOFT_UNITS = 2,
	SOFT_TEXTURE_LISTS = 256,
	SOFT_LEVELS = 11, /* 1024 down to 1 */
	SOFT_TEXTURE_SIZE_MAX = 1024,
	SOFT_WIDTH_MAX = 64, /* of points and lines, in pixels */
	SOFT_STACK_DEPTH = 32,
};

/*
 * The groups of the state, as bits. A draw call prepares anew what reads a group
 * that has changed: parts[] in vertex/prepare.c says which part reads which.
 */
enum {
	GROUP_MATRICES = 1, /* model-view and projection */
	GROUP_ARRAYS = 2,   /* vertex arrays and which of them are enabled */
	GROUP_COLOR = 4, /* the current colour, or that an array replaces it */
	GROUP_LIGHTING = 8,  /* lights, material, and flags of lighting */
	GROUP_TEXTURES = 16, /* textures, their matrices and environments */
	GROUP_FRAGMENTS =
		32, /* all other state of drawing: fog, culling, tests */
	GROUP_VIEWPORT = 64, /* viewport, scissors, picture */
	GROUP_SCALE = 128, /* of positions, from their type and their values */
	GROUP_ALL = 255,
};

/* Names of ES 1.1 that gl.h does not have. */
enum {
	GL_SRC_ALPHA_SATURATE = 0x0308,
	GL_ADD_SIGNED = 0x8574,
	GL_INTERPOLATE = 0x8575,
	GL_SUBTRACT = 0x84E7,
};

/* Column-major, column vectors, as in GL. */
struct matrix {
	float m[16];
};

struct matrix_stack {
	struct matrix *top; /* the current matrix, an element of the next member */
	struct matrix matrix[SOFT_STACK_DEPTH];
};

/* The stacks in the order of glMatrixMode()'s names; one for each unit. */
enum {
	STACK_MODELVIEW,
	STACK_PROJECTION,
	STACK_TEXTURE,
	SOFT_STACKS = STACK_TEXTURE + SOFT_UNITS,
};

struct matrices {
	GLenum mode;
	struct matrix_stack stack[SOFT_STACKS];
};

/* Colours are 16.16, not clamped; position and direction are in eye space. */
struct light {
	bool enabled;
	GLfixed ambient[4], diffuse[4], specular[4];
	float position[4];
	float towards[3], half[3]; /* unit vectors, if position[3] is 0 */
	float direction[3];
	GLfixed exponent, cutoff; /* degrees */
	GLfixed attenuation[3];   /* constant, linear, quadratic */
};

struct material {
	GLfixed ambient[4], diffuse[4], specular[4], emission[4];
	GLfixed shininess;
};

struct lighting {
	struct light light[SOFT_LIGHTS];
	struct material material; /* ES has one for both faces */
	GLfixed ambient[4];
	GLfixed two_side; /* GL_LIGHT_MODEL_TWO_SIDE: 0 is off */
	bool enabled, color_material, normalize, rescale;
};

struct fog {
	bool enabled;
	GLenum mode;
	GLfixed density, start, end, color[4];
};

struct array {
	bool enabled;
	int size;
	GLenum type;
	int element_bytes, stride_bytes; /* never 0 */
	const uint8_t *pointer;
};

struct arrays {
	struct array vertex, normal, color, texcoord[SOFT_UNITS];
	int client_unit;
	GLfixed current_color[4], current_normal[3];
};

/* How the driver stores texels. */
enum texel_format {
	TEXEL_NONE,
	TEXEL_565,
	TEXEL_4444,
	TEXEL_5551,
	TEXEL_8888, /* bytes R G B A */
	TEXEL_L8,
	TEXEL_A8,
	TEXEL_LA88,
};

struct level {
	enum texel_format format;
	GLenum base_format; /* GL_RGB and so on, for the environment */
	int width_log2, height_log2;
	uint8_t *texels;     /* owned; row by row, first row first */
	struct tiles *tiles; /* owned; NULL unless luminance, see tiles.h */
	bool changed;        /* since the tiles were made */
};

struct texture {
	GLuint name;
	struct texture *next;
	GLenum min_filter, mag_filter, wrap_s, wrap_t;
	struct level level[SOFT_LEVELS];
};

struct texenv {
	GLenum mode;
	GLfixed color[4];
	GLenum combine_rgb, combine_alpha;
	GLenum source_rgb[3], source_alpha[3];
	GLenum operand_rgb[3], operand_alpha[3];
	GLfixed scale_rgb, scale_alpha;
};

struct unit {
	bool enabled;
	struct texture *bound; /* never NULL */
	struct texenv env;
};

struct textures {
	struct unit unit[SOFT_UNITS];
	int active;
	struct texture none; /* name 0 */
	/* [name % SOFT_TEXTURE_LISTS]: lists of all other textures */
	struct texture *first[SOFT_TEXTURE_LISTS];
	GLuint last_name;
	int unpack_alignment, pack_alignment;
};

struct stencil {
	bool enabled;
	GLenum function, fail, depth_fail, pass;
	uint8_t reference, mask, write_mask, clear;
};

struct rectangle {
	int x, y, width, height; /* GL's: y upwards */
};

/* The state of rasterization and of fragment operations. */
struct fragment_state {
	bool alpha_test, blend, depth_test, scissor_test, cull, offset_fill;
	bool flat, dither, point_smooth, line_smooth;
	GLenum alpha_function, depth_function;
	GLfixed alpha_reference;
	GLenum blend_source, blend_destination;
	GLboolean color_mask[4], depth_mask;
	/* the pixels' bits that color_mask lets through; 565 in both halves */
	uint32_t color_bits;
	GLenum cull_face, front_face;
	GLfixed offset_factor, offset_units;
	GLfixed line_width, point_size;
	GLfixed clear_color[4], clear_depth;
	struct stencil stencil;
	struct rectangle scissor, viewport;
};

/* The picture, given for each frame, and the driver's own buffers for it. */
struct buffers {
	struct pixels target; /* data NULL between frames */
	uint16_t *depth;      /* [height][width], owned */
	uint8_t *stencil; /* [height][width], owned; NULL until first enabled */
	size_t room;      /* pixels that each has memory for */
	int width, height; /* of the last frame */
};

struct draw;
struct setup;

struct soft {
	struct gl_context base; /* first: pointers to it are cast to soft */
	struct log log;
	enum pixel_format format;
	GLenum error;
	uint32_t changed; /* groups, since a draw call was prepared for them */
	struct buffers buffers;
	struct lighting lighting;
	struct fog fog;
	struct arrays arrays;
	struct textures textures;
	struct fragment_state fragment;
	/*
	 * NULL, or a test's function that draws all triangles instead; the test
	 * sets changed, too.
	 */
	void (*fill)(struct draw *draw, struct setup *setup);
	struct draw *draw;        /* scratch of the draw call, owned */
	struct gl_counts *counts; /* or NULL */
	struct matrices matrices; /* last: offsets of the others stay short */
};

/* The context of GL's functions; and the same, some of whose groups change. */
struct soft *soft_current(void);
struct soft *soft_change(uint32_t groups);
void soft_make_current(struct soft *soft);

/* defaults.c: sets the context's table of functions and GL's initial state. */
void soft_init_state(struct soft *soft);

/* texture.c: a texture without levels, with GL's initial parameters. */
struct texture soft_new_texture(GLuint name);
void soft_release_textures(struct soft *soft);

/* state.c: the stencil buffer, allocated when needed; NULL without memory. */
uint8_t *soft_stencil(struct soft *soft);

/* A rectangle of the picture; row 0 is at the top. */
struct clip_box {
	int left, top, right, bottom; /* right and bottom are outside */
};
/* state.c: the picture inside the scissor box and, if asked, the viewport. */
struct clip_box soft_clip_box(const struct soft *soft, bool viewport);

/*
 * Converts a depth, 16.16 in 0 to 1, to units of the depth buffer: 1 to 65533,
 * or 65535 for 1. So rounding errors of interpolation never wrap around.
 */
static inline int soft_depth_units(GLfixed depth)
{
	return depth >= 65536 ? 65535 : 1 + (int)((int64_t)depth * 65533 >> 16);
}

/* Converts 16.16 in 0 to 1 to a byte of 0 to 255; other values are clamped. */
static inline int soft_byte(GLfixed value)
{
	if (value <= 0) {
		return 0;
	}
	return value >= 65536 ? 255 : (value * 255 + 32768) >> 16;
}

#endif
