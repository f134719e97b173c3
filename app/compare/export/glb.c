#include "app/compare/export/glb.h"

#include "platform/base/json_memory.h"
#include "platform/base/output_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	CHUNK_JSON = 0x4E4F534A,
	CHUNK_BINARY = 0x004E4942,
	MAGIC = 0x46546C67,
	HEADER_BYTES = 12,
	CHUNK_HEADER_BYTES = 8,
	COMPONENT_BYTES = 4
};

void glb_begin(struct glb *glb)
{
	json_memory_begin();
	*glb = (struct glb){.root = json_object(),
		.accessors = json_array(),
		.views = json_array()};
	glb_set(glb, "asset",
		json_pack("{s:s, s:s}", "version", "2.0", "generator",
			"limber compare"));
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

static bool reserve(struct glb *glb, size_t size)
{
	size_t capacity = glb->capacity ? glb->capacity : 65536;
	uint8_t *data;

	while (capacity - glb->size < size) {
		capacity *= 2;
	}
	if (capacity == glb->capacity) {
		return true;
	}
	data = realloc(glb->data, capacity);
	if (!data) {
		glb->error = -ENOMEM;
		return false;
	}
	glb->data = data;
	glb->capacity = capacity;
	return true;
}

int glb_add_view(struct glb *glb, const void *data, size_t size)
{
	size_t padded = (size + 3) & ~(size_t)3;
	json_t *view;

	if (glb->error || !reserve(glb, padded)) {
		return -1;
	}
	view = json_pack("{s:i, s:I, s:I}", "buffer", 0, "byteOffset",
		(json_int_t)glb->size, "byteLength", (json_int_t)size);
	if (!view || json_array_append_new(glb->views, view) != 0) {
		glb->error = -ENOMEM;
		return -1;
	}
	memcpy(glb->data + glb->size, data, size);
	memset(glb->data + glb->size + size, 0, padded - size);
	glb->size += padded;
	return (int)json_array_size(glb->views) - 1;
}

static const char *type_name(int width)
{
	static const char *const names[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};

	return names[width - 1];
}

/* Sets the smallest and the largest value of each component. */
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
	if (!accessor || json_array_append_new(glb->accessors, accessor) != 0) {
		glb->error = glb->error ? glb->error : -ENOMEM;
		return -1;
	}
	return (int)json_array_size(glb->accessors) - 1;
}

int glb_add_array(struct glb *glb, const void *data, int count, int width,
	enum glb_component component)
{
	int view = glb_add_view(
		glb, data, (size_t)count * (size_t)width * COMPONENT_BYTES);
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
	return add_accessor(glb, accessor);
}

static void put_u32(uint8_t *out, size_t value)
{
	for (int i = 0; i < 4; i++) {
		out[i] = (uint8_t)(value >> 8 * i);
	}
}

static void put_chunk(
	FILE *file, uint32_t type, const void *data, size_t size, char pad)
{
	uint8_t header[CHUNK_HEADER_BYTES];
	size_t padding = -size & 3;

	put_u32(header, size + padding);
	put_u32(header + 4, type);
	fwrite(header, sizeof(header), 1, file);
	fwrite(data, 1, size, file);
	while (padding-- > 0) {
		fputc(pad, file);
	}
}

static void put_file(const struct glb *glb, const char *text, FILE *file)
{
	uint8_t header[HEADER_BYTES];
	size_t length = strlen(text);

	put_u32(header, MAGIC);
	put_u32(header + 4, 2);
	put_u32(header + 8,
		HEADER_BYTES + 2 * CHUNK_HEADER_BYTES + ((length + 3) & ~3UL) +
			glb->size);
	fwrite(header, sizeof(header), 1, file);
	put_chunk(file, CHUNK_JSON, text, length, ' ');
	put_chunk(file, CHUNK_BINARY, glb->data, glb->size, '\0');
}

static int write_file(const struct glb *glb, const char *text, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	put_file(glb, text, output_file_stream(file));
	return output_file_commit(file);
}

int glb_write(struct glb *glb, const char *path, const struct log *log)
{
	char *text = NULL;
	int error;

	glb_set(glb, "buffers",
		json_pack("[{s:I}]", "byteLength", (json_int_t)glb->size));
	glb_set(glb, "accessors", json_incref(glb->accessors));
	glb_set(glb, "bufferViews", json_incref(glb->views));
	if (!glb->error) {
		text = json_dumps(glb->root, JSON_COMPACT);
		glb->error = text && json_memory_ok() ? 0 : -ENOMEM;
	}
	error = glb->error;
	if (error) {
		log_error(log,
			"%s: there is not enough memory to write this file",
			path);
	} else {
		error = write_file(glb, text, path, log);
	}
	free(text);
	free(glb->data);
	json_decref(glb->accessors);
	json_decref(glb->views);
	json_decref(glb->root);
	*glb = (struct glb){0};
	return error;
}
