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
#include <stdio.h>

#include <jansson.h>

struct glb {
	int error; /* 0 or -errno */
	json_t *root;
	json_t *accessors, *views;
	FILE *data;   /* the binary chunk, in a file or in memory */
	char *memory; /* the buffer of data if in memory, else NULL */
	size_t memory_size;
	bool shares_images; /* export_load() gives the loaded model the images
			       of the exported one */
	size_t size;
	bool quantized; /* the file needs KHR_mesh_quantization */
};

/* The component types of glTF, which are OpenGL's constants. */
enum glb_component {
	GLB_BYTE = 5120,
	GLB_UBYTE = 5121,
	GLB_SHORT = 5122,
	GLB_USHORT = 5123,
	GLB_UINT = 5125,
	GLB_FLOAT = 5126,
};

/* Begins a file whose binary chunk is kept in a temporary file. */
void glb_begin(struct glb *glb);

/*
 * Begins a small file in memory. *glb must not be moved before it is written.
 */
void glb_begin_memory(struct glb *glb);

/* The size of a component in bytes. */
size_t glb_component_bytes(enum glb_component component);

/* Appends bytes to the binary chunk. Returns the buffer view's index or -1. */
int glb_add_view(struct glb *glb, const void *data, size_t size);

/*
 * Appends count elements of width components each (1 to 4, or 16). Returns the
 * accessor's index or -1. Floats of width 1 and 3 get the bounds (min and max)
 * that glTF demands of times and positions. Shorts are marked as normalized:
 * they stand for -1 to 1.
 */
int glb_add_array(struct glb *glb, const void *data, int count, int width,
	enum glb_component component);

/*
 * Appends an attribute of count vertices with 3 signed bytes or shorts each,
 * each vertex aligned to 4 bytes. normalized is glTF's flag. The accessor is
 * sparse if that takes fewer bytes, because many vertices are zero. Returns its
 * index or -1.
 */
int glb_add_vectors(struct glb *glb, const void *data, int count,
	enum glb_component component, bool normalized);

/*
 * Appends count normalized bytes as a sparse accessor: the ones elements whose
 * indices are in at[] are 1, all others are 0. Returns its index or -1.
 */
int glb_add_ones(struct glb *glb, const uint32_t *at, int ones, int count);

/* Makes a JSON array of count numbers, which the caller owns. */
json_t *glb_floats(const float *value, int count);

/* Sets a member of the root object and takes ownership of value. */
void glb_set(struct glb *glb, const char *name, json_t *value);

/* Adds an extension to extensionsUsed, unless it is there already. */
void glb_use_extension(struct glb *glb, const char *name);

/*
 * Writes the file (platform/base/output_file.h) and releases everything.
 * Returns 0, or -errno after logging an error.
 */
int glb_write(struct glb *glb, const char *path, const struct log *log);

/*
 * The same into *data, which the caller frees with free(). path is used in
 * messages only.
 */
int glb_write_memory(struct glb *glb, const char *path, const struct log *log,
	uint8_t **data, size_t *size);

/* Releases everything without writing a file. */
void glb_discard(struct glb *glb);

#endif
