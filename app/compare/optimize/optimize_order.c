#include "app/compare/optimize/optimize_order.h"

#include "app/compare/export/glb.h"
#include "app/compare/optimize/optimize_tipsify.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	FREE = -1,  /* no group uses the accessor */
	FIXED = -2, /* several groups use it */
	TRIANGLES = 4
};

typedef int (*primitive_visitor)(
	struct optimize_order *order, json_t *primitive);

static int number_of(const struct optimize_order *order, const json_t *value)
{
	json_int_t index =
		json_is_integer(value) ? json_integer_value(value) : -1;

	return index >= 0 && index < gltf_document_array_count(order->document)
		? (int)index
		: -1;
}

static int list_of(const struct optimize_order *order, const json_t *primitive)
{
	return number_of(order, json_object_get(primitive, "indices"));
}

static void join(struct optimize_order *order, int *of, int accessor, int number)
{
	if (of[accessor] == FREE) {
		of[accessor] = number;
	} else if (of[accessor] != number) {
		if (of[accessor] >= 0) {
			order->group[of[accessor]].fixed = true;
		}
		of[accessor] = FIXED;
		order->group[number].fixed = true;
	}
}

static void join_attributes(
	struct optimize_order *order, json_t *attributes, int number)
{
	struct optimize_group *group = &order->group[number];
	const char *key;
	json_t *value;

	json_object_foreach(attributes, key, value)
	{
		int accessor = number_of(order, value), count;

		if (accessor < 0) {
			group->fixed = true;
			continue;
		}
		count = gltf_document_array(order->document, accessor).count;
		if (group->vertex_count == 0) {
			group->vertex_count = count;
		}
		group->fixed = group->fixed || count != group->vertex_count;
		join(order, order->of_vertices, accessor, number);
	}
}

static bool has_triangles(
	const struct optimize_order *order, const json_t *primitive)
{
	const json_t *mode = json_object_get(primitive, "mode");
	int list = list_of(order, primitive);
	struct gltf_document_array array;

	if (list < 0 || (mode && json_integer_value(mode) != TRIANGLES)) {
		return false;
	}
	array = gltf_document_array(order->document, list);
	return array.count % 3 == 0 && array.width == 1 && !array.normalized &&
		(array.component == GLB_UBYTE || array.component == GLB_USHORT ||
			array.component == GLB_UINT);
}

/* The primitive's group: order->count if it is new; -1 without memory. */
static int find_group(struct optimize_order *order, const json_t *primitive)
{
	json_t *parts =
		json_pack("[O?, O?]", json_object_get(primitive, "attributes"),
			json_object_get(primitive, "targets"));
	char *key = json_dumps(parts, JSON_COMPACT | JSON_SORT_KEYS);
	json_t *known = key ? json_object_get(order->by_key, key) : NULL;
	int number = known ? (int)json_integer_value(known) : order->count;

	if (!key ||
		(!known &&
			json_object_set_new(order->by_key, key,
				json_integer(number)) != 0)) {
		number = -1;
	}
	free(key);
	json_decref(parts);
	return number;
}

/* Whether triangles are blended, so that their order changes the picture. */
static bool is_blended(
	const struct optimize_order *order, const json_t *primitive)
{
	json_t *root = gltf_document_json(order->document);
	json_t *number = json_object_get(primitive, "material");
	json_t *material = json_is_integer(number)
		? json_array_get(json_object_get(root, "materials"),
			  (size_t)json_integer_value(number))
		: NULL;
	const char *mode =
		json_string_value(json_object_get(material, "alphaMode"));

	return mode && strcmp(mode, "BLEND") == 0;
}

static int add_primitive(struct optimize_order *order, json_t *primitive)
{
	int number = find_group(order, primitive);
	int list = list_of(order, primitive);
	json_t *target;
	size_t t;

	if (number < 0) {
		return -ENOMEM;
	}
	order->count += number == order->count;
	join_attributes(order, json_object_get(primitive, "attributes"), number);
	json_array_foreach(json_object_get(primitive, "targets"), t, target)
	{
		join_attributes(order, target, number);
	}
	if (!has_triangles(order, primitive)) {
		order->group[number].fixed = true;
	}
	if (list >= 0) {
		join(order, order->of_list, list, number);
		order->blended[list] =
			order->blended[list] || is_blended(order, primitive);
	}
	return 0;
}

static int for_each_primitive(
	struct optimize_order *order, primitive_visitor visit)
{
	json_t *meshes =
		json_object_get(gltf_document_json(order->document), "meshes");
	json_t *mesh, *primitive;
	size_t m, p;
	int error = 0;

	json_array_foreach(meshes, m, mesh)
	{
		json_array_foreach(
			json_object_get(mesh, "primitives"), p, primitive)
		{
			error = error ? error : visit(order, primitive);
		}
	}
	return error;
}

/* Reads a list of indices; fixes the group if one of them is out of range. */
static int read_list(struct optimize_order *order, int list)
{
	struct optimize_group *group = &order->group[order->of_list[list]];
	int count = gltf_document_array(order->document, list).count;
	uint32_t *index = malloc((size_t)count * sizeof(*index));

	if (!index) {
		return -ENOMEM;
	}
	gltf_document_uints(order->document, list, index);
	for (int i = 0; i < count; i++) {
		if (index[i] >= (uint32_t)group->vertex_count) {
			group->fixed = true;
		}
	}
	order->list[list] = index;
	return 0;
}

/* The group of an accessor if it may be reordered, else NULL. */
static struct optimize_group *free_group(
	const struct optimize_order *order, const int *of, int accessor)
{
	struct optimize_group *group =
		of[accessor] >= 0 ? &order->group[of[accessor]] : NULL;

	return group && !group->fixed ? group : NULL;
}

static int order_lists(struct optimize_order *order)
{
	int count = gltf_document_array_count(order->document);
	int error = 0;

	for (int i = 0; i < count && !error; i++) {
		if (free_group(order, order->of_list, i)) {
			error = read_list(order, i);
		}
	}
	for (int i = 0; i < count && !error; i++) {
		const struct optimize_group *group =
			free_group(order, order->of_list, i);

		if (group && !order->blended[i]) {
			error = optimize_tipsify(order->list[i],
				gltf_document_array(order->document, i).count,
				group->vertex_count);
		}
	}
	return error;
}

static int begin_vertices(struct optimize_group *group)
{
	size_t count = (size_t)group->vertex_count + 1;

	if (!group->source) {
		group->source = calloc(count, sizeof(*group->source));
		group->rename = calloc(count, sizeof(*group->rename));
	}
	return group->source && group->rename ? 0 : -ENOMEM;
}

/* Numbers vertices in the order of their first use in the primitive's list. */
static int order_vertices(struct optimize_order *order, json_t *primitive)
{
	int list = list_of(order, primitive), count;
	struct optimize_group *group =
		list >= 0 ? free_group(order, order->of_list, list) : NULL;
	uint32_t *index;

	if (!group || order->renamed[list]) {
		return 0;
	}
	if (begin_vertices(group) != 0) {
		return -ENOMEM;
	}
	index = order->list[list];
	count = gltf_document_array(order->document, list).count;
	for (int i = 0; i < count; i++) {
		uint32_t *name = &group->rename[index[i]];

		if (*name == 0) {
			group->source[group->used_count++] = index[i];
			*name = (uint32_t)group->used_count;
		}
		index[i] = *name - 1;
	}
	order->renamed[list] = true;
	return 0;
}

static int count_primitive(struct optimize_order *order, json_t *primitive)
{
	(void)primitive;
	order->count++;
	return 0;
}

static int allocate(struct optimize_order *order)
{
	size_t count = (size_t)gltf_document_array_count(order->document) + 1;

	(void)for_each_primitive(order, count_primitive);
	order->group = calloc((size_t)order->count + 1, sizeof(*order->group));
	order->count = 0;
	order->by_key = json_object();
	order->of_vertices = malloc(count * sizeof(int));
	order->of_list = malloc(count * sizeof(int));
	order->list = calloc(count, sizeof(*order->list));
	order->blended = calloc(count, sizeof(*order->blended));
	order->renamed = calloc(count, sizeof(*order->renamed));
	if (!order->group || !order->by_key || !order->of_vertices ||
		!order->of_list || !order->list || !order->blended ||
		!order->renamed) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < count; i++) {
		order->of_vertices[i] = order->of_list[i] = FREE;
	}
	return 0;
}

int optimize_order_find(
	struct optimize_order *order, const struct gltf_document *document)
{
	int error;

	*order = (struct optimize_order){.document = document};
	error = allocate(order);
	if (!error) {
		error = for_each_primitive(order, add_primitive);
	}
	if (!error) {
		error = order_lists(order);
	}
	return error ? error : for_each_primitive(order, order_vertices);
}

void optimize_order_release(struct optimize_order *order)
{
	for (int i = 0; i < order->count; i++) {
		free(order->group[i].source);
		free(order->group[i].rename);
	}
	for (int i = 0;
		order->list && i < gltf_document_array_count(order->document);
		i++) {
		free(order->list[i]);
	}
	json_decref(order->by_key);
	free(order->group);
	free(order->of_vertices);
	free(order->of_list);
	free(order->list);
	free(order->blended);
	free(order->renamed);
	*order = (struct optimize_order){0};
}

const struct optimize_group *optimize_order_vertices(
	const struct optimize_order *order, int accessor)
{
	const struct optimize_group *group =
		free_group(order, order->of_vertices, accessor);

	return group && group->source ? group : NULL;
}

const uint32_t *optimize_order_list(
	const struct optimize_order *order, int accessor)
{
	return free_group(order, order->of_list, accessor)
		? order->list[accessor]
		: NULL;
}
