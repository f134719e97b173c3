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
	REAL_DIGITS = 15, /* more than floats have; 0.1 stays 0.1 */
	CHUNK_HEADER_BYTES = 8
};

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
	return add_accessor(glb, accessor);
}

/* The components of vectors, whose type is GLB_BYTE or GLB_SHORT. */
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

/* Copies vectors that are not zero, each padded to stride bytes. */
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

/* The values of the vectors in scratch, in one view, sparse or not. */
static json_t *vectors_json(struct glb *glb, const void *data, int count,
	enum glb_component component, uint8_t *scratch, uint32_t *index)
{
	size_t size = 3 * glb_component_bytes(component);
	size_t stride = (size + 3) & ~(size_t)3;
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

static void put_u32(uint8_t *out, size_t value)
{
	for (int i = 0; i < 4; i++) {
		out[i] = (uint8_t)(value >> 8 * i);
	}
}

static void put_json(FILE *file, const char *text, size_t length)
{
	uint8_t header[CHUNK_HEADER_BYTES];

	put_u32(header, (length + 3) & ~(size_t)3);
	put_u32(header + 4, CHUNK_JSON);
	fwrite(header, sizeof(header), 1, file);
	fwrite(text, 1, length, file);
	for (; length & 3; length++) {
		fputc(' ', file);
	}
}

/* Copies the binary data. Returns 0, or -errno when they cannot be read. */
static int put_data(const struct glb *glb, FILE *file)
{
	uint8_t buffer[16384];
	size_t left = glb->size;

	if (fflush(glb->data) != 0) {
		return -errno;
	}
	if (glb->memory) {
		fwrite(glb->memory, 1, glb->size, file);
		return 0;
	}
	if (fseek(glb->data, 0, SEEK_SET) != 0) {
		return -errno;
	}
	while (left > 0) {
		size_t size = left < sizeof(buffer) ? left : sizeof(buffer);

		errno = EIO;
		if (fread(buffer, 1, size, glb->data) != size) {
			return -errno;
		}
		fwrite(buffer, 1, size, file);
		left -= size;
	}
	return 0;
}

static int put_binary(const struct glb *glb, FILE *file)
{
	uint8_t header[CHUNK_HEADER_BYTES];

	if (glb->size == 0) {
		return 0;
	}
	put_u32(header, glb->size);
	put_u32(header + 4, CHUNK_BINARY);
	fwrite(header, sizeof(header), 1, file);
	return put_data(glb, file);
}

static int put_file(const struct glb *glb, const char *text, FILE *file)
{
	uint8_t header[HEADER_BYTES];
	size_t length = strlen(text);

	put_u32(header, MAGIC);
	put_u32(header + 4, 2);
	put_u32(header + 8,
		HEADER_BYTES + (glb->size > 0 ? 2u : 1u) * CHUNK_HEADER_BYTES +
			((length + 3) & ~(size_t)3) + glb->size);
	fwrite(header, sizeof(header), 1, file);
	put_json(file, text, length);
	return put_binary(glb, file);
}

static int write_file(const struct glb *glb, const char *text, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	error = put_file(glb, text, output_file_stream(file));
	if (error) {
		log_error(log,
			"%s: the temporary file with its vertices cannot be read: %s",
			path, strerror(-error));
		output_file_discard(file);
		return error;
	}
	return output_file_commit(file);
}

static void set_extensions(struct glb *glb)
{
	json_t *used = json_object_get(glb->root, "extensionsUsed");

	if (!glb->quantized) {
		return;
	}
	if (!used) {
		used = json_array();
		json_object_set_new(glb->root, "extensionsUsed", used);
	}
	json_array_append_new(used, json_string("KHR_mesh_quantization"));
	glb_set(glb, "extensionsRequired",
		json_pack("[s]", "KHR_mesh_quantization"));
}

static void report_error(
	const struct glb *glb, const char *path, const struct log *log)
{
	if (glb->error == -ENOMEM) {
		log_error(log,
			"%s: there is not enough memory to write this file",
			path);
	} else {
		log_error(log,
			"%s: a temporary file for its vertices cannot be written: %s",
			path, strerror(-glb->error));
	}
}

void glb_discard(struct glb *glb)
{
	if (glb->data) {
		fclose(glb->data);
	}
	free(glb->memory);
	json_decref(glb->accessors);
	json_decref(glb->views);
	json_decref(glb->root);
	*glb = (struct glb){0};
}

/* Completes the JSON: its text, or NULL after logging an error. */
static char *finish(struct glb *glb, const char *path, const struct log *log)
{
	char *text = NULL;

	set_extensions(glb);
	if (glb->size > 0) {
		glb_set(glb, "buffers",
			json_pack("[{s:I}]", "byteLength",
				(json_int_t)glb->size));
		glb_set(glb, "bufferViews", json_incref(glb->views));
	}
	if (json_array_size(glb->accessors) > 0) {
		glb_set(glb, "accessors", json_incref(glb->accessors));
	}
	if (!glb->error) {
		text = json_dumps(glb->root,
			JSON_COMPACT | JSON_REAL_PRECISION(REAL_DIGITS));
		glb->error = text && json_memory_ok() ? 0 : -ENOMEM;
	}
	if (glb->error) {
		report_error(glb, path, log);
		free(text);
		return NULL;
	}
	return text;
}

int glb_write(struct glb *glb, const char *path, const struct log *log)
{
	char *text = finish(glb, path, log);
	int error = glb->error;

	if (text) {
		error = write_file(glb, text, path, log);
	}
	free(text);
	glb_discard(glb);
	return error;
}

int glb_write_memory(struct glb *glb, const char *path, const struct log *log,
	uint8_t **data, size_t *size)
{
	char *text = finish(glb, path, log);
	char *bytes = NULL;
	FILE *file = text ? open_memstream(&bytes, size) : NULL;
	int error;

	if (text && file) {
		glb->error = put_file(glb, text, file);
		if (fclose(file) != 0 && !glb->error) {
			glb->error = -ENOMEM;
		}
	} else if (text) {
		glb->error = -ENOMEM;
	}
	if (text && glb->error) {
		report_error(glb, path, log);
		free(bytes);
		bytes = NULL;
	}
	*data = (uint8_t *)bytes;
	free(text);
	error = glb->error;
	glb_discard(glb);
	return error;
}
