/*
 * A struct gl that keeps the texture it was sent last, and draws nothing. There
 * is one at a time, because GL's calls carry no context. Tests read and write
 * the members of texture_sent themselves.
 */
#ifndef TESTS_SUPPORT_GL_TEXTURE_SENT_H
#define TESTS_SUPPORT_GL_TEXTURE_SENT_H

#include "app/model/model.h"
#include "platform/gl/gl.h"

enum {
	TEXTURE_SENT_LEVELS_MAX = 12,
	TEXTURE_SENT_BYTES_MAX = 4096
};

struct texture_sent_level {
	int width, height;
	GLenum format, type;
	uint8_t data[TEXTURE_SENT_BYTES_MAX]; /* the first texels */
};

struct texture_sent {
	int level_count;
	struct texture_sent_level level[TEXTURE_SENT_LEVELS_MAX];
	GLfixed magnify, minify, wrap_s, wrap_t;
	GLenum error;       /* what GetError() returns next */
	int deleted, named; /* how many textures so far */
	GLuint bound;       /* the name bound last; the first name is 70 */
	GLfixed scale[2];   /* of texture coordinates */
};

extern struct texture_sent texture_sent;

/* Forgets what was sent. Returns a table that keeps what is sent to it. */
struct gl texture_sent_begin(void);

/* An image of arbitrary texels, whose rgba the caller frees. */
struct model_image texture_sent_image(int width, int height, bool opaque);

#endif
