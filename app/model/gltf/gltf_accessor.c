#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
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

size_t gltf_element_bytes(const struct gltf_accessor *accessor)
{
	size_t column = (size_t)accessor->rows *
		gltf_component_bytes(accessor->base.component);

	if (accessor->rows == accessor->width) {
		return column;
	}
	column = (column + 3) & ~(size_t)3;
	return column * (size_t)(accessor->width / accessor->rows);
}

static int read_component(
	const struct gltf_at *at, enum gltf_component *component)
{
	int64_t value = 0;
	int error = gltf_require(at, "componentType");

	if (!error) {
		error = gltf_maybe_integer(
			at, "componentType", 0, INT32_MAX, &value);
	}
	if (error) {
		return error;
	}
	*component = (enum gltf_component)value;
	if (!gltf_component_bytes(*component)) {
		return gltf_fail(at, -EINVAL,
			"componentType %lld is not defined by glTF 2.0",
			(long long)value);
	}
	return 0;
}

static int read_type(const struct gltf_at *at, const struct type **type)
{
	const char *name = NULL;
	size_t i;
	int error = gltf_require(at, "type");

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
	return gltf_fail(
		at, -EINVAL, "type \"%.40s\" is not defined by glTF 2.0", name);
}

/* Fails unless the view has count elements of size bytes from offset on. */
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

/*
 * Reads bufferView and byteOffset. Without a bufferView, *out stays as it is.
 * strided says whether the view's byteStride counts; indices and values of
 * sparse accessors are always packed.
 */
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
			"elements of %zu bytes are larger than the byteStride of %zu",
			size, out->stride);
	}
	error = check_bounds(
		at, view, (uint64_t)offset, out->stride, count, size);
	if (!error) {
		out->data = view->data + offset;
	}
	return error;
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
	int64_t previous = -1;
	int i;

	for (i = 0; i < accessor->sparse_count; i++) {
		uint32_t value = gltf_get_uint(&accessor->sparse_index, i);

		if (value >= (uint32_t)accessor->count) {
			return gltf_fail(at, -EINVAL,
				"index %u is out of range (the accessor has %d elements)",
				value, accessor->count);
		}
		if (value <= previous) {
			return gltf_fail(at, -EINVAL,
				"index %u does not come after index %lld",
				value, (long long)previous);
		}
		previous = value;
	}
	return 0;
}

static int read_sparse_indices(
	const struct gltf_at *at, struct gltf_accessor *out)
{
	struct gltf_elements *index = &out->sparse_index;
	int error = gltf_require(at, "bufferView");

	if (!error) {
		error = read_component(at, &index->component);
	}
	if (!error && !is_unsigned(index->component)) {
		error = gltf_fail(at, -EINVAL,
			"componentType %d is not an unsigned integer",
			index->component);
	}
	if (!error) {
		error = read_elements(at, out->sparse_count,
			gltf_component_bytes(index->component), false, index);
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
	error = gltf_require(&at, "count");
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
		error = gltf_require(&values, "bufferView");
	}
	out->sparse_value.component = out->base.component;
	return error ? error
		     : read_elements(&values, out->sparse_count, size, false,
			       &out->sparse_value);
}

/*
 * Fails if count * width > 2^26, so that the size of an accessor in bytes fits
 * 32 bits, whatever budget the model has.
 */
static int check_size(const struct gltf_at *at, int64_t count, int width)
{
	int64_t most = GLTF_ACCESSOR_BYTES_MAX / (int64_t)sizeof(float) / width;

	if (count > most) {
		return gltf_fail(at, -EFBIG,
			"has %lld elements; limber reads up to %lld",
			(long long)count, (long long)most);
	}
	return 0;
}

static int read_accessor(const struct gltf_at *at)
{
	struct gltf_accessor *out = &at->gltf->accessor[at->index];
	const struct type *type = NULL;
	int64_t count = 0;
	size_t size;
	int error = gltf_require(at, "count");

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
	out->index = at->index;
	out->type = type->name;
	out->width = type->columns * type->rows;
	out->rows = type->rows;
	error = check_size(at, count, out->width);
	if (error) {
		return error;
	}
	out->count = (int)count;
	size = gltf_element_bytes(out);
	error = read_elements(at, out->count, size, true, &out->base);
	return error ? error : read_sparse(at, size, out);
}

int gltf_read_accessors(struct gltf *gltf)
{
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "accessors", &array, &count);

	if (error) {
		return error;
	}
	gltf->accessor = GLTF_SCRATCH(&array, struct gltf_accessor, count);
	gltf->times = GLTF_SCRATCH(&array, float *, count);
	if (!gltf->accessor || !gltf->times) {
		return -ENOMEM;
	}
	gltf->accessor_count = count;
	return gltf_for_each(&array, count, read_accessor);
}

/* Whether the space-separated list contains name. */
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
