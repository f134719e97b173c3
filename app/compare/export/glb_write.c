#include "app/compare/export/glb.h"

#include "platform/base/json_memory.h"
#include "platform/base/output_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	CHUNK_JSON = 0x4E4F534A,
	CHUNK_BINARY = 0x004E4942,
	MAGIC = 0x46546C67,
	HEADER_BYTES = 12,
	REAL_DIGITS = 15, /* enough for floats; 0.1 stays 0.1 */
	CHUNK_HEADER_BYTES = 8
};

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

/* Copies the binary data. Returns 0, or -errno if it cannot be read. */
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
	if (glb->quantized) {
		glb_use_extension(glb, "KHR_mesh_quantization");
		glb_set(glb, "extensionsRequired",
			json_pack("[s]", "KHR_mesh_quantization"));
	}
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

/* Completes the JSON and returns its text, or NULL after logging an error. */
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
		/*
		 * Without memory, glibc closes without error, but leaves no
		 * bytes.
		 */
		if ((fclose(file) != 0 || !bytes) && !glb->error) {
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
