#include "app/compare/export/glb.h"

#include "platform/base/json_memory.h"
#include "platform/base/output_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void begin(struct glb *glb, FILE *data)
{
	glb->data = data;
	glb->error = data ? 0 : -errno;
	json_memory_begin();
	glb->root = json_object();
	glb->accessors = json_array();
	glb->views = json_array();
	glb_set(glb, "asset",
		json_pack("{s:s, s:s}", "version", "2.0", "generator",
			"limber compare"));
}

void glb_begin(struct glb *glb)
{
	*glb = (struct glb){0};
	begin(glb, output_file_scratch());
}

void glb_begin_memory(struct glb *glb)
{
	*glb = (struct glb){0};
	begin(glb, open_memstream(&glb->memory, &glb->memory_size));
}

json_t *glb_floats(const float *value, int count)
{
	json_t *array = json_array();

	for (int i = 0; i < count; i++) {
		json_array_append_new(array, json_real((double)value[i]));
	}
	return array;
}

void glb_set(struct glb *glb, const char *name, json_t *value)
{
	if (!value || json_object_set_new(glb->root, name, value) != 0) {
		glb->error = glb->error ? glb->error : -ENOMEM;
	}
}

void glb_use_extension(struct glb *glb, const char *name)
{
	json_t *used = json_object_get(glb->root, "extensionsUsed");
	size_t i;
	json_t *known;

	if (!used) {
		used = json_array();
		glb_set(glb, "extensionsUsed", used);
	}
	json_array_foreach(used, i, known)
	{
		if (strcmp(json_string_value(known), name) == 0) {
			return;
		}
	}
	json_array_append_new(used, json_string(name));
}

size_t glb_component_bytes(enum glb_component component)
{
	switch (component) {
	case GLB_BYTE:
	case GLB_UBYTE:
		return 1;
	case GLB_SHORT:
	case GLB_USHORT:
		return 2;
	default:
		return 4;
	}
}

static bool append(struct glb *glb, const void *data, size_t size)
{
	static const uint8_t zero[4] = {0};
	size_t padding = -size & 3;

	if (glb->error) {
		return false;
	}
	errno = ENOSPC;
	if (fwrite(data, 1, size, glb->data) != size ||
		fwrite(zero, 1, padding, glb->data) != padding) {
		glb->error = -errno;
		return false;
	}
	glb->size += size + padding;
	return true;
}

int glb_add_view(struct glb *glb, const void *data, size_t size)
{
	size_t at = glb->size;
	json_t *view;

	if (!append(glb, data, size)) {
		return -1;
	}
	view = json_pack("{s:i, s:I, s:I}", "buffer", 0, "byteOffset",
		(json_int_t)at, "byteLength", (json_int_t)size);
	if (!view || json_array_append_new(glb->views, view) != 0) {
		glb->error = -ENOMEM;
		return -1;
	}
	return (int)json_array_size(glb->views) - 1;
}

static const char *type_name(int width)
{
	static const char *const names[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};

	return width == 16 ? "MAT4" : names[width - 1];
}

/* Sets min and max to the bounds of each component. */
static void set_bounds(
	json_t *accessor, const float *value, int count, int width)
{
	json_t *low = json_array(), *high = json_array();

	for (int axis = 0; axis < width; axis++) {
		float least = value[axis], most = value[axis];

		for (int i = 1; i < count; i++) {
			float v = value[i * width + axis];

			least = v < least ? v : least;
			most = v > most ? v : most;
		}
		json_array_append_new(low, json_real((double)least));
		json_array_append_new(high, json_real((double)most));
	}
	json_object_set_new(accessor, "min", low);
	json_object_set_new(accessor, "max", high);
}

static int add_accessor(struct glb *glb, json_t *accessor)
{
	if (glb->error) {
		json_decref(accessor);
		return -1;
	}
	if (!accessor || json_array_append_new(glb->accessors, accessor) != 0) {
		glb->error = -ENOMEM;
		return -1;
	}
	return (int)json_array_size(glb->accessors) - 1;
}

int glb_add_array(struct glb *glb, const void *data, int count, int width,
	enum glb_component component)
{
	int view = glb_add_view(glb, data,
		(size_t)count * (size_t)width * glb_component_bytes(component));
	json_t *accessor;

	if (view < 0) {
		return -1;
	}
	accessor = json_pack("{s:i, s:i, s:i, s:s}", "bufferView", view,
		"componentType", (int)component, "count", count, "type",
		type_name(width));
	if (accessor && component == GLB_FLOAT && (width == 1 || width == 3)) {
		set_bounds(accessor, data, count, width);
	}
	if (accessor && component == GLB_SHORT) {
		json_object_set_new(accessor, "normalized", json_true());
	}
	return add_accessor(glb, accessor);
}

/* Reads a component; its type is GLB_BYTE or GLB_SHORT. */
static int component_of(
	const void *data, enum glb_component component, size_t index)
{
	return component == GLB_BYTE ? ((const int8_t *)data)[index]
				     : ((const int16_t *)data)[index];
}

static bool is_zero(const void *data, enum glb_component component, int vertex)
{
	size_t first = 3 * (size_t)vertex;

	return component_of(data, component, first) == 0 &&
		component_of(data, component, first + 1) == 0 &&
		component_of(data, component, first + 2) == 0;
}

static void set_vector_bounds(json_t *accessor, const void *data, int count,
	enum glb_component component)
{
	json_t *low = json_array(), *high = json_array();

	for (size_t axis = 0; axis < 3; axis++) {
		int least = component_of(data, component, axis);
		int most = least;

		for (size_t i = 1; i < (size_t)count; i++) {
			int v = component_of(data, component, 3 * i + axis);

			least = v < least ? v : least;
			most = v > most ? v : most;
		}
		json_array_append_new(low, json_integer(least));
		json_array_append_new(high, json_integer(most));
	}
	json_object_set_new(accessor, "min", low);
	json_object_set_new(accessor, "max", high);
}

/*
 * Copies vectors to out, each padded to stride bytes, and their indices to
 * index[]; if sparse, only those that are not zero. Returns their number.
 */
static int pack_vectors(const void *data, int count,
	enum glb_component component, bool sparse, uint8_t *out, size_t stride,
	uint32_t *index)
{
	size_t size = 3 * glb_component_bytes(component);
	int packed = 0;

	for (int v = 0; v < count; v++) {
		if (sparse && is_zero(data, component, v)) {
			continue;
		}
		memset(out, 0, stride);
		memcpy(out, (const uint8_t *)data + (size_t)v * size, size);
		out += stride;
		index[packed++] = (uint32_t)v;
	}
	return packed;
}

static json_t *sparse_json(
	struct glb *glb, const uint32_t *index, int count, int values)
{
	int indices = glb_add_view(glb, index, (size_t)count * sizeof(*index));

	return json_pack("{s:i, s:{s:i, s:i}, s:{s:i}}", "count", count,
		"indices", "bufferView", indices, "componentType", GLB_UINT,
		"values", "bufferView", values);
}

/*
 * Makes an accessor, sparse if that is smaller. scratch has room for count
 * padded vectors, index[] for count indices.
 */
static json_t *vectors_json(struct glb *glb, const void *data, int count,
	enum glb_component component, uint8_t *scratch, uint32_t *index)
{
	size_t size = 3 * glb_component_bytes(component);
	size_t stride = 4 * glb_component_bytes(component);
	int moved = pack_vectors(
		data, count, component, true, scratch, size, index);
	bool sparse = moved > 0 &&
		(size_t)moved * (size + sizeof(*index)) < (size_t)count * stride;
	int view;

	if (!sparse) {
		moved = pack_vectors(
			data, count, component, false, scratch, stride, index);
	}
	view = glb_add_view(
		glb, scratch, (size_t)moved * (sparse ? size : stride));
	if (view < 0) {
		return NULL;
	}
	if (sparse) {
		return json_pack("{s:i, s:i, s:s, s:o}", "componentType",
			(int)component, "count", count, "type", "VEC3",
			"sparse", sparse_json(glb, index, moved, view));
	}
	json_object_set_new(json_array_get(glb->views, (size_t)view),
		"byteStride", json_integer((json_int_t)stride));
	return json_pack("{s:i, s:i, s:i, s:s}", "bufferView", view,
		"componentType", (int)component, "count", count, "type", "VEC3");
}

int glb_add_vectors(struct glb *glb, const void *data, int count,
	enum glb_component component, bool normalized)
{
	uint8_t *scratch = malloc((size_t)count * 8);
	uint32_t *index = malloc((size_t)count * sizeof(*index));
	json_t *accessor = NULL;

	if (scratch && index) {
		accessor = vectors_json(
			glb, data, count, component, scratch, index);
	}
	free(scratch);
	free(index);
	if (accessor) {
		set_vector_bounds(accessor, data, count, component);
		if (normalized) {
			json_object_set_new(accessor, "normalized", json_true());
		}
		glb->quantized = true;
	}
	return add_accessor(glb, accessor);
}

int glb_add_ones(struct glb *glb, const uint32_t *at, int ones, int count)
{
	uint8_t *value = malloc((size_t)ones + 1);
	json_t *accessor = NULL;
	int view;

	if (value) {
		memset(value, 255, (size_t)ones);
		view = glb_add_view(glb, value, (size_t)ones);
		accessor = json_pack("{s:i, s:b, s:i, s:s, s:o}",
			"componentType", GLB_UBYTE, "normalized", 1, "count",
			count, "type", "SCALAR", "sparse",
			sparse_json(glb, at, ones, view));
	}
	free(value);
	return add_accessor(glb, accessor);
}
