#include "app/compare/optimize/optimize_scale.h"

#include "app/compare/export/glb.h"
#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * Meshes, then skins. A union-find structure joins those that need one unit:
 * the mesh and the skin of a node, and a mesh and its levels of detail.
 */
struct parts {
	const struct gltf_document *document;
	json_t *nodes, *meshes;
	int mesh_count, count, node_count;
	struct part {
		int parent; /* in the set's tree; the root is its own */
		bool skinned, unskinned;
		bool placed;  /* some node cannot take a scale */
		bool integer; /* some positions are integers already */
		float largest;
	} * part;
	bool *still; /* [node_count]: the node must keep its scale */
};

static int index_of(const json_t *object, const char *key, int count)
{
	const json_t *value = json_object_get(object, key);
	json_int_t index =
		json_is_integer(value) ? json_integer_value(value) : -1;

	return index >= 0 && index < count ? (int)index : -1;
}

static struct part *set_of(const struct parts *parts, int index)
{
	while (parts->part[index].parent != index) {
		int *parent = &parts->part[index].parent;

		*parent = parts->part[*parent].parent;
		index = *parent;
	}
	return &parts->part[index];
}

static void connect(const struct parts *parts, int a, int b)
{
	set_of(parts, a)->parent = (int)(set_of(parts, b) - parts->part);
}

static void keep_still(const struct parts *parts, const json_t *numbers)
{
	const json_t *number;
	size_t i;

	json_array_foreach((json_t *)numbers, i, number)
	{
		json_int_t index = json_integer_value(number);

		if (index >= 0 && index < parts->node_count) {
			parts->still[index] = true;
		}
	}
}

static json_t *levels_of(const json_t *node)
{
	return json_object_get(
		json_object_get(json_object_get(node, "extensions"), "MSFT_lod"),
		"ids");
}

/* Finds nodes that must keep their scale: joints, levels, animated scales. */
static void find_still(const struct parts *parts)
{
	json_t *root = gltf_document_json(parts->document);
	json_t *item, *channel;
	size_t i, k;

	json_array_foreach(json_object_get(root, "skins"), i, item)
	{
		keep_still(parts, json_object_get(item, "joints"));
	}
	json_array_foreach(json_object_get(root, "animations"), i, item)
	{
		json_array_foreach(json_object_get(item, "channels"), k, channel)
		{
			const json_t *target =
				json_object_get(channel, "target");
			const char *path = json_string_value(
				json_object_get(target, "path"));
			int node = index_of(target, "node", parts->node_count);

			if (node >= 0 && path && strcmp(path, "scale") == 0) {
				parts->still[node] = true;
			}
		}
	}
	json_array_foreach(parts->nodes, i, item)
	{
		keep_still(parts, levels_of(item));
	}
}

static bool can_scale(const struct parts *parts, const json_t *node, int index)
{
	return !parts->still[index] && !json_object_get(node, "children") &&
		!json_object_get(node, "camera") &&
		!json_object_get(node, "extensions");
}

static void add_node(struct parts *parts, const json_t *node, int index)
{
	int mesh = index_of(node, "mesh", parts->mesh_count);
	int skin = index_of(node, "skin", parts->count - parts->mesh_count);
	json_t *number;
	size_t i;

	if (mesh < 0) {
		return;
	}
	if (skin >= 0) {
		connect(parts, mesh, parts->mesh_count + skin);
		set_of(parts, mesh)->skinned = true;
	} else {
		parts->part[mesh].unskinned = true;
		parts->part[mesh].placed = parts->part[mesh].placed ||
			!can_scale(parts, node, index);
	}
	json_array_foreach(levels_of(node), i, number)
	{
		json_t *level = json_array_get(
			parts->nodes, (size_t)json_integer_value(number));
		int other = index_of(level, "mesh", parts->mesh_count);

		if (other >= 0) {
			connect(parts, mesh, other);
		}
	}
}

static int measure(const struct parts *parts, int accessor, struct part *part)
{
	struct gltf_document_array array =
		gltf_document_array(parts->document, accessor);
	size_t count = (size_t)array.count * (size_t)array.width;
	float *value;
	int error;

	if (array.component != GLB_FLOAT) {
		part->integer = true;
		return 0;
	}
	value = malloc(count * sizeof(*value));
	if (!value) {
		return -ENOMEM;
	}
	error = gltf_document_floats(parts->document, accessor, value);
	for (size_t i = 0; i < count && !error; i++) {
		float size = scalar_abs(value[i]);

		part->largest = size > part->largest ? size : part->largest;
	}
	free(value);
	return error;
}

static int measure_mesh(const struct parts *parts, const json_t *mesh, int index)
{
	json_t *primitive;
	size_t i;
	int error = 0;

	json_array_foreach(json_object_get(mesh, "primitives"), i, primitive)
	{
		int accessor = index_of(json_object_get(primitive, "attributes"),
			"POSITION", gltf_document_array_count(parts->document));

		if (accessor >= 0 && !error) {
			error = measure(parts, accessor, &parts->part[index]);
		}
	}
	return error;
}

/* Merges the members of each part into the root of its set. */
static void join_sets(const struct parts *parts)
{
	for (int i = 0; i < parts->count; i++) {
		const struct part *part = &parts->part[i];
		struct part *set = set_of(parts, i);

		set->skinned = set->skinned || part->skinned;
		set->unskinned = set->unskinned || part->unskinned;
		set->placed = set->placed || part->placed;
		set->integer = set->integer || part->integer;
		set->largest = part->largest > set->largest ? part->largest
							    : set->largest;
	}
}

static float unit_of(const struct part *set)
{
	float unit = 1.0f;

	if (set->integer || !(set->largest > 0.0f)) {
		return 0.0f;
	}
	/* Above 1/16, at least 11 bits are used without scaling. */
	if (set->largest <= 1.0f && set->largest > 1.0f / 16.0f) {
		return 1.0f;
	}
	if (set->placed || (set->skinned && set->unskinned)) {
		return 0.0f;
	}
	while (unit < set->largest) {
		unit *= 2.0f;
	}
	while (unit * 0.5f >= set->largest && unit > 1e-6f) {
		unit *= 0.5f;
	}
	return unit;
}

static int find_units(struct parts *parts)
{
	json_t *item;
	size_t i;
	int error = 0;

	for (int p = 0; p < parts->count; p++) {
		parts->part[p].parent = p;
	}
	find_still(parts);
	json_array_foreach(parts->nodes, i, item)
	{
		add_node(parts, item, (int)i);
	}
	json_array_foreach(parts->meshes, i, item)
	{
		error = error ? error : measure_mesh(parts, item, (int)i);
	}
	join_sets(parts);
	return error;
}

int optimize_scale_find(
	struct optimize_scale *scale, const struct gltf_document *document)
{
	json_t *root = gltf_document_json(document);
	struct parts parts = {
		.document = document,
		.nodes = json_object_get(root, "nodes"),
		.meshes = json_object_get(root, "meshes"),
	};
	int error = -ENOMEM;

	parts.node_count = (int)json_array_size(parts.nodes);
	parts.mesh_count = (int)json_array_size(parts.meshes);
	parts.count = parts.mesh_count +
		(int)json_array_size(json_object_get(root, "skins"));
	parts.part = calloc((size_t)parts.count + 1, sizeof(*parts.part));
	parts.still = calloc((size_t)parts.node_count + 1, sizeof(bool));
	scale->mesh = calloc((size_t)parts.count + 1, sizeof(float));
	scale->skin = scale->mesh ? scale->mesh + parts.mesh_count : NULL;
	if (parts.part && parts.still && scale->mesh) {
		error = find_units(&parts);
		for (int p = 0; p < parts.count; p++) {
			scale->mesh[p] = unit_of(set_of(&parts, p));
		}
	}
	free(parts.part);
	free(parts.still);
	return error;
}

void optimize_scale_release(struct optimize_scale *scale)
{
	free(scale->mesh);
	*scale = (struct optimize_scale){NULL, NULL};
}
