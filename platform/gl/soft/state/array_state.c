/* Where vertices come from, and the current colour and normal. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/state/parameter.h"

static int type_bytes(GLenum type)
{
	switch (type) {
	case GL_BYTE:
	case GL_UNSIGNED_BYTE:
		return 1;
	case GL_SHORT:
		return 2;
	default:
		return 4;
	}
}

static bool is_signed_type(GLenum type)
{
	return IS_ONE_OF(type, GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT);
}

static void describe(struct array *array, int size, int least, bool type_known,
	GLenum type, GLsizei stride, const void *pointer)
{
	if (soft_check(size >= least && size <= 4 && stride >= 0,
		    GL_INVALID_VALUE) &&
		soft_check(type_known, GL_INVALID_ENUM)) {
		array->size = size;
		array->type = type;
		array->stride_bytes = stride ? stride : size * type_bytes(type);
		array->pointer = pointer;
	}
}

static void vertex_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.vertex, size, 2, is_signed_type(type),
		type, stride, pointer);
}

static void normal_pointer(GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.normal, 3, 3, is_signed_type(type),
		type, stride, pointer);
}

static void color_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	describe(&soft_current()->arrays.color, size, 4,
		IS_ONE_OF(type, GL_UNSIGNED_BYTE, GL_FIXED, GL_FLOAT), type,
		stride, pointer);
}

static void tex_coord_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	struct arrays *arrays = &soft_current()->arrays;

	describe(&arrays->texcoord[arrays->client_unit], size, 2,
		is_signed_type(type), type, stride, pointer);
}

static void client_active_texture(GLenum unit)
{
	if (soft_check(unit - GL_TEXTURE0 < SOFT_UNITS, GL_INVALID_ENUM)) {
		soft_current()->arrays.client_unit = (int)(unit - GL_TEXTURE0);
	}
}

static struct array *find_array(struct arrays *arrays, GLenum name)
{
	switch (name) {
	case GL_VERTEX_ARRAY:
		return &arrays->vertex;
	case GL_NORMAL_ARRAY:
		return &arrays->normal;
	case GL_COLOR_ARRAY:
		return &arrays->color;
	case GL_TEXTURE_COORD_ARRAY:
		return &arrays->texcoord[arrays->client_unit];
	default:
		return NULL;
	}
}

static void set_enabled(GLenum name, bool on)
{
	struct array *array = find_array(&soft_current()->arrays, name);

	if (soft_check(array != NULL, GL_INVALID_ENUM)) {
		array->enabled = on;
	}
}

static void enable_client_state(GLenum name)
{
	set_enabled(name, true);
}

static void disable_client_state(GLenum name)
{
	set_enabled(name, false);
}

static void color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed given[4] = {red, green, blue, alpha};

	memcpy(soft_current()->arrays.current_color, given, sizeof(given));
}

static void normal(GLfixed x, GLfixed y, GLfixed z)
{
	const GLfixed given[3] = {x, y, z};

	memcpy(soft_current()->arrays.current_normal, given, sizeof(given));
}

void soft_init_arrays(struct soft *soft)
{
	const struct array nothing = {
		.size = 4, .type = GL_FLOAT, .stride_bytes = 16};
	struct arrays *arrays = &soft->arrays;
	struct gl *gl = &soft->base.gl;

	*arrays = (struct arrays){.vertex = nothing,
		.normal = nothing,
		.color = nothing,
		.texcoord = {nothing, nothing},
		.current_color = {FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE},
		.current_normal = {0, 0, FX16_ONE}};
	gl->VertexPointer = vertex_pointer;
	gl->NormalPointer = normal_pointer;
	gl->ColorPointer = color_pointer;
	gl->TexCoordPointer = tex_coord_pointer;
	gl->ClientActiveTexture = client_active_texture;
	gl->EnableClientState = enable_client_state;
	gl->DisableClientState = disable_client_state;
	gl->Color4x = color;
	gl->Normal3x = normal;
}
