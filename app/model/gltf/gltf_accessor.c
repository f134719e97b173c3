#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <math.h>
#include <string.h>

struct type {
	const char *name;
	int columns, rows;
};

static const struct type types[] = {
	{"SCALAR", 1, 1},
	{"VEC2", 1, 2},
	{"VEC3", 1, 3},
	{"VEC4", 1, 4},
	{"MAT2", 2, 2},
	{"MAT3", 3, 3},
	{"MAT4", 4, 4},
};

static size_t component_bytes(enum gltf_component component)
{
	switch (component) {
	case GLTF_I8:
	case GLTF_U8:
		return 1;
	case GLTF_I16:
	case GLTF_U16:
		return 2;
	case GLTF_U32:
	case GLTF_F32:
		return 4;
	}
	return 0;
}

/* Columns of a matrix begin on 4-byte boundaries (glTF 2.0, 3.6.2.4). */
static size_t element_bytes(
	const struct type *type, enum gltf_component component)
{
	size_t column = (size_t)type->rows * component_bytes(component);

	if (type->columns > 1) {
		column = (column + 3) & ~(size_t)3;
	}
	return column * (size_t)type->columns;
}

static int read_component(
	const struct gltf_at *at, enum gltf_component *component)
{
	int64_t value = 0;
	int error = gltf_need(at, "componentType");

	if (!error) {
		error = gltf_maybe_integer(
			at, "componentType", 0, INT32_MAX, &value);
	}
	if (error) {
		return error;
	}
	*component = (enum gltf_component)value;
	if (!component_bytes(*component)) {
		return gltf_fail(at, -EINVAL, "componentType %lld is unknown",
			(long long)value);
	}
	return 0;
}

static int read_type(const struct gltf_at *at, const struct type **type)
{
	const char *name = NULL;
	size_t i;
	int error = gltf_need(at, "type");

	if (!error) {
		error = gltf_maybe_string(at, "type", &name);
	}
	if (error) {
		return error;
	}
	for (i = 0; i < ARRAY_COUNT(types); i++) {
		if (strcmp(types[i].name, name) == 0) {
			*type = &types[i];
			return 0;
		}
	}
	return gltf_fail(at, -EINVAL, "type \"%.40s\" is unknown", name);
}

/* Whether count elements of size bytes lie in the view, from offset on. */
static int check_bounds(const struct gltf_at *at, const struct gltf_view *view,
	uint64_t offset, uint64_t stride, int count, uint64_t size)
{
	uint64_t end = offset + stride * (uint64_t)(count - 1) + size;

	if (end > view->size) {
		return gltf_fail(at, -EINVAL,
			"needs %llu bytes of its bufferView, which has %zu",
			(unsigned long long)end, view->size);
	}
	return 0;
}

/* A bufferView and byteOffset; a stride counts only where it is allowed. */
static int read_elements(const struct gltf_at *at, int count, size_t size,
	bool strided, struct gltf_elements *out)
{
	struct gltf *gltf = at->gltf;
	const struct gltf_view *view;
	int64_t offset = 0;
	int index = -1;
	int error = gltf_maybe_index(
		at, "bufferView", gltf->view_count, "bufferView", &index);

	if (!error) {
		error = gltf_maybe_integer(
			at, "byteOffset", 0, INT32_MAX, &offset);
	}
	if (error || index < 0) {
		return error;
	}
	view = &gltf->view[index];
	out->stride = strided && view->stride ? view->stride : size;
	if (out->stride < size) {
		return gltf_fail(at, -EINVAL,
			"elements of %zu bytes do not fit the byteStride %zu",
			size, out->stride);
	}
	error = check_bounds(
		at, view, (uint64_t)offset, out->stride, count, size);
	if (!error) {
		out->data = view->data + offset;
	}
	return error;
}

static uint32_t get_u16(const uint8_t *bytes)
{
	return bytes[0] | (uint32_t)bytes[1] << 8;
}

static uint32_t get_uint(const uint8_t *bytes, enum gltf_component component)
{
	switch (component) {
	case GLTF_U8:
		return bytes[0];
	case GLTF_U16:
		return get_u16(bytes);
	default:
		return get_u16(bytes) | get_u16(bytes + 2) << 16;
	}
}

static bool is_unsigned(enum gltf_component component)
{
	return component == GLTF_U8 || component == GLTF_U16 ||
		component == GLTF_U32;
}

bool gltf_is_unsigned(const struct gltf_accessor *accessor)
{
	return is_unsigned(accessor->base.component) && !accessor->normalized;
}

static int check_sparse_indices(
	const struct gltf_at *at, const struct gltf_accessor *accessor)
{
	const struct gltf_elements *index = &accessor->sparse_index;
	int64_t previous = -1;
	int i;

	for (i = 0; i < accessor->sparse_count; i++) {
		uint32_t value = get_uint(
			index->data + i * index->stride, index->component);

		if (value >= (uint32_t)accessor->count) {
			return gltf_fail(at, -EINVAL,
				"index %u is not below the count %d", value,
				accessor->count);
		}
		if (value <= previous) {
			return gltf_fail(at, -EINVAL,
				"index %u does not rise from %lld", value,
				(long long)previous);
		}
		previous = value;
	}
	return 0;
}

static int read_sparse_indices(
	const struct gltf_at *at, struct gltf_accessor *out)
{
	struct gltf_elements *index = &out->sparse_index;
	int error = gltf_need(at, "bufferView");

	if (!error) {
		error = read_component(at, &index->component);
	}
	if (!error && !is_unsigned(index->component)) {
		error = gltf_fail(at, -EINVAL,
			"componentType %d is not unsigned", index->component);
	}
	if (!error) {
		error = read_elements(at, out->sparse_count,
			component_bytes(index->component), false, index);
	}
	return error ? error : check_sparse_indices(at, out);
}

static int read_sparse(
	const struct gltf_at *accessor, size_t size, struct gltf_accessor *out)
{
	struct gltf_at at, indices, values;
	int64_t count = 0;
	int error = gltf_object(accessor, "sparse", &at);

	if (error || !at.json) {
		return error;
	}
	error = gltf_need(&at, "count");
	if (!error) {
		error = gltf_maybe_integer(&at, "count", 1, out->count, &count);
	}
	if (!error) {
		error = gltf_object(&at, "indices", &indices);
	}
	if (!error) {
		error = gltf_object(&at, "values", &values);
	}
	if (error) {
		return error;
	}
	out->sparse_count = (int)count;
	error = read_sparse_indices(&indices, out);
	if (!error) {
		error = gltf_need(&values, "bufferView");
	}
	out->sparse_value.component = out->base.component;
	return error ? error
		     : read_elements(&values, out->sparse_count, size, false,
			       &out->sparse_value);
}

/*
 * Unpacked to floats, an accessor alone must fit the budget; so products of
 * count and width stay below 2^26, which 32-bit sizes hold in bytes, too.
 */
static int check_size(const struct gltf_at *at, int64_t count, int width)
{
	int64_t most = GLTF_BUDGET_BYTES / (int64_t)sizeof(float) / width;

	if (count > most) {
		return gltf_fail(at, -EFBIG,
			"has %lld elements; limber reads up to %lld",
			(long long)count, (long long)most);
	}
	return 0;
}

static int read_accessor(const struct gltf_at *at, struct gltf_accessor *out)
{
	const struct type *type = NULL;
	int64_t count = 0;
	size_t size;
	int error = gltf_need(at, "count");

	if (!error) {
		error = gltf_maybe_integer(at, "count", 1, INT32_MAX, &count);
	}
	if (!error) {
		error = read_type(at, &type);
	}
	if (!error) {
		error = read_component(at, &out->base.component);
	}
	if (!error) {
		error = gltf_maybe_bool(at, "normalized", &out->normalized);
	}
	if (error) {
		return error;
	}
	out->type = type->name;
	out->width = type->columns * type->rows;
	error = check_size(at, count, out->width);
	if (error) {
		return error;
	}
	out->count = (int)count;
	size = element_bytes(type, out->base.component);
	error = read_elements(at, out->count, size, true, &out->base);
	return error ? error : read_sparse(at, size, out);
}

int gltf_read_accessors(struct gltf *gltf)
{
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(&gltf->root, "accessors", &array, &count);

	if (error) {
		return error;
	}
	gltf->accessor = GLTF_SCRATCH(&array, struct gltf_accessor, count);
	gltf->times = GLTF_SCRATCH(&array, const float *, count);
	if (!gltf->accessor || !gltf->times) {
		return -ENOMEM;
	}
	gltf->accessor_count = count;
	for (i = 0; i < count && !error; i++) {
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_accessor(&item, &gltf->accessor[i]);
		}
	}
	return error;
}

/* glTF 2.0, 3.6.2.2 for the normalised ones: -128 and -127 are both -1. */
static float get_float(
	const uint8_t *bytes, enum gltf_component component, bool normalized)
{
	uint32_t bits;
	float value = 0;
	float unit = 1;

	switch (component) {
	case GLTF_I8:
		value = (float)(int8_t)bytes[0];
		unit = 127.0f;
		break;
	case GLTF_U8:
		value = (float)bytes[0];
		unit = 255.0f;
		break;
	case GLTF_I16:
		value = (float)(int16_t)get_u16(bytes);
		unit = 32767.0f;
		break;
	case GLTF_U16:
		value = (float)get_u16(bytes);
		unit = 65535.0f;
		break;
	case GLTF_U32:
		return (float)get_uint(bytes, component);
	case GLTF_F32:
		bits = get_uint(bytes, component);
		memcpy(&value, &bits, sizeof(value));
		return value;
	}
	if (!normalized) {
		return value;
	}
	value /= unit;
	return value < -1 ? -1 : value;
}

/* Matrices of small components have gaps; limber reads MAT4 of floats only. */
static void unpack_element(const struct gltf_elements *elements, int index,
	int width, bool normalized, float *out)
{
	const uint8_t *bytes = elements->data + index * elements->stride;
	size_t size = component_bytes(elements->component);
	int i;

	for (i = 0; i < width; i++) {
		out[i] = get_float(
			bytes + i * size, elements->component, normalized);
	}
}

static int check_finite(const struct gltf_at *at,
	const struct gltf_accessor *accessor, const float *values)
{
	size_t total = (size_t)accessor->count * (size_t)accessor->width;
	size_t i;

	for (i = 0; i < total; i++) {
		if (!isfinite(values[i])) {
			return gltf_fail(at, -EINVAL,
				"element %zu of accessor %d is not finite",
				i / (size_t)accessor->width,
				(int)(accessor - at->gltf->accessor));
		}
	}
	return 0;
}

int gltf_unpack_floats(const struct gltf_at *at,
	const struct gltf_accessor *accessor, float *out)
{
	const struct gltf_elements *index = &accessor->sparse_index;
	size_t width = (size_t)accessor->width;
	int i;

	if (accessor->base.data) {
		for (i = 0; i < accessor->count; i++) {
			unpack_element(&accessor->base, i, accessor->width,
				accessor->normalized, out + i * width);
		}
	} else {
		memset(out, 0, (size_t)accessor->count * width * sizeof(*out));
	}
	for (i = 0; i < accessor->sparse_count; i++) {
		uint32_t element = get_uint(
			index->data + i * index->stride, index->component);

		unpack_element(&accessor->sparse_value, i, accessor->width,
			accessor->normalized, out + element * width);
	}
	return accessor->base.component == GLTF_F32
		? check_finite(at, accessor, out)
		: 0;
}

static void unpack_uints(const struct gltf_elements *elements, int index,
	int width, uint32_t *out)
{
	const uint8_t *bytes = elements->data + index * elements->stride;
	size_t size = component_bytes(elements->component);
	int i;

	for (i = 0; i < width; i++) {
		out[i] = get_uint(bytes + i * size, elements->component);
	}
}

void gltf_unpack_uints(const struct gltf_accessor *accessor, uint32_t *out)
{
	const struct gltf_elements *index = &accessor->sparse_index;
	size_t width = (size_t)accessor->width;
	int i;

	if (accessor->base.data) {
		for (i = 0; i < accessor->count; i++) {
			unpack_uints(&accessor->base, i, accessor->width,
				out + i * width);
		}
	} else {
		memset(out, 0, (size_t)accessor->count * width * sizeof(*out));
	}
	for (i = 0; i < accessor->sparse_count; i++) {
		uint32_t element = get_uint(
			index->data + i * index->stride, index->component);

		unpack_uints(&accessor->sparse_value, i, accessor->width,
			out + element * width);
	}
}

/* Whether name is one of the words in list. */
static bool is_listed(const char *list, const char *name)
{
	size_t length = strlen(name);
	const char *at = strstr(list, name);

	return at && (at[length] == ' ' || at[length] == '\0');
}

int gltf_maybe_accessor(const struct gltf_at *at, const char *key,
	const char *type, const struct gltf_accessor **out)
{
	struct gltf_at member = gltf_member(at, key);
	const struct gltf_accessor *accessor;
	int index = -1;
	int error = gltf_maybe_index(
		at, key, at->gltf->accessor_count, "accessor", &index);

	*out = NULL;
	if (error || index < 0) {
		return error;
	}
	accessor = &at->gltf->accessor[index];
	if (!is_listed(type, accessor->type)) {
		return gltf_fail(&member, -EINVAL,
			"accessor %d is %s instead of %s", index,
			accessor->type, type);
	}
	*out = accessor;
	return 0;
}
