/*
 * Reading a model file and the files that it refers to (buffers, images).
 *
 * A reference must not lead outside the model's folder, neither by an absolute
 * path, nor by "..", nor through a symbolic link. Loaders read all files by
 * these functions.
 */
#ifndef APP_MODEL_MODEL_FILE_H
#define APP_MODEL_MODEL_FILE_H

#include "platform/base/log.h"
#include "platform/base/memory_budget.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
	MODEL_FILE_BYTES_MAX = 256 * 1024 * 1024
};

/* The input of a loader. It is valid while the loader runs. */
struct model_source {
	const char *name; /* for messages: the path as the user gave it */
	bool has_folder;  /* whether name is a path, so that files beside it can
			     be read; false for bytes from memory */
	const uint8_t *data;
	size_t size;
	size_t memory_bytes; /* see model_load_within() */
};

/* A whole file in memory. */
struct model_file {
	uint8_t *data; /* never NULL after success; a zero byte follows */
	size_t size;
	struct memory_budget *budget; /* from which the bytes were taken, or
					 NULL */
};

/*
 * Reads a regular file of at most MODEL_FILE_BYTES_MAX. Its bytes count against
 * the budget, unless the budget is NULL. Returns 0, or -errno after one error
 * "PATH: REASON" on the log. The caller calls model_file_release() while the
 * budget exists.
 */
int model_file_read(const char *path, struct memory_budget *budget,
	const struct log *log, struct model_file *out);

/* Like model_file_read(), but only opens the file and checks its size. */
int model_file_check(const char *path, const struct log *log);

/*
 * Reads a file that the model refers to by a relative path with '/' between
 * folders; URI escapes are already decoded. Returns 0, or -errno after one
 * error on the log: -EACCES if the path is empty or absolute, contains a
 * backslash, a control character or "..", or leads outside the model's folder
 * through a link, or if the model has no folder. where is the start of the
 * message ("fox.gltf: /buffers/0/uri").
 */
int model_file_read_beside(const struct model_source *source,
	const char *relative, const char *where, struct memory_budget *budget,
	const struct log *log, struct model_file *out);

/* Frees the bytes, also in the budget; a struct of zeros is allowed. */
void model_file_release(struct model_file *file);

#endif
