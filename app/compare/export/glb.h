/*
 * Writing a binary glTF 2.0 file, piece by piece.
 *
 * The first failure is kept and everything after it does nothing, so only
 * glb_write() needs to be asked how it went.
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
	size_t size, room;
};

/* GL's numbers, as the format uses them. */
enum glb_component {
	GLB_INT = 5125,
	GLB_FLOAT = 5126,
};

void glb_begin(struct glb *glb);

/* Bytes of their own; the number of the view, or -1. */
int glb_add_view(struct glb *glb, const void *data, size_t size);

/*
 * An array of count elements of width unsigned numbers or floats; the number
 * of the accessor. Floats of width 1 and 3 get the bounds that positions and
 * times must have.
 */
int glb_add_array(struct glb *glb, const void *data, int count, int width,
	enum glb_component component);

/* The numbers as a JSON array. */
json_t *glb_floats(const float *value, int count);

/* Sets a member of the root; takes value. */
void glb_set(struct glb *glb, const char *name, json_t *value);

/*
 * Writes the file (platform/base/output_file.h) and releases everything. 0, or
 * -errno after a sentence.
 */
int glb_write(struct glb *glb, const char *path, const struct log *log);

#endif
