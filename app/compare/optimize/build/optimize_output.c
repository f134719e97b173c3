#include "app/compare/optimize/build/optimize_output.h"

#include "app/compare/optimize/optimize_hash.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	TARGET_VERTICES = 34962, /* GL_ARRAY_BUFFER */
	TARGET_INDICES = 34963,  /* GL_ELEMENT_ARRAY_BUFFER */
	SPARSE_JSON_BYTES = 120  /* the JSON text of a sparse accessor */
};

void optimize_output_begin(struct optimize_output *output)
{
	*output = (struct optimize_output){.count = 0};
	glb_begin(&output->glb);
	memset(output->bucket, 0xFF, sizeof(output->bucket));
}

double optimize_decimal(float value)
{
	char text[32];

	for (int digits = 1; digits < 9; digits++) {
		snprintf(text, sizeof(text), "%.*g", digits, (double)value);
		if (strtof(text, NULL) == value) {
			return strtod(text, NULL);
		}
	}
	snprintf(text, sizeof(text), "%.9g", (double)value);
	return strtod(text, NULL);
}

/* Makes room for size more bytes. Returns the place, or NULL. */
static uint8_t *reserve(struct optimize_output *output,
	struct optimize_bytes *bytes, size_t size)
{
	if (bytes->capacity - bytes->size < size) {
		size_t capacity = bytes->capacity * 2 + size + 1024;
		uint8_t *data = realloc(bytes->data, capacity);

		if (!data) {
			output->glb.error = -ENOMEM;
			return NULL;
		}
		bytes->data = data;
		bytes->capacity = capacity;
	}
	return bytes->data + bytes->size;
}

static void put_component(
	uint8_t *out, const struct optimize_array *array, size_t at)
{
	size_t size = glb_component_bytes(array->component);
	uint32_t bits;

	if (array->component == GLB_FLOAT) {
		memcpy(&bits, &array->value[at], sizeof(bits));
	} else if (array->value) {
		bits = (uint32_t)lrintf(array->value[at]);
	} else {
		bits = array->index[at];
	}
	for (size_t i = 0; i < size; i++) {
		out[i] = (uint8_t)(bits >> 8 * i);
	}
}

static size_t aligned(size_t bytes)
{
	return (bytes + 3) & ~(size_t)3;
}

/* Columns of a matrix are aligned to 4 bytes (glTF 2.0, 3.6.2.4). */
static size_t element_bytes(const struct optimize_array *array)
{
	size_t size = glb_component_bytes(array->component);

	return array->rows > 0 ? (size_t)(array->width / array->rows) *
			aligned((size_t)array->rows * size)
			       : (size_t)array->width * size;
}

static void put_element(
	uint8_t *out, const struct optimize_array *array, int element)
{
	size_t size = glb_component_bytes(array->component);
	size_t width = (size_t)array->width;
	size_t rows = array->rows > 0 ? (size_t)array->rows : width;

	for (size_t i = 0; i < width; i++) {
		put_component(
			out + i / rows * aligned(rows * size) + i % rows * size,
			array, (size_t)element * width + i);
	}
}

static bool is_zero(const struct optimize_array *array, int element)
{
	for (int i = 0; i < array->width; i++) {
		size_t at = (size_t)element * (size_t)array->width + (size_t)i;

		if (array->value ? array->value[at] != 0.0f
				 : array->index[at] != 0) {
			return false;
		}
	}
	return true;
}

static uint64_t hash_of(const uint8_t *data, size_t size)
{
	uint64_t hash = optimize_hash(optimize_hash_empty, data, size);

	return hash ^ hash >> 29;
}

static json_t *number(const struct optimize_array *array, size_t at)
{
	if (array->component == GLB_FLOAT) {
		return json_real(optimize_decimal(array->value[at]));
	}
	return json_integer((json_int_t)lrintf(array->value[at]));
}

static void set_bounds(json_t *json, const struct optimize_array *array)
{
	json_t *low = json_array(), *high = json_array();
	size_t width = (size_t)array->width;

	for (size_t axis = 0; axis < width; axis++) {
		size_t least = axis, most = axis;

		for (size_t i = axis; i < (size_t)array->count * width;
			i += width) {
			least = array->value[i] < array->value[least] ? i
								      : least;
			most = array->value[i] > array->value[most] ? i : most;
		}
		json_array_append_new(low, number(array, least));
		json_array_append_new(high, number(array, most));
	}
	json_object_set_new(json, "min", low);
	json_object_set_new(json, "max", high);
}

static json_t *accessor_json(const struct optimize_array *array)
{
	static const char *const vectors[] = {
		[1] = "SCALAR", [2] = "VEC2", [3] = "VEC3", [4] = "VEC4"};
	static const char *const matrices[] = {
		[2] = "MAT2", [3] = "MAT3", [4] = "MAT4"};
	json_t *json = json_pack("{s:i, s:i, s:s}", "componentType",
		(int)array->component, "count", array->count, "type",
		array->rows > 0 ? matrices[array->rows] : vectors[array->width]);

	if (array->normalized) {
		json_object_set_new(json, "normalized", json_true());
	}
	if (array->bounded) {
		set_bounds(json, array);
	}
	return json;
}

/* bufferView is an enum optimize_view until optimize_output_end(). */
static void set_place(json_t *json, enum optimize_view view, size_t offset)
{
	json_object_set_new(json, "bufferView", json_integer((int)view));
	if (offset > 0) {
		json_object_set_new(
			json, "byteOffset", json_integer((json_int_t)offset));
	}
}

/*
 * Finds a stored accessor with the same bytes and type, or -1. Times of keys,
 * which are the bounded data, do not share one with values: glTF forbids two
 * uses of an accessor.
 */
static int find_equal(
	struct optimize_output *output, const struct optimize_accessor *wanted)
{
	const uint8_t *base = output->view[wanted->view].data;
	int i = output->bucket[wanted->hash % ARRAY_COUNT(output->bucket)];

	for (; i >= 0; i = output->accessor[i].next) {
		const struct optimize_accessor *have = &output->accessor[i];

		if (have->dense && have->hash == wanted->hash &&
			have->size == wanted->size &&
			have->view == wanted->view &&
			have->width == wanted->width &&
			have->rows == wanted->rows &&
			have->component == wanted->component &&
			have->normalized == wanted->normalized &&
			(have->bounded == wanted->bounded ||
				have->view != OPTIMIZE_DATA) &&
			memcmp(base + have->offset, base + wanted->offset,
				have->size) == 0) {
			return i;
		}
	}
	return -1;
}

static int append(
	struct optimize_output *output, struct optimize_accessor accessor)
{
	int *bucket =
		&output->bucket[accessor.hash % ARRAY_COUNT(output->bucket)];
	struct optimize_accessor *grown;

	if (output->count == output->capacity) {
		int capacity = output->capacity * 2 + 64;

		grown = realloc(output->accessor,
			(size_t)capacity * sizeof(*output->accessor));
		if (!grown) {
			output->glb.error = -ENOMEM;
			json_decref(accessor.json);
			return -1;
		}
		output->accessor = grown;
		output->capacity = capacity;
	}
	if (json_array_append_new(output->glb.accessors, accessor.json) != 0) {
		output->glb.error = -ENOMEM;
		return -1;
	}
	accessor.next = *bucket;
	*bucket = output->count;
	output->accessor[output->count] = accessor;
	return output->count++;
}

static int add_dense(struct optimize_output *output, enum optimize_view view,
	const struct optimize_array *array)
{
	size_t element = element_bytes(array);
	size_t stride = view >= OPTIMIZE_VERTICES ? aligned(element) : element;
	size_t size = stride * (size_t)array->count;
	struct optimize_bytes *bytes;
	struct optimize_accessor accessor;
	uint8_t *out;
	int same;

	if (view >= OPTIMIZE_VERTICES) {
		view = OPTIMIZE_VERTICES +
			(enum optimize_view)(stride / 4 <= 4 ? stride / 4 : 0);
	}
	bytes = &output->view[view];
	out = reserve(output, bytes, size + 4);
	if (!out) {
		return -1;
	}
	memset(out, 0, size + 4);
	for (int i = 0; i < array->count; i++) {
		put_element(out + (size_t)i * stride, array, i);
	}
	accessor = (struct optimize_accessor){
		.view = view,
		.offset = bytes->size,
		.size = size,
		.hash = hash_of(out, size),
		.component = (int)array->component,
		.width = array->width,
		.rows = array->rows,
		.normalized = array->normalized,
		.bounded = array->bounded,
		.dense = true,
	};
	same = find_equal(output, &accessor);
	if (same >= 0) {
		if (array->bounded) {
			set_bounds(output->accessor[same].json, array);
		}
		return same;
	}
	accessor.json = accessor_json(array);
	set_place(accessor.json, view, accessor.offset);
	bytes->size += aligned(size);
	return append(output, accessor);
}

static size_t put_bytes(
	struct optimize_output *output, const uint8_t *data, size_t size)
{
	struct optimize_bytes *bytes = &output->view[OPTIMIZE_DATA];
	uint8_t *out = reserve(output, bytes, size + 4);
	size_t offset = bytes->size;

	if (out) {
		memset(out, 0, size + 4);
		memcpy(out, data, size);
		bytes->size += aligned(size);
	}
	return offset;
}

/* Writes the elements that are not 0 to value, and their indices to index. */
static void pack(const struct optimize_array *array, size_t index_bytes,
	uint8_t *index, uint8_t *value)
{
	size_t element = element_bytes(array);

	for (int i = 0; i < array->count; i++) {
		if (is_zero(array, i)) {
			continue;
		}
		for (size_t b = 0; b < index_bytes; b++) {
			*index++ = (uint8_t)((uint32_t)i >> 8 * b);
		}
		put_element(value, array, i);
		value += element;
	}
}

static int add_sparse(struct optimize_output *output,
	const struct optimize_array *array, size_t index_bytes, int moved)
{
	size_t element = element_bytes(array);
	uint8_t *index = malloc((size_t)moved * index_bytes + 1);
	uint8_t *value = calloc((size_t)moved, element);
	json_t *json = accessor_json(array), *indices, *values;

	if (!index || !value) {
		output->glb.error = -ENOMEM;
	} else {
		pack(array, index_bytes, index, value);
		indices = json_pack("{s:i}", "componentType",
			index_bytes == 2 ? GLB_USHORT : GLB_UINT);
		values = json_object();
		set_place(indices, OPTIMIZE_DATA,
			put_bytes(output, index, (size_t)moved * index_bytes));
		set_place(values, OPTIMIZE_DATA,
			put_bytes(output, value, (size_t)moved * element));
		json_object_set_new(json, "sparse",
			json_pack("{s:i, s:o, s:o}", "count", moved, "indices",
				indices, "values", values));
	}
	free(index);
	free(value);
	return append(output, (struct optimize_accessor){.json = json});
}

int optimize_output_add(struct optimize_output *output, enum optimize_view view,
	const struct optimize_array *array)
{
	size_t index_bytes = array->count <= 65535 ? 2 : 4;
	size_t element = element_bytes(array);
	size_t dense = aligned(element) * (size_t)array->count;
	int moved = 0;

	if (output->glb.error) {
		return -1;
	}
	for (int i = 0; array->sparse && i < array->count; i++) {
		moved += !is_zero(array, i);
	}
	if (array->sparse && moved > 0 &&
		(size_t)moved * (element + index_bytes) + SPARSE_JSON_BYTES <
			dense) {
		return add_sparse(output, array, index_bytes, moved);
	}
	return add_dense(output, view, array);
}

static void describe_view(json_t *view, int kind)
{
	if (kind == OPTIMIZE_INDICES) {
		json_object_set_new(
			view, "target", json_integer(TARGET_INDICES));
	} else if (kind > OPTIMIZE_VERTICES) {
		json_object_set_new(view, "byteStride",
			json_integer(4 * (kind - OPTIMIZE_VERTICES)));
		json_object_set_new(
			view, "target", json_integer(TARGET_VERTICES));
	}
}

static void renumber(json_t *place, const int *number)
{
	json_t *kind = json_object_get(place, "bufferView");

	if (kind) {
		json_object_set_new(place, "bufferView",
			json_integer(number[json_integer_value(kind)]));
	}
}

void optimize_output_end(struct optimize_output *output)
{
	int number[OPTIMIZE_VIEWS] = {0};
	json_t *accessor;
	size_t i;

	for (int kind = 0; kind < OPTIMIZE_VIEWS; kind++) {
		struct optimize_bytes *bytes = &output->view[kind];

		if (bytes->size > 0) {
			number[kind] = glb_add_view(
				&output->glb, bytes->data, bytes->size);
			describe_view(json_array_get(output->glb.views,
					      (size_t)number[kind]),
				kind);
		}
		free(bytes->data);
	}
	json_array_foreach(output->glb.accessors, i, accessor)
	{
		json_t *sparse = json_object_get(accessor, "sparse");

		renumber(accessor, number);
		renumber(json_object_get(sparse, "indices"), number);
		renumber(json_object_get(sparse, "values"), number);
	}
	free(output->accessor);
}
