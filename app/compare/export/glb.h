/*
 * Builds a binary glTF 2.0 file.
 *
 * The first failure is kept in error and makes every later call do nothing, so
 * callers only check the result of glb_write().
 */
#ifndef APP_COMPARE_EXPORT_GLB_H
#define APP_COMPARE_EXPORT_GLB_H

#include "platform/base/log.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <jansson.h>

struct glb {
	int error; /* 0 or -errno */
	json_t *root;
	json_t *accessors, *views;
	uint8_t *data; /* the binary chunk */
	size_t size, capacity;
};

/* The component types of glTF: OpenGL's numbers. */
enum glb_component {
	GLB_UINT = 5125,
	GLB_FLOAT = 5126,
};

void glb_begin(struct glb *glb);

/* Appends bytes to the binary chunk. Returns the buffer view's number or -1. */
int glb_add_view(struct glb *glb, const void *data, size_t size);

/*
 * Appends count elements of width components each (1 to 4). Returns the
 * accessor's number or -1. Floats of width 1 and 3 get the bounds that glTF
 * demands of times and positions.
 */
int glb_add_array(struct glb *glb, const void *data, int count, int width,
	enum glb_component component);

/* Makes a JSON array, which the caller owns. */
json_t *glb_floats(const float *value, int count);

/* Sets a member of the root object and takes ownership of value. */
void glb_set(struct glb *glb, const char *name, json_t *value);

/*
 * Writes the file (platform/base/output_file.h) and releases everything.
 * Returns 0, or -errno after logging an error.
 */
int glb_write(struct glb *glb, const char *path, const struct log *log);

#endif
