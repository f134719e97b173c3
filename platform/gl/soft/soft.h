/*
 * The fixed-point driver's context and what its chapters share.
 *
 * README.md tells the way of a triangle. State is kept as GL tells it; what
 * drawing needs is derived from it once a draw call (struct draw, draw.h).
 *
 * Calls of GL carry no context: soft_current() is what they work on, and it
 * is the one thing here that is not passed.
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
	SOFT_MODELVIEW_DEPTH = 32,
	SOFT_PROJECTION_DEPTH = 4,
	SOFT_TEXTURE_DEPTH = 4,
};

/* Column-major, column vectors, as in GL. */
struct matrix {
	float m[16];
};

struct matrix_stack {
	struct matrix *top; /* of one of the arrays of struct matrices */
	struct matrix *bottom;
	int room;
};

struct matrices {
	GLenum mode;
	struct matrix modelview[SOFT_MODELVIEW_DEPTH];
	struct matrix projection[SOFT_PROJECTION_DEPTH];
	struct matrix texture[SOFT_UNITS][SOFT_TEXTURE_DEPTH];
	struct matrix_stack modelview_stack;
	struct matrix_stack projection_stack;
	struct matrix_stack texture_stack[SOFT_UNITS];
};

/* Colours are 16.16 as given; positions and directions in eye space. */
struct light {
	bool enabled;
	GLfixed ambient[4], diffuse[4], specular[4];
	float position[4];
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
	GLfixed two_side; /* unless 0 */
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
	int stride_bytes; /* never 0 */
	const uint8_t *pointer;
};

struct arrays {
	struct array vertex, normal, color, texcoord[SOFT_UNITS];
	int client_unit;
	GLfixed current_color[4], current_normal[3];
};

/* Texels as they are kept. */
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
	struct tiles *tiles; /* of luminance, see tiles.h; or NULL; owned */
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
	/* The others: lists, by the name's remainder. */
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

/* What happens to fragments, and to triangles before they are some. */
struct fragment_state {
	bool alpha_test, blend, depth_test, scissor_test, cull, offset_fill;
	bool flat, dither, point_smooth, line_smooth;
	GLenum alpha_function, depth_function;
	GLfixed alpha_reference;
	GLenum blend_source, blend_destination;
	GLboolean color_mask[4], depth_mask;
	GLenum cull_face, front_face;
	GLfixed offset_factor, offset_units;
	GLfixed line_width, point_size;
	GLfixed clear_color[4], clear_depth;
	struct stencil stencil;
	struct rectangle scissor, viewport;
};

/* The picture and the buffers beside it, which grow only in begin_frame(). */
struct buffers {
	struct pixels target; /* data NULL between frames */
	uint16_t *depth;      /* [height][width], owned */
	uint8_t *stencil;     /* the same; NULL until it is asked for */
	size_t room;          /* pixels there is depth for */
	size_t stencil_room;
	int width, height; /* of the last frame */
};

struct draw;
struct setup;

struct soft {
	struct gl_context base; /* first: the two share their address */
	struct log log;
	enum pixel_format format;
	GLenum error;
	struct buffers buffers;
	struct matrices matrices;
	struct lighting lighting;
	struct fog fog;
	struct arrays arrays;
	struct textures textures;
	struct fragment_state fragment;
	/* Draws triangles in place of the driver: a test's reference, or NULL. */
	void (*fill)(struct draw *draw, struct setup *setup);
	struct draw *draw;        /* scratch of the draw call, owned */
	struct gl_counts *counts; /* or NULL */
};

struct soft *soft_current(void);
void soft_make_current(struct soft *soft);

/* Remembers the first error since GetError(). */
void soft_set_error(struct soft *soft, GLenum error);

/* defaults.c: all calls of the context's table, and GL's defaults. */
void soft_init_state(struct soft *soft);

/* texture.c */
struct texture soft_new_texture(GLuint name);
void soft_release_textures(struct soft *soft);

/* The stencil buffer, made when it is first wanted; NULL without memory. */
uint8_t *soft_stencil(struct soft *soft);

/* The picture's part inside a rectangle of GL's, in rows from the top. */
struct clip_box {
	int left, top, right, bottom; /* right and bottom are outside */
};
struct clip_box soft_clip_box(const struct soft *soft, bool viewport);

/*
 * A depth of 0..65536 as the buffer has it. The ends are left free, so that
 * what interpolation rounds never wraps.
 */
static inline int soft_depth_units(GLfixed depth)
{
	return depth >= 65536 ? 65535 : 1 + (int)((int64_t)depth * 65533 >> 16);
}

/* 0..65536 to 0..255, clamped. */
static inline int soft_byte(GLfixed value)
{
	if (value <= 0) {
		return 0;
	}
	return value >= 65536 ? 255 : (value * 255 + 32768) >> 16;
}

#endif
