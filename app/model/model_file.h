/*
 * Getting at a model's bytes and at the files beside it.
 *
 * A model names other files (buffers, images) and must not reach anything
 * outside its own folder with them, neither by an absolute path or "..", nor
 * through a symbolic link. Everything that loaders read goes through here.
 */
#ifndef APP_MODEL_MODEL_FILE_H
#define APP_MODEL_MODEL_FILE_H

#include "platform/base/log.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
	MODEL_FILE_BYTES_MAX = 256 * 1024 * 1024
};

/* The bytes a loader works on; they outlive the call of the loader. */
struct model_source {
	const char *name; /* what sentences call it: the path as given */
	bool has_folder;  /* name is a path, and files beside it may be read;
			     false for bytes from memory */
	const uint8_t *data;
	size_t size;
};

/* A whole file in memory. */
struct model_file {
	uint8_t *data; /* never NULL after success; one zero byte follows */
	size_t size;
};

/*
 * Reads a regular file of at most MODEL_FILE_BYTES_MAX. 0, or -errno after one
 * sentence "PATH: WHY". The caller ends with model_file_release().
 */
int model_file_read(
	const char *path, const struct log *log, struct model_file *out);

/*
 * Whether model_file_read() would find such a file, with the same sentences.
 */
int model_file_check(const char *path, const struct log *log);

/*
 * Reads a file named by the model: relative, folders divided by '/', already
 * decoded from whatever the format wraps it in. It is refused with -EACCES
 * when it is empty, absolute, holds a backslash, a control character or a ".."
 * step, leads out of the model's folder through a link, or when the model has
 * no folder. where begins the sentence ("fox.gltf: /buffers/0/uri").
 */
int model_file_read_beside(const struct model_source *source,
	const char *relative, const char *where, const struct log *log,
	struct model_file *out);

/* Frees the bytes; an empty struct is fine. */
void model_file_release(struct model_file *file);

#endif
