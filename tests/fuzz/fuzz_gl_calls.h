/*
 * What the parts of fuzz_gl share: the input as a stream of bytes, values of GL
 * made from it, and the calls that set state.
 */
#ifndef TESTS_FUZZ_FUZZ_GL_CALLS_H
#define TESTS_FUZZ_FUZZ_GL_CALLS_H

#include "platform/gl/gl_context.h"

#include <stddef.h>
#include <stdint.h>

#define ONE          65536
#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

enum {
	POOL_BYTES = 1 << 17,
	VERTICES = 256,
	SIDE_MAX = 72,
	CALLS_MAX = 400,
	TEXTURES = 4
};

struct reader {
	const uint8_t *at, *end;
};

struct scene {
	struct gl_context *context;
	const struct gl *gl;
	struct reader *from;
	struct pixels target;
	uint8_t *pool; /* what arrays and pictures are read from */
	uint16_t index[VERTICES];
	GLuint texture[TEXTURES];
};

static inline unsigned int byte(struct reader *from)
{
	return from->at < from->end ? *from->at++ : 0;
}

static inline GLfixed fixed(struct reader *from)
{
	unsigned int kind = byte(from);
	int value = (int)(byte(from) << 8 | byte(from)) - 32768;

	switch (kind % 8) {
	case 0:
		return (GLfixed)((unsigned int)value << 16 | byte(from) << 8);
	case 1:
		return kind & 8 ? INT32_MAX : INT32_MIN;
	case 2:
		return 0;
	case 3:
		return ONE;
	case 4:
		return value;
	default:
		return value * 4;
	}
}

static inline GLenum pick(
	struct reader *from, const uint16_t *list, size_t count)
{
	unsigned int choice = byte(from);

	/* One in 64 is no value of the list, and seldom one of GL. */
	return choice < 252 ? list[choice % count]
			    : 0x0b00u + byte(from) + (choice << 8);
}

#define PICK(from, ...)                               \
	pick((from), (const uint16_t[]){__VA_ARGS__}, \
		COUNT(((const uint16_t[]){__VA_ARGS__})))

static inline GLenum comparison(struct reader *from)
{
	return PICK(from, GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER,
		GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS);
}

static inline GLenum capability(struct reader *from)
{
	return PICK(from, GL_FOG, GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE,
		GL_ALPHA_TEST, GL_BLEND, GL_STENCIL_TEST, GL_DEPTH_TEST,
		GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_COLOR_MATERIAL, GL_NORMALIZE,
		GL_RESCALE_NORMAL, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL,
		GL_DITHER, GL_POINT_SMOOTH, GL_LINE_SMOOTH);
}

static inline GLenum array(struct reader *from)
{
	return PICK(from, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
		GL_TEXTURE_COORD_ARRAY);
}

static inline void values(struct reader *from, GLfixed *out, int count)
{
	for (int i = 0; i < count; i++) {
		out[i] = fixed(from);
	}
}

/* Each makes one call, or a few that belong together, from the next bytes. */
void fuzz_gl_matrix(struct scene *scene);
void fuzz_gl_light(struct scene *scene);
void fuzz_gl_fragment(struct scene *scene);
void fuzz_gl_texture(struct scene *scene);
void fuzz_gl_arrays(struct scene *scene);

#endif
