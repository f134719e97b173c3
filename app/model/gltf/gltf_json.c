#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <string.h>

struct gltf_at gltf_member(const struct gltf_at *at, const char *key)
{
	return (struct gltf_at){
		.gltf = at->gltf,
		.up = at,
		.key = key,
		.json = json_object_get(at->json, key),
	};
}

struct gltf_at gltf_element(const struct gltf_at *array, int index)
{
	return (struct gltf_at){
		.gltf = array->gltf,
		.up = array,
		.index = index,
		.json = json_array_get(array->json, (size_t)index),
	};
}

int gltf_item(const struct gltf_at *array, int index, struct gltf_at *out)
{
	*out = gltf_element(array, index);
	if (!json_is_object(out->json)) {
		return gltf_fail(out, -EINVAL, "is not an object");
	}
	return 0;
}

int gltf_for_each(const struct gltf_at *array, int count,
	int (*read)(const struct gltf_at *item))
{
	struct gltf_at item;
	int error = 0;
	int i;

	for (i = 0; i < count && !error; i++) {
		error = gltf_item(array, i, &item);
		if (!error) {
			error = read(&item);
		}
	}
	return error;
}

int gltf_object(const struct gltf_at *at, const char *key, struct gltf_at *out)
{
	*out = gltf_member(at, key);
	if (out->json && !json_is_object(out->json)) {
		return gltf_fail(out, -EINVAL, "is not an object");
	}
	return 0;
}

int gltf_array(const struct gltf_at *at, const char *key, struct gltf_at *out,
	int *count)
{
	*out = gltf_member(at, key);
	if (out->json && !json_is_array(out->json)) {
		return gltf_fail(out, -EINVAL, "is not an array");
	}
	/* The JSON text has less than 2^31 bytes, so the length fits. */
	*count = (int)json_array_size(out->json);
	return 0;
}

int gltf_maybe_string(
	const struct gltf_at *at, const char *key, const char **out)
{
	struct gltf_at member = gltf_member(at, key);

	if (!member.json) {
		return 0;
	}
	if (!json_is_string(member.json)) {
		return gltf_fail(&member, -EINVAL, "is not a string");
	}
	*out = json_string_value(member.json);
	return 0;
}

int gltf_maybe_choice(const struct gltf_at *at, const char *key,
	const char *const *names, int count, int *out)
{
	struct gltf_at member = gltf_member(at, key);
	const char *name = NULL;
	int error = gltf_maybe_string(at, key, &name);

	if (error || !name) {
		return error;
	}
	for (int i = 0; i < count; i++) {
		if (strcmp(names[i], name) == 0) {
			*out = i;
			return 0;
		}
	}
	return gltf_fail(
		&member, -EINVAL, "\"%.40s\" is not defined by glTF 2.0", name);
}

int gltf_maybe_bool(const struct gltf_at *at, const char *key, bool *out)
{
	struct gltf_at member = gltf_member(at, key);

	if (!member.json) {
		return 0;
	}
	if (!json_is_boolean(member.json)) {
		return gltf_fail(&member, -EINVAL, "is neither true nor false");
	}
	*out = json_is_true(member.json);
	return 0;
}

static int read_number(const struct gltf_at *at, float *out)
{
	double value;

	if (!json_is_number(at->json)) {
		return gltf_fail(at, -EINVAL, "is not a number");
	}
	value = json_number_value(at->json);
	if (!(fabs(value) <= (double)FLT_MAX)) {
		return gltf_fail(
			at, -EINVAL, "%g exceeds the range of a float", value);
	}
	*out = (float)value;
	return 0;
}

int gltf_maybe_number(const struct gltf_at *at, const char *key, float *out)
{
	struct gltf_at member = gltf_member(at, key);

	return member.json ? read_number(&member, out) : 0;
}

int gltf_maybe_floats(
	const struct gltf_at *at, const char *key, float *out, int count)
{
	struct gltf_at array;
	int length, i;
	int error = gltf_array(at, key, &array, &length);

	if (error || !array.json) {
		return error;
	}
	if (length != count) {
		return gltf_fail(&array, -EINVAL,
			"has %d numbers instead of %d", length, count);
	}
	for (i = 0; i < count && !error; i++) {
		struct gltf_at element = gltf_element(&array, i);

		error = read_number(&element, &out[i]);
		if (!error && fabsf(out[i]) > MODEL_NUMBER_MAX) {
			error = gltf_fail(
				&element, -EINVAL, "is larger than 1e9");
		}
	}
	return error;
}

/* Reads an integer. Some exporters write integers with ".0". */
static int read_integer(const struct gltf_at *at, int64_t *out)
{
	double value;

	if (json_is_integer(at->json)) {
		*out = json_integer_value(at->json);
		return 0;
	}
	value = json_is_real(at->json) ? json_real_value(at->json) : 0.5;
	if (!(fabs(value) < 9e15) || floor(value) != value) {
		return gltf_fail(at, -EINVAL, "is not an integer");
	}
	*out = (int64_t)value;
	return 0;
}

int gltf_maybe_integer(const struct gltf_at *at, const char *key, int64_t min,
	int64_t max, int64_t *out)
{
	struct gltf_at member = gltf_member(at, key);
	int64_t value;
	int error;

	if (!member.json) {
		return 0;
	}
	error = read_integer(&member, &value);
	if (error) {
		return error;
	}
	if (value < min || value > max) {
		return gltf_fail(&member, -EINVAL,
			"%lld is out of range (%lld to %lld)", (long long)value,
			(long long)min, (long long)max);
	}
	*out = value;
	return 0;
}

int gltf_index(const struct gltf_at *at, int count, const char *what, int *out)
{
	int64_t value;
	int error = read_integer(at, &value);

	if (error) {
		return error;
	}
	if (value < 0 || value >= count) {
		return gltf_fail(at, -EINVAL,
			"%s %lld does not exist (the file has %d)", what,
			(long long)value, count);
	}
	*out = (int)value;
	return 0;
}

int gltf_maybe_index(const struct gltf_at *at, const char *key, int count,
	const char *what, int *out)
{
	struct gltf_at member = gltf_member(at, key);

	return member.json ? gltf_index(&member, count, what, out) : 0;
}

int gltf_maybe_root_index(const struct gltf_at *at, const char *key,
	const char *array, const char *what, int *out)
{
	struct gltf_at elements;
	int count;
	int error = gltf_array(&at->gltf->root, array, &elements, &count);

	return error ? error : gltf_maybe_index(at, key, count, what, out);
}

int gltf_require(const struct gltf_at *at, const char *key)
{
	if (!json_object_get(at->json, key)) {
		return gltf_fail(at, -EINVAL, "has no \"%s\"", key);
	}
	return 0;
}

int gltf_copy_string(
	const struct gltf_at *at, const char *text, const char **out)
{
	size_t bytes = strlen(text) + 1;
	char *copy = GLTF_KEEP(at, char, bytes);

	if (!copy) {
		return -ENOMEM;
	}
	memcpy(copy, text, bytes);
	*out = copy;
	return 0;
}

int gltf_name(const struct gltf_at *at, const char **out)
{
	const char *name = "";
	int error = gltf_maybe_string(at, "name", &name);

	return error ? error : gltf_copy_string(at, name, out);
}

int gltf_no_memory(const struct gltf_at *at)
{
	char where[256];

	gltf_path(at, where, sizeof(where));
	return memory_budget_fail(at->gltf->model->budget, where, at->gltf->log);
}

int gltf_take(const struct gltf_at *at, size_t count, size_t size)
{
	size_t bytes = SIZE_MAX;

	(void)size_multiply(count, size, &bytes);
	if (!memory_budget_take(at->gltf->model->budget, bytes)) {
		return gltf_no_memory(at);
	}
	at->gltf->taken_bytes += bytes;
	return 0;
}

void gltf_give_back(struct gltf *gltf, size_t bytes)
{
	memory_budget_give_back(gltf->model->budget, bytes);
	gltf->taken_bytes -= bytes;
}

void gltf_end_brief(struct gltf *gltf)
{
	arena_release(&gltf->brief);
}

void gltf_drop_element(struct gltf *gltf, const char *array, int index)
{
	json_t *elements = json_object_get(gltf->json, array);

	if (gltf->all_keys) {
		return;
	}
	if (!gltf->nothing) {
		gltf->nothing = json_object();
	}
	if (gltf->nothing) {
		(void)json_array_set(elements, (size_t)index, gltf->nothing);
	}
}

void *gltf_alloc(const struct gltf_at *at, struct arena *arena, size_t count,
	size_t size)
{
	void *memory = arena_alloc(arena, count, size);

	if (!memory) {
		(void)gltf_no_memory(at);
	}
	return memory;
}
