#include "app/model/gltf/base64.h"
#include "app/model/gltf/gltf_internal.h"
#include "app/model/gltf/uri.h"
#include "app/model/little_endian.h"
#include "platform/base/json_memory.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	GLB_HEADER_BYTES = 12,
	GLB_CHUNK_HEADER_BYTES = 8,
	GLB_JSON = 0x4e4f534a,
	GLB_BIN = 0x004e4942,
};

struct chunk {
	const uint8_t *data;
	size_t size;
	uint32_t type;
};

/* Reads the chunk at *offset <= length and advances *offset behind it. */
static int next_chunk(
	struct gltf *gltf, size_t length, size_t *offset, struct chunk *out)
{
	const uint8_t *at = gltf->source->data + *offset;
	size_t left = length - *offset;
	size_t size;

	if (left < GLB_CHUNK_HEADER_BYTES) {
		return gltf_fail(&gltf->root, -EINVAL,
			"the header of the chunk at byte %zu is truncated",
			*offset);
	}
	size = little_endian_u32(at);
	if (size > left - GLB_CHUNK_HEADER_BYTES) {
		return gltf_fail(&gltf->root, -EINVAL,
			"the chunk at byte %zu claims %zu bytes, but %zu remain",
			*offset, size, left - GLB_CHUNK_HEADER_BYTES);
	}
	*out = (struct chunk){
		.data = at + GLB_CHUNK_HEADER_BYTES,
		.size = size,
		.type = little_endian_u32(at + 4),
	};
	*offset += GLB_CHUNK_HEADER_BYTES + size;
	return 0;
}

/*
 * Finds the chunks of a .glb (glTF 2.0, chapter 4): first the JSON chunk, then
 * optional chunks, of which BIN comes first.
 */
static int open_glb(struct gltf *gltf, struct chunk *json)
{
	const struct model_source *source = gltf->source;
	size_t offset = GLB_HEADER_BYTES;
	struct chunk binary;
	size_t length;
	int error;

	if (source->size < GLB_HEADER_BYTES) {
		return gltf_fail(&gltf->root, -EINVAL, "the file is truncated");
	}
	if (little_endian_u32(source->data + 4) != 2) {
		return gltf_fail(&gltf->root, -ENOTSUP,
			"the .glb has version %u; limber reads version 2, that of glTF 2.0",
			little_endian_u32(source->data + 4));
	}
	length = little_endian_u32(source->data + 8);
	if (length < GLB_HEADER_BYTES || length > source->size) {
		return gltf_fail(&gltf->root, -EINVAL,
			"the file is truncated: its header claims %zu bytes, but it has %zu: export or copy it again",
			length, source->size);
	}
	error = next_chunk(gltf, length, &offset, json);
	if (!error && json->type != GLB_JSON) {
		error = gltf_fail(&gltf->root, -EINVAL,
			"the first chunk is not the JSON");
	}
	if (error || offset == length) {
		return error;
	}
	error = next_chunk(gltf, length, &offset, &binary);
	if (!error && binary.type == GLB_BIN) {
		gltf->binary = binary.data;
		gltf->binary_size = binary.size;
	}
	return error;
}

/* Returns an upper bound of the number of JSON values in the text. */
static size_t count_values(const struct chunk *text)
{
	size_t count = 1;
	size_t i;

	for (i = 0; i < text->size; i++) {
		uint8_t c = text->data[i];

		count += c == ',' || c == '[' || c == '{';
	}
	return count;
}

/* The approximate memory that Jansson needs for a value and its key. */
enum {
	JSON_VALUE_BYTES = 100
};

static int parse(struct gltf *gltf, const struct chunk *text)
{
	size_t values = count_values(text);
	json_error_t error;

	if (text->size > GLTF_JSON_BYTES_MAX) {
		return gltf_fail(&gltf->root, -EFBIG,
			"the JSON has %zu bytes; limber reads up to %d",
			text->size, GLTF_JSON_BYTES_MAX);
	}
	if (values > GLTF_JSON_VALUES_MAX) {
		return gltf_fail(&gltf->root, -EFBIG,
			"the JSON has more than %d values",
			GLTF_JSON_VALUES_MAX);
	}
	if (gltf_take(&gltf->root, values, JSON_VALUE_BYTES) != 0) {
		return -ENOMEM;
	}
	gltf->json = json_memory_load((const char *)text->data, text->size,
		JSON_REJECT_DUPLICATES, &error);
	if (!json_memory_ok()) {
		return gltf_no_memory(&gltf->root);
	}
	if (!gltf->json) {
		return gltf_fail(&gltf->root, -EINVAL, "line %d, column %d: %s",
			error.line, error.column, error.text);
	}
	gltf->root.json = gltf->json;
	if (!json_is_object(gltf->json)) {
		return gltf_fail(
			&gltf->root, -EINVAL, "the JSON is not an object");
	}
	return 0;
}

int gltf_open(struct gltf *gltf)
{
	struct chunk text = {
		.data = gltf->source->data,
		.size = gltf->source->size,
	};
	int error = 0;

	if (text.size >= 4 && memcmp(text.data, "glTF", 4) == 0) {
		error = open_glb(gltf, &text);
	} else if (text.size >= 3 && memcmp(text.data, "\xef\xbb\xbf", 3) == 0) {
		text.data += 3;
		text.size -= 3;
	}
	/* Some programs fill up the chunk with zeros instead of spaces. */
	while (text.size > 0 && text.data[text.size - 1] == 0) {
		text.size--;
	}
	return error ? error : parse(gltf, &text);
}

static int read_data_uri(const struct gltf_at *at, const char *uri,
	const uint8_t **data, size_t *size)
{
	const char *text = uri_data_base64(uri);
	size_t length;
	uint8_t *bytes;

	if (!text) {
		return gltf_fail(
			at, -EINVAL, "is a data URI that is not in base64");
	}
	length = strlen(text);
	bytes = GLTF_SCRATCH(at, uint8_t, base64_decoded_max(length));
	if (!bytes) {
		return -ENOMEM;
	}
	if (base64_decode(text, length, bytes, size) < 0) {
		return gltf_fail(at, -EINVAL, "is not valid base64");
	}
	*data = bytes;
	return 0;
}

static int read_file_uri(
	const struct gltf_at *at, const char *uri, struct model_file *file)
{
	struct gltf *gltf = at->gltf;
	char where[256];
	char *name;

	if (uri_has_scheme(uri)) {
		return gltf_fail(at, -EACCES,
			"\"%.80s\" does not name a file in the model's folder",
			uri);
	}
	name = GLTF_SCRATCH(at, char, strlen(uri) + 1);
	if (!name) {
		return -ENOMEM;
	}
	if (uri_unescape(uri, name) < 0) {
		return gltf_fail(at, -EINVAL,
			"\"%.80s\" has a malformed %% escape", uri);
	}
	gltf_path(at, where, sizeof(where));
	return model_file_read_beside(gltf->source, name, where,
		gltf->model->budget, gltf->log, file);
}

int gltf_read_uri(const struct gltf_at *at, const char *uri,
	struct model_file *file, const uint8_t **data, size_t *size)
{
	int error;

	if (uri_is_data(uri)) {
		return read_data_uri(at, uri, data, size);
	}
	error = read_file_uri(at, uri, file);
	if (!error) {
		*data = file->data;
		*size = file->size;
	}
	return error;
}

/*
 * Finds a buffer's bytes. Buffer 0 of a .glb may have no URI; then it is the
 * BIN chunk.
 */
static int find_buffer(const struct gltf_at *at, struct gltf_buffer *out)
{
	struct gltf_at uri_at = gltf_member(at, "uri");
	const char *uri = NULL;
	int error = gltf_maybe_string(at, "uri", &uri);

	if (error) {
		return error;
	}
	if (uri) {
		return gltf_read_uri(
			&uri_at, uri, &out->file, &out->data, &out->size);
	}
	if (at->index != 0 || !at->gltf->binary) {
		return gltf_fail(at, -EINVAL,
			"has no uri, and the file has no binary chunk for it");
	}
	out->data = at->gltf->binary;
	out->size = at->gltf->binary_size;
	return 0;
}

static int read_buffer(const struct gltf_at *at)
{
	struct gltf_buffer *out = &at->gltf->buffer[at->index];
	int64_t length = 0;
	int error = gltf_require(at, "byteLength");

	if (!error) {
		error = gltf_maybe_integer(
			at, "byteLength", 1, MODEL_FILE_BYTES_MAX, &length);
	}
	if (!error) {
		error = find_buffer(at, out);
	}
	if (!error && out->size < (size_t)length) {
		error = gltf_fail(at, -EINVAL,
			"byteLength is %lld, but the data has only %zu bytes",
			(long long)length, out->size);
	}
	out->size = (size_t)length;
	return error;
}

static int read_view(const struct gltf_at *at)
{
	struct gltf *gltf = at->gltf;
	struct gltf_view *out = &gltf->view[at->index];
	int64_t offset = 0, length = 0, stride = 0;
	int buffer = -1;
	int error = gltf_require(at, "buffer");

	if (!error) {
		error = gltf_require(at, "byteLength");
	}
	if (!error) {
		error = gltf_maybe_index(
			at, "buffer", gltf->buffer_count, "buffer", &buffer);
	}
	if (!error) {
		error = gltf_maybe_integer(
			at, "byteOffset", 0, INT32_MAX, &offset);
	}
	if (!error) {
		error = gltf_maybe_integer(
			at, "byteLength", 1, INT32_MAX, &length);
	}
	if (!error) {
		error = gltf_maybe_integer(at, "byteStride", 4, 252, &stride);
	}
	if (error) {
		return error;
	}
	if ((uint64_t)(offset + length) > gltf->buffer[buffer].size) {
		return gltf_fail(at, -EINVAL,
			"ends at byte %lld, but buffer %d has %zu bytes",
			(long long)(offset + length), buffer,
			gltf->buffer[buffer].size);
	}
	out->data = gltf->buffer[buffer].data + offset;
	out->size = (size_t)length;
	out->stride = (size_t)stride;
	return 0;
}

static int read_views(struct gltf *gltf)
{
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "bufferViews", &array, &count);

	if (error) {
		return error;
	}
	gltf->view = GLTF_SCRATCH(&array, struct gltf_view, count);
	if (!gltf->view) {
		return -ENOMEM;
	}
	gltf->view_count = count;
	return gltf_for_each(&array, count, read_view);
}

int gltf_read_buffers(struct gltf *gltf)
{
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "buffers", &array, &count);

	if (error) {
		return error;
	}
	gltf->buffer = GLTF_SCRATCH(&array, struct gltf_buffer, count);
	if (!gltf->buffer) {
		return -ENOMEM;
	}
	gltf->buffer_count = count;
	error = gltf_for_each(&array, count, read_buffer);
	return error ? error : read_views(gltf);
}
