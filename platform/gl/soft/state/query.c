/* What a program may ask. */
#include <string.h>

#include "platform/gl/soft/state/parameter.h"

static GLenum get_error(void)
{
	struct soft *soft = soft_current();
	GLenum error = soft->error;

	soft->error = GL_NO_ERROR;
	return error;
}

static const struct {
	GLenum name;
	int count;
	GLint value[2];
} numbers[] = {
	{GL_MAX_TEXTURE_SIZE, 1, {SOFT_TEXTURE_SIZE_MAX}},
	{GL_MAX_TEXTURE_UNITS, 1, {SOFT_UNITS}},
	{GL_MAX_MODELVIEW_STACK_DEPTH, 1, {SOFT_MODELVIEW_DEPTH}},
	{GL_STENCIL_BITS, 1, {8}},
	{GL_SUBPIXEL_BITS, 1, {4}},
	{GL_DEPTH_BITS, 1, {16}},
	{GL_SMOOTH_POINT_SIZE_RANGE, 2, {1, SOFT_WIDTH_MAX}},
	{GL_SMOOTH_LINE_WIDTH_RANGE, 2, {1, SOFT_WIDTH_MAX}},
	{GL_ALIASED_POINT_SIZE_RANGE, 2, {1, SOFT_WIDTH_MAX}},
	{GL_ALIASED_LINE_WIDTH_RANGE, 2, {1, SOFT_WIDTH_MAX}},
};

static void get_integer(GLenum name, GLint *values)
{
	size_t i = 0;

	while (i < ARRAY_COUNT(numbers) && numbers[i].name != name) {
		i++;
	}
	if (soft_check(i < ARRAY_COUNT(numbers), GL_INVALID_ENUM)) {
		memcpy(values, numbers[i].value,
			(size_t)numbers[i].count * sizeof(*values));
	}
}

static const GLubyte *get_string(GLenum name)
{
	static const char *const strings[] = {
		[GL_VENDOR - GL_VENDOR] = "limber",
		[GL_RENDERER - GL_VENDOR] = "soft",
		[GL_VERSION - GL_VENDOR] = "OpenGL ES-CL 1.1",
		[GL_EXTENSIONS - GL_VENDOR] = "",
	};

	return soft_check(
		       name - GL_VENDOR < ARRAY_COUNT(strings), GL_INVALID_ENUM)
		? (const GLubyte *)strings[name - GL_VENDOR]
		: NULL;
}

void soft_init_query(struct soft *soft)
{
	struct gl *gl = &soft->base.gl;

	gl->GetError = get_error;
	gl->GetIntegerv = get_integer;
	gl->GetString = get_string;
}
