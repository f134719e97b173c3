/* Vertex arrays' pointers and enables; the current colour and normal. */
#include <string.h>

#include "platform/gl/soft/state/state.h"

static void describe(struct array *array, int size, int least, bool type_known,
	GLenum type, GLsizei stride, const void *pointer)
{
	int bytes = IS_ONE_OF(type, GL_BYTE, GL_UNSIGNED_BYTE) ? 1
		: type == GL_SHORT                             ? 2
							       : 4;

	if (soft_check(size >= least && size <= 4 && stride >= 0,
		    GL_INVALID_VALUE) &&
		soft_check(type_known, GL_INVALID_ENUM)) {
		soft_change(GROUP_ARRAYS);
		array->size = size;
		array->type = type;
		array->element_bytes = size * bytes;
		array->stride_bytes = stride ? stride : size * bytes;
		array->pointer = pointer;
	}
}

static bool is_signed_type(GLenum type)
{
	return IS_ONE_OF(type, GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT);
}

void soft_gl_VertexPointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.vertex, size, 2, is_signed_type(type),
		type, stride, pointer);
}

void soft_gl_NormalPointer(GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.normal, 3, 3, is_signed_type(type),
		type, stride, pointer);
}

void soft_gl_ColorPointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.color, size, 4,
		IS_ONE_OF(type, GL_UNSIGNED_BYTE, GL_FIXED, GL_FLOAT), type,
		stride, pointer);
}

void soft_gl_TexCoordPointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	struct arrays *arrays = &soft_current()->arrays;

	describe(&arrays->texcoord[arrays->client_unit], size, 2,
		is_signed_type(type), type, stride, pointer);
}

static void set_enabled(GLenum name, bool on)
{
	struct arrays *arrays = &soft_current()->arrays;
	struct array *array = name == GL_VERTEX_ARRAY ? &arrays->vertex
		: name == GL_NORMAL_ARRAY             ? &arrays->normal
		: name == GL_COLOR_ARRAY              ? &arrays->color
		: name == GL_TEXTURE_COORD_ARRAY
		? &arrays->texcoord[arrays->client_unit]
		: NULL;

	if (soft_check(array != NULL, GL_INVALID_ENUM) && array->enabled != on) {
		soft_change(array != &arrays->color
				? GROUP_ARRAYS
				: GROUP_ARRAYS | GROUP_COLOR | GROUP_FRAGMENTS);
		array->enabled = on;
	}
}

void soft_gl_EnableClientState(GLenum name)
{
	set_enabled(name, true);
}

void soft_gl_DisableClientState(GLenum name)
{
	set_enabled(name, false);
}

void soft_gl_Color4x(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed given[4] = {red, green, blue, alpha};

	memcpy(soft_change(GROUP_COLOR)->arrays.current_color, given,
		sizeof(given));
}

void soft_gl_Normal3x(GLfixed x, GLfixed y, GLfixed z)
{
	const GLfixed given[3] = {x, y, z};

	memcpy(soft_current()->arrays.current_normal, given, sizeof(given));
}
