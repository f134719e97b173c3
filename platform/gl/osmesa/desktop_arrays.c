#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/osmesa/desktop.h"

static int type_bytes(GLenum type)
{
	switch (type) {
	case GL_BYTE:
	case GL_UNSIGNED_BYTE:
		return 1;
	case GL_SHORT:
	case GL_UNSIGNED_SHORT:
		return 2;
	default:
		return 4;
	}
}

/*
 * Records an array. Returns whether desktop GL can read it directly. reads_bytes:
 * it can read GL_BYTE for this array. The library itself reports invalid sizes.
 */
static bool record(struct desktop_array *array, GLint size, GLenum type,
	GLsizei stride, const void *pointer, bool reads_bytes)
{
	array->converted = type == GL_FIXED || (type == GL_BYTE && !reads_bytes);
	array->size = size;
	array->type = type;
	array->stride_bytes = stride ? stride : size * type_bytes(type);
	array->pointer = pointer;
	return !array->converted;
}

static void vertex_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	struct desktop *desktop = desktop_current();

	if (record(&desktop->array[DESKTOP_VERTEX], size, type, stride, pointer,
		    false)) {
		desktop->gl.VertexPointer(size, type, stride, pointer);
	}
}

static void normal_pointer(GLenum type, GLsizei stride, const void *pointer)
{
	struct desktop *desktop = desktop_current();

	if (record(&desktop->array[DESKTOP_NORMAL], 3, type, stride, pointer,
		    true)) {
		desktop->gl.NormalPointer(type, stride, pointer);
	}
}

static void color_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	struct desktop *desktop = desktop_current();

	if (record(&desktop->array[DESKTOP_COLOR], size, type, stride, pointer,
		    true)) {
		desktop->gl.ColorPointer(size, type, stride, pointer);
	}
}

static void tex_coord_pointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	struct desktop *desktop = desktop_current();
	int name = DESKTOP_TEXTURE_COORD + desktop->client_unit;

	if (record(&desktop->array[name], size, type, stride, pointer, false)) {
		desktop->gl.TexCoordPointer(size, type, stride, pointer);
	}
}

/* Units beyond DESKTOP_TEXTURE_UNITS are only passed on to the library. */
static void client_active_texture(GLenum unit)
{
	struct desktop *desktop = desktop_current();

	if (unit - GL_TEXTURE0 < DESKTOP_TEXTURE_UNITS) {
		desktop->client_unit = (int)(unit - GL_TEXTURE0);
	}
	desktop->gl.ClientActiveTexture(unit);
}

static void set_enabled(struct desktop *desktop, GLenum array, bool enabled)
{
	int name;

	switch (array) {
	case GL_VERTEX_ARRAY:
		name = DESKTOP_VERTEX;
		break;
	case GL_NORMAL_ARRAY:
		name = DESKTOP_NORMAL;
		break;
	case GL_COLOR_ARRAY:
		name = DESKTOP_COLOR;
		break;
	case GL_TEXTURE_COORD_ARRAY:
		name = DESKTOP_TEXTURE_COORD + desktop->client_unit;
		break;
	default:
		return;
	}
	desktop->array[name].enabled = enabled;
}

static void enable_client_state(GLenum array)
{
	struct desktop *desktop = desktop_current();

	set_enabled(desktop, array, true);
	desktop->gl.EnableClientState(array);
}

static void disable_client_state(GLenum array)
{
	struct desktop *desktop = desktop_current();

	set_enabled(desktop, array, false);
	desktop->gl.DisableClientState(array);
}

static bool reserve(struct desktop_array *array, size_t floats)
{
	float *grown;

	if (floats <= array->capacity) {
		return true;
	}
	grown = realloc(array->floats, floats * sizeof(*grown));
	if (!grown) {
		return false;
	}
	array->floats = grown;
	array->capacity = floats;
	return true;
}

/* Converts the first count elements. */
static bool convert(struct desktop_array *array, int count)
{
	float *out;

	if (!reserve(array, (size_t)count * (size_t)array->size)) {
		return false;
	}
	out = array->floats;
	for (int i = 0; i < count; i++) {
		const uint8_t *element = array->pointer +
			(size_t)i * (size_t)array->stride_bytes;

		for (int j = 0; j < array->size; j++) {
			GLfixed fixed;

			if (array->type == GL_BYTE) {
				*out++ = (float)(int8_t)element[j];
				continue;
			}
			memcpy(&fixed, element + 4 * j, sizeof(fixed));
			*out++ = fx16_to_float(fixed);
		}
	}
	return true;
}

static void point_at_floats(struct desktop *desktop, int name)
{
	const struct desktop_array *array = &desktop->array[name];
	const struct desktop_gl *gl = &desktop->gl;
	int unit = name - DESKTOP_TEXTURE_COORD;

	switch (name) {
	case DESKTOP_VERTEX:
		gl->VertexPointer(array->size, GL_FLOAT, 0, array->floats);
		break;
	case DESKTOP_NORMAL:
		gl->NormalPointer(GL_FLOAT, 0, array->floats);
		break;
	case DESKTOP_COLOR:
		gl->ColorPointer(array->size, GL_FLOAT, 0, array->floats);
		break;
	default:
		gl->ClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
		gl->TexCoordPointer(array->size, GL_FLOAT, 0, array->floats);
		gl->ClientActiveTexture(
			GL_TEXTURE0 + (GLenum)desktop->client_unit);
		break;
	}
}

static bool needs_conversion(const struct desktop *desktop)
{
	for (int i = 0; i < DESKTOP_ARRAY_COUNT; i++) {
		if (desktop->array[i].enabled && desktop->array[i].converted) {
			return true;
		}
	}
	return false;
}

/* Converts count elements where needed; false when memory is short. */
static bool convert_arrays(struct desktop *desktop, int count)
{
	for (int i = 0; i < DESKTOP_ARRAY_COUNT; i++) {
		struct desktop_array *array = &desktop->array[i];

		if (!array->enabled || !array->converted) {
			continue;
		}
		if (!convert(array, count)) {
			return false;
		}
		point_at_floats(desktop, i);
	}
	return true;
}

static void draw_arrays(GLenum mode, GLint first, GLsizei count)
{
	struct desktop *desktop = desktop_current();

	if (first >= 0 && count > 0 && needs_conversion(desktop) &&
		!convert_arrays(desktop, first + count)) {
		return;
	}
	desktop->gl.DrawArrays(mode, first, count);
}

/* Returns 1 + the highest index, or 0 for an index type that ES does not have. */
static int element_count(GLsizei count, GLenum type, const void *indices)
{
	const uint8_t *bytes = indices;
	int highest = -1;

	if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT) {
		return 0;
	}
	for (int i = 0; i < count; i++) {
		uint16_t index = bytes[i];

		if (type == GL_UNSIGNED_SHORT) {
			memcpy(&index, bytes + 2 * i, sizeof(index));
		}
		highest = index > highest ? index : highest;
	}
	return highest + 1;
}

static void draw_elements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	struct desktop *desktop = desktop_current();

	if (needs_conversion(desktop) &&
		!convert_arrays(desktop, element_count(count, type, indices))) {
		return;
	}
	desktop->gl.DrawElements(mode, count, type, indices);
}

void desktop_set_array_shims(struct gl *gl)
{
	gl->VertexPointer = vertex_pointer;
	gl->NormalPointer = normal_pointer;
	gl->ColorPointer = color_pointer;
	gl->TexCoordPointer = tex_coord_pointer;
	gl->ClientActiveTexture = client_active_texture;
	gl->EnableClientState = enable_client_state;
	gl->DisableClientState = disable_client_state;
	gl->DrawArrays = draw_arrays;
	gl->DrawElements = draw_elements;
}
