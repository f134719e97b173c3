/* What a program may ask. */
#include "platform/gl/soft/soft.h"

void soft_set_error(struct soft *soft, GLenum error)
{
	if (soft->error == GL_NO_ERROR) {
		soft->error = error;
	}
}

static GLenum get_error(void)
{
	struct soft *soft = soft_current();
	GLenum error = soft->error;

	soft->error = GL_NO_ERROR;
	return error;
}

static void get_integer(GLenum name, GLint *values)
{
	switch (name) {
	case GL_MAX_TEXTURE_SIZE:
		*values = SOFT_TEXTURE_SIZE_MAX;
		return;
	case GL_MAX_TEXTURE_UNITS:
		*values = SOFT_UNITS;
		return;
	case GL_MAX_MODELVIEW_STACK_DEPTH:
		*values = SOFT_MODELVIEW_DEPTH;
		return;
	case GL_STENCIL_BITS:
		*values = 8;
		return;
	case GL_SUBPIXEL_BITS:
		*values = 4;
		return;
	case GL_SMOOTH_POINT_SIZE_RANGE:
	case GL_SMOOTH_LINE_WIDTH_RANGE:
	case GL_ALIASED_POINT_SIZE_RANGE:
	case GL_ALIASED_LINE_WIDTH_RANGE:
		values[0] = 1;
		values[1] = SOFT_WIDTH_MAX;
		return;
	case GL_DEPTH_BITS:
		*values = 16;
		return;
	default:
		soft_set_error(soft_current(), GL_INVALID_ENUM);
	}
}

static const GLubyte *get_string(GLenum name)
{
	switch (name) {
	case GL_VENDOR:
		return (const GLubyte *)"limber";
	case GL_RENDERER:
		return (const GLubyte *)"soft";
	case GL_VERSION:
		return (const GLubyte *)"OpenGL ES-CL 1.1";
	case GL_EXTENSIONS:
		return (const GLubyte *)"";
	default:
		soft_set_error(soft_current(), GL_INVALID_ENUM);
		return NULL;
	}
}

void soft_init_query(struct soft *soft)
{
	struct gl *gl = &soft->base.gl;

	gl->GetError = get_error;
	gl->GetIntegerv = get_integer;
	gl->GetString = get_string;
}
