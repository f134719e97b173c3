#include "tests/support/gl/texture_sent.h"

#include "platform/base/fixed.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

struct texture_sent texture_sent;

static size_t texel_bytes(GLenum format, GLenum type)
{
	return type != GL_UNSIGNED_BYTE ? 2 : format == GL_LUMINANCE ? 1 : 4;
}

static void tex_image(GLenum target, GLint number, GLint internal,
	GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
	const void *data)
{
	struct texture_sent_level *level = &texture_sent.level[number];
	size_t bytes =
		(size_t)width * (size_t)height * texel_bytes(format, type);

	assert_int_equal(target, GL_TEXTURE_2D);
	assert_int_equal(number, texture_sent.level_count);
	assert_int_equal(internal, format);
	assert_int_equal(border, 0);
	texture_sent.level_count++;
	level->width = width;
	level->height = height;
	level->format = format;
	level->type = type;
	memcpy(level->data, data,
		bytes < TEXTURE_SENT_BYTES_MAX ? bytes : TEXTURE_SENT_BYTES_MAX);
}

static void tex_parameter(GLenum target, GLenum name, GLfixed value)
{
	(void)target;
	*(name == GL_TEXTURE_MAG_FILTER                 ? &texture_sent.magnify
			: name == GL_TEXTURE_MIN_FILTER ? &texture_sent.minify
			: name == GL_TEXTURE_WRAP_S     ? &texture_sent.wrap_s
						    : &texture_sent.wrap_t) =
		value;
}

static void gen_textures(GLsizei count, GLuint *textures)
{
	for (int i = 0; i < count; i++) {
		textures[i] = (GLuint)(70 + texture_sent.named++);
	}
	texture_sent.level_count = 0;
}

static void delete_textures(GLsizei count, const GLuint *textures)
{
	(void)textures;
	texture_sent.deleted += count;
}

static void bind_texture(GLenum target, GLuint texture)
{
	assert_int_equal(target, GL_TEXTURE_2D);
	texture_sent.bound = texture;
}

static void scale(GLfixed x, GLfixed y, GLfixed z)
{
	assert_int_equal(z, FX16_ONE);
	texture_sent.scale[0] = x;
	texture_sent.scale[1] = y;
}

static GLenum get_error(void)
{
	GLenum error = texture_sent.error;

	texture_sent.error = GL_NO_ERROR;
	return error;
}

struct gl texture_sent_begin(void)
{
	struct gl gl = gl_recorder_begin();

	memset(&texture_sent, 0, sizeof(texture_sent));
	gl.TexImage2D = tex_image;
	gl.TexParameterx = tex_parameter;
	gl.GenTextures = gen_textures;
	gl.DeleteTextures = delete_textures;
	gl.BindTexture = bind_texture;
	gl.Scalex = scale;
	gl.GetError = get_error;
	return gl;
}

struct model_image texture_sent_image(int width, int height, bool opaque)
{
	struct model_image image = {.name = "image",
		.width = width,
		.height = height,
		.opaque = opaque,
		.rgba = malloc((size_t)width * (size_t)height * 4)};
	uint32_t chance = 12345;

	assert_non_null(image.rgba);
	for (int i = 0; i < 4 * width * height; i++) {
		chance = chance * 1664525u + 1013904223u;
		image.rgba[i] =
			opaque && i % 4 == 3 ? 255 : (uint8_t)(chance >> 24);
	}
	return image;
}
