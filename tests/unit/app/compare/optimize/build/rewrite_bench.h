/*
 * A mesh in one buffer, to which a test adds arrays, and what
 * optimize_build() makes of it.
 */
#ifndef TESTS_UNIT_APP_COMPARE_OPTIMIZE_BUILD_REWRITE_BENCH_H
#define TESTS_UNIT_APP_COMPARE_OPTIMIZE_BUILD_REWRITE_BENCH_H

#include "app/compare/optimize/build/optimize_build.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	BYTE = 5120,
	UBYTE = 5121,
	SHORT = 5122,
	USHORT = 5123,
	UINT = 5125,
	FLOAT = 5126,
	NUMBERS_MAX = 256
};

struct file {
	json_t *root, *primitive, *attributes, *accessors, *views;
	uint8_t *data, *glb;
	size_t size, glb_size, capacity;
	struct gltf_document *document;
};

static inline void begin(struct file *file, size_t capacity)
{
	*file = (struct file){
		.root = json_pack("{s:{s:s}, s:[{s:[i]}], s:[{s:i}],"
				  " s:[{s:[{s:{}}]}], s:[], s:[]}",
			"asset", "version", "2.0", "scenes", "nodes", 0,
			"nodes", "mesh", 0, "meshes", "primitives",
			"attributes", "accessors", "bufferViews"),
		.data = malloc(capacity),
		.capacity = capacity,
	};
	assert_non_null(file->root);
	assert_non_null(file->data);
	file->accessors = json_object_get(file->root, "accessors");
	file->views = json_object_get(file->root, "bufferViews");
	file->primitive = json_array_get(
		json_object_get(
			json_array_get(json_object_get(file->root, "meshes"), 0),
			"primitives"),
		0);
	file->attributes = json_object_get(file->primitive, "attributes");
}

static inline int add(struct file *file, const void *value, int count,
	int component, const char *type)
{
	int rows = type[0] == 'S' ? 1 : type[3] - '0';
	int width = type[0] == 'M' ? rows * rows : rows;
	size_t each = component >= UINT ? 4 : component >= SHORT ? 2 : 1;
	size_t bytes = each * (size_t)count * (size_t)width;

	assert_true(file->size + bytes + 3 <= file->capacity);
	memcpy(file->data + file->size, value, bytes);
	json_array_append_new(file->views,
		json_pack("{s:i, s:i, s:i}", "buffer", 0, "byteOffset",
			(int)file->size, "byteLength", (int)bytes));
	file->size += (bytes + 3) & ~(size_t)3;
	json_array_append_new(file->accessors,
		json_pack("{s:i, s:i, s:i, s:s}", "bufferView",
			(int)json_array_size(file->views) - 1, "componentType",
			component, "count", count, "type", type));
	return (int)json_array_size(file->accessors) - 1;
}

static inline void set(struct file *file, json_t *object, const char *key,
	const void *value, int count, int component, const char *type)
{
	json_object_set_new(object, key,
		json_integer(add(file, value, count, component, type)));
}

/* The bytes of a file of that text and buffer. */
static inline uint8_t *pack(const struct file *file, size_t *size)
{
	char *text = json_dumps(file->root, 0);
	size_t length = strlen(text), padded = (length + 3) & ~(size_t)3;
	const uint32_t header[] = {0x46546c67u, 2,
		(uint32_t)(28 + padded + file->size), (uint32_t)padded,
		0x4e4f534au};
	const uint32_t chunk[] = {(uint32_t)file->size, 0x004e4942u};
	uint8_t *packed = malloc(28 + padded + file->size);

	assert_non_null(packed);
	memcpy(packed, header, sizeof(header));
	memset(packed + 20, ' ', padded);
	memcpy(packed + 20, text, length);
	memcpy(packed + 20 + padded, chunk, sizeof(chunk));
	memcpy(packed + 28 + padded, file->data, file->size);
	free(text);
	*size = 28 + padded + file->size;
	return packed;
}

static inline struct gltf_document *open_bytes(const uint8_t *data, size_t size)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	const struct model_source source = {.name = "t.glb",
		.data = data,
		.size = size,
		.memory_bytes = 1 << 26};
	struct gltf_document *document;

	assert_int_equal(gltf_document_open(&source, &log, &document), 0);
	return document;
}

/* Rewrites the file. A plan without numbers changes only the order. */
static inline void rebuild(struct file *file, struct optimize_plan plan)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct optimize_order order;
	struct optimize_scale scale;
	struct optimize_build build = {
		.order = &order, .scale = &scale, .plan = &plan};
	struct gltf_document *document;
	uint8_t *packed;
	size_t size;

	plan.stated_px = -1.0f;
	json_object_set_new(file->root, "buffers",
		json_pack("[{s:i}]", "byteLength", (int)file->size));
	packed = pack(file, &size);
	document = open_bytes(packed, size);
	assert_int_equal(optimize_order_find(&order, document), 0);
	assert_int_equal(optimize_scale_find(&scale, document), 0);
	build.document = document;
	assert_int_equal(optimize_build(&build, "t.glb", &log, &file->glb,
				 &file->glb_size),
		0);
	optimize_order_release(&order);
	optimize_scale_release(&scale);
	gltf_document_close(document);
	free(packed);
	file->document = open_bytes(file->glb, file->glb_size);
}

static inline void end(struct file *file)
{
	gltf_document_close(file->document);
	free(file->glb);
	free(file->data);
	json_decref(file->root);
}

static inline const json_t *rewritten(const struct file *file)
{
	return json_array_get(
		json_object_get(
			json_array_get(json_object_get(gltf_document_json(
							       file->document),
					       "meshes"),
				0),
			"primitives"),
		0);
}

static inline int index_of(const json_t *object, const char *key)
{
	const json_t *index = json_object_get(object, key);

	assert_true(json_is_integer(index));
	return (int)json_integer_value(index);
}

/* Reads an array of the rewritten file, and returns how it is stored. */
static inline struct gltf_document_array read_array(const struct file *file,
	const json_t *object, const char *key, float out[NUMBERS_MAX])
{
	int index = index_of(object, key);
	struct gltf_document_array array =
		gltf_document_array(file->document, index);

	assert_true(array.count * array.width <= NUMBERS_MAX);
	assert_int_equal(gltf_document_floats(file->document, index, out), 0);
	return array;
}

static inline bool member_exists(const struct file *file, const json_t *object,
	const char *key, const char *member)
{
	const json_t *accessor = json_array_get(
		json_object_get(gltf_document_json(file->document), "accessors"),
		(size_t)index_of(object, key));

	assert_non_null(accessor);
	return json_object_get(accessor, member) != NULL;
}

#endif
