#include "app/compare/optimize/build/optimize_build.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An accessor's elements in the new order, ready to be written. */
struct numbers {
	struct optimize_array array;
	float *value;
	uint32_t *index;
};

static void release(struct numbers *numbers)
{
	free(numbers->value);
	free(numbers->index);
}

static int fail(struct optimize_build *build, int error)
{
	struct glb *glb = &build->output.glb;

	glb->error = glb->error ? glb->error : error;
	return error;
}

/* Keeps the vertices that are used, in the group's order. */
static void reorder(struct numbers *numbers, const struct optimize_group *group)
{
	size_t width = (size_t)numbers->array.width;
	size_t count = (size_t)group->used_count * width;
	float *value = malloc((count + 1) * sizeof(*value));

	for (size_t i = 0; value && i < count; i++) {
		value[i] = numbers->value[group->source[i / width] * width +
			i % width];
	}
	free(numbers->value);
	numbers->value = value;
	numbers->array.value = value;
	numbers->array.count = group->used_count;
}

/* Reads an accessor's stored numbers, in the order of its group. */
static int read_numbers(const struct optimize_build *build, int accessor,
	const struct optimize_group *group, struct numbers *out)
{
	struct gltf_document_array from =
		gltf_document_array(build->document, accessor);
	size_t count = (size_t)from.count * (size_t)from.width;
	int error;

	*out = (struct numbers){
		.array = {.count = from.count,
			.width = from.width,
			.rows = from.rows,
			.component = (enum glb_component)from.component,
			.normalized = from.normalized},
		.value = malloc(count * sizeof(float)),
	};
	if (!out->value) {
		return -ENOMEM;
	}
	error = gltf_document_floats(build->document, accessor, out->value);
	out->array.value = out->value;
	if (!error && group) {
		reorder(out, group);
		error = out->value ? 0 : -ENOMEM;
	}
	return error;
}

static bool within(const struct optimize_array *array, float low, float high)
{
	size_t count = (size_t)array->count * (size_t)array->width;

	for (size_t i = 0; i < count; i++) {
		if (!(array->value[i] >= low && array->value[i] <= high)) {
			return false;
		}
	}
	return true;
}

/* Rounds values of -1..1 or 0..1 to normalised integers; one stands for 1. */
static void normalize_to(
	struct numbers *numbers, enum glb_component component, float one)
{
	size_t count =
		(size_t)numbers->array.count * (size_t)numbers->array.width;

	for (size_t i = 0; i < count; i++) {
		numbers->value[i] = rintf(numbers->value[i] * one);
	}
	numbers->array.component = component;
	numbers->array.normalized = true;
}

static void shrink_directions(struct numbers *numbers)
{
	int width = numbers->array.width;

	for (int v = 0; v < numbers->array.count; v++) {
		float *at = numbers->value + (size_t)v * (size_t)width;
		float length =
			sqrtf(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);

		for (int axis = 0; axis < 3 && length > 0.0f; axis++) {
			at[axis] /= length;
		}
	}
	normalize_to(numbers, GLB_BYTE, 127.0f);
}

static void shrink_joints(struct numbers *numbers)
{
	if (within(&numbers->array, 0.0f, 255.0f)) {
		numbers->array.component = GLB_UBYTE;
	}
}

static void scale_by(struct numbers *numbers, float factor)
{
	size_t count =
		(size_t)numbers->array.count * (size_t)numbers->array.width;

	for (size_t i = 0; i < count; i++) {
		numbers->value[i] *= factor;
	}
}

static void shrink_positions(struct numbers *numbers, float unit)
{
	if (unit > 0.0f) {
		scale_by(numbers, 1.0f / unit);
		if (within(&numbers->array, -1.0f, 1.0f)) {
			normalize_to(numbers, GLB_SHORT, 32767.0f);
		}
	}
}

static bool begins(const char *string, const char *start)
{
	return strncmp(string, start, strlen(start)) == 0;
}

/* Converts floats of an attribute to integers if their range allows it. */
static void shrink(struct optimize_build *build, const char *name, bool target,
	float unit, struct numbers *numbers)
{
	struct optimize_array *array = &numbers->array;

	if (begins(name, "JOINTS_") && array->component == GLB_USHORT) {
		shrink_joints(numbers);
	}
	if (array->component != GLB_FLOAT) {
		return;
	}
	if (strcmp(name, "POSITION") == 0) {
		shrink_positions(numbers, unit);
	} else if (target) {
		if (array->width == 3 && within(array, -1.0f, 1.0f)) {
			normalize_to(numbers, GLB_BYTE, 127.0f);
		}
	} else if (strcmp(name, "NORMAL") == 0 || strcmp(name, "TANGENT") == 0) {
		shrink_directions(numbers);
	} else if ((begins(name, "TEXCOORD_") || begins(name, "COLOR_")) &&
		within(array, 0.0f, 1.0f)) {
		normalize_to(numbers, GLB_USHORT, 65535.0f);
	}
	if (array->component == GLB_BYTE || array->component == GLB_SHORT) {
		build->output.glb.quantized = true;
	}
}

static int put(struct optimize_build *build, json_t *attributes,
	const char *name, struct numbers *numbers)
{
	optimize_build_set(build, attributes, name,
		optimize_output_add(
			&build->output, OPTIMIZE_VERTICES, &numbers->array));
	return build->output.glb.error;
}

static int build_attribute(struct optimize_build *build, json_t *attributes,
	const char *name, bool target, float unit)
{
	int accessor = optimize_build_member(build, attributes, name);
	struct numbers numbers;
	int error;

	if (accessor < 0) {
		return 0;
	}
	error = read_numbers(build, accessor,
		optimize_order_vertices(build->order, accessor), &numbers);
	if (!error) {
		if (build->plan->directions) {
			shrink(build, name, target, unit, &numbers);
		}
		numbers.array.bounded = strcmp(name, "POSITION") == 0;
		numbers.array.sparse = target;
		error = put(build, attributes, name, &numbers);
	}
	release(&numbers);
	return error ? fail(build, error) : 0;
}

enum {
	SETS = 8, /* WEIGHTS_0 to WEIGHTS_7 */
	SET_NAME = 24
};

/* Rounds a vertex's weights so that their sum stays exactly 1. */
static void round_weights(
	struct numbers *set, int sets, size_t vertex, float one)
{
	float *weight[4 * SETS];
	float sum = 0.0f, total = 0.0f;
	int count = 4 * sets, largest = 0;

	for (int i = 0; i < count; i++) {
		weight[i] = &set[i / 4].value[vertex * 4 + (size_t)(i % 4)];
		*weight[i] = *weight[i] > 0.0f ? *weight[i] : 0.0f;
		sum += *weight[i];
		largest = *weight[i] > *weight[largest] ? i : largest;
	}
	for (int i = 0; i < count && sum > 0.0f; i++) {
		*weight[i] = rintf(*weight[i] / sum * one);
		total += *weight[i];
	}
	*weight[largest] += sum > 0.0f ? one - total : 0.0f;
}

static void shrink_weights(
	const struct optimize_build *build, struct numbers *set, int sets)
{
	bool bytes = build->plan->byte_weights;
	float one = bytes ? 255.0f : 65535.0f;

	for (int i = 0; i < sets; i++) {
		if (set[i].array.component != GLB_FLOAT ||
			set[i].array.count != set[0].array.count ||
			set[i].array.width != 4) {
			return;
		}
	}
	for (int v = 0; v < set[0].array.count; v++) {
		round_weights(set, sets, (size_t)v, one);
	}
	for (int i = 0; i < sets; i++) {
		set[i].array.component = bytes ? GLB_UBYTE : GLB_USHORT;
		set[i].array.normalized = true;
	}
}

static void name_weights(int set, char name[SET_NAME])
{
	snprintf(name, SET_NAME, "WEIGHTS_%d", set);
}

/* The number of successive sets from WEIGHTS_0 on; 0 if above SETS. */
static int count_weights(
	const struct optimize_build *build, const json_t *attributes)
{
	for (int set = 0; set <= SETS; set++) {
		char name[SET_NAME];

		name_weights(set, name);
		if (optimize_build_member(build, attributes, name) < 0) {
			return set;
		}
	}
	return 0;
}

static bool is_weights(const char *key, int sets)
{
	for (int set = 0; set < sets; set++) {
		char name[SET_NAME];

		name_weights(set, name);
		if (strcmp(key, name) == 0) {
			return true;
		}
	}
	return false;
}

static int build_weights(
	struct optimize_build *build, json_t *attributes, int sets)
{
	struct numbers set[SETS] = {{.value = NULL}};
	char name[SET_NAME];
	int error = 0;

	for (int i = 0; i < sets && !error; i++) {
		int accessor;

		name_weights(i, name);
		accessor = optimize_build_member(build, attributes, name);
		error = read_numbers(build, accessor,
			optimize_order_vertices(build->order, accessor),
			&set[i]);
	}
	if (!error && build->plan->weights) {
		shrink_weights(build, set, sets);
	}
	for (int i = 0; i < sets; i++) {
		name_weights(i, name);
		error = error ? error : put(build, attributes, name, &set[i]);
		release(&set[i]);
	}
	return error ? fail(build, error) : 0;
}

static int build_attributes(struct optimize_build *build, json_t *attributes,
	bool target, float unit)
{
	int sets = target ? 0 : count_weights(build, attributes);
	json_t *names = json_array();
	const char *key;
	json_t *value;
	size_t i;
	int error = 0;

	json_object_foreach(attributes, key, value)
	{
		json_array_append_new(names, json_string(key));
	}
	json_array_foreach(names, i, value)
	{
		const char *name = json_string_value(value);

		if (!error && !is_weights(name, sets)) {
			error = build_attribute(
				build, attributes, name, target, unit);
		}
	}
	json_decref(names);
	return error ? error : build_weights(build, attributes, sets);
}

static int build_indices(struct optimize_build *build, json_t *primitive)
{
	int accessor = optimize_build_member(build, primitive, "indices");
	struct gltf_document_array from;
	const uint32_t *list;
	uint32_t *index, most = 0;
	struct optimize_array array;

	if (accessor < 0) {
		return 0;
	}
	from = gltf_document_array(build->document, accessor);
	index = malloc((size_t)from.count * sizeof(*index));
	if (!index) {
		return fail(build, -ENOMEM);
	}
	gltf_document_uints(build->document, accessor, index);
	list = optimize_order_list(build->order, accessor);
	for (int i = 0; i < from.count; i++) {
		index[i] = list ? list[i] : index[i];
		most = index[i] > most ? index[i] : most;
	}
	/* 65535 restarts a strip in some programs, so glTF excludes it. */
	array = (struct optimize_array){
		.count = from.count,
		.width = 1,
		.component = most < UINT16_MAX ? GLB_USHORT : GLB_UINT,
		.index = index,
	};
	optimize_build_set(build, primitive, "indices",
		optimize_output_add(&build->output, OPTIMIZE_INDICES, &array));
	free(index);
	return build->output.glb.error;
}

static int build_primitive(
	struct optimize_build *build, json_t *primitive, float unit)
{
	json_t *target;
	size_t i;
	int error = build_attributes(
		build, json_object_get(primitive, "attributes"), false, unit);

	json_array_foreach(json_object_get(primitive, "targets"), i, target)
	{
		error = error ? error
			      : build_attributes(build, target, true, unit);
	}
	return error ? error : build_indices(build, primitive);
}

int optimize_build_meshes(struct optimize_build *build)
{
	json_t *mesh, *primitive;
	size_t m, p;
	int error = 0;

	json_array_foreach(json_object_get(build->root, "meshes"), m, mesh)
	{
		float unit = optimize_build_unit(build, &build->scale->mesh[m]);

		json_array_foreach(
			json_object_get(mesh, "primitives"), p, primitive)
		{
			error = error ? error
				      : build_primitive(build, primitive, unit);
		}
	}
	return error;
}
